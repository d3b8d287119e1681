// Sizes spread along the edges of the triangulation.
// Tested by tests/unit/sizes/sizes_test.cpp.
#include "sizes/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"
#include "geom/box.hpp"
#include "geom/vector.hpp"
#include "sizes/fields/ask_size.hpp"
#include "sizes/spread_sizes.hpp"

namespace cover {
namespace {

/// How fast sizes may fall beside long sides, per unit of distance. Targets of 100 and 20 degrees
/// are met so; with 1, small angles of 10 to 18 degrees are left.
constexpr double kFall = 0.85;
constexpr double kNoSize = kInfinity;

/// The mean length of the sides at each vertex, by side where `lengths` are given; infinite where
/// there are none.
std::vector<double> spacing_of(const RegionBoundary& boundary, std::span<const double> lengths) {
  std::vector<double> sum(boundary.points.size(), 0);
  std::vector<int> count(boundary.points.size(), 0);
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
    const auto [a, b] = boundary.sides[s];
    const double l = lengths.empty() ? length(boundary.points[b] - boundary.points[a]) : lengths[s];
    sum[a] += l;
    sum[b] += l;
    ++count[a];
    ++count[b];
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] = count[v] > 0 ? sum[v] / count[v] : kNoSize;
  return sum;
}

/// Whether the triangulation has an edge longer than `most`. New vertices make shorter ones of it.
bool has_longer_edge(const RegionBoundary& boundary, const Triangulation& cdt, double most) {
  for (const Triangle& t : cdt.triangles) {
    for (const Corner i : kCorners) {
      const Point a = boundary.points[t.v[i]], b = boundary.points[t.v[i.next()]];
      if (length(b - a) > most) return true;
    }
  }
  return false;
}

/// Zero where a function wishes nothing.
double wish_of(const SizeFunction& function, Point p) {
  const double size = function(p);
  return size > 0 && std::isfinite(size) ? size : 0;
}

}  // namespace

SizeFunction smaller_of(SizeFunction a, SizeFunction b) {
  if (!a) return b;
  if (!b) return a;
  return [a = std::move(a), b = std::move(b)](Point p) {
    const double first = wish_of(a, p), second = wish_of(b, p);
    return first > 0 && second > 0 ? std::min(first, second) : std::max(first, second);
  };
}

namespace {

/// `wishes`, raised to `least` where they are above zero.
SizeFunction no_smaller_than(std::optional<double> least, SizeFunction wishes) {
  if (!least || !wishes) return wishes;
  return [wishes = std::move(wishes), least = *least](Point p) {
    return at_least(least, wish_of(wishes, p));
  };
}

}  // namespace

SizeFunction background_of(const RegionBoundary& boundary, const Options& options) {
  return smaller_of(no_smaller_than(options.min_size, options.size_field), boundary.size_function);
}

bool has_sizes(const RegionBoundary& boundary, const Options& options) {
  return boundary.size > 0 || !boundary.size_at.empty() || boundary.size_function ||
         options.size_field;
}

SizeField::SizeField(const RegionBoundary& boundary, const Triangulation& cdt,
                     std::optional<double> growth, SizeFunction background,
                     const BeforeCuts& before)
    : slope_(growth.value_or(Options::kGrowth) - 1),
      largest_(boundary.size > 0 ? boundary.size : kNoSize),
      background_(std::move(background)) {
  const double longest_edge = box_of(boundary.points).diagonal();
  if (!growth && !background_ && boundary.size_at.empty() && largest_ >= longest_edge) return;
  at_ = spacing_of(boundary, before.lengths);
  for (std::size_t v = 0; v < at_.size(); ++v) {
    if (!boundary.vertices.empty() && !(boundary.vertices[v] < before.first_cut)) at_[v] = kNoSize;
  }
  least_.assign(at_.size(), 0);
  for (std::uint32_t v = 0; v < at_.size(); ++v) {
    const double largest = largest_at(cdt.points[v]);
    if (at_[v] > kNear * largest && at_[v] < kNoSize) least_[v] = at_[v];
    if (at_[v] * kNear >= largest) at_[v] = largest;
    const double given = boundary.size_at.empty() ? 0 : boundary.size_at[v];
    if (given > 0) at_[v] = std::min(given, largest);
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : cdt.triangles) {
    for (const Corner i : kCorners) edges.emplace_back(t.v[i], t.v[i.next()]);
  }
  spread_sizes(cdt.points, edges, slope_, at_);
}

SizeField SizeField::where_it_counts(const RegionBoundary& boundary, const Triangulation& cdt,
                                     std::optional<double> growth, SizeFunction background) {
  const bool is_one_size = !growth && !background && boundary.size_at.empty();
  if (is_one_size && boundary.size > 0 && !has_longer_edge(boundary, cdt, boundary.size)) return {};
  return {boundary, cdt, growth, std::move(background)};
}

SizeField SizeField::part(std::span<const std::uint32_t> vertices) const {
  SizeField part;
  part.slope_ = slope_;
  part.largest_ = largest_;
  if (!is_active()) return part;
  part.background_ = background_;
  for (const std::uint32_t v : vertices) {
    part.at_.push_back(at_[v]);
    part.least_.push_back(least_[v]);
  }
  return part;
}

double SizeField::largest_at(Point p) const {
  if (!background_) return largest_;
  const double size = ask_size(background_, p);
  return size > 0 ? std::min(largest_, size) : largest_;
}

double SizeField::near(std::uint32_t v, double distance) const {
  return std::min(largest_, at_[v] + slope_ * distance);
}

double SizeField::least_near(std::uint32_t v, double distance) const {
  return least_[v] - kFall * distance;
}

void SizeField::set(std::uint32_t v, double size, double least) {
  if (at_.size() <= v) at_.resize(v + 1, largest_), least_.resize(v + 1, 0);
  at_[v] = size;
  least_[v] = least;
}

}  // namespace cover
