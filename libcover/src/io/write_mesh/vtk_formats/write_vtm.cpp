// A block per group of regions and per group of lines, under the names that people see in ParaView
// and that .msh has for its physical groups: whoever extracts the block SiO2 gets all of it. The
// blocks are files in a folder beside the target. What blocks cannot hold, names of materials and
// of points above all, stands in an element behind them that VTK does not look at.
// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtm_test.cpp.
#include <cover/mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/text.hpp>
#include <cover/write_mesh.hpp>

#include <bit>
#include <cerrno>
#include <filesystem>

#include <fmt/core.h>

#include "base/containers/buckets.hpp"
#include "base/words/safe_names.hpp"
#include "io/files/piece_folder.hpp"
#include "io/write_mesh/check_format.hpp"
#include "io/write_mesh/vtk_formats/vtu_parts.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

/// So many groups of lines have blocks of their own; where there are more, nobody looks for one by
/// its name, and all lines between regions are one block, told apart by LineID.
constexpr std::size_t kMostLineBlocks = 100;

/// The text of a .vtm, which grows as the pieces do.
class VtmWriter {
 public:
  VtmWriter(const Output& output, const MeshView& view, PieceFolder& folder)
      : output_(output), view_(view), folder_(folder) {}

  Result<std::string> text() {
    text_ = fmt::format(
        "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\" byte_order=\"{}\" "
        "header_type=\"UInt64\">\n  <vtkMultiBlockDataSet>\n",
        std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian");
    if (Status status = block(0, "regions", [&] { return regions(); }); !status)
      return std::move(status).error();
    if (Status status = block(1, "interfaces", [&] { return interfaces(); }); !status)
      return std::move(status).error();
    text_ += "  </vtkMultiBlockDataSet>\n";
    names();
    text_ += "</VTKFile>\n";
    return std::move(text_);
  }

 private:
  template <class Write>
  Status block(int index, const char* name, Write write) {
    text_ += fmt::format("    <Block name=\"{}\" index=\"{}\">\n", name, index);
    Status status = write();
    text_ += "    </Block>\n";
    return status;
  }

  Status data_set(std::size_t index, const std::string& name,
                  const std::function<void(const ByteSink&)>& write) {
    Result<std::string> file = folder_.add(write);
    if (!file) return std::move(file).error();
    text_ += fmt::format("      <DataSet index=\"{}\" name=\"{}\" file=\"{}\"/>\n", index,
                         escaped_markup(name), escaped_markup(*file));
    return ok();
  }

  Status regions() {
    const Buckets members(view_.region_groups.size(), view_.triangles.size(), [&](std::size_t t) {
      return view_.region_group[place_of(view_.region[t])];
    });
    for (std::size_t g = 0; g < members.size(); ++g) {
      Status status = data_set(g, view_.region_groups[g].label, [&](const ByteSink& sink) {
        write_triangles(view_, members[g], sink);
      });
      if (!status) return status;
    }
    return ok();
  }

  Status interfaces() {
    const Buckets members(view_.line_groups.size(), view_.lines.size(),
                          [&](std::size_t l) { return view_.line_group[l]; });
    std::size_t index = 0;
    const auto add = [&](const std::string& name, std::span<const std::size_t> lines) {
      return data_set(index++, name, [&](const ByteSink& sink) {
        write_lines(view_, output_.table, lines, sink);
      });
    };
    const bool many = members.size() > kMostLineBlocks;
    std::vector<std::size_t> others;
    for (std::size_t g = 0; g < members.size(); ++g) {
      // Sides of the hull are on no interface, and all in one group.
      if (view_.interface[members[g].front()] == kNoInterface) continue;
      if (many && !has_own_name(members[g].front())) {
        others.insert(others.end(), members[g].begin(), members[g].end());
        continue;
      }
      if (Status status = add(view_.line_groups[g].label, members[g]); !status) return status;
    }
    return others.empty() ? ok() : add("lines", others);
  }

  /// Whether a line is called by a contact or a marker, and not by what it separates.
  [[nodiscard]] bool has_own_name(std::size_t line) const {
    const Interface& of = output_.table.interface(view_.interface[line]);
    return of.kind == InterfaceKind::contact || view_.marker[line] != 0;
  }

  void names() {
    std::size_t input_points = 0;
    for (const auto v : output_.mesh.tri().vertices())
      input_points += output_.mesh.input_id(v) >= 0 ? 1 : 0;
    const Report& report = output_.report;
    const std::string cuts =
        view_.cut_vertices > 0 ? fmt::format(" CutVertices=\"{}\"", view_.cut_vertices) : "";
    text_ += fmt::format(
        "  <CoverNames InputVertices=\"{}\"{} Source=\"{}\" Version=\"{}\" Unit=\"{}\" "
        "Scale=\"{}\">\n",
        input_points, cuts, attribute(report.provenance.source),
        attribute(report.provenance.version), attribute(report.unit), report.scale);
    for (const Provenance::Setting& setting : report.provenance.settings)
      text_ += fmt::format("    <Option Name=\"{}\" Value=\"{}\"/>\n", attribute(setting.name),
                           attribute(setting.value));
    for (const Region& region : output_.table.regions)
      text_ +=
          fmt::format("    <Region Id=\"{}\" Name=\"{}\" Material=\"{}\"/>\n", region.id.value(),
                      attribute(region.name), attribute(region.material_name));
    for (const Interface& line : output_.table.interfaces)
      text_ +=
          fmt::format("    <Line Id=\"{}\" Name=\"{}\"/>\n", line.id.value(), attribute(line.name));
    for (std::size_t k = 0; k < view_.named.size(); ++k)
      text_ += fmt::format("    <Point Vertex=\"{}\" Name=\"{}\"/>\n", view_.named[k],
                           attribute(view_.point_groups[view_.named_group[k]].original));
    for (const Attribute& of : view_.attributes) {
      text_ += fmt::format("    <Attribute Name=\"{}\">\n", attribute(of.name));
      for (std::size_t k = 0; k < of.words.size(); ++k)
        text_ +=
            fmt::format("      <Word Id=\"{}\" Name=\"{}\"/>\n", k + 1, attribute(of.words[k]));
      text_ += "    </Attribute>\n";
    }
    text_ += "  </CoverNames>\n";
  }

  /// A text as the value of an attribute of XML.
  static std::string attribute(const std::string& text) {
    if (text.empty()) return text;
    // Double quotes, which escaped_markup() bears, are the only thing that is not the same twice.
    std::string out, piece;
    const auto put = [&] {
      if (!piece.empty()) out += escaped_markup(legible_name(piece));
      piece.clear();
    };
    for (const char c : text) {
      if (c == '"') {
        put();
        out += "&quot;";
      } else {
        piece += c;
      }
    }
    put();
    return out;
  }

  const Output& output_;
  const MeshView& view_;
  PieceFolder& folder_;
  std::string text_;
};

}  // namespace

Status write_vtm(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".vtm", output, path, options); !status) return status;
  const Result<fs::path> target = end_of_links(path);
  if (!target) return target.error();
  std::error_code ignored;
  if (fs::is_directory(*target, ignored)) return cannot_write(path, EISDIR);
  Result<PieceFolder> folder = PieceFolder::open(*target, path, options.stop);
  if (!folder) return std::move(folder).error();
  WriteOptions all = options;
  all.inner_lines = true;
  all.ids.clear();
  const MeshView view = view_of(output, all);
  const Result<std::string> text = VtmWriter(output, view, *folder).text();
  return text ? folder->commit(*text) : Status(text.error());
}

}  // namespace cover
