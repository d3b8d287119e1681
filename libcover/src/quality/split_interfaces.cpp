// Passes over the regions that changed: every side that its apex sees at too large an angle marks
// its segment; then all marked segments are cut at once. A cut lies half way; where a segment meets
// another one sharply at one end, at a distance from there that is a power of two, so that pieces
// of both come to lie on the same circles around the corner and stop cutting each other (concentric
// shells). Tested by tests/unit/quality/sizes_test.cpp.
#include "quality/split_interfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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
constexpr double kFloor = 0x1p-10;  ///< of its segment: the shortest piece
constexpr double kLongPiece = 1.5;  ///< times the wished size: is cut
constexpr double kSharp = 60;       ///< degrees: segments that meet below this use shells
constexpr double kRounding = 1e-9;  ///< radians
constexpr std::size_t kPlaces = 8;

class Splitter {
 public:
  Splitter(Pslg& pslg, RegionTable& table, const Options& options)
      : pslg_(pslg),
        table_(table),
        options_(options),
        least_nu_(options.split_interfaces->supplement().in_radians() - kRounding),
        dirty_(table.regions.size(), 1) {
    for (const Segment& s : pslg.segments) whole_.push_back(length_of(s));
    find_sharp_points();
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
  [[nodiscard]] bool is_sharp(VertexId v) const {
    return v.index() < sharp_.size() && sharp_[v.index()] != 0;
  }

  /// Marks the points at which two segments meet below kSharp.
  void find_sharp_points() {
    std::vector<std::vector<double>> directions(pslg_.points.size());
    for (const Segment& s : pslg_.segments) {
      const Vector d = at(s.b) - at(s.a);
      directions[s.a.index()].push_back(std::atan2(d.y, d.x));
      directions[s.b.index()].push_back(std::atan2(-d.y, -d.x));
    }
    sharp_.assign(pslg_.points.size(), 0);
    for (std::size_t v = 0; v < directions.size(); ++v) {
      auto& angles = directions[v];
      std::sort(angles.begin(), angles.end());
      for (std::size_t k = 0; k < angles.size() && angles.size() > 1; ++k) {
        const double next =
            k + 1 < angles.size() ? angles[k + 1] : angles[0] + 2 * std::numbers::pi;
        if (next - angles[k] < kSharp * std::numbers::pi / 180) sharp_[v] = 1;
      }
    }
  }

  /// One cut for every segment that a region that changed wants shorter.
  Result<std::vector<SegmentCut>> find_cuts() {
    std::vector<RegionBoundary> boundaries = split_regions(pslg_, table_);
    if (Status status = resolve_sizes(pslg_, table_, options_, boundaries); !status) {
      return std::move(status).error();
    }
    std::vector<std::uint8_t> marked(pslg_.segments.size(), 0);
    for (std::size_t r = 0; r < boundaries.size(); ++r) {
      if (dirty_[r] != 0) mark(boundaries[r], marked);
    }
    std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{0});
    std::vector<SegmentCut> cuts;
    stuck_.clear();
    for (std::size_t s = 0; s < marked.size(); ++s) {
      if (marked[s] == 0) continue;
      const Segment& segment = pslg_.segments[s];
      if (length_of(segment) < 2 * kFloor * whole_[s]) {
        stuck_.push_back(midpoint(at(segment.a), at(segment.b)));
        continue;
      }
      cuts.push_back({SegmentId{s}, {place_on(segment)}});
    }
    return cuts;
  }

  void mark(const RegionBoundary& boundary, std::vector<std::uint8_t>& marked) const {
    const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
    const AngleLimit limit = angle_limit(cdt, boundary.sides, boundary.segments);
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      if (boundary.segments[s] == kHullSide) continue;
      if (limit.side_nu[s] < least_nu_ || is_long(boundary, s)) {
        marked[boundary.segments[s].index()] = 1;
      }
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

  [[nodiscard]] Point place_on(const Segment& segment) const {
    const Point a = at(segment.a), b = at(segment.b);
    if (is_sharp(segment.a) == is_sharp(segment.b)) return midpoint(a, b);
    const double l = length_of(segment);
    double shell = std::exp2(std::floor(std::log2(l)));  // at most l
    while (shell > 2 * l / 3) shell /= 2;
    const double part = is_sharp(segment.a) ? shell / l : 1 - shell / l;
    return a + part * (b - a);
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
                     fmt::format("{} would have to be cut to less than 1/1024 to force no angle "
                                 "above {:.6g} degrees, the first near {}",
                                 counted(stuck_.size(), "segment"), degrees, describe(where[0])),
                     std::move(where)});
  }

  Pslg& pslg_;
  RegionTable& table_;
  const Options& options_;
  double least_nu_;
  std::vector<std::uint8_t> dirty_;  ///< by region
  std::vector<std::uint8_t> sharp_;  ///< by point of the input
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
