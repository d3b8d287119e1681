// Passes over the regions that changed: every side that its apex sees at too large an angle marks
// its segment; then all marked segments are cut at once, each at the foot of its apex: the apex and
// the pieces then make right triangles, and where walls are parallel a structured grid comes of it.
// Half way instead, thin layers with vertices that do not face each other take 10 to 200 times the
// points; and feet need no care at sharp corners, where they end with a fan of right triangles.
// What is only too long, or to be seen at less than 90 degrees, is cut half way. Tested by
// tests/unit/quality/sizes_test.cpp.
#include "quality/split_interfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "base/describe.hpp"
#include "cdt/cdt.hpp"
#include "covering/angle_limit.hpp"
#include "geom/vector.hpp"
#include "quality/sizes.hpp"
#include "region/cut_segments.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

constexpr int kPasses = 64;
constexpr double kFloor = 0x1p-10;      ///< of its segment: the shortest half that is cut in two
constexpr double kFootFloor = 0x1p-40;  ///< of its segment: the shortest piece beside a foot
constexpr double kLongPiece = 1.5;      ///< times the wished size: is cut
constexpr double kRounding = 1e-9;      ///< radians
constexpr std::size_t kPlaces = 8;

/// What the regions on both sides of a segment want.
struct Wish {
  bool cut = false;
  double nu = std::numbers::pi;  ///< of the worst angle forced on it
  Point apex;                    ///< sees it at that angle
};

class Splitter {
 public:
  Splitter(Pslg& pslg, RegionTable& table, const Options& options)
      : pslg_(pslg),
        table_(table),
        options_(options),
        least_nu_(options.split_interfaces->supplement().in_radians() - kRounding),
        dirty_(table.regions.size(), 1) {
    for (const Segment& s : pslg.segments) whole_.push_back(length_of(s));
  }

  Status run(std::vector<Note>& notes) {
    const std::size_t before = pslg_.points.size();
    for (int pass = 0; pass < kPasses; ++pass) {
      Result<std::vector<SegmentCut>> cuts = find_cuts();
      if (!cuts) return std::move(cuts).error();
      if (cuts->empty()) break;
      apply(*cuts);
    }
    tell(before, notes);
    return ok();
  }

 private:
  [[nodiscard]] Point at(VertexId v) const { return pslg_.points[v.index()]; }
  [[nodiscard]] double length_of(const Segment& s) const { return length(at(s.b) - at(s.a)); }

  /// One cut for every segment that a region that changed wants shorter.
  Result<std::vector<SegmentCut>> find_cuts() {
    std::vector<RegionBoundary> boundaries = split_regions(pslg_, table_);
    if (Status status = resolve_sizes(pslg_, table_, options_, boundaries); !status) {
      return std::move(status).error();
    }
    wishes_.assign(pslg_.segments.size(), {});
    for (std::size_t r = 0; r < boundaries.size(); ++r) {
      if (dirty_[r] != 0) wish(boundaries[r]);
    }
    std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{0});
    std::vector<SegmentCut> cuts;
    stuck_.clear();
    for (std::size_t s = 0; s < wishes_.size(); ++s) {
      if (!wishes_[s].cut) continue;
      const Segment& segment = pslg_.segments[s];
      if (const auto place = place_on(segment, wishes_[s], whole_[s])) {
        cuts.push_back({SegmentId{s}, {*place}});
      } else {
        stuck_.push_back(midpoint(at(segment.a), at(segment.b)));
      }
    }
    return cuts;
  }

  /// Notes which sides of a region need a cut, and where.
  void wish(const RegionBoundary& boundary) {
    const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
    const AngleLimit limit = angle_limit(cdt, boundary.sides, boundary.segments);
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      if (boundary.segments[s] == kHullSide) continue;
      const bool forced = limit.side_nu[s] < least_nu_;
      if (!forced && !is_long(boundary, s)) continue;
      Wish& wish = wishes_[boundary.segments[s].index()];
      wish.cut = true;
      if (!forced || limit.side_nu[s] > wish.nu) continue;
      const EdgeRef& at = limit.at[s];
      const Point apex = cdt.points[cdt.triangles[at.triangle].v[at.edge]];
      if (limit.side_nu[s] == wish.nu && wish.apex < apex) continue;
      wish.nu = limit.side_nu[s];
      wish.apex = apex;
    }
  }

  [[nodiscard]] static bool is_long(const RegionBoundary& boundary, std::size_t s) {
    if (boundary.size_at.empty()) return false;
    const auto& [a, b] = boundary.sides[s];
    double wished = boundary.size_at[a];
    if (wished == 0 || (boundary.size_at[b] > 0 && boundary.size_at[b] < wished)) {
      wished = boundary.size_at[b];
    }
    return wished > 0 && length(boundary.points[b] - boundary.points[a]) > kLongPiece * wished;
  }

  /// Where to cut a piece of a segment that is `whole` long; nothing if pieces would be too short.
  [[nodiscard]] std::optional<Point> place_on(const Segment& piece, const Wish& wish,
                                              double whole) const {
    const Point a = at(piece.a), b = at(piece.b);
    if (wish.nu > std::numbers::pi / 2 - kRounding) {
      if (length_of(piece) < 2 * kFloor * whole) return std::nullopt;
      return midpoint(a, b);
    }
    const Vector along = b - a;
    const double from_a = dot(wish.apex - a, along) / squared_length(along);
    const double from_b = dot(wish.apex - b, along) / squared_length(along);
    const Point foot = from_a <= 0.5 ? a + from_a * along : b + from_b * along;
    const double shorter = std::min(length(foot - a), length(foot - b));
    return shorter > kFootFloor * whole ? std::optional(foot) : std::nullopt;
  }

  void apply(const std::vector<SegmentCut>& cuts) {
    std::vector<double> whole;
    auto cut = cuts.begin();
    for (std::size_t s = 0; s < whole_.size(); ++s) {
      whole.push_back(whole_[s]);
      if (cut == cuts.end() || cut->segment.index() != s) continue;
      whole.insert(whole.end(), cut->points.size(), whole_[s]);
      for (const RegionId r : {table_.sides[s].left, table_.sides[s].right}) {
        if (r != kVoid) dirty_[r.index() - 1] = 1;
      }
      ++cut;
    }
    whole_ = std::move(whole);
    cut_segments(pslg_, table_, cuts);
  }

  void tell(std::size_t before, std::vector<Note>& notes) const {
    const auto degrees = options_.split_interfaces->in_degrees();
    if (pslg_.points.size() > before) {
      std::vector<Point> where(pslg_.points.begin() + static_cast<std::ptrdiff_t>(before),
                               pslg_.points.end());
      where.resize(std::min(where.size(), kPlaces));
      notes.push_back({Note::Kind::change, kVoid,
                       fmt::format("segments cut for --split-interfaces {:.6g}: {} added, the "
                                   "first at {}",
                                   degrees, counted(pslg_.points.size() - before, "point"),
                                   describe(where.front())),
                       std::move(where)});
    }
    if (stuck_.empty()) return;
    std::vector<Point> where = stuck_;
    where.resize(std::min(where.size(), kPlaces));
    notes.push_back({Note::Kind::warning, kVoid,
                     fmt::format("{} would have to be cut too short to force no angle above {:.6g} "
                                 "degrees, the first near {}",
                                 counted(stuck_.size(), "segment"), degrees, describe(where[0])),
                     std::move(where)});
  }

  Pslg& pslg_;
  RegionTable& table_;
  const Options& options_;
  double least_nu_;
  std::vector<Wish> wishes_;         ///< by segment
  std::vector<std::uint8_t> dirty_;  ///< by region
  std::vector<double> whole_;        ///< by segment: length of the segment it is a piece of
  std::vector<Point> stuck_;
};

}  // namespace

Status split_interfaces(Pslg& pslg, RegionTable& table, const Options& options,
                        std::vector<Note>& notes) {
  if (!options.split_interfaces) return ok();
  return Splitter(pslg, table, options).run(notes);
}

}  // namespace cover
