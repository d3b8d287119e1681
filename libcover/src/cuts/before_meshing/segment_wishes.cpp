// Tested by tests/unit/cuts/before_meshing/split_interfaces_test.cpp.
#include "cuts/before_meshing/segment_wishes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "cdt/cdt.hpp"
#include "cuts/before_meshing/least_pieces.hpp"
#include "geom/angle_rounding.hpp"
#include "sizes/size_field.hpp"
#include "target/angle_limit.hpp"

namespace cover {

SeenFrom seen_from(const RegionBoundary& boundary, std::size_t s, const Segment& segment) {
  return boundary.vertices[boundary.sides[s][0]] == segment.a ? SeenFrom::left : SeenFrom::right;
}

SegmentWishes::SegmentWishes(const Pslg& pslg, const Options& options, VertexId first_cut)
    : pslg_(&pslg),
      options_(&options),
      first_cut_(first_cut),
      whole_(pslg, first_cut.index()),
      least_nu_(options.split_interfaces->supplement().in_radians() - kNuRounding),
      is_right_(*options.split_interfaces == Angle::degrees(90)),
      wishes_(pslg.segments.size()),
      facing_(pslg.segments.size()) {}

std::optional<Flaw> SegmentWishes::add(RegionBoundary& boundary) {
  CdtResult result = triangulate_domain(boundary.points, boundary.sides);
  if (auto flaw = find_flaw(result, boundary.points, boundary.sides)) return flaw;
  const Triangulation& cdt = result.triangulation;
  const bool has_sizes = grade(boundary, cdt);
  const AngleLimit limit = angle_limit(cdt, boundary.sides, boundary.segments);
  if (has_sizes) look_across(boundary, cdt, limit, facing_);
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
    if (boundary.segments[s] == kHullSide) continue;
    const Segment& segment = pslg_->segments[boundary.segments[s].index()];
    SegmentWish& wish = wishes_[boundary.segments[s].index()];
    if (!wish.sizes) wish.sizes.emplace(at(segment.a), at(segment.b), *options_);
    wish.sizes->add(boundary, s);
    const EdgeRef& edge = limit.at[s];
    const Point apex = cdt.points[cdt.triangles[edge.triangle].v[edge.edge]];
    wish.apexes.push_back(apex);
    add_angle(wish, segment, seen_from(boundary, s, segment), apex, limit.side_nu[s]);
  }
  return std::nullopt;
}

std::vector<double> SegmentWishes::whole_lengths(const RegionBoundary& boundary) const {
  std::vector<double> lengths;
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
    const auto& [a, b] = boundary.sides[s];
    const SegmentId segment = boundary.segments[s];
    const auto [from, to] = segment == kHullSide
                                ? std::array{boundary.points[a], boundary.points[b]}
                                : whole_.ends(segment);
    lengths.push_back(length(to - from));
  }
  return lengths;
}

bool SegmentWishes::grade(RegionBoundary& boundary, const Triangulation& cdt) const {
  // Only who asks for a growth wants the sides beside a short piece, cut at a foot, graded from it.
  std::vector<double> lengths;
  if (!options_->growth) lengths = whole_lengths(boundary);
  const SizeField field(boundary, cdt, options_->growth, background_of(boundary, *options_),
                        {.first_cut = first_cut_, .lengths = lengths});
  if (!field.is_active()) return false;
  boundary.size_at.resize(boundary.points.size());
  for (std::uint32_t v = 0; v < boundary.points.size(); ++v) boundary.size_at[v] = field.at(v);
  return true;
}

void SegmentWishes::add_angle(SegmentWish& wish, const Segment& segment, SeenFrom from, Point apex,
                              double nu) const {
  if (nu >= least_nu_) return;
  // A foot of an earlier pass is rounded, and sees what it was made for so.
  if (is_right_ && bluntness(at(segment.a), apex, at(segment.b)) != Blunt::yes) return;
  const bool is_first = wish.forced_from == SeenFrom::none;
  wish.forced_from = wish.forced_from | from;
  if (!is_first && (nu > wish.nu || (nu == wish.nu && wish.apex < apex))) return;
  wish.nu = nu;
  wish.apex = apex;
}

std::vector<Point> SegmentWishes::feet_on(std::size_t segment) const {
  const Segment& s = pslg_->segments[segment];
  return feet_across(at(s.a), at(s.b), facing_[segment], *wishes_[segment].sizes,
                     wishes_[segment].apexes);
}

std::vector<SegmentId> SegmentWishes::finer_across(std::size_t segment) const {
  const auto length_in_the_middle = [&](std::size_t s) { return wishes_[s].sizes->wished_at(0.5); };
  const Segment& s = pslg_->segments[segment];
  const double own = length_in_the_middle(segment);
  std::vector<SegmentId> finer;
  for (const SegmentId other : facing_[segment].segments) {
    if (other.index() == segment || !wishes_[other.index()].sizes ||
        !wishes_[other.index()].sizes->is_long() || !(length_in_the_middle(other.index()) < own))
      continue;
    const Segment& its = pslg_->segments[other.index()];
    if (lies_across(at(s.a), at(s.b), at(its.a), at(its.b), own)) finer.push_back(other);
  }
  return finer;
}

}  // namespace cover
