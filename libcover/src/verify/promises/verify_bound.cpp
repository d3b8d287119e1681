// Tested by tests/unit/verify/verify_test.cpp.
#include "verify/promises/verify_bound.hpp"

#include <algorithm>
#include <numbers>

#include "geom/angle_rounding.hpp"
#include "geom/vector.hpp"
#include "verify/by_region.hpp"

namespace cover {
namespace {

/// The worst triangle of a region, as it is and with rounding in its favour.
struct Worst {
  double nu = std::numbers::pi;
  double nu_rounded = std::numbers::pi;
  std::uint32_t triangle = 0;  ///< that of nu_rounded, and
  double its_nu = std::numbers::pi;
};

}  // namespace

BoundCheck verify_bound(const TriangleSoup& mesh, std::span<const RegionId> region,
                        const ExpectedDomain& domain, double scale,
                        std::span<const std::uint32_t> without_room, const Team& team) {
  const auto merge = [](Worst& w, const Worst& other) {
    w.nu = std::min(w.nu, other.nu);
    if (other.nu_rounded >= w.nu_rounded) return;
    w.nu_rounded = other.nu_rounded;
    w.triangle = other.triangle;
    w.its_nu = other.its_nu;
  };
  const auto add = [&](Worst& w, std::size_t t) {
    const auto& v = mesh.triangles[t];
    const Point a = mesh.points[v[0]], b = mesh.points[v[1]], c = mesh.points[v[2]];
    const double nu = least_nu(a, b, c);
    const double rounded = nu + angle_rounding(a, b, c, scale);
    const bool has_room = !std::binary_search(without_room.begin(), without_room.end(), t);
    merge(w, {nu, has_room ? rounded : std::numbers::pi, static_cast<std::uint32_t>(t), nu});
  };
  std::vector<Worst> worst(domain.nu_opt.size());
  fold_by_region(
      region.size(), [&](std::size_t t) { return region[t]; }, Worst{}, add, merge, worst, team);
  BoundCheck check;
  for (std::uint32_t r = 1; r < worst.size(); ++r) {
    const double bound = promised_nu(domain.nu_opt[r]);
    const double needed = bound * kNuRounded;
    if (worst[r].nu_rounded < needed) {
      check.missed.push_back(
          {RegionId(r), worst[r].triangle, Angle::radians(worst[r].its_nu), Angle::radians(bound)});
    } else if (worst[r].nu < needed) {
      ++check.within_rounding;
    }
  }
  return check;
}

}  // namespace cover
