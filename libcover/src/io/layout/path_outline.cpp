// Tested by tests/unit/io/layout/path_outline_test.cpp.
#include "io/layout/path_outline.hpp"

#include "geom/predicates.hpp"
#include "geom/rings/is_simple.hpp"
#include "geom/vector.hpp"
#include "io/input/drawings/curves.hpp"

namespace cover {
namespace {

constexpr std::size_t kMostForOutline = 256;
constexpr std::size_t kMostInRoundEnd = 1 << 12;

Vector direction(Point a, Point b) {
  const Vector v = b - a;
  // Along an axis, exactly.
  if (v.y == 0) return {v.x > 0 ? 1.0 : -1.0, 0};
  if (v.x == 0) return {0, v.y > 0 ? 1.0 : -1.0};
  return (1 / length(v)) * v;
}

/// Leaves out points at which the line goes straight on.
std::vector<Point> without_straight_points(const std::vector<Point>& line) {
  std::vector<Point> out;
  for (const Point p : line) {
    while (out.size() > 1 && orientation(out[out.size() - 2], out.back(), p) == Sign::zero &&
           dot(out.back() - out[out.size() - 2], p - out.back()) > 0)
      out.pop_back();
    if (out.empty() || out.back() != p) out.push_back(p);
  }
  return out;
}

class Outliner {
 public:
  explicit Outliner(WidePath path) : path_(std::move(path)) {
    path_.line = without_straight_points(path_.line);
    for (std::size_t k = 0; k + 1 < path_.line.size(); ++k)
      along_.push_back(direction(path_.line[k], path_.line[k + 1]));
    if (path_.round) return;
    path_.line.front() = path_.line.front() + -path_.begin * along_.front();
    path_.line.back() = path_.line.back() + path_.end * along_.back();
  }

  std::vector<std::vector<Point>> polygons() {
    if (path_.line.size() <= kMostForOutline) {
      std::vector<Point> ring = outline();
      if (is_simple(ring)) return {std::move(ring)};
    }
    return pieces();
  }

 private:
  /// `p` moved to the left by half the width times `side`.
  [[nodiscard]] Point beside(Point p, Vector along, double side) const {
    return p + side * path_.half_width * left_normal(along);
  }

  /// The corners on one side of an inner point of the line.
  void add_corner(std::vector<Point>& ring, std::size_t k, double side) const {
    const Vector before = along_[k - 1], after = along_[k];
    const double cosine = dot(before, after);
    const bool outer = side * cross(before, after) < 0;
    const Point p = path_.line[k];
    constexpr double kThereAndBack = 1e-6;  // of such a corner a mitre would be far away
    if ((outer && cosine < -0.5) || 1 + cosine < kThereAndBack) {
      ring.push_back(beside(p, before, side));
      ring.push_back(beside(p, after, side));
      return;
    }
    const Vector mitre = (1 / (1 + cosine)) * (left_normal(before) + left_normal(after));
    ring.push_back(p + side * path_.half_width * mitre);
  }

  /// Half a disk from `from` to `to`, clockwise, without its ends.
  void add_round_end(std::vector<Point>& ring, Point from, Point to, Point centre) const {
    const auto arc = cut_arc_between(from, to, centre, true, path_.step, kMostInRoundEnd);
    if (arc) ring.insert(ring.end(), arc->begin() + 1, arc->end() - 1);
  }

  [[nodiscard]] std::vector<Point> outline() const {
    const std::vector<Point>& line = path_.line;
    std::vector<Point> ring, right;
    ring.push_back(beside(line.front(), along_.front(), 1));
    right.push_back(beside(line.front(), along_.front(), -1));
    for (std::size_t k = 1; k + 1 < line.size(); ++k) {
      add_corner(ring, k, 1);
      add_corner(right, k, -1);
    }
    ring.push_back(beside(line.back(), along_.back(), 1));
    right.push_back(beside(line.back(), along_.back(), -1));
    if (path_.round) add_round_end(ring, ring.back(), right.back(), line.back());
    const Point first = ring.front(), last = right.front();
    ring.insert(ring.end(), right.rbegin(), right.rend());
    if (path_.round) add_round_end(ring, last, first, line.front());
    return ring;
  }

  [[nodiscard]] std::vector<std::vector<Point>> pieces() const {
    const std::vector<Point>& line = path_.line;
    std::vector<std::vector<Point>> out;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      out.push_back({beside(line[k], along_[k], 1), beside(line[k], along_[k], -1),
                     beside(line[k + 1], along_[k], -1), beside(line[k + 1], along_[k], 1)});
      if (k == 0) continue;
      const double turn = cross(along_[k - 1], along_[k]);
      if (turn == 0) continue;
      const double side = turn > 0 ? -1 : 1;
      std::vector<Point> joint{line[k], beside(line[k], along_[k - 1], side)};
      if (dot(along_[k - 1], along_[k]) >= -0.5) add_corner(joint, k, side);
      joint.push_back(beside(line[k], along_[k], side));
      out.push_back(std::move(joint));
    }
    if (!path_.round) return out;
    for (const bool at_end : {false, true}) {
      const Point p = at_end ? line.back() : line.front();
      const Vector along = at_end ? along_.back() : -1.0 * along_.front();
      std::vector<Point> disk{beside(p, along, 1)};
      add_round_end(disk, beside(p, along, 1), beside(p, along, -1), p);
      disk.push_back(beside(p, along, -1));
      out.push_back(std::move(disk));
    }
    return out;
  }

  WidePath path_;
  std::vector<Vector> along_;
};

}  // namespace

std::vector<std::vector<Point>> path_polygons(WidePath path) {
  return Outliner(std::move(path)).polygons();
}

}  // namespace cover
