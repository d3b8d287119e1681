// Triangles come from the mesh; names and lines from the manifest or the .vtm beside it, since most
// formats cannot hold them all; else what the file itself has is made the best of. Where a file
// beside it contradicts the mesh's own file, as one that an earlier run left, the own one counts.
// Tested by tests/unit/io/read_mesh/read_output_test.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>
#include <cover/text.hpp>
#include <cover/write_mesh.hpp>

#include "base/faults/errors.hpp"
#include "base/faults/out_of_memory.hpp"
#include "geom/topology/bent_edges.hpp"
#include "io/read_mesh/carried_arrays.hpp"
#include "io/read_mesh/complete_mesh.hpp"
#include "io/read_mesh/formats/pieces/read_vtm.hpp"
#include "io/read_mesh/formats/read_vtkhdf_mesh.hpp"
#include "io/read_mesh/own_names.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

/// Names of points as the .vtm has them: those of a .msh lack letters. Old versions have none.
void take_points(StoredMesh& named, StoredMesh& stored) {
  if (!named.points.empty()) stored.points = std::move(named.points);
}

/// Names, lines and arrays for the triangles of `stored` out of the .vtm of the same mesh; false,
/// and nothing is changed, if it is of another one.
Result<bool> take_names_from_vtm(const std::string& path, StoredMesh& stored) {
  Result<VtmMesh> blocks = read_vtm(path);
  if (!blocks) return std::move(blocks).error();
  std::vector<std::string> ignored;  // the mesh's own file tells
  StoredMesh named = std::move(*blocks).finish(ignored);
  if (named.soup.points != stored.soup.points) return false;
  stored.regions = std::move(named.regions);
  stored.interfaces = std::move(named.interfaces);
  stored.edges = std::move(named.edges);
  take_points(named, stored);
  stored.attributes = std::move(named.attributes);
  stored.fields = std::move(named.fields);
  stored.region_values = std::move(named.region_values);
  stored.provenance = std::move(named.provenance);
  stored.unit = std::move(named.unit);
  stored.scale = named.scale;
  stored.input_vertices = named.input_vertices;
  stored.cut_vertices = std::max(stored.cut_vertices, named.cut_vertices);
  if (!take_materials(stored)) return wrong_file(path, "it is of another mesh");
  return true;
}

/// How the .vtm of the same mesh was made and names of points, for triangles without numbers of
/// regions, to which it can give nothing else.
void take_run_from_vtm(const std::string& path, StoredMesh& stored) {
  Result<VtmMesh> blocks = read_vtm(path);
  if (!blocks) return;
  std::vector<std::string> ignored;
  StoredMesh named = std::move(*blocks).finish(ignored);
  if (named.soup.points != stored.soup.points) return;
  take_points(named, stored);
  stored.provenance = std::move(named.provenance);
  stored.cut_vertices = std::max(stored.cut_vertices, named.cut_vertices);
}

/// Whether the numbers are 1, 2, ... of which each comes up, as those of words do; 0 is none.
bool may_number_words(const Attribute& attribute) {
  std::set<double> numbers;
  for (const double value : attribute.values)
    if (!std::isnan(value) && value != 0) numbers.insert(value);
  return !attribute.is_text && !numbers.empty() && *numbers.begin() == 1 &&
         *numbers.rbegin() == static_cast<double>(numbers.size()) &&
         std::all_of(numbers.begin(), numbers.end(),
                     [](double number) { return number == std::floor(number); });
}

/// How many points are corners of no triangle.
std::size_t unused_points(const TriangleSoup& soup) {
  std::vector<bool> used(soup.points.size());
  for (const auto& triangle : soup.triangles)
    for (const std::uint32_t corner : triangle) used[corner] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

/// Of all edges, in an order that does not depend on that of the file.
std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_of(const std::vector<StoredEdge>& edges) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  ends.reserve(edges.size());
  for (const StoredEdge& edge : edges) ends.emplace_back(std::minmax(edge.a, edge.b));
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// What a mesh's own file and those beside it hold.
class Completion {
 public:
  explicit Completion(const std::string& path) : path_(path) {}

  /// Notes on what stays unknown and on what is left out.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  Result<StoredMesh> read() {
    Result<StoredMesh> stored = read_all();
    if (stored && has_periodic_points_ && stored->periodic.empty())
      tell(
          {fmt::format("pairs of points on periodic sides are left out: only the manifest, {}, "
                       "or a .msh names these sides",
                       beside(".json"))});
    if (stored && stored->second_order) take_nodes(*stored);
    return stored;
  }

 private:
  void take_bent_edges(const TriangleSoup& soup, const std::vector<std::array<Point, 3>>& middles) {
    has_all_nodes_ = middles.size() == soup.triangles.size();
    for (const auto& [edge, middle] : bent_edges(soup, middles))
      nodes_.push_back({edge.first, edge.second, middle});
  }

  /// Arcs of a manifest tell more than the nodes on them.
  void take_nodes(StoredMesh& stored) {
    if (stored.arcs.empty()) stored.nodes = std::move(nodes_);
    if (!has_all_nodes_)
      tell({"not every triangle has six nodes: of those that have, the corners are taken"});
  }

  Result<StoredMesh> read_all() {
    if (extension_of(path_) == ".vtm") return read_blocks();
    if (extension_of(path_) == ".vtkhdf") {
      Result<VtkHdfMesh> file = read_vtkhdf_mesh(path_);
      if (!file) return std::move(file).error();
      return file->has_names ? read_named(*std::move(file)) : complete(std::move(file->mesh));
    }
    Result<MeshFile> file = read_mesh(path_);
    return file ? complete(*std::move(file)) : std::move(file).error();
  }

  [[nodiscard]] std::string beside(const char* extension) const {
    return fs::path(path_).replace_extension(extension);
  }

  void tell(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences)
      notes_.push_back(fmt::format("{}: {}", path_, sentence));
  }

  /// A file that holds all that cover knows.
  Result<StoredMesh> read_named(VtkHdfMesh file) {
    has_periodic_points_ = file.mesh.has_periodic_points;
    take_bent_edges(file.mesh.soup, file.mesh.middles);
    StoredMesh stored = std::move(file.names);
    stored.soup = std::move(file.mesh.soup);
    stored.second_order = file.mesh.second_order;
    stored.cut_vertices = file.mesh.cut_vertices;
    stored.points = std::move(file.mesh.named_points);
    for (const MeshLine& line : file.mesh.lines) {
      if (line.group < 1 || line.group > static_cast<std::int64_t>(stored.interfaces.size()))
        return wrong_file(path_, fmt::format("there is no interface {}", line.group));
      stored.edges.push_back(
          {line.a, line.b, InterfaceId(static_cast<std::uint32_t>(line.group)), line.marker});
    }
    if (!take_materials(stored)) return wrong_file(path_, "it lacks regions");
    const StoredMesh told = take_curves_and_pairs(stored);
    tell(take_arrays(std::move(file.mesh.arrays), std::move(file.mesh.point_arrays), file.words,
                     stored));
    tell_contradictions(told, ".json", stored);
    sort_by_region(stored.soup);
    return stored;
  }

  /// `told`: by the file of this extension beside the mesh.
  void tell_contradictions(const StoredMesh& told, const char* extension,
                           const StoredMesh& stored) {
    if (const std::string all = contradictions(told, stored); !all.empty())
      tell({fmt::format("{} contradicts it, and the mesh's own file counts: {}", beside(extension),
                        all)});
  }

  /// The names and the attributes of `stored`, to be compared later.
  static StoredMesh names_in(const StoredMesh& stored) {
    StoredMesh names;
    names.regions = stored.regions;
    names.interfaces = stored.interfaces;
    names.points = stored.points;
    names.attributes = stored.attributes;
    return names;
  }

  /// Arcs and periodic sides from the manifest. The file does not need one: that of another mesh is
  /// told, and changes nothing. Returns what it says besides; nothing if it is of another mesh.
  StoredMesh take_curves_and_pairs(StoredMesh& stored) {
    StoredMesh told;
    told.soup = std::move(stored.soup);
    const std::vector<std::int64_t> material = told.soup.material;
    const Result<bool> named = read_manifest(beside(".json"), {}, told);
    stored.soup = std::move(told.soup);
    stored.soup.material = material;
    if (named && !*named) return {};
    if (named && ends_of(told.edges) == ends_of(stored.edges)) {
      stored.arcs = std::move(told.arcs);
      stored.periodic = std::move(told.periodic);
      return told;
    }
    tell({fmt::format("arcs and periodic sides are left out: {}",
                      named ? fmt::format("{}: it is of another mesh", beside(".json"))
                            : named.error().message)});
    has_periodic_points_ = false;
    return {};
  }

  Result<StoredMesh> complete(MeshFile read) {
    const MeshFile* file = &read;
    StoredMesh stored;
    stored.soup = file->soup;
    stored.second_order = file->second_order;
    stored.cut_vertices = file->cut_vertices;
    stored.points = file->named_points;
    take_bent_edges(file->soup, file->middles);
    has_periodic_points_ = file->has_periodic_points;
    Result<bool> named = read_manifest(beside(".json"), file->group, stored);
    if (!named) return std::move(named).error();
    if (!*named) stored.periodic = std::move(read.periodic);
    const char* names = *named ? ".json" : nullptr;  // from what the names are
    const bool has_blocks = !*named && fs::is_regular_file(beside(".vtm"));
    if (has_blocks && stored.soup.region.empty()) take_run_from_vtm(beside(".vtm"), stored);
    if (has_blocks && !stored.soup.region.empty()) {
      const Result<bool> taken = take_names_from_vtm(beside(".vtm"), stored);
      if (!taken) return taken.error();
      if (*taken) names = ".vtm";
      has_other_blocks_ = !*taken;
    }
    if (names == nullptr) {
      if (Status status = complete_alone(*file, stored); !status) return std::move(status).error();
    }
    const StoredMesh told = names == nullptr ? StoredMesh() : names_in(stored);
    if (names != nullptr) take_own_names(*file, stored);
    const std::vector<std::string> holding = attribute_formats();
    const bool holds_all =
        std::find(holding.begin(), holding.end(), extension_of(path_)) != holding.end();
    tell(take_arrays(std::move(read.arrays), std::move(read.point_arrays), {}, stored, holds_all));
    if (names != nullptr)
      tell_contradictions(told, names, stored);
    else
      tell_numbers_of_words(stored.attributes);
    sort_by_region(stored.soup);
    return stored;
  }

  Result<StoredMesh> read_blocks() {
    Result<VtmMesh> blocks = read_vtm(path_);
    if (!blocks) return std::move(blocks).error();
    has_periodic_points_ = blocks->has_periodic_points;
    take_bent_edges(blocks->mesh.soup, blocks->middles);
    // What tells of triangles goes there and back, as it may be most of the memory.
    TriangleSoup soup = std::exchange(blocks->mesh.soup, {});
    StoredMesh told = blocks->mesh;
    const std::vector<std::int64_t> material = soup.material;
    told.soup = std::move(soup);
    const Result<bool> named = read_manifest(beside(".json"), {}, told);
    if (!named) return named.error();
    blocks->mesh.soup = std::move(told.soup);
    if (*named) take_manifest(told, material, *blocks);
    std::vector<std::string> left_out;
    StoredMesh stored = std::move(*blocks).finish(left_out);
    tell(left_out);
    if (*named) tell_contradictions(told, ".json", stored);
    return stored;
  }

  /// What blocks do not hold: arcs, periodic sides, and what the input calls attributes and fields;
  /// all names, where these are those of blocks. `material`: of the blocks' own triangles.
  static void take_manifest(const StoredMesh& told, const std::vector<std::int64_t>& material,
                            VtmMesh& blocks) {
    if (!blocks.has_names) {
      TriangleSoup soup = std::move(blocks.mesh.soup);
      blocks.mesh = told;
      blocks.mesh.soup = std::move(soup);
      return;
    }
    blocks.mesh.soup.material = material;
    blocks.mesh.arcs = told.arcs;
    blocks.mesh.periodic = told.periodic;
    blocks.mesh.attributes = told.attributes;
    blocks.mesh.fields = told.fields;
  }

  void tell_numbers_of_words(const std::vector<Attribute>& attributes) {
    std::vector<std::string> names;
    for (const Attribute& attribute : attributes)
      if (may_number_words(attribute)) names.push_back(fmt::format("'{}'", attribute.name));
    if (!names.empty())
      tell(
          {fmt::format("numbers of {} may stand for texts, which a manifest, a .vtm and a .vtkhdf "
                       "alone hold",
                       listed(names))});
  }

  Status complete_alone(const MeshFile& file, StoredMesh& stored) {
    // Medit's format and those that have groups alone cannot tell regions; all others do.
    const bool tells_regions = file.group.empty() && extension_of(path_) != ".mesh";
    if (stored.soup.region.empty() && tells_regions)
      return wrong_file(path_, "no RegionId of its triangles: not a mesh that cover wrote");
    std::vector<std::string> renumbered;
    const std::string unknown = complete_from_file(file, stored, renumbered);
    tell(renumbered);
    if (!unknown.empty()) {
      // Blocks name regions; which triangle is in which, the mesh itself has to say.
      const std::string why =
          fs::is_regular_file(beside(".json"))
              ? fmt::format("{} is no manifest of a mesh", beside(".json"))
          : has_other_blocks_ ? fmt::format("{} is of another mesh", beside(".vtm"))
          : fs::is_regular_file(beside(".vtm"))
              ? fmt::format(
                    "{} is not there, and {} cannot give them to triangles without "
                    "numbers of regions",
                    beside(".json"), beside(".vtm"))
              : fmt::format("neither {} nor {} is there", beside(".json"), beside(".vtm"));
      notes_.push_back(
          fmt::format("{} holds no {}, and {}: they are made up", path_, unknown, why));
    }
    if (file.parts > 0)
      tell({fmt::format("it is one of {} files of a mesh, and has copies of triangles of others",
                        file.parts)});
    // Formats without counts look whole wherever they end.
    if (const std::size_t unused = unused_points(stored.soup); unused > 0)
      tell({fmt::format("{} in no triangle: the file may have been cut short",
                        counted(unused, "point") + (unused == 1 ? " is" : " are"))});
    return ok();
  }

  std::string path_;
  std::vector<std::string> notes_;
  bool has_periodic_points_ = false;
  std::vector<MovedNode> nodes_;
  bool has_all_nodes_ = false;     ///< every triangle has six
  bool has_other_blocks_ = false;  ///< in a .vtm beside it that is of another mesh
};

}  // namespace

Result<Output> read_output(const std::string& path) {
  return memory_as_value(path, [&]() -> Result<Output> {
    Completion completion(path);
    Result<StoredMesh> stored = completion.read();
    if (!stored) return std::move(stored).error();
    Result<Output> output = rebuild(*stored);
    if (!output && output.error().code == ErrorCode::out_of_memory) return output;
    if (!output) return wrong_file(path, output.error().message);
    const auto warn = [&](std::string message) {
      output->report.notes.push_back({Note::Kind::warning, kVoid, std::move(message), {}});
    };
    for (const std::string& note : completion.notes()) warn(note);
    return output;
  });
}

}  // namespace cover
