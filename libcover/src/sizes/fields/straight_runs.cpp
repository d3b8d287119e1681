// Tested by tests/unit/sizes/fields/straight_runs_test.cpp.
#include "sizes/fields/straight_runs.hpp"

#include <cstdint>

#include "base/none.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// The directions from a place in which a line passes all points so far closely enough.
class Cone {
 public:
  Cone(Point from, double tolerance) : from_(from), tolerance_(tolerance) {}

  /// Whether a line from there to `p` passes the points added before, going forwards.
  [[nodiscard]] bool admits(Point p) const {
    const Vector to = p - from_;
    return is_open_ || (dot(to, to - last_) > 0 && cross(right_, to) >= 0 && cross(left_, to) <= 0);
  }

  /// False where `p` is too near for a direction.
  bool add(Point p) {
    const Vector to = p - from_;
    const double far = length(to);
    if (!(far > tolerance_)) return false;
    const Vector across = (tolerance_ / far) * left_normal(to);
    const Vector right = to - across, left = to + across;
    if (is_open_ || cross(right_, right) > 0) right_ = right;
    if (is_open_ || cross(left_, left) < 0) left_ = left;
    last_ = to;
    is_open_ = false;
    return true;
  }

 private:
  Point from_;
  double tolerance_;
  Vector right_{}, left_{}, last_{};
  bool is_open_ = true;
};

class Runs {
 public:
  Runs(std::span<const Point> points, std::span<const IndexPair> sides, double tolerance)
      : points_(points), sides_(sides), tolerance_(tolerance), follower_(points.size(), kNone) {
    std::vector<std::uint32_t> in(points.size(), 0), out(points.size(), 0);
    for (const auto& [a, b] : sides) {
      ++out[a], ++in[b];
      follower_[a] = b;
    }
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (in[v] != 1 || out[v] != 1) follower_[v] = kNone;
    }
  }

  Outline joined() {
    std::vector<std::uint8_t> is_done(points_.size(), 0);  // as the end of a run, or within one
    std::vector<IndexPair> joined;
    const auto walk = [&](IndexPair side) {
      while (true) {
        const std::uint32_t end = end_of_run(side, is_done);
        joined.push_back({side[0], end});
        if (follower_[end] == kNone || is_done[end] != 0) return;
        is_done[end] = 1;
        side = {end, follower_[end]};
      }
    };
    for (const IndexPair& side : sides_) {
      if (follower_[side[0]] == kNone) walk(side);
    }
    for (const IndexPair& side : sides_) {  // rings of vertices that are all between two sides
      if (follower_[side[0]] == kNone || is_done[side[0]] != 0) continue;
      is_done[side[0]] = 1;
      walk(side);
    }
    return compact(joined);
  }

 private:
  /// Along the line that `side` begins; what it passes is marked.
  std::uint32_t end_of_run(const IndexPair& side, std::vector<std::uint8_t>& is_done) const {
    Cone cone(points_[side[0]], tolerance_);
    std::uint32_t end = side[1];
    while (cone.add(points_[end])) {
      const std::uint32_t next = follower_[end];
      if (next == kNone || is_done[end] != 0 || !cone.admits(points_[next])) break;
      is_done[end] = 1;
      end = next;
    }
    return end;
  }

  /// Without the points that runs pass.
  [[nodiscard]] Outline compact(std::span<const IndexPair> joined) const {
    std::vector<std::uint8_t> is_kept(points_.size(), 1);
    for (const auto& [a, b] : sides_) is_kept[a] = is_kept[b] = 0;
    for (const auto& [a, b] : joined) is_kept[a] = is_kept[b] = 1;
    Outline outline;
    std::vector<std::uint32_t> number(points_.size(), kNone);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (is_kept[v] == 0) continue;
      number[v] = static_cast<std::uint32_t>(outline.points.size());
      outline.points.push_back(points_[v]);
    }
    for (const auto& [a, b] : joined) outline.sides.push_back({number[a], number[b]});
    return outline;
  }

  std::span<const Point> points_;
  std::span<const IndexPair> sides_;
  double tolerance_;
  std::vector<std::uint32_t> follower_;  ///< the next vertex, of those between two sides
};

}  // namespace

Outline with_straight_runs_joined(std::span<const Point> points, std::span<const IndexPair> sides,
                                  double tolerance) {
  return Runs(points, sides, tolerance).joined();
}

}  // namespace cover
