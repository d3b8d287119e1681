// A disk may be as large as 0.45 times the distance of its centre from everything that is not its
// own segment: two disks on different segments are then less than 0.9 times the distance of their
// centres. A disk around a point keeps that from what does not end in the point. Between the disks
// around its ends a segment is covered by one disk if that is small enough, else it is halved.
// Next to a corner of angle theta, sizes grow geometrically with the distance from it.
// Tested by tests/unit/nonobtuse/nonobtuse_test.cpp.
#include "disks/segment_disks.hpp"

#include <algorithm>

#include "disks/packing/search/line_tree.hpp"
#include "disks/unit_frame.hpp"

namespace cover::disks {
namespace {

constexpr double kShare = 0.45;

class Cover {
 public:
  Cover(std::span<const Point> points, std::span<const IndexPair> segments, double smallest,
        std::size_t most)
      : frame_({points.begin(), points.end()}),
        segments_(segments),
        smallest_(frame_.inward(smallest)),
        most_(most) {
    for (const Point p : points) points_.push_back(frame_.inward(p));
    std::vector<bool> isolated(points.size(), true);
    for (const auto& [a, b] : segments) {
      lines_.push_back(make_line(points_[a], points_[b], static_cast<Index>(lines_.size())));
      ends_.push_back({a, b});
      isolated[a] = isolated[b] = false;
    }
    for (Index p = 0; p < points_.size(); ++p) {
      if (!isolated[p]) continue;
      Element point;
      point.shape = Element::Shape::line;
      point.c = points_[p];
      point.d = {1, 0};
      lines_.push_back(point);
      ends_.push_back({p, p});
    }
    tree_ = LineTree(lines_);
  }

  SegmentDisks run() {
    SegmentDisks result;
    result.chain.resize(segments_.size());
    std::vector<double> radius(points_.size(), 1);
    for (Index p = 0; p < points_.size(); ++p) {
      radius[p] = kShare * distance(points_[p], 2,
                                    [&](Index e) { return ends_[e][0] == p || ends_[e][1] == p; });
    }
    for (Index s = 0; s < segments_.size(); ++s) {
      for (const Index p : segments_[s]) radius[p] = std::min(radius[p], kShare * lines_[s].to);
    }
    for (std::size_t e = segments_.size(); e < ends_.size() && is_complete(result); ++e) {
      const Index p = ends_[e][0];
      if (radius[p] >= smallest_) continue;
      result.obstacle = SegmentDisks::Obstacle::too_small;
      result.crowded = nearest_segment(points_[p]);
    }
    for (Index s = 0; s < segments_.size() && is_complete(result); ++s) {
      const auto& [a, b] = segments_[s];
      if (std::min(radius[a], radius[b]) < smallest_) {
        result.obstacle = SegmentDisks::Obstacle::too_small;
      } else {
        cover(s, radius[a], lines_[s].to - radius[b], result);
      }
      result.crowded = s;
    }
    for (const double r : radius) result.radius.push_back(frame_.outward(r));
    return result;
  }

 private:
  static bool is_complete(const SegmentDisks& result) {
    return result.obstacle == SegmentDisks::Obstacle::none;
  }

  /// Distance from `x` to the nearest segment or isolated point that is not skipped.
  template <class Skip>
  [[nodiscard]] double distance(Point x, double bound, Skip skip) const {
    tree_.visit(x, bound, [&](Index e) {
      if (!skip(e)) bound = std::min(bound, distance_to(x, e));
      return bound;
    });
    return bound;
  }

  [[nodiscard]] double distance_to(Point x, Index e) const {
    const Element& line = lines_[e];
    const double t = std::clamp(dot(line.d, x - line.c), line.from, line.to);
    return norm(x - (line.c + t * line.d));
  }

  /// REQUIRES: there is one
  [[nodiscard]] Index nearest_segment(Point x) const {
    Index nearest = 0;
    for (Index s = 1; s < segments_.size(); ++s)
      if (distance_to(x, s) < distance_to(x, nearest)) nearest = s;
    return nearest;
  }

  /// Covers the piece [from, to] of segment `s`.
  void cover(Index s, double from, double to, SegmentDisks& result) {
    const double middle = from + (to - from) / 2, radius = (to - from) / 2;
    if (!(radius >= smallest_)) result.obstacle = SegmentDisks::Obstacle::too_small;
    if (++count_ > most_) result.obstacle = SegmentDisks::Obstacle::too_many;
    if (!is_complete(result)) return;
    const Element& line = lines_[s];
    const Point c = line.c + middle * line.d;
    const double needed = radius / kShare;
    if (distance(c, needed, [&](Index e) { return e == s; }) >= needed) {
      result.chain[s].push_back({frame_.outward(c), frame_.outward(radius)});
      return;
    }
    cover(s, from, middle, result);
    cover(s, middle, to, result);
  }

  UnitFrame frame_;
  std::span<const IndexPair> segments_;
  double smallest_;
  std::size_t most_;
  std::size_t count_ = 0;
  std::vector<Point> points_;
  std::vector<Element> lines_;  ///< segments, then isolated points
  std::vector<IndexPair> ends_;
  LineTree tree_;
};

}  // namespace

SegmentDisks cover_segments(std::span<const Point> points, std::span<const IndexPair> segments,
                            double smallest, std::size_t most) {
  return Cover(points, segments, smallest, most).run();
}

}  // namespace cover::disks
