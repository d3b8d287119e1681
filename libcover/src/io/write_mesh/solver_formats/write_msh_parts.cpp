// A .msh of 4.1 for each part of a mesh, as gmsh splits one.
// Tested by tests/unit/io/write_mesh/solver_formats/write_msh_test.cpp.
#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include "base/containers/order.hpp"
#include "base/numbers.hpp"
#include "geom/topology/half_edges.hpp"
#include "io/files/mapped_file.hpp"
#include "io/write_mesh/partition.hpp"
#include "io/write_mesh/solver_formats/msh_sections.hpp"
#include "io/write_mesh/solver_formats/msh_text.hpp"
#include "io/write_mesh/view_cells.hpp"

namespace cover {
namespace {

/// A mesh in parts, with the numbers that elements have in the file of the whole mesh.
struct MshParts {
  const MeshView& view;
  const Partition& partition;
  std::vector<std::vector<std::size_t>> lines;  ///< by part: beside its own triangles
  std::vector<std::size_t> line_number, triangle_number;
  std::vector<int> first_curve, first_surface;  ///< by part: tags; the last surface is for ghosts

  MshParts(const MeshView& mesh, const Partition& parts) : view(mesh), partition(parts) {
    number_elements();
    place_lines();
    number_entities();
  }

  [[nodiscard]] const std::vector<std::size_t>& own(std::uint32_t part) const {
    return partition.parts[part].own;
  }
  [[nodiscard]] std::uint32_t group(std::size_t t) const {
    return view.region_group[place_of(view.region[t])];
  }

 private:
  void number_elements() {
    std::size_t next = 0;
    const auto number = [&](const Buckets& groups, std::vector<std::size_t>& numbers) {
      for (std::size_t g = 0; g < groups.size(); ++g)
        for (const std::size_t k : groups[g]) numbers[k] = ++next;
    };
    line_number.resize(view.lines.size());
    triangle_number.resize(view.triangles.size());
    number(Buckets(view.line_groups.size(), view.lines.size(),
                   [&](std::size_t l) { return view.line_group[l]; }),
           line_number);
    number(Buckets(view.region_groups.size(), view.triangles.size(),
                   [&](std::size_t t) { return group(t); }),
           triangle_number);
  }

  /// A line between two parts belongs to both.
  void place_lines() {
    std::vector<IndexTriple> corners;
    corners.reserve(view.triangles.size());
    for (std::size_t t = 0; t < view.triangles.size(); ++t) {
      const auto nodes = view.triangles[t];
      corners.push_back({nodes[0], nodes[1], nodes[2]});
    }
    const HalfEdges edges(view.points.size(), corners);
    lines.resize(partition.parts.size());
    for (std::size_t l = 0; l < view.lines.size(); ++l) {
      const auto ends = view.lines[l];
      std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
      for (const std::uint32_t h : {edges.find(ends[0], ends[1]), edges.find(ends[1], ends[0])}) {
        if (h == kNone || partition.owner[h / 3] == first) continue;
        first = partition.owner[h / 3];
        lines[first].push_back(l);
      }
    }
  }

  /// Tags that no other part has, nor the whole mesh.
  void number_entities() {
    int next = 1;
    for (const auto* groups : {&view.line_groups, &view.region_groups})
      for (const Group& group : *groups) next = std::max(next, group.tag + 1);
    const auto count = [](const std::vector<std::size_t>& cells, auto group) {
      std::set<std::uint32_t> groups;
      for (const std::size_t cell : cells) groups.insert(group(cell));
      return static_cast<int>(groups.size());
    };
    int curve = next, surface = next;
    for (std::uint32_t part = 0; part < partition.parts.size(); ++part) {
      first_curve.push_back(curve);
      first_surface.push_back(surface);
      curve += count(lines[part], [&](std::size_t l) { return view.line_group[l]; });
      surface += count(own(part), [&](std::size_t t) { return group(t); }) + 1;
    }
  }
};

/// The file of one part.
class MshPartWriter : MshSections {
 public:
  using MshSections::MshSections;

  /// The file of one process: its own triangles, the lines beside them, and ghosts. Entities of the
  /// whole mesh have one of the part each, as gmsh does it.
  void write(const MshParts& parts, std::uint32_t part) {
    head_4(Buckets(view_.line_groups.size(), view_.lines.size(),
                   [&](std::size_t l) { return view_.line_group[l]; }));
    const PartOfGroups curves(parts.lines[part], parts.first_curve[part],
                              [&](std::size_t l) { return view_.line_group[l]; });
    const PartOfGroups surfaces(parts.own(part), parts.first_surface[part],
                                [&](std::size_t t) { return parts.group(t); });
    const std::vector<std::size_t>& ghosts = parts.partition.parts[part].ghosts;
    const int ghost_tag = surfaces.tag(surfaces.groups.size());
    out_ << "$PartitionedEntities\n"
         << parts.partition.parts.size() << "\n1\n"
         << ghost_tag << ' ' << part + 1 << "\n0 " << curves.groups.size() << ' '
         << surfaces.groups.size() << " 0\n";
    std::vector<std::uint32_t> nodes;
    const auto entities = [&](int dimension, const PartOfGroups& all, const Cells& cells,
                              const std::vector<Group>& groups) {
      for (std::size_t k = 0; k < all.groups.size(); ++k) {
        Box box;
        for (const std::size_t c : all.items[k]) {
          for (const std::uint32_t node : cells[c]) box.add(view_.points[node]);
          nodes.insert(nodes.end(), cells[c].begin(), cells[c].end());
        }
        const int parent = groups[all.groups[k]].tag;
        out_ << all.tag(k) << ' ' << dimension << ' ' << parent << " 1 " << part + 1;
        corners(box);
        out_ << " 1 " << parent << " 0\n";
      }
    };
    entities(1, curves, view_.lines, view_.line_groups);
    entities(2, surfaces, view_.triangles, view_.region_groups);
    out_ << "$EndPartitionedEntities\n";
    for (const std::size_t t : ghosts)
      nodes.insert(nodes.end(), view_.triangles[t].begin(), view_.triangles[t].end());
    sort_unique(nodes);
    part_nodes(nodes, surfaces);
    part_elements(parts, curves, surfaces, ghosts, ghost_tag);
    out_ << "$GhostElements\n" << ghosts.size() << '\n';
    for (const std::size_t t : ghosts)
      out_ << parts.triangle_number[t] << ' ' << parts.partition.owner[t] + 1 << " 1 " << part + 1
           << '\n';
    out_ << "$EndGhostElements\n";
    part_data(parts, curves, surfaces, ghosts, nodes);
  }

 private:
  /// The cells of a part by the groups that they are of, each an entity.
  struct PartOfGroups {
    std::vector<std::uint32_t> groups;
    std::vector<std::vector<std::size_t>> items;
    int first = 0;  ///< tag

    template <class Group>
    PartOfGroups(std::vector<std::size_t> cells, int first_tag, Group group) : first(first_tag) {
      std::stable_sort(cells.begin(), cells.end(),
                       [&](std::size_t a, std::size_t b) { return group(a) < group(b); });
      for (const std::size_t cell : cells) {
        if (groups.empty() || groups.back() != group(cell)) {
          groups.push_back(group(cell));
          items.emplace_back();
        }
        items.back().push_back(cell);
      }
    }
    [[nodiscard]] int tag(std::size_t k) const { return first + static_cast<int>(k); }
    [[nodiscard]] std::size_t size() const {
      std::size_t n = 0;
      for (const auto& some : items) n += some.size();
      return n;
    }
  };

  void part_nodes(std::span<const std::uint32_t> nodes, const PartOfGroups& surfaces) {
    out_ << "$Nodes\n";
    if (nodes.empty()) {
      out_ << "0 0 0 0\n$EndNodes\n";
      return;
    }
    out_ << "1 " << nodes.size() << ' ' << nodes.front() + 1 << ' ' << nodes.back() + 1 << "\n2 "
         << surfaces.tag(0) << " 0 " << nodes.size() << '\n';
    for (const std::uint32_t node : nodes) out_ << node + 1 << '\n';
    for (const std::uint32_t node : nodes) coordinates(view_.points[node]);
    out_ << "$EndNodes\n";
  }

  void part_elements(const MshParts& parts, const PartOfGroups& curves,
                     const PartOfGroups& surfaces, std::span<const std::size_t> ghosts,
                     int ghost_tag) {
    std::size_t least = std::numeric_limits<std::size_t>::max(), most = 0;
    const auto note = [&](std::size_t number) {
      least = std::min(least, number);
      most = std::max(most, number);
    };
    for (const auto& some : curves.items)
      for (const std::size_t l : some) note(parts.line_number[l]);
    for (const auto& some : surfaces.items)
      for (const std::size_t t : some) note(parts.triangle_number[t]);
    for (const std::size_t t : ghosts) note(parts.triangle_number[t]);
    out_ << "$Elements\n"
         << curves.groups.size() + surfaces.groups.size() + (ghosts.empty() ? 0 : 1) << ' '
         << curves.size() + surfaces.size() + ghosts.size() << ' ' << std::min(least, most) << ' '
         << most << '\n';
    const auto elements = [&](std::span<const std::size_t> cells, const Cells& of,
                              const std::vector<std::size_t>& numbers) {
      for (const std::size_t c : cells) {
        out_ << numbers[c];
        nodes(of[c]);
      }
    };
    for (std::size_t k = 0; k < curves.groups.size(); ++k) {
      block(1, curves.tag(k), line_type(), curves.items[k].size());
      elements(curves.items[k], view_.lines, parts.line_number);
    }
    for (std::size_t k = 0; k < surfaces.groups.size(); ++k) {
      block(2, surfaces.tag(k), triangle_type(), surfaces.items[k].size());
      elements(surfaces.items[k], view_.triangles, parts.triangle_number);
    }
    if (!ghosts.empty()) {
      block(2, ghost_tag, triangle_type(), ghosts.size());
      elements(ghosts, view_.triangles, parts.triangle_number);
    }
    out_ << "$EndElements\n";
  }

  /// As data(), of what is in the part.
  void part_data(const MshParts& parts, const PartOfGroups& curves, const PartOfGroups& surfaces,
                 std::span<const std::size_t> ghosts, std::span<const std::uint32_t> nodes) {
    for (const Attribute& attribute : view_.attributes) {
      begin_data("Element", attribute.name, curves.size() + surfaces.size() + ghosts.size());
      const auto value = [&](std::size_t number, RegionId region) {
        out_ << number << ' ' << (region == kVoid ? kNoNumber : attribute.values[place_of(region)])
             << '\n';
      };
      for (const auto& some : curves.items)
        for (const std::size_t l : some) value(parts.line_number[l], region_of_line(l));
      for (const auto& some : surfaces.items)
        for (const std::size_t t : some) value(parts.triangle_number[t], view_.region[t]);
      for (const std::size_t t : ghosts) value(parts.triangle_number[t], view_.region[t]);
      out_ << "$EndElementData\n";
    }
    for (const PlaneField::Array& field : view_.fields) {
      begin_data("Node", field.name, nodes.size());
      for (const std::uint32_t p : nodes) out_ << p + 1 << ' ' << field.values[p] << '\n';
      out_ << "$EndNodeData\n";
    }
  }
};

/// "x_3.msh" of "x.msh".
std::string part_name(const std::filesystem::path& path, std::uint32_t part) {
  std::filesystem::path stem = path;
  stem.replace_extension();
  return stem.string() + "_" + std::to_string(part + 1) + path.extension().string();
}

/// Removes the parts of a mesh in more parts that was written under the same name: who reads all
/// x_*.msh would mix two meshes.
void remove_further_parts(const std::filesystem::path& path, std::uint32_t count) {
  for (std::uint32_t part = count;; ++part) {
    const std::string name = part_name(path, part);
    const std::optional<MappedFile> file = MappedFile::open(name);
    if (!file || !file->bytes().starts_with("$MeshFormat\n4.1") ||
        file->bytes().find("\n$PartitionedEntities\n") == std::string_view::npos)
      return;
    std::error_code ignored;
    std::filesystem::remove(name, ignored);
  }
}

}  // namespace

Status write_msh_parts(const MeshView& view, const RegionTable& table, const std::string& path,
                       const WriteOptions& options) {
  const auto count = static_cast<std::uint32_t>(options.parts);
  const Partition partition = partition_of(view, count);
  const MshParts parts(view, partition);
  const ViewCells cells(view, true);
  std::vector<TextWriter> files;
  for (std::uint32_t part = 0; part < count; ++part) {
    Result<TextWriter> file = TextWriter::create(part_name(path, part), options.stop);
    if (!file) return std::move(file).error();
    MshPartWriter(view, cells, table, *file).write(parts, part);
    if (Status status = file->prepare(); !status) return status;
    files.push_back(*std::move(file));
  }
  std::vector<AtomicFile*> prepared;
  for (TextWriter& file : files) prepared.push_back(&file.file());
  if (Status done = commit_together(prepared); !done) return done;
  remove_further_parts(path, count);
  return ok();
}

}  // namespace cover
