// Tested by tests/unit/sizes/fields/graded_function_test.cpp.
#include "sizes/fields/graded_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/size_function.hpp>
#include <cover/text.hpp>

#include "cdt/cdt.hpp"
#include "geom/box.hpp"
#include "geom/vector.hpp"
#include "sizes/fields/straight_runs.hpp"
#include "sizes/size_field.hpp"

namespace cover {
namespace {

constexpr double kLeast = 1e-9;             ///< of the extent: what is smaller is zero
constexpr std::size_t kMostCells = 20'000;  ///< some 10 ms
constexpr double kMuch = 4;                 ///< times as long edges are worth telling
struct HashOfPlace {
  std::size_t operator()(Point p) const {
    return std::hash<double>{}(p.x) * 0x9e3779b97f4a7c15U + std::hash<double>{}(p.y);
  }
};

/// A triangle of the grid.
struct Cell {
  std::array<std::uint32_t, 3> corners;  ///< indices of samples
  double longest;                        ///< edge
  Corner opposite;                       ///< to that edge, at whose middle it is cut
  double smallest;                       ///< wish at its corners
};

/// The smallest wish first: where there is none to be found, it is found soon.
struct IsLater {
  bool operator()(const Cell& a, const Cell& b) const {
    return a.smallest != b.smallest ? a.smallest > b.smallest : a.corners > b.corners;
  }
};

class Grid {
 public:
  Grid(const SizeFunction& wish, const Triangulation& cdt, double extent, double width,
       double slope)
      : wish_(wish), extent_(extent), width_(width), slope_(slope) {
    for (const Triangle& t : cdt.triangles) {
      std::array<std::uint32_t, 3> corners{};
      for (const Corner i : kCorners) corners[i] = sample_at(cdt.points[t.v[i]]);
      add(corners);
    }
  }

  /// Refines until nothing can hide, or there are too many cells. The place of a wish that is zero,
  /// if there is one.
  std::optional<Point> refine() {
    while (!waiting_.empty()) {
      const Cell cell = waiting_.top();
      waiting_.pop();
      if (cell.smallest < kLeast * extent_) return place_of_zero(cell);
      const std::array<std::uint32_t, 3> middles = middles_of(cell);
      const Wish wish = wish_in(cell, middles);
      const bool is_steep = may_hide(cell, wish);
      found_steep_ = found_steep_ || is_steep;
      const bool is_coarse = is_steep || cell.longest > width_;
      if (is_coarse && waiting_.size() + samples_.triangles.size() < kMostCells) {
        const Corner i = cell.opposite;
        const std::uint32_t apex = cell.corners[i], middle = middles[i];
        add({apex, cell.corners[i.next()], middle});
        add({apex, middle, cell.corners[i.previous()]});
      } else {
        if (is_coarse && is_steep && !missed_) missed_ = missed_in(cell, middles, wish);
        keep(cell, middles);
      }
    }
    return std::nullopt;
  }

  /// Whether there is a cell that could hide something.
  [[nodiscard]] bool found_steep() const { return found_steep_; }
  /// Where much less is wished than was found before there were too many cells.
  [[nodiscard]] std::optional<Point> missed() const { return missed_; }
  /// No size is larger than the region.
  [[nodiscard]] SizeSamples take() {
    for (double& size : samples_.sizes) size = std::min(size, extent_);
    return std::move(samples_);
  }

 private:
  [[nodiscard]] Point at(std::uint32_t sample) const { return samples_.points[sample]; }

  std::uint32_t sample_at(Point p) {
    const auto [place, is_new] =
        numbers_.try_emplace(p, static_cast<std::uint32_t>(samples_.points.size()));
    if (is_new) {
      const double size = wish_(p);
      samples_.points.push_back(p);
      has_wish_.push_back(size > 0 && std::isfinite(size));
      samples_.sizes.push_back(has_wish_.back() ? size : extent_);
    }
    return place->second;
  }
  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    return sample_at(midpoint(std::min(at(a), at(b)), std::max(at(a), at(b))));
  }

  void add(const std::array<std::uint32_t, 3>& corners) {
    Cell cell{corners, 0, 0U, smallest_at(corners)};
    for (const Corner i : kCorners) {
      const double edge = length(at(corners[i.previous()]) - at(corners[i.next()]));
      if (edge > cell.longest) cell.longest = edge, cell.opposite = i;
    }
    waiting_.push(cell);
  }

  /// Of the edges opposite to the corners.
  std::array<std::uint32_t, 3> middles_of(const Cell& cell) {
    const auto& [a, b, c] = cell.corners;
    return {between(b, c), between(c, a), between(a, b)};
  }

  /// A cell becomes a part of the grid; four of them if less is wished at its middles.
  void keep(const Cell& cell, const std::array<std::uint32_t, 3>& middles) {
    auto& triangles = samples_.triangles;
    if (smallest_at(middles) >= cell.smallest) return triangles.push_back(cell.corners);
    for (const Corner i : kCorners)
      triangles.push_back({cell.corners[i], middles[i.previous()], middles[i.next()]});
    triangles.push_back(middles);
  }

  [[nodiscard]] double smallest_at(const std::array<std::uint32_t, 3>& places) const {
    const auto& [a, b, c] = places;
    return std::min({samples_.sizes[a], samples_.sizes[b], samples_.sizes[c]});
  }

  /// What the corners and middles of a cell tell of the wish in it.
  struct Wish {
    double least, steepest = 0;
    bool is_asked = false, is_lacking = false;  ///< at some of them
  };

  [[nodiscard]] Wish wish_in(const Cell& cell, const std::array<std::uint32_t, 3>& middles) const {
    Wish wish{extent_};
    const auto look_along = [&](std::uint32_t u, std::uint32_t v) {
      wish.is_asked = wish.is_asked || has_wish_[u];
      wish.is_lacking = wish.is_lacking || !has_wish_[u];
      if (has_wish_[u]) wish.least = std::min(wish.least, samples_.sizes[u]);
      if (!has_wish_[u] || !has_wish_[v]) return;
      const double change = std::abs(samples_.sizes[u] - samples_.sizes[v]);
      wish.steepest = std::max(wish.steepest, change / length(at(u) - at(v)));
    };
    for (const Corner i : kCorners) {
      look_along(cell.corners[i], middles[i.next()]);
      look_along(cell.corners[i], middles[i.previous()]);
      look_along(middles[i], middles[i.next()]);
    }
    return wish;
  }

  /// What may be wished in a cell: no place is farther from one that was asked than a quarter of an
  /// edge, or hardly.
  static double lowest(const Cell& cell, const Wish& wish) {
    return wish.least - wish.steepest * cell.longest / 4;
  }

  /// Whether a wish that is smaller than a cell may lie between the places that were asked.
  [[nodiscard]] bool may_hide(const Cell& cell, const Wish& wish) const {
    // It passes through zero, or ends: then half of the smallest wish is fine enough.
    if (wish.is_lacking && wish.is_asked && wish.least < 2 * cell.longest) return true;
    return wish.steepest > slope_ && lowest(cell, wish) < cell.longest;
  }

  /// A place in a cell where much less is wished than its corners and middles let expect, or may
  /// be.
  [[nodiscard]] std::optional<Point> missed_in(const Cell& cell,
                                               const std::array<std::uint32_t, 3>& middles,
                                               const Wish& wish) const {
    // Where it changes by less than the distance no edge of that length reaches beyond.
    if (wish.is_asked && wish.steepest > 1 && kMuch * lowest(cell, wish) < wish.least)
      return midpoint(at(cell.corners[cell.opposite]), at(middles[cell.opposite]));
    const auto look_at = [&](Point p) {
      const double size = wish_(p);
      if (!(size > 0)) return false;
      double expected = extent_;
      for (const auto& known : {cell.corners, middles}) {
        for (const std::uint32_t v : known)
          expected = std::min(expected, samples_.sizes[v] + slope_ * length(p - at(v)));
      }
      return kMuch * size < expected;
    };
    const std::array<std::array<std::uint32_t, 3>, 4> parts{
        {{cell.corners[0], middles[1], middles[2]},
         {cell.corners[1], middles[2], middles[0]},
         {cell.corners[2], middles[0], middles[1]},
         middles}};
    for (const auto& [u, v, w] : parts) {
      const Point a = at(u), b = at(v), c = at(w);
      for (const Point p : {midpoint(a, b), midpoint(b, c), midpoint(c, a),
                            midpoint(midpoint(a, b), midpoint(b, c))})
        if (look_at(p)) return p;
    }
    return std::nullopt;
  }

  [[nodiscard]] Point place_of_zero(const Cell& cell) const {
    return at(*std::min_element(
        cell.corners.begin(), cell.corners.end(),
        [&](std::uint32_t a, std::uint32_t b) { return samples_.sizes[a] < samples_.sizes[b]; }));
  }

  const SizeFunction& wish_;
  double extent_;
  double width_;
  double slope_;
  /// Where nothing is wished, the extent. Sizes beyond it tell how steep a wish is.
  SizeSamples samples_;
  std::vector<bool> has_wish_;
  std::unordered_map<Point, std::uint32_t, HashOfPlace> numbers_;
  std::priority_queue<Cell, std::vector<Cell>, IsLater> waiting_;
  bool found_steep_ = false;
  std::optional<Point> missed_;
};

Error too_short(double least, double extent) {
  return {ErrorCode::bad_option,
          fmt::format(
              "--min-size {} is too short: a region that expressions give sizes is {} wide, "
              "and no edge can be shorter than {}",
              describe_roughly(least), describe_roughly(extent), describe_roughly(kLeast * extent)),
          {},
          {}};
}

}  // namespace

Result<GradedFunction> graded_function(SizeFunction wish, std::string_view name,
                                       const RegionBoundary& boundary, double slope,
                                       std::optional<double> least) {
  const double extent = box_of(boundary.points).diagonal();
  const Outline outline =
      with_straight_runs_joined(boundary.points, boundary.sides, kLeast * extent);
  CdtResult cdt = triangulate_domain(outline.points, outline.sides);
  if (!cdt.conflicts.empty() || cdt.triangulation.triangles.empty())
    cdt = triangulate_domain(boundary.points, boundary.sides);
  if (!cdt.conflicts.empty())
    return GradedFunction{wish, {}};  // who looks at the region next says why
  Grid grid(wish, cdt.triangulation, extent, boundary.size_grid, slope);
  if (const std::optional<Point> zero = grid.refine()) {
    if (least && *least < kLeast * extent) return too_short(*least, extent);
    return Error{ErrorCode::bad_option,
                 fmt::format("the size '{}' falls to zero near {}, and edges would have no length "
                             "there; --min-size gives the shortest",
                             name, describe(*zero)),
                 {*zero},
                 {}};
  }
  if (!grid.found_steep()) return GradedFunction{std::move(wish), {}};
  Result<SizeFunction> graded = size_function(grid.take(), 1 + slope);
  if (!graded) return std::move(graded).error();
  return GradedFunction{smaller_of(std::move(wish), *std::move(graded)), grid.missed()};
}

}  // namespace cover
