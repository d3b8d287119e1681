// Negative couplings of a mesh, counted by CGAL alone: nothing here is of cover.
//
//   recount_couplings CLEAN.poly MESH.node MESH.ele
//
// CLEAN.poly is the geometry as it was meshed (`cover mesh IN -o MESH.ele -o CLEAN.poly --ids
// region`). Prints the negative couplings on inner edges, all sides, the negative ones among them
// that a vertex of the geometry encroaches, and the other negative ones. Exact: by predicates of
// CGAL on the numbers as they are written.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Face = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<Vertex, Face>>;
using Point = Kernel::Point_2;

/// The words of a file of Triangle's, line by line.
class Lines {
 public:
  explicit Lines(const char* path) : file_(path) {
    if (!file_) std::fprintf(stderr, "cannot read %s\n", path), std::exit(2);
  }
  std::vector<double> next() {
    std::string line;
    while (std::getline(file_, line)) {
      std::istringstream words(line.substr(0, line.find('#')));
      std::vector<double> row;
      for (std::string word; words >> word;) row.push_back(std::strtod(word.c_str(), nullptr));
      if (!row.empty()) return row;
    }
    return {};
  }

 private:
  std::ifstream file_;
};

std::vector<Point> read_points(Lines& lines, int& first) {
  std::vector<Point> points(static_cast<std::size_t>(lines.next().at(0)));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::vector<double> row = lines.next();
    if (k == 0) first = static_cast<int>(row.at(0));
    points[k] = {row.at(1), row.at(2)};
  }
  return points;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  int first = 0;
  Lines poly(argv[1]), node(argv[2]), ele(argv[3]);
  const std::vector<Point> given = read_points(poly, first);
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> handles;
  for (const Point& p : given) handles.push_back(cdt.insert(p));
  std::map<std::pair<Point, Point>, bool> segments;  // by ends, both ways
  const auto count = static_cast<std::size_t>(poly.next().at(0));
  for (std::size_t k = 0; k < count; ++k) {
    const std::vector<double> row = poly.next();
    const auto a = static_cast<std::size_t>(row.at(1) - first),
               b = static_cast<std::size_t>(row.at(2) - first);
    cdt.insert_constraint(handles[a], handles[b]);
    segments[{given[a], given[b]}] = segments[{given[b], given[a]}] = true;
  }
  // The side from a to b is encroached where the corner left of it sees it at more than a right
  // angle.
  std::map<std::pair<Point, Point>, bool> encroached;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    for (int i = 0; i < 3; ++i) {
      if (!f->is_constrained(i)) continue;
      const Point apex = f->vertex(i)->point(), a = f->vertex(Cdt::ccw(i))->point(),
                  b = f->vertex(Cdt::cw(i))->point();
      encroached[{a, b}] = CGAL::angle(a, apex, b) == CGAL::OBTUSE;
    }
  }
  int ignored = 0, base = 0;
  const std::vector<Point> points = read_points(node, base);
  ignored = base;
  std::map<std::array<std::size_t, 2>, std::array<std::size_t, 2>> edges;  // directed: apex, region
  const auto triangles = static_cast<std::size_t>(ele.next().at(0));
  for (std::size_t k = 0; k < triangles; ++k) {
    const std::vector<double> row = ele.next();
    std::array<std::size_t, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = static_cast<std::size_t>(row.at(i + 1) - ignored);
    const auto region = row.size() > 4 ? static_cast<std::size_t>(row[4]) : 0;
    for (std::size_t i = 0; i < 3; ++i) edges[{v[i], v[(i + 1) % 3]}] = {v[(i + 2) % 3], region};
  }
  std::size_t inside = 0, sides = 0, by_input = 0, others = 0;
  for (const auto& [edge, of] : edges) {
    const Point a = points[edge[0]], b = points[edge[1]], c = points[of[0]];
    const auto twin = edges.find({edge[1], edge[0]});
    if (twin != edges.end() && twin->second[1] == of[1] && segments.count({a, b}) == 0) {
      if (edge[0] < edge[1] &&
          CGAL::side_of_oriented_circle(a, b, c, points[twin->second[0]]) == CGAL::ON_POSITIVE_SIDE)
        ++inside;
      continue;
    }
    ++sides;
    if (CGAL::angle(a, c, b) != CGAL::OBTUSE) continue;
    const auto known = encroached.find({a, b});
    (known != encroached.end() && known->second ? by_input : others) += 1;
  }
  std::printf("%zu %zu %zu %zu\n", inside, sides, by_input, others);
  return 0;
}
