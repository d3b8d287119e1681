// Between two walls that are a thousandth or a millionth of their length apart a cut of one is a
// cut of the other, and what is right on one side is hardly ever so on the other: no search finds
// both at once. As a line, a cleft is a segment like any other.
// Tested by tests/unit/cuts/after_meshing/mesh_with_closed_clefts_test.cpp.
#include "cuts/after_meshing/mesh_with_closed_clefts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/containers/order.hpp"
#include "base/faults/errors.hpp"
#include "cuts/after_meshing/cut_until_met.hpp"
#include "cuts/after_meshing/effort.hpp"
#include "cuts/after_meshing/join_regions.hpp"
#include "cuts/after_meshing/thin_cuts.hpp"
#include "cuts/before_meshing/split_interfaces.hpp"
#include "cuts/clefts/closed_clefts.hpp"
#include "cuts/unite_pieces.hpp"
#include "mend/thin_mesh.hpp"
#include "region/region_graph.hpp"
#include "tasks/begin_stage.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/mesh_regions.hpp"

namespace cover {
namespace {

/// Whether so many triangles are obtuse that halving segments was in vain. A few are mended where
/// they are, with fewer vertices.
bool misses_nearly_everywhere(const Work& work) {
  return 2 * obtuse_triangles(work.meshes) > work.report.input_points;
}

/// Cuts segments and meshes regions as it is done without clefts.
Status mesh_closed(Work& work, const Options& options, const std::stop_token& stop) {
  Callbacks quiet;
  quiet.stop = stop;
  std::vector<Note> notes;
  if (Status status = split_interfaces(work.pslg, work.table, options, notes); !status)
    return status;
  work.boundaries = split_regions(work.pslg, work.table);
  Result<std::vector<RegionMesh>> meshes = mesh_regions(work.boundaries, options, quiet);
  if (!meshes) return std::move(meshes).error();
  work.meshes = *std::move(meshes);
  return cut_until_met(work, options, quiet);
}

/// The mesh of closed clefts in one.
JoinedMesh joined(const ClosedClefts& closed) {
  Pslg uncut = closed.work.pslg;
  RegionTable table = closed.work.table;
  const United united = unite_pieces(uncut, table, closed.point_before.size());
  return join_regions(closed.work, uncut, united);
}

/// The same without the obtuse triangles that a few more vertices mend. Points that came before any
/// region was meshed have the numbers they had, and stay where they are, as ends of clefts need
/// them there.
JoinedMesh mended(JoinedMesh mesh, const ClosedClefts& closed, const std::stop_token& stop) {
  const Work& work = closed.work;
  const auto given = static_cast<std::ptrdiff_t>(work.report.input_points);
  const std::vector<std::uint32_t> lines(mesh.line.begin(), mesh.line.begin() + given);
  std::fill(mesh.line.begin(), mesh.line.begin() + given, JoinedMesh::kFixed);
  std::vector<std::uint32_t> fixed = sort_by_place(mesh);
  std::erase_if(fixed, [&](std::uint32_t v) { return v >= lines.size(); });

  MeshWithUndo mending(mesh, std::vector<WantedAngles>(work.meshes.size()));
  const MendEffort effort{effort::cuts::kPlacesBesideClefts, effort::cuts::kMostPlacesBesideClefts,
                          stop};
  thin_mesh(mending, {0, 0, effort});
  mend_what_is_left(mending, effort);
  mesh = mending.result(mesh);

  auto next_fixed = fixed.begin();
  auto next = static_cast<std::uint32_t>(lines.size());
  std::vector<std::uint32_t> number;
  for (const std::uint32_t line : mesh.line)
    number.push_back(line == JoinedMesh::kFixed ? *next_fixed++ : next++);
  renumber(number, mesh);
  std::copy(lines.begin(), lines.end(), mesh.line.begin());
  return mesh;
}

/// Puts `opened` into `whole`, whose segments are whole; false if a region would be broken.
bool take(OpenedClefts opened, const Options& options, Work& whole) {
  const std::size_t points = whole.pslg.points.size();
  std::vector<std::uint32_t> fixed = sort_by_place(opened.mesh);
  const std::vector<std::uint32_t> number = places_in(fixed);
  for (FollowedVertex& pair : opened.pairs)
    pair = {number[pair.first], number[pair.other], pair.right_at_first};
  ease(opened.pairs, opened.mesh);
  std::erase_if(fixed, [&](std::uint32_t v) { return v >= points; });
  separate(opened.mesh, fixed, whole);
  std::erase_if(whole.report.notes, [](const Note& note) { return note.kind == Note::Kind::cut; });
  if (!is_sound(whole)) return false;
  measure_again(whole, options);
  return true;
}

}  // namespace

Status mesh_with_closed_clefts(Work& work, const Options& options, const Callbacks& callbacks) {
  // What is cut for boxes is told cut by cut, and stays. Walls are straight.
  if (options.box_method || !work.pslg.circles.empty() ||
      !wants_thinning(work, work.boundaries, options) || !misses_nearly_everywhere(work))
    return ok();
  return errors_as_values("close clefts", [&]() -> Status {
    Work whole = work;
    unite_pieces(whole.pslg, whole.table, work.report.input_points);
    const std::vector<Cleft> clefts =
        find_clefts(whole.pslg, whole.table, split_regions(whole.pslg, whole.table));
    if (2 * effort::cuts::kCornersOfCleft * clefts.size() < work.report.input_points) return ok();
    std::optional<ClosedClefts> closed = close_clefts(whole, clefts);
    if (!closed) return ok();
    if (Status status = begin_stage("cut", callbacks); !status) return status;
    if (Status status = mesh_closed(closed->work, options, callbacks.stop); !status) return status;
    const JoinedMesh mesh = joined(*closed);
    std::optional<OpenedClefts> opened =
        open_clefts(mended(mesh, *closed, callbacks.stop), *closed, whole);
    // What mends may come nearer to a wall than the other one will be.
    if (!opened) opened = open_clefts(mesh, *closed, whole);
    if (callbacks.stop.stop_requested()) return interrupted();
    if (opened && take(*std::move(opened), options, whole)) work = std::move(whole);
    return ok();
  });
}

}  // namespace cover
