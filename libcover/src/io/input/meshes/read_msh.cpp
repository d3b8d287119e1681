// gmsh's .msh as geometry: the mesh is taken apart again into the borders of its physical surfaces
// and its physical curves, so that a gmsh model can be remeshed.
//
// A surface element has the material of its physical group: the group's name, else its number. A
// name that is a number is that of the region too.
// Surfaces in no group are materials of their own ("surface_7"). Line elements count where they are
// in a physical group, whose name becomes the contact's, and all of them in a file without
// surfaces. Of elements of higher order the corners are taken.
// Tested by tests/unit/io/input/meshes/read_msh_test.cpp.
#include <fmt/core.h>

#include <limits>
#include <map>
#include <set>
#include <string>

#include <cover/text.hpp>

#include "geom/topology/mesh_borders.hpp"
#include "io/input/formats.hpp"
#include "io/input/meshes/left_out.hpp"
#include "io/read_mesh/formats/msh_file.hpp"

namespace cover {
namespace {

class CellsOfMsh {
 public:
  CellsOfMsh(MshFile file, const std::string& source) : file_(std::move(file)) {
    mesh_.source = source;
    mesh_.points = std::move(file_.points);
    mesh_.point_ids = std::move(file_.point_ids);
  }

  Input convert() {
    for (const MshElement& element : file_.elements) add(element);
    if (mesh_.cells() == 0) mesh_.lines.insert(mesh_.lines.end(), loose_.begin(), loose_.end());
    Input input = borders_of(mesh_);
    // Where it is a number, the name of the material would be another than that of the group.
    for (RegionSeed& seed : input.seeds)
      if (named_.contains(seed.material)) seed.region = seed.material;
    if (second_order_ > 0) input.warnings.push_back(corners_taken(second_order_));
    if (file_.in_several_groups > 0)
      input.warnings.push_back(
          fmt::format("curves and surfaces are in {}: the first of each counts",
                      counted(file_.in_several_groups, "further physical group")));
    // Its curves need not be in groups, and a group may have more curves than the pair.
    if (file_.has_periodic_points) input.warnings.push_back(pairs_left_out("$Periodic"));
    for (std::string& warning : values_left_out(file_.point_arrays))
      input.warnings.push_back(std::move(warning));
    return input;
  }

 private:
  void add(const MshElement& element) {
    const auto nodes = file_.nodes_of(element);
    const std::vector<std::uint32_t> corners(nodes.begin(), nodes.begin() + element.corners);
    second_order_ += element.nodes > element.corners;
    if (element.dimension == 0 && element.physical != 0) add_point(element, corners[0]);
    if (element.dimension == 1) add_line(element, corners);
    if (element.dimension == 2) mesh_.add_cell(corners, material_of(element));
  }

  void add_point(const MshElement& element, std::uint32_t point) {
    mesh_.kept.push_back(point);
    const auto name = file_.names.find({0, element.physical});
    if (name != file_.names.end() && !name->second.empty())
      mesh_.names.push_back({point, name->second});
  }

  void add_line(const MshElement& element, const std::vector<std::uint32_t>& ends) {
    CellMesh::Line line{ends[0], ends[1], {}, 0, element.id};
    if (element.physical == 0) return loose_.push_back(std::move(line));
    line.name = group_name(1, element.physical);
    if (element.physical <= std::numeric_limits<int>::max())
      line.marker = static_cast<int>(element.physical);
    mesh_.lines.push_back(std::move(line));
  }

  std::string group_name(long dimension, long tag) const {
    const auto name = file_.names.find({dimension, tag});
    return name != file_.names.end() && !name->second.empty() ? name->second : std::to_string(tag);
  }

  std::uint32_t material_of(const MshElement& element) {
    const std::string name = element.physical != 0 ? group_name(2, element.physical)
                                                   : fmt::format("surface_{}", element.entity);
    if (file_.names.contains({2, element.physical})) named_.insert(name);
    const auto [at, is_new] =
        material_.emplace(name, static_cast<std::uint32_t>(mesh_.materials.size()));
    if (is_new) mesh_.materials.push_back(name);
    return at->second;
  }

  MshFile file_;
  std::map<std::string, std::uint32_t> material_;
  std::set<std::string> named_;        // materials that physical groups are called by, not numbered
  std::vector<CellMesh::Line> loose_;  // line elements in no physical group
  std::size_t second_order_ = 0;
  CellMesh mesh_;
};

}  // namespace

Result<Input> parse_msh(std::string_view text, const std::string& source) {
  Result<MshFile> file = parse_msh_file(text, source);
  if (!file) return std::move(file).error();
  return CellsOfMsh(*std::move(file), source).convert();
}

}  // namespace cover
