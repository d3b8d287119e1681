// All regions become a joined mesh whose vertices may leave the segments that they cut; what is
// left of it becomes cuts of the whole segments, and meshes of regions, again.
// Tested by tests/unit/cuts/after_meshing/thin_cuts_test.cpp.
#include "cuts/after_meshing/thin_cuts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/errors.hpp"
#include "base/run_all.hpp"
#include "cuts/after_meshing/join_regions.hpp"
#include "cuts/unite_pieces.hpp"
#include "geom/cotangent.hpp"
#include "geom/vector.hpp"
#include "mend/thin_mesh.hpp"
#include "sizes/size_field.hpp"
#include "tasks/begin_stage.hpp"
#include "tasks/errors_as_values.hpp"

namespace cover {
namespace {

/// Angles that are kept as they are, in parts of themselves: no rounding makes them too small.
constexpr double kSlack = 1 - 1e-9;

/// How the last obtuse triangles are mended.
struct Last {
  double part;                   ///< of smallest angles, that is kept there
  std::uint64_t times;           ///< as many places for each
  std::size_t most;              ///< if so many are left
  std::uint64_t part_of_places;  ///< one in so many of ThinCutsEffort::last, at most
};
/// Of the smallest angles, where nothing else mends what is left: with no limit at all triangles of
/// a few units in the last place came in between, whose angles are rounding's (110 degrees, where
/// none is obtuse but for it).
constexpr double kLeastPart = 1e-6;
constexpr std::array kLast{Last{0.2, 1, kNone, 2}, Last{kLeastPart, 1, kNone, 2},
                           Last{kLeastPart, 10, 6, 1}, Last{kLeastPart, 50, 3, 1}};
/// The same while there are all vertices, in turn, until no triangle is obtuse: needles come only
/// where nothing else mends. Of 48 sections through the ground in which a layer pinches out, half
/// have a smallest angle below 0.1 degrees then, with the least part alone below 0.0006, for a
/// third more time and as many obtuse triangles (2).
constexpr std::array kFirstParts{0.1, 1e-3, kLeastPart};
/// Of the smallest angles asked for, what thinning out may leave where right angles came first; or
/// else it leaves what there is.
constexpr double kKeptPart = 0.2;
/// For each of the last obtuse triangles: there are few, and each may be hard. With a ninth of it
/// combs whose slits are a thousandth wide keep 50, 19 and 26 in place of 13, 7 and 6; with ten
/// times as much in the end, where it is 6 or fewer, 0, 0 and 1 in place of 4, 6 and 2.
constexpr std::uint64_t kPlacesForTheLast = 100'000;

/// Places for each vertex, at most, each time that what is left is mended: in a small mesh there is
/// not more to be found: of nine hostile drawings of up to 230 vertices all end as without a limit,
/// in at most 10 s; nested squares some 1e-323 apart took 40 s for their 30. With a tenth of it
/// three keep one or two obtuse triangles more.
constexpr std::uint64_t kPlacesPerVertex = 10'000;

/// How many places are tried in all that is done.
struct ThinCutsEffort {
  ThinEffort thinning;
  std::uint64_t last;  ///< at most, for one way to mend the last triangles
};

ThinCutsEffort effort_in_large(Effort effort, std::size_t vertices) {
  switch (effort) {
    case Effort::fast:
      return {{30, 200'000 + 10 * vertices, {3'000, 300'000}}, 300'000};
    case Effort::normal:
      return {{1'000, 1'000'000 + 100 * vertices, {20'000, 3'000'000 + 500 * vertices}}, 3'000'000};
    case Effort::thorough:
      break;
  }
  return {{20'000, 8'000'000 + 1'000 * vertices, {100'000, 20'000'000}}, 20'000'000};
}

/// For a mesh of `all` vertices, so many of which are new.
ThinCutsEffort thin_cuts_effort(Effort effort, std::size_t all, std::size_t vertices) {
  ThinCutsEffort out = effort_in_large(effort, vertices);
  const std::uint64_t most = (effort == Effort::thorough ? 10 : 1) * kPlacesPerVertex * all;
  out.last = std::min(out.last, most);
  MendEffort& mending = out.thinning.mending;
  mending.places_at_most = std::min(mending.places_at_most, most);
  return out;
}

/// By region: no angle becomes smaller than the target, or than what there is; and where triangles
/// are obtuse, none becomes worse than the worst of all regions, however many it mends.
std::vector<WantedAngles> angles_of(const std::vector<RegionMesh>& meshes, const Options& options) {
  Angle least_nu = Angle::degrees(180);
  for (const RegionMesh& mesh : meshes) {
    if (mesh.report.quality.obtuse > 0)
      least_nu = std::min(least_nu, mesh.report.quality.largest_nu);
  }
  std::vector<WantedAngles> angles;
  for (const RegionMesh& mesh : meshes) {
    const double smallest =
        kSlack * std::min(mesh.report.quality.smallest, options.min_angle).in_radians();
    angles.push_back({smallest > 0 ? cot_of(smallest) : 0, 0, false});
    if (least_nu < Angle::degrees(90))
      angles.back().worst_cot = -cot_of(kSlack * least_nu.in_radians());
  }
  return angles;
}

/// Smaller angles in the regions around triangles that are bad by `angles`, down to a part of those
/// `asked`: right angles come first.
std::vector<WantedAngles> angles_for_the_last(const JoinedMesh& mesh, double part,
                                              const std::vector<WantedAngles>& asked,
                                              const std::vector<WantedAngles>& angles) {
  const MeshWithUndo now(mesh, angles);
  std::vector<bool> is_near(mesh.points.size(), false);
  for (const MeshWithUndo::Triangle& t : now.triangles()) {
    if (t.v[0] == kNone || t.cost == 0) continue;
    for (const std::uint32_t v : t.v) is_near[v] = true;
  }
  std::vector<WantedAngles> out = angles;
  for (const MeshWithUndo::Triangle& t : now.triangles()) {
    if (t.v[0] == kNone || (!is_near[t.v[0]] && !is_near[t.v[1]] && !is_near[t.v[2]])) continue;
    out[t.region].largest_cot =
        std::max(angles[t.region].largest_cot, asked[t.region].largest_cot / part);
  }
  return out;
}

/// By region, the cotangent of the smallest angle in `mesh`.
std::vector<double> smallest_cots(const JoinedMesh& mesh, std::size_t regions) {
  std::vector<double> cots(regions, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [i, j, k] = mesh.triangles[t];
    const Point a = mesh.points[i], b = mesh.points[j], c = mesh.points[k];
    const double largest = std::max({dot(b - a, c - a), dot(c - b, a - b), dot(a - c, b - c)});
    double& cot = cots[mesh.region[t]];
    cot = std::max(cot, largest / std::abs(cross(b - a, c - a)));
  }
  return cots;
}

/// Angles no smaller than those of `mesh`, or than a part of those `asked`.
void keep_what_is_reached(const JoinedMesh& mesh, const std::vector<WantedAngles>& asked,
                          std::vector<WantedAngles>& angles) {
  const std::vector<double> cots = smallest_cots(mesh, angles.size());
  for (std::size_t r = 0; r < angles.size(); ++r)
    angles[r].largest_cot = std::min(angles[r].largest_cot,
                                     std::max(asked[r].largest_cot / kKeptPart, cots[r] / kSlack));
}

/// Whether more couplings are negative.
bool has_more_couplings(const std::vector<RegionMesh>& before,
                        const std::vector<RegionMesh>& after) {
  const auto negative = [](const std::vector<RegionMesh>& meshes) {
    std::size_t count = 0;
    for (const RegionMesh& mesh : meshes) count += mesh.report.box.negative_couplings;
    return count;
  };
  return negative(after) > negative(before);
}

/// Whether promise 3 held in a region and does no longer: what stays obtuse is not asked how much.
bool loses_a_bound(const std::vector<RegionMesh>& before, const std::vector<RegionMesh>& after) {
  for (std::size_t r = 0; r < before.size(); ++r) {
    if (before[r].report.bound_held && !after[r].report.bound_held) return true;
  }
  return false;
}

constexpr std::string_view kNoneAway = "no vertices were taken away again: ";

/// What an earlier attempt said is not so any longer.
void forget_none_away(Report& report) {
  std::erase_if(report.notes, [](const Note& note) { return note.message.starts_with(kNoneAway); });
}

/// What cuts are there now, and what went.
void tell(const Pslg& pslg, std::size_t first, std::size_t before, std::size_t after,
          const Options& options, Report& report) {
  std::erase_if(report.notes, [](const Note& note) { return note.kind == Note::Kind::cut; });
  std::vector<Point> where(pslg.points.begin() + static_cast<std::ptrdiff_t>(first),
                           pslg.points.end());
  std::vector<Point> sorted = where;
  std::sort(sorted.begin(), sorted.end());
  std::erase_if(report.box_cuts, [&](const BoxCut& cut) {
    return !std::binary_search(sorted.begin(), sorted.end(), cut.at);
  });
  report.notes.push_back(
      {Note::Kind::cut, kVoid,
       fmt::format(
           "{} added on segments for --split-interfaces {:.6g}{}; {} new vertices became {} "
           "when those that no right angle needs were taken away",
           counted(where.size(), "point"), options.split_interfaces->in_degrees(),
           where.empty() ? "" : fmt::format(", the first at {}", describe(where.front())), before,
           after),
       std::move(where)});
}

/// What came of taking vertices away.
struct ThinTrial {
  std::size_t before = 0, after = 0;  ///< new vertices
  std::size_t bad = 0;                ///< obtuse triangles, once all is judged
  bool is_better = false;             ///< fewer obtuse triangles or vertices, before all is judged
  std::optional<Work> work;           ///< nothing: not what was asked for,
  std::string objection;              ///< for this reason, where it is better
};

/// The mesh of all regions, to be thinned out more than once.
class Thinning {
 public:
  /// `work` and `options` outlive this object.
  Thinning(const Work& work, const Options& options)
      : work_(work), options_(options), whole_(work) {
    const United united = unite_pieces(whole_.pslg, whole_.table, work.report.input_points);
    mesh_ = join_regions(work, whole_.pslg, united);
    for (const std::uint32_t v : sort_by_place(mesh_)) {
      if (v < united.number.size() && united.number[v] != kNone) fixed_.push_back(united.number[v]);
    }
  }

  [[nodiscard]] std::size_t new_vertices() const {
    return mesh_.points.size() - work_.report.input_points;
  }

  /// `mends_first`: bad triangles are mended in any way while there are all vertices.
  [[nodiscard]] ThinTrial run(bool mends_first, const std::stop_token& stop) const {
    ThinTrial trial;
    const std::size_t first = work_.report.input_points;
    trial.before = new_vertices();
    const std::vector<WantedAngles> asked = angles_of(work_.meshes, options_);
    std::vector<WantedAngles> angles = asked;
    ThinCutsEffort effort = thin_cuts_effort(options_.effort, mesh_.points.size(), trial.before);
    effort.thinning.mending.stop = stop;
    JoinedMesh start = mesh_;
    const std::size_t bad_before = MeshWithUndo(start, angles).bad();
    if (mends_first) angles = angles_after_mending(start, asked, effort);
    MeshWithUndo thinning(start, angles);
    std::size_t bad = thin_mesh(thinning, effort.thinning).after;
    JoinedMesh result = thinning.result(start);
    for (const Last& last : kLast) {
      if (bad == 0 || bad > last.most) continue;
      MeshWithUndo mending(result, angles_for_the_last(result, last.part, asked, angles));
      bad = mend_what_is_left(
                mending, {last.times * kPlacesForTheLast, effort.last / last.part_of_places, stop})
                .after;
      result = mending.result(result);
    }
    trial.after = result.points.size() - first;
    trial.is_better = bad < bad_before || (bad == bad_before && trial.after < trial.before);
    if (!stop.stop_requested() && trial.is_better) judge(result, trial);
    return trial;
  }

 private:
  /// Mends bad triangles of `mesh` in any way. Returns the angles that are kept from then on.
  static std::vector<WantedAngles> angles_after_mending(JoinedMesh& mesh,
                                                        const std::vector<WantedAngles>& asked,
                                                        const ThinCutsEffort& effort) {
    const MendEffort for_all{kPlacesForTheLast, effort.thinning.mending.places_at_most,
                             effort.thinning.mending.stop};
    std::vector<WantedAngles> angles = asked;
    for (const double part : kFirstParts) {
      angles = angles_for_the_last(mesh, part, asked, angles);
      MeshWithUndo mending(mesh, angles);
      mend_what_is_left(mending, for_all);
      mesh = mending.result(mesh);
      if (mending.bad() == 0) break;
    }
    keep_what_is_reached(mesh, asked, angles);
    return angles;
  }

  void judge(const JoinedMesh& result, ThinTrial& trial) const {
    Work thin = whole_;
    separate(result, fixed_, thin);
    if (!is_sound(thin)) {
      trial.objection = "rounding would break a region";
      return;
    }
    measure_again(thin, options_);
    trial.objection = what_is_worse(work_.meshes, thin.meshes, options_);
    if (!trial.objection.empty()) return;
    trial.bad = obtuse_triangles(thin.meshes);
    trial.work = std::move(thin);
  }

  const Work& work_;
  const Options& options_;
  Work whole_;  ///< segments are whole
  JoinedMesh mesh_;
  std::vector<std::uint32_t> fixed_;  ///< by fixed vertex of mesh_: its number in the PSLG
};

/// Whether bad triangles are mended before vertices are taken away, in turn. What mends first comes
/// first: it has fewer to mend in the end, which takes the longest, and often leaves none.
constexpr std::array kMendsFirst{true, false};
/// The second attempt goes another way. Of 9 hostile drawings and combs where the first left up to
/// so many triangles, it left none once and as many or more 8 times. Of 9 where the first left
/// more, it left a fourth fewer once, in as much time again.
constexpr std::size_t kTriedAgain = 6;
/// Nor is it made where there were more new vertices: with 9,000 on Voronoi cells, where the first
/// attempt left 1, 2 and 3 triangles, it left as many or more, in half as much time again.
constexpr std::size_t kMostTriedAgain = 5'000;

using TrialOrError = Result<ThinTrial>;

/// Whether another attempt is of no use: no triangle is bad, too many are, or nothing was better.
bool settles(const TrialOrError& trial) {
  if (!trial || !trial->is_better) return true;
  return trial->work && (trial->bad == 0 || trial->bad > kTriedAgain);
}

/// The attempts up to the first that settles it, both at a time if there are threads for it: what
/// the later one has done is of no use then, and no matter.
std::vector<TrialOrError> trials_of(const Thinning& thinning, const Options& options,
                                    const std::stop_token& stop) {
  const std::size_t attempts = thinning.new_vertices() > kMostTriedAgain ? 1 : kMendsFirst.size();
  std::array<std::optional<TrialOrError>, kMendsFirst.size()> made;
  std::array<std::stop_source, kMendsFirst.size()> ends;
  const auto end_from = [&](std::size_t first) {
    for (std::size_t k = first; k < ends.size(); ++k) ends[k].request_stop();
  };
  const std::stop_callback on_stop(stop, [&] { end_from(0); });
  run_all(attempts, worker_count(options.threads), [&](std::size_t k) {
    if (ends[k].stop_requested()) return;
    made[k] = errors_as_values("thin out", [&]() -> TrialOrError {
      return thinning.run(kMendsFirst[k], ends[k].get_token());
    });
    if (settles(*made[k])) end_from(k + 1);
  });
  std::vector<TrialOrError> trials;
  for (std::size_t k = 0; k < made.size() && made[k]; ++k) {
    trials.push_back(*std::move(made[k]));
    if (settles(trials.back())) break;
  }
  return trials;
}

}  // namespace

std::size_t obtuse_triangles(const std::vector<RegionMesh>& meshes) {
  std::size_t count = 0;
  for (const RegionMesh& mesh : meshes) count += mesh.report.quality.obtuse;
  return count;
}

std::string what_is_worse(const std::vector<RegionMesh>& before,
                          const std::vector<RegionMesh>& after, const Options& options) {
  if (const std::size_t left = obtuse_triangles(after); left > obtuse_triangles(before))
    return counted(left, "triangle") + " would be obtuse";
  if (options.box_method && has_more_couplings(before, after))
    return "more couplings would be negative";
  return loses_a_bound(before, after) ? "a region would lose its bound" : "";
}

bool wants_thinning(const Prepared& prepared, const std::vector<RegionBoundary>& boundaries,
                    const Options& options) {
  const Pslg& pslg = prepared.pslg;
  return options.split_interfaces && options.method == Method::quality &&
         options.max_angle == Angle::degrees(90) && options.layers.empty() && !options.growth &&
         prepared.table.hull_sides.empty() && pslg.periodic.empty() &&
         std::none_of(boundaries.begin(), boundaries.end(),
                      [&](const RegionBoundary& b) { return has_sizes(b, options); });
}

Status thin_cuts(Work& work, const Options& options, const Callbacks& callbacks) {
  if (!wants_thinning(work, work.boundaries, options)) return ok();
  if (Status status = begin_stage("thin", callbacks); !status) return status;
  return errors_as_values("thin out", [&]() -> Status {
    const Thinning thinning(work, options);
    std::vector<TrialOrError> trials = trials_of(thinning, options, callbacks.stop);
    if (callbacks.stop.stop_requested()) return interrupted();
    std::optional<ThinTrial> best;
    std::string objection;
    for (TrialOrError& trial : trials) {
      if (!trial) return std::move(trial).error();
      if (!trial->work) {
        if (objection.empty()) objection = std::move(trial->objection);
      } else if (!best || trial->bad < best->bad) {
        best = *std::move(trial);
      }
    }
    if (best) {
      work = *std::move(best->work);
      forget_none_away(work.report);
      tell(work.pslg, work.report.input_points, best->before, best->after, options, work.report);
      return ok();
    }
    if (objection.empty()) return ok();
    forget_none_away(work.report);
    work.report.notes.push_back(
        {Note::Kind::warning, kVoid, std::string(kNoneAway) + objection, {}});
    return ok();
  });
}

}  // namespace cover
