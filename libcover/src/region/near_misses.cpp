// Tested by tests/unit/region/region_graph_test.cpp.
#include "region/near_misses.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "base/describe.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// What is nearer than this, compared with the edges beside it, is worth a warning. Rounded decimal
/// drawings miss by 1e-16 to 1e-7 of their size; the thinnest layers that are meant (1 nm on 1 mm)
/// are just above.
constexpr double kNear = 5e-7;
constexpr std::size_t kMostWarnings = 50;

class NearMisses {
 public:
  NearMisses(const Pslg& pslg, std::vector<Note>& notes) : pslg_(pslg), notes_(notes) {}

  /// Looks at edge i of triangle f and the corner opposite to it.
  void look(const Triangle& f, int i) {
    const std::uint32_t w = f.v[static_cast<std::size_t>(i)];
    const std::uint32_t u = f.v[static_cast<std::size_t>(next3(i))];
    const std::uint32_t v = f.v[static_cast<std::size_t>(prev3(i))];
    const Point pu = pslg_.points[u], pv = pslg_.points[v], pw = pslg_.points[w];
    const double uv = length(pv - pu), vw = length(pw - pv), wu = length(pu - pw);
    if (uv < kNear * std::min(vw, wu)) {
      if (!f.is_locked(i)) points(u, v, uv);
      return;
    }
    if (!f.is_locked(i) || f.is_locked(next3(i)) || f.is_locked(prev3(i))) return;
    const double height = cross(pv - pu, pw - pu) / uv;
    if (height < kNear * std::min(vw, wu)) point_and_segment(w, u, v, height);
  }

  /// Says how many more there are than were listed.
  void finish() {
    if (seen_.size() <= kMostWarnings) return;
    warn(fmt::format("{} more places where points or segments nearly touch",
                     seen_.size() - kMostWarnings),
         {});
  }

 private:
  [[nodiscard]] std::string name(std::uint32_t p) const {
    const long id = pslg_.point_ids[p];
    return id < 0 ? fmt::format("the point at {}", describe(pslg_.points[p]))
                  : fmt::format("point {} at {}", id, describe(pslg_.points[p]));
  }

  void points(std::uint32_t u, std::uint32_t v, double distance) {
    if (!is_new({std::min(u, v), std::max(u, v), std::max(u, v)})) return;
    warn(fmt::format("{} and {} are only {} apart", name(u), name(v), describe(distance)),
         {pslg_.points[u], pslg_.points[v]});
  }

  void point_and_segment(std::uint32_t w, std::uint32_t u, std::uint32_t v, double distance) {
    if (!is_new({w, std::min(u, v), std::max(u, v)})) return;
    warn(fmt::format("{} is only {} away from the segment between {} and {}", name(w),
                     describe(distance), name(u), name(v)),
         {pslg_.points[w]});
  }

  bool is_new(std::array<std::uint32_t, 3> place) {
    return seen_.insert(place).second && seen_.size() <= kMostWarnings;
  }

  void warn(std::string message, std::vector<Point> where) {
    notes_.push_back({Note::Kind::warning, kVoid, std::move(message), std::move(where)});
  }

  const Pslg& pslg_;
  std::vector<Note>& notes_;
  std::set<std::array<std::uint32_t, 3>> seen_;
};

}  // namespace

void warn_of_near_misses(const Pslg& pslg, const Triangulation& triangulation,
                         std::vector<Note>& notes) {
  NearMisses misses(pslg, notes);
  for (const Triangle& f : triangulation.triangles) {
    for (int i = 0; i < 3; ++i) misses.look(f, i);
  }
  misses.finish();
}

}  // namespace cover
