// See to_region_mesh.hpp. Tested by tests/unit/quality/quality_region_test.cpp.
#include "quality/mutable/to_region_mesh.hpp"

#include <atomic>
#include <numeric>
#include <vector>

#include "geom/predicates.hpp"

namespace cover {
namespace {

/// Calls `use` with each of the numbers below `size` that `is_used`, and how many of these there
/// are before it; first `make_room` with how many there are.
template <class IsUsed, class MakeRoom, class Use>
void for_each_used(std::size_t size, const IsUsed& is_used, const MakeRoom& make_room,
                   const Use& use, const Team& team) {
  std::vector<std::size_t> before(Team::ranges(size, kItemsAtATime) + 1, 0);
  team.each_range(size, kItemsAtATime, [&](std::size_t first, std::size_t last) {
    std::size_t own = 0;
    for (std::size_t k = first; k < last; ++k) own += is_used(k) ? 1 : 0;
    before[first / kItemsAtATime + 1] = own;
  });
  for (std::size_t k = 1; k < before.size(); ++k) before[k] += before[k - 1];
  make_room(before.back());
  team.each_range(size, kItemsAtATime, [&](std::size_t first, std::size_t last) {
    std::size_t place = before[first / kItemsAtATime];
    for (std::size_t k = first; k < last; ++k) {
      if (is_used(k)) use(k, place++);
    }
  });
}

}  // namespace

RegionMesh to_region_mesh(const MutableMesh& mesh, const LocalFrame& frame,
                          std::span<const Point> points, const Team& team) {
  RegionMesh out;
  const auto fixed = static_cast<std::uint32_t>(points.size());
  std::vector<std::uint32_t> number(mesh.points.size(), kNone);
  std::iota(number.begin(), number.begin() + fixed, 0U);
  for_each_used(
      mesh.points.size(), [&](std::size_t v) { return v >= fixed && mesh.home[v] != kNone; },
      [&](std::size_t count) { out.steiner.resize(count); },
      [&](std::size_t v, std::size_t place) {
        number[v] = fixed + static_cast<std::uint32_t>(place);
        out.steiner[place] = frame.restore(mesh.points[v]);
      },
      team);
  for_each_used(
      mesh.triangles.size(), [&](std::size_t t) { return mesh.triangles[t].v[0] != kNone; },
      [&](std::size_t count) { out.triangles.resize(count); },
      [&](std::size_t t, std::size_t place) {
        const auto& v = mesh.triangles[t].v;
        out.triangles[place] = {number[v[0]], number[v[1]], number[v[2]]};
      },
      team);
  const auto at = [&](std::uint32_t v) { return v < fixed ? points[v] : out.steiner[v - fixed]; };
  std::atomic<bool> is_valid = true;
  team.each_range(out.triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last && is_valid; ++k) {
      const auto& [a, b, c] = out.triangles[k];
      if (orientation(at(a), at(b), at(c)) != Sign::positive) is_valid = false;
    }
  });
  if (!is_valid) out.triangles.clear();
  return out;
}

}  // namespace cover
