// CGAL's surface sweep over segments with lazy exact arithmetic. Each curve carries the indices of
// the segments that it comes from; overlapping pieces unite theirs.
// Tested by tests/unit/geom/exact_subdivision_test.cpp.
#include "geom/exact_subdivision.hpp"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_sweep_2_algorithms.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

namespace cover {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

/// Indices of segments: one nearly always, shared lists where pieces overlap.
struct Parents {
  std::uint32_t only = 0;
  std::shared_ptr<const std::vector<std::uint32_t>> several;

  [[nodiscard]] std::vector<std::uint32_t> list() const {
    return several ? *several : std::vector<std::uint32_t>{only};
  }
  friend bool operator==(const Parents& x, const Parents& y) { return x.list() == y.list(); }
};

/// For curves that overlap.
struct Unite {
  Parents operator()(const Parents& x, const Parents& y) const {
    const auto a = x.list(), b = y.list();
    auto both = std::make_shared<std::vector<std::uint32_t>>();
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(*both));
    return {0, std::move(both)};
  }
};

using Traits = CGAL::Arr_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>, Parents, Unite>;

/// The double nearest to an exact number.
double nearest(const Kernel::FT& lazy) {
  if (lazy.approx().is_point()) return lazy.approx().inf();
  const auto& exact = lazy.exact();
  using Exact = std::decay_t<decltype(exact)>;
  const double d = CGAL::to_double(exact);
  const Exact error = exact - Exact(d);
  if (error == 0) return d;
  const double other = std::nextafter(d, error > 0 ? HUGE_VAL : -HUGE_VAL);
  if (!std::isfinite(other)) return d;
  return CGAL::abs(Exact(exact - Exact(other))) < CGAL::abs(error) ? other : d;
}

Point rounded(const Kernel::Point_2& p) { return {nearest(p.x()), nearest(p.y())}; }

}  // namespace

std::vector<SubSegment> subdivide(std::span<const PlainSegment> segments) {
  std::vector<Traits::Curve_2> curves;
  curves.reserve(segments.size());
  for (std::uint32_t k = 0; k < segments.size(); ++k) {
    const PlainSegment& s = segments[k];
    curves.emplace_back(Traits::Base_traits_2::Curve_2(Kernel::Point_2(s.a.x, s.a.y),
                                                       Kernel::Point_2(s.b.x, s.b.y)),
                        Parents{k, nullptr});
  }
  std::vector<Traits::X_monotone_curve_2> pieces;
  Traits traits;
  CGAL::compute_subcurves(curves.begin(), curves.end(), std::back_inserter(pieces), false, traits);
  std::vector<SubSegment> out;
  out.reserve(pieces.size());
  for (const auto& piece : pieces) {
    out.push_back({rounded(piece.left()), rounded(piece.right()), piece.data().list()});
  }
  return out;
}

}  // namespace cover
