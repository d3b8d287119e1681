// One constrained Delaunay triangulation of everything; faces are what is connected without
// crossing a segment. Nesting, holes and isolated points need no thought of their own.
#include "faces/faces.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "base/none.hpp"

namespace cover {
namespace {

/// Gives `face` to everything that is connected with triangle `start`. True if it is open.
bool flood(Faces& faces, std::uint32_t start, std::uint32_t face,
           std::vector<std::uint32_t>& stack) {
  bool open = false;
  faces.of_triangle[start] = face;
  stack.assign(1, start);
  while (!stack.empty()) {
    const Triangle& f = faces.triangulation.triangles[stack.back()];
    stack.pop_back();
    for (const Corner i : kCorners) {
      if (f.is_locked(i)) continue;
      const std::uint32_t next = f.n[i];
      if (next == kNone) {
        open = true;
      } else if (faces.of_triangle[next] == kNone) {
        faces.of_triangle[next] = face;
        stack.push_back(next);
      }
    }
  }
  return open;
}

void number_faces(Faces& faces, bool hull) {
  faces.of_triangle.assign(faces.triangulation.triangles.size(), kNone);
  faces.open.assign(1, true);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t t = 0; t < faces.of_triangle.size(); ++t) {
    if (faces.of_triangle[t] != kNone) continue;
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

/// The segments by their lower end points: a counting sort.
class SegmentIndex {
 public:
  SegmentIndex(std::size_t points, std::span<const IndexPair> segments)
      : segments_(segments), first_(points + 2, 0), sorted_(segments.size()) {
    for (const IndexPair& s : segments) ++first_[lower(s) + 2];
    for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
    // first_[v + 1] is where the next segment of v goes; in the end it is where v + 1 begins.
    for (std::uint32_t s = 0; s < segments.size(); ++s)
      sorted_[first_[lower(segments[s]) + 1]++] = s;
    for (std::size_t v = 0; v < points; ++v) {
      std::sort(sorted_.begin() + first_[v], sorted_.begin() + first_[v + 1],
                [&](std::uint32_t r, std::uint32_t s) {
                  return std::pair(upper(segments[r]), r) < std::pair(upper(segments[s]), s);
                });
    }
  }
  /// REQUIRES: there is a segment between u and v
  [[nodiscard]] std::uint32_t find(std::uint32_t u, std::uint32_t v) const {
    const auto [low, high] = std::minmax(u, v);
    return *std::lower_bound(
        sorted_.begin() + first_[low], sorted_.begin() + first_[low + 1], high,
        [this](std::uint32_t s, std::uint32_t end) { return upper(segments_[s]) < end; });
  }

 private:
  static std::uint32_t lower(const IndexPair& s) { return std::min(s[0], s[1]); }
  static std::uint32_t upper(const IndexPair& s) { return std::max(s[0], s[1]); }

  std::span<const IndexPair> segments_;
  std::vector<std::uint32_t> first_;   ///< by point, into sorted_
  std::vector<std::uint32_t> sorted_;  ///< by lower, then upper end
};

/// Each side is one triangle's.
void find_sides(Faces& faces, std::span<const IndexPair> segments, const SegmentIndex& index,
                const Team& team) {
  team.each_range(faces.of_triangle.size(), kItemsAtATime,
                  [&](std::size_t first, std::size_t last) {
                    for (std::size_t t = first; t < last; ++t) {
                      const Triangle& f = faces.triangulation.triangles[t];
                      for (const Corner i : kCorners) {
                        if (!f.is_locked(i)) continue;
                        const std::uint32_t u = f.v[i.next()];
                        const std::uint32_t v = f.v[i.previous()];
                        const std::uint32_t s = index.find(u, v);
                        faces.of_segment[s][segments[s][0] == u ? 0 : 1] = faces.of_triangle[t];
                      }
                    }
                  });
}

}  // namespace

Faces find_faces(std::span<const Point> points, std::span<const IndexPair> segments, bool hull) {
  CdtResult cdt = triangulate_hull(points, segments);
  if (!cdt.conflicts.empty()) throw std::logic_error("find_faces: the segments are no PSLG");
  return faces_of(std::move(cdt.triangulation), segments, hull);
}

Faces faces_of(Triangulation triangulation, std::span<const IndexPair> segments, bool hull,
               const Team& team) {
  Faces faces;
  faces.triangulation = std::move(triangulation);
  std::optional<SegmentIndex> index;
  team.each(2, [&](std::size_t k) {
    if (k == 0) {
      number_faces(faces, hull);
    } else {
      index.emplace(faces.triangulation.points.size(), segments);
      faces.of_segment.assign(segments.size(), {kOutside, kOutside});
    }
  });
  find_sides(faces, segments, *index, team);
  return faces;
}

}  // namespace cover
