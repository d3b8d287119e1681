// One constrained Delaunay triangulation of everything; faces are what is connected without
// crossing a segment. Nesting, holes and isolated points need no thought of their own.
// Tested by tests/unit/region/region_graph_test.cpp.
#include "faces/faces.hpp"

#include <algorithm>
#include <stdexcept>

namespace cover {
namespace {

constexpr std::uint32_t kUnseen = 0xffffffffU;

/// Gives `face` to everything that is connected with triangle `start`. True if it is open.
bool flood(Faces& faces, std::uint32_t start, std::uint32_t face,
           std::vector<std::uint32_t>& stack) {
  bool open = false;
  faces.of_triangle[start] = face;
  stack.assign(1, start);
  while (!stack.empty()) {
    const Triangle& f = faces.triangulation.triangles[stack.back()];
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      if (f.is_locked(i)) continue;
      const std::uint32_t next = f.n[static_cast<std::size_t>(i)];
      if (next == kNone) {
        open = true;
      } else if (faces.of_triangle[next] == kUnseen) {
        faces.of_triangle[next] = face;
        stack.push_back(next);
      }
    }
  }
  return open;
}

void number_faces(Faces& faces, bool hull) {
  faces.of_triangle.assign(faces.triangulation.triangles.size(), kUnseen);
  faces.open.assign(1, true);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t t = 0; t < faces.of_triangle.size(); ++t) {
    if (faces.of_triangle[t] != kUnseen) continue;
    faces.open.push_back(flood(faces, t, static_cast<std::uint32_t>(faces.open.size()), stack));
  }
  faces.count = faces.open.size();
  if (hull) return;
  // Open faces are the outside; the others move up.
  std::vector<std::uint32_t> renumbered(faces.count, kOutside);
  std::uint32_t closed = 1;
  for (std::size_t f = 1; f < faces.count; ++f) {
    if (!faces.open[f]) renumbered[f] = closed++;
  }
  for (std::uint32_t& f : faces.of_triangle) f = renumbered[f];
  faces.count = closed;
  faces.open.assign(closed, false);
  faces.open[kOutside] = true;
}

/// The segments by their end points.
class SegmentIndex {
 public:
  explicit SegmentIndex(std::span<const IndexPair> segments) : entries_(segments.size()) {
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
      entries_[s] = {key(segments[s][0], segments[s][1]), s};
    }
    std::sort(entries_.begin(), entries_.end());
  }
  /// REQUIRES: there is a segment between u and v
  [[nodiscard]] std::uint32_t find(std::uint32_t u, std::uint32_t v) const {
    return std::lower_bound(entries_.begin(), entries_.end(), std::pair(key(u, v), 0U))->second;
  }

 private:
  static std::uint64_t key(std::uint32_t u, std::uint32_t v) {
    return std::uint64_t{std::min(u, v)} << 32 | std::max(u, v);
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> entries_;
};

void find_sides(Faces& faces, std::span<const IndexPair> segments) {
  faces.of_segment.assign(segments.size(), {kOutside, kOutside});
  const SegmentIndex index(segments);
  for (std::size_t t = 0; t < faces.of_triangle.size(); ++t) {
    const Triangle& f = faces.triangulation.triangles[t];
    for (int i = 0; i < 3; ++i) {
      if (!f.is_locked(i)) continue;
      const std::uint32_t u = f.v[static_cast<std::size_t>(next3(i))];
      const std::uint32_t v = f.v[static_cast<std::size_t>(prev3(i))];
      const std::uint32_t s = index.find(u, v);
      faces.of_segment[s][segments[s][0] == u ? 0 : 1] = faces.of_triangle[t];
    }
  }
}

}  // namespace

Faces find_faces(std::span<const Point> points, std::span<const IndexPair> segments, bool hull) {
  CdtResult cdt = triangulate_hull(points, segments);
  if (!cdt.conflicts.empty()) throw std::logic_error("find_faces: the segments are no PSLG");
  return faces_of(std::move(cdt.triangulation), segments, hull);
}

Faces faces_of(Triangulation triangulation, std::span<const IndexPair> segments, bool hull) {
  Faces faces;
  faces.triangulation = std::move(triangulation);
  number_faces(faces, hull);
  find_sides(faces, segments);
  return faces;
}

}  // namespace cover
