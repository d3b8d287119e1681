// Edges are known by the places of their ends: the points of an input and of a mesh need not have
// the same numbers.
// Tested by tests/unit/app/named_lines_test.cpp, tests/cli/check_test.py.
#include "commands/check/named_lines.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include <cover/mesh_view.hpp>
#include <cover/write_mesh.hpp>

namespace cover::app {
namespace {

using Name = std::uint32_t;  ///< index into Pslg::names; 0: none
using Ends = std::pair<Point, Point>;

Ends ends(Point a, Point b) { return std::minmax(a, b); }

class LineCheck {
 public:
  LineCheck(const CutInput& cut, const MeshTriangles& mesh) : pslg_(cut.pslg), mesh_(mesh) {
    for (std::size_t s = 0; s < pslg_.segments.size(); ++s) {
      const Segment& segment = pslg_.segments[s];
      const SegmentSides& sides = cut.table.sides[s];
      if (sides.interface == kNoInterface) continue;
      const Ends edge = ends(pslg_.points[segment.a.index()], pslg_.points[segment.b.index()]);
      const bool is_inner = sides.left != kVoid && sides.right != kVoid;
      if (segment.name != 0) expected_[segment.name].emplace(edge, is_inner);
      // A marker is written as if it were the name of its line.
      else if (segment.marker != 0)
        marked_[std::to_string(segment.marker)].insert(edge);
    }
    name_lines(cut.table);
  }

  NamedLines run() {
    for (const MeshLine& line : mesh_.lines) take(line);
    const bool has_inner = has_inner_lines();
    bool leaves_out = false;
    NamedLines found;
    for (const auto& [name, edges] : expected_) {
      WrongLine line{pslg_.names[name]};
      const std::set<Ends>& there = found_[name];
      for (const auto& [edge, is_inner] : edges) {
        if (is_inner && !has_inner) {
          leaves_out = true;
          continue;
        }
        ++line.edges;
        if (!there.contains(edge)) add(edge, line.missing, line.missing_at);
      }
      for (const Ends& edge : there) {
        if (!edges.contains(edge) && !is_marked_like(line.name, edge))
          add(edge, line.foreign, line.foreign_at);
      }
      if (line.missing + line.foreign > 0) found.wrong.push_back(std::move(line));
    }
    if (leaves_out)
      found.unchecked.emplace_back("named lines (contacts) inside the mesh: it has no lines there");
    return found;
  }

 private:
  static void add(const Ends& edge, std::size_t& count, std::vector<Point>& first) {
    if (count++ == 0) first = {edge.first, edge.second};
  }

  /// Names as the input and as files have them: some formats bear no quotes.
  void name_lines(const RegionTable& table) {
    std::vector<LineEdge> lines;
    for (const Interface& line : table.interfaces) {
      LineEdge edge;
      edge.order = lines.size();
      edge.interface = line.id;
      lines.push_back(edge);
    }
    std::map<std::string, Name> names;
    for (const auto& [name, edges] : expected_) names.emplace(pslg_.names[name], name);
    for (const Group& group : view_of_lines(table, std::move(lines), {}).line_groups) {
      const auto known = names.find(group.original);
      if (!group.is_made_up && known != names.end()) name_of_.emplace(group.label, known->second);
    }
    name_of_.insert(names.begin(), names.end());
  }

  void take(const MeshLine& line) {
    const auto text = mesh_.line_names.find(line.group);
    if (text == mesh_.line_names.end()) return;
    const auto name = name_of_.find(text->second);
    if (name != name_of_.end())
      found_[name->second].insert(ends(mesh_.soup.points[line.a], mesh_.soup.points[line.b]));
  }

  /// Whether any line of the mesh has triangles on both sides.
  [[nodiscard]] bool has_inner_lines() const {
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::map<Edge, int> sides;
    for (const MeshLine& line : mesh_.lines) sides.emplace(std::minmax(line.a, line.b), 0);
    for (const auto& triangle : mesh_.soup.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto side = sides.find(std::minmax(triangle[k], triangle[(k + 1) % 3]));
        if (side != sides.end()) ++side->second;
      }
    }
    return std::any_of(sides.begin(), sides.end(),
                       [](const auto& side) { return side.second > 1; });
  }

  [[nodiscard]] bool is_marked_like(const std::string& name, const Ends& edge) const {
    const auto marked = marked_.find(name);
    return marked != marked_.end() && marked->second.contains(edge);
  }

  const Pslg& pslg_;
  const MeshTriangles& mesh_;
  std::map<Name, std::map<Ends, bool>> expected_;  ///< whether regions lie on both sides
  std::map<std::string, std::set<Ends>> marked_;   ///< lines without a name, by their marker
  std::map<std::string, Name> name_of_;
  std::map<Name, std::set<Ends>> found_;
};

}  // namespace

bool has_named_lines(const Pslg& pslg, const RegionTable& table) {
  for (std::size_t s = 0; s < pslg.segments.size(); ++s)
    if (pslg.segments[s].name != 0 && table.sides[s].interface != kNoInterface) return true;
  return false;
}

NamedLines lines_not_checked(const Pslg& pslg, const RegionTable& table) {
  if (!has_named_lines(pslg, table)) return {};
  return {{}, {"named lines (contacts)"}};
}

NamedLines check_named_lines(const CutInput& cut, const MeshTriangles& mesh) {
  if (mesh.line_names.empty()) return lines_not_checked(cut.pslg, cut.table);
  return has_named_lines(cut.pslg, cut.table) ? LineCheck(cut, mesh).run() : NamedLines{};
}

}  // namespace cover::app
