// Steps of the wished length are taken from the end that comes first in the plane, so that the
// points do not depend on the direction of the segment, and then stretched so that the last one
// ends at the other end.
// Tested by tests/unit/sizes/segment_sizes_test.cpp.
#include "sizes/segment_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "geom/vector.hpp"
#include "sizes/fields/ask_size.hpp"

namespace cover {
namespace {

constexpr std::size_t kMostPieces = 1'000'000;

/// Zero stands for "none".
void lower(double& size, double wished) {
  if (wished > 0 && std::isfinite(wished)) size = size == 0 ? wished : std::min(size, wished);
}

}  // namespace

void SegmentSizes::add(const RegionBoundary& boundary, std::size_t s) {
  lower(along_, boundary.size);
  if (!boundary.size_along.empty()) lower(along_, boundary.size_along[s]);
  if (boundary.size_function)
    functions_[functions_[0] == nullptr ? 0 : 1] = &boundary.size_function;
  if (boundary.size_at.empty()) return;
  const auto& [from, to] = boundary.sides[s];
  const bool forward = boundary.points[from] == a_;
  lower(at_a_, boundary.size_at[forward ? from : to]);
  lower(at_b_, boundary.size_at[forward ? to : from]);
}

bool SegmentSizes::has_wish() const {
  return along_ > 0 || at_a_ > 0 || at_b_ > 0 || options_->size_field || functions_[0] != nullptr;
}

double SegmentSizes::wished_at(double part) const {
  double size = 0;
  lower(size, along_);
  const double whole = length(b_ - a_), slope = options_->growth.value_or(Options::kGrowth) - 1;
  if (at_a_ > 0) lower(size, at_a_ + slope * part * whole);
  if (at_b_ > 0) lower(size, at_b_ + slope * (1 - part) * whole);
  const Point here = a_ + part * (b_ - a_);
  if (options_->size_field)
    lower(size, at_least(options_->min_size, ask_size(options_->size_field, here)));
  for (const SizeFunction* function : functions_)
    if (function != nullptr) lower(size, (*function)(here));
  return size > 0 ? size : kInfinity;
}

SegmentSizes::Steps SegmentSizes::steps(double enough) const {
  Steps steps;
  if (!has_wish()) return steps;
  const double whole = length(b_ - a_);
  const auto step_at = [&](double part) { return wished_at(part) / whole; };
  for (double part = 0; steps.places.size() <= kMostPieces && !(steps.count > enough);) {
    // The size in the middle of the step, which is found with that at its beginning.
    const double step = step_at(std::min(part + step_at(part) / 2, 1.0));
    if (part + step >= 1) {
      steps.count = static_cast<double>(steps.places.size()) - 1 + (1 - part) / step;
      if (std::isfinite(step)) steps.places.push_back(part + step);
      break;
    }
    steps.places.push_back(part += step);
    steps.count = static_cast<double>(steps.places.size()) - 1;
  }
  return steps;
}

std::vector<Point> SegmentSizes::cuts() const {
  const Steps way = steps(kInfinity);
  const auto pieces = static_cast<std::size_t>(std::max(1.0, std::round(way.count)));
  std::vector<Point> points;
  for (std::size_t k = 1; k < pieces; ++k) {
    const double step = way.count * static_cast<double>(k) / static_cast<double>(pieces);
    const auto before = static_cast<std::size_t>(step);
    const double from = way.places[before];
    const double to = before + 1 < way.places.size() ? way.places[before + 1] : from;
    points.push_back(a_ + (from + (step - std::floor(step)) * (to - from)) * (b_ - a_));
  }
  if (reversed_) std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace cover
