// Two ways, both ending with a PSLG whose segments are cut and with regions that put no further
// point on them:
//  - every region is packed for itself; its points on chords become cuts. Only where no segment has
//    regions on both sides, since they would put different points on it;
//  - disks on all segments come first, for all regions together; the cuts are their centres and
//    tangency points, and every region is packed between them.
// (Uniting the points of both sides instead, and joining them to the opposite vertices, would keep
// the mesh conforming but not nonobtuse.)
// Tested by tests/unit/nonobtuse/nonobtuse_test.cpp.
#include "nonobtuse/nonobtuse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "almond/almond_region.hpp"
#include "base/stage_clock.hpp"
#include "cdt/region_cdt.hpp"
#include "cuts/cut_segments.hpp"
#include "disks/fill_disks.hpp"
#include "disks/segment_disks.hpp"
#include "geom/curves/arc.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"
#include "region/whole_mesh.hpp"
#include "target/angle_limit.hpp"
#include "target/report/fill_report.hpp"
#include "tasks/for_each_region.hpp"

namespace cover {
namespace {

FillTask task_of(const RegionBoundary& boundary) {
  FillTask task;
  task.points = boundary.points;
  for (const auto& [a, b] : boundary.sides) task.chords.push_back({a, b, false});
  return task;
}

using Obstacle = disks::SegmentDisks::Obstacle;
using PslgEnds = std::array<Point, 2>;

/// Spacings of the coordinates: the smallest radius of a disk whose centre and ends stay apart.
constexpr double kSmallest = 8;

/// Whether some segment has regions on both sides.
bool shares_segments(const RegionTable& table) {
  return std::any_of(table.sides.begin(), table.sides.end(),
                     [](const SegmentSides& s) { return s.left != kVoid && s.right != kVoid; });
}

class Nonobtuse {
 public:
  Nonobtuse(Work& work, const Options& options, const Callbacks& callbacks)
      : work_(work),
        options_(options),
        callbacks_(callbacks),
        fillings_(work.boundaries.size()),
        flaws_(work.boundaries.size()),
        packings_(callbacks.packing ? work.boundaries.size() : 0) {
    work.meshes.resize(work.boundaries.size());
  }

  Status run() {
    Status status = shares_segments(work_.table) ? pack_between_segments() : pack_apart();
    if (!status) return status;
    for (std::size_t r = 0; r < packings_.size(); ++r)
      callbacks_.packing(work_.boundaries[r].id, packings_[r]);
    return ok();
  }

 private:
  [[nodiscard]] DiskFillOptions fill_options(std::size_t r) {
    return {.record = packings_.empty() ? nullptr : &packings_[r]};
  }

  Status for_each(const std::function<void(std::size_t)>& task) {
    return for_each_region(work_.boundaries, worker_count(options_), "mesh", callbacks_, task);
  }

  /// Every region for itself.
  Status pack_apart() {
    Status status = for_each([&](std::size_t r) {
      const StageClock clock;
      fillings_[r] =
          make_disk_filler(fill_options(r))->fill(task_of(work_.boundaries[r]), callbacks_.stop);
      work_.meshes[r].report.seconds = clock.seconds();
    });
    if (!status) return status;
    const std::vector<std::vector<VertexId>> ids = cut_at_splits();
    const std::vector<RegionBoundary> before =
        std::exchange(work_.boundaries, split_regions(work_.pslg, work_.table));
    for (std::size_t r = 0; r < before.size(); ++r) renumber(before[r], ids[r], r);
    status = for_each([&](std::size_t r) { finish(r); });
    return status ? first_flaw() : status;
  }

  /// Cuts the segments at what the fillings put on them. Returns, by region, the PSLG vertex of
  /// every added vertex that lies on a chord, in the order of Filling::splits.
  std::vector<std::vector<VertexId>> cut_at_splits() {
    struct Origin {
      std::size_t region;
      const ChordSplit* split;
      bool forward;
    };
    std::vector<std::pair<SegmentCut, Origin>> cuts;
    for (std::size_t r = 0; r < fillings_.size(); ++r) {
      const RegionBoundary& boundary = work_.boundaries[r];
      for (const ChordSplit& split : fillings_[r].splits) {
        SegmentCut cut{boundary.segments[split.chord], {}};
        for (const std::uint32_t v : split.vertices) {
          cut.points.push_back(fillings_[r].added[v - boundary.points.size()]);
        }
        const bool forward = boundary.vertices[boundary.sides[split.chord][0]] ==
                             work_.pslg.segments[cut.segment.index()].a;
        if (!forward) std::reverse(cut.points.begin(), cut.points.end());
        cuts.emplace_back(std::move(cut), Origin{r, &split, forward});
      }
    }
    std::sort(cuts.begin(), cuts.end(),
              [](const auto& x, const auto& y) { return x.first.segment < y.first.segment; });
    std::vector<std::vector<VertexId>> ids(fillings_.size());
    for (std::size_t r = 0; r < ids.size(); ++r) ids[r].resize(fillings_[r].added.size());
    std::size_t next = work_.pslg.points.size();
    std::vector<SegmentCut> plain;
    for (auto& [cut, origin] : cuts) {
      const std::size_t n = cut.points.size();
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t place = origin.forward ? k : n - 1 - k;
        ids[origin.region][origin.split->vertices[k] -
                           work_.boundaries[origin.region].points.size()] = VertexId{next + place};
      }
      next += n;
      plain.push_back(std::move(cut));
    }
    cut_segments(work_.pslg, work_.table, plain);
    return ids;
  }

  /// Puts filling `r`, made over `before`, over the new boundary.
  void renumber(const RegionBoundary& before, const std::vector<VertexId>& ids, std::size_t r) {
    const RegionBoundary& after = work_.boundaries[r];
    std::vector<std::pair<VertexId, std::uint32_t>> local;
    for (std::uint32_t k = 0; k < after.vertices.size(); ++k)
      local.push_back({after.vertices[k], k});
    std::sort(local.begin(), local.end());
    const auto local_of = [&](VertexId v) {
      return std::lower_bound(local.begin(), local.end(), std::pair(v, 0U))->second;
    };
    const Filling& filling = fillings_[r];
    std::vector<std::uint32_t> to;
    for (const VertexId v : before.vertices) to.push_back(local_of(v));
    std::vector<bool> on_chord(filling.added.size(), false);
    for (const ChordSplit& split : filling.splits) {
      for (const std::uint32_t v : split.vertices) on_chord[v - before.points.size()] = true;
    }
    for (std::size_t k = 0; k < filling.added.size(); ++k) {
      if (on_chord[k]) {
        to.push_back(local_of(ids[k]));
      } else {
        to.push_back(
            static_cast<std::uint32_t>(after.points.size() + work_.meshes[r].steiner.size()));
        work_.meshes[r].steiner.push_back(filling.added[k]);
      }
    }
    for (const auto& t : filling.triangles)
      work_.meshes[r].triangles.push_back({to[t[0]], to[t[1]], to[t[2]]});
  }

  /// Disks on all segments first.
  Status pack_between_segments() {
    std::vector<IndexPair> segments;
    std::vector<SegmentId> ids;
    for (std::size_t s = 0; s < work_.pslg.segments.size(); ++s) {
      if (work_.table.sides[s].left == kVoid && work_.table.sides[s].right == kVoid) continue;
      segments.push_back({work_.pslg.segments[s].a.value(), work_.pslg.segments[s].b.value()});
      ids.emplace_back(s);
    }
    // Ordinary input needs 3 to 10 per segment.
    const std::size_t limit = 100 * segments.size() + 100'000;
    const double smallest = kSmallest * spacing_of_coordinates();
    const disks::SegmentDisks disks =
        disks::cover_segments(work_.pslg.points, segments, smallest, limit);
    const Segment* const crowded = disks.obstacle == Obstacle::none
                                       ? nullptr
                                       : &work_.pslg.segments[ids[disks.crowded].index()];
    if (disks.obstacle == Obstacle::too_many) return too_close(*crowded, limit);
    if (disks.obstacle == Obstacle::too_small) return too_small(*crowded, smallest);

    std::vector<double> radius = disks.radius;
    std::vector<SegmentCut> cuts;
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const auto& [a, b] = segments[k];
      const Point from = work_.pslg.points[a];
      const Vector along = work_.pslg.points[b] - from;
      const Vector direction = (1 / length(along)) * along;
      SegmentCut cut{ids[k], {from + disks.radius[a] * direction}};
      radius.push_back(0);
      for (const disks::DiskOnSegment& disk : disks.chain[k]) {
        cut.points.push_back(disk.centre);
        cut.points.push_back(disk.centre + disk.radius * direction);
        radius.push_back(disk.radius);
        radius.push_back(0);
      }
      cuts.push_back(std::move(cut));
    }
    cut_segments(work_.pslg, work_.table, cuts);
    work_.boundaries = split_regions(work_.pslg, work_.table);
    Status status = for_each([&](std::size_t r) {
      const StageClock clock;
      const RegionBoundary& boundary = work_.boundaries[r];
      flaws_[r] = find_flaw(triangulate_domain(boundary.points, boundary.sides), boundary.points,
                            boundary.sides);
      if (flaws_[r]) return;
      std::vector<double> local;
      for (const VertexId v : work_.boundaries[r].vertices) local.push_back(radius[v.index()]);
      fillings_[r] =
          fill_between_disks(task_of(work_.boundaries[r]), local, callbacks_.stop, fill_options(r));
      work_.meshes[r].steiner = fillings_[r].added;
      work_.meshes[r].triangles = fillings_[r].triangles;
      finish(r);
      work_.meshes[r].report.seconds = clock.seconds();
    });
    return status ? first_flaw() : status;
  }

  /// The region that rounding broke, if there is one.
  [[nodiscard]] Status first_flaw() const {
    for (std::size_t r = 0; r < flaws_.size(); ++r) {
      if (!flaws_[r]) continue;
      return Error{ErrorCode::meshing_incomplete,
                   fmt::format("method nonobtuse: region {} needs points on its segments that are "
                               "nearer to each other than coordinates can tell: {}; use another "
                               "method",
                               work_.boundaries[r].id.value(), flaws_[r]->what),
                   flaws_[r]->where,
                   {}};
    }
    return ok();
  }

  /// The distance of doubles at the largest coordinate.
  [[nodiscard]] double spacing_of_coordinates() const { return spacing_of(work_.pslg.points); }

  [[nodiscard]] static Error at_segment(const PslgEnds& ends, const std::string& why) {
    return {ErrorCode::meshing_incomplete,
            fmt::format("method nonobtuse: several regions share segments, and these come so close "
                        "to each other that {}, most near the segment from {} to {}; use another "
                        "method, or mesh the regions one by one",
                        why, describe(ends[0]), describe(ends[1])),
            {ends[0], ends[1]},
            {}};
  }

  [[nodiscard]] Error too_small(const Segment& segment, double smallest) const {
    return at_segment(ends_of(segment),
                      fmt::format("disks smaller than {} would be needed on them, which rounded "
                                  "coordinates cannot hold",
                                  describe_roughly(smallest)));
  }

  [[nodiscard]] PslgEnds ends_of(const Segment& segment) const {
    return {work_.pslg.points[segment.a.index()], work_.pslg.points[segment.b.index()]};
  }

  [[nodiscard]] Error too_close(const Segment& segment, std::size_t limit) const {
    return at_segment(ends_of(segment),
                      fmt::format("more than {} disks would be needed on them", limit));
  }

  /// Bounds, figures and notes of a region.
  void finish(std::size_t r) {
    const RegionBoundary& boundary = work_.boundaries[r];
    RegionMesh& mesh = work_.meshes[r];
    mesh.report.id = boundary.id;
    mesh.report.method = "nonobtuse";
    const CdtResult cdt = triangulate_domain(boundary.points, boundary.sides);
    flaws_[r] = find_flaw(cdt, boundary.points, boundary.sides);
    if (flaws_[r]) return;
    set_bound(angle_limit(cdt.triangulation, boundary.sides, boundary.segments), mesh.report);
    if (!fillings_[r].target_reached) {
      mesh.report.notes.push_back(
          {Note::Kind::target_missed,
           boundary.id,
           fmt::format("region {}: {}", boundary.id.value(), fillings_[r].remark),
           {}});
    }
    flaws_[r] = find_flaw(boundary, mesh);
    fill_report(boundary, mesh);
    if (!flaws_[r] && !mesh.report.bound_held) fall_back(r);
  }

  /// Rounding left an angle beyond the bound, which almonds between the same points hold.
  void fall_back(std::size_t r) {
    RegionMesh almonds = almond_region(work_.boundaries[r], options_, callbacks_.stop);
    RegionMesh& mesh = work_.meshes[r];
    fill_report(work_.boundaries[r], almonds);
    if (almonds.report.bound_held && !find_flaw(work_.boundaries[r], almonds)) {
      for (Note& note : mesh.report.notes) {
        if (note.kind == Note::Kind::bound_missed) continue;
        note.message += "; the almond method, which holds the bound, made this region";
        almonds.report.notes.push_back(std::move(note));
      }
      mesh = std::move(almonds);
      return;
    }
    for (Note& note : mesh.report.notes) {
      if (note.kind == Note::Kind::bound_missed)
        note.message += fmt::format(": {}; use another method", fillings_[r].remark);
    }
  }

  Work& work_;
  const Options& options_;
  const Callbacks& callbacks_;
  std::vector<Filling> fillings_;
  std::vector<std::optional<Flaw>> flaws_;  ///< by region: what rounding broke
  std::vector<PackingRecord> packings_;     ///< empty where nobody asks for them
};

}  // namespace

Status mesh_nonobtuse(Work& work, const Options& options, const Callbacks& callbacks) {
  if (options.hull) {
    return Error{ErrorCode::bad_option,
                 "method nonobtuse cannot be combined with hull: it splits the boundary itself",
                 {},
                 {}};
  }
  for (Segment& s : work.pslg.segments) straighten(s);  // disks lie on chords
  return Nonobtuse(work, options, callbacks).run();
}

}  // namespace cover
