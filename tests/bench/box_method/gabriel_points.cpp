// How many points CGAL's conformer adds until every segment's diametral disk is empty.
//
//   bench_gabriel INPUT [MOST]
//
// INPUT is what `cover mesh` reads; it is made clean first. All of the plane counts, the void too.
// Stops above MOST points (default 200,000) and prints "> MOST" then.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_conformer_2.h>
#include <fmt/core.h>

#include <cstdlib>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/read_input.hpp>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                         CGAL::Constrained_triangulation_face_base_2<Kernel>>>;

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::size_t most = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 200'000;
  const cover::Result<cover::Input> input = cover::read_input(argv[1]);
  if (!input) {
    fmt::print(stderr, "{}\n", input.error().message);
    return 1;
  }
  const cover::Result<cover::Prepared> prepared = cover::prepare(*input);
  if (!prepared) {
    fmt::print(stderr, "{}\n", prepared.error().message);
    return 1;
  }
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> vertices;
  for (const cover::Point p : prepared->pslg.points) vertices.push_back(cdt.insert({p.x, p.y}));
  for (const cover::Segment& s : prepared->pslg.segments)
    cdt.insert_constraint(vertices[s.a.index()], vertices[s.b.index()]);
  const std::size_t before = cdt.number_of_vertices();
  CGAL::Triangulation_conformer_2<Cdt> conformer(cdt);
  conformer.init_Gabriel();
  while (!conformer.is_conforming_done() && cdt.number_of_vertices() - before <= most)
    conformer.step_by_step_conforming_Gabriel();
  const std::size_t added = cdt.number_of_vertices() - before;
  fmt::print("{}{}\n", added > most ? "> " : "", added > most ? most : added);
  return 0;
}
