#include <cover/requirements.hpp>

#include <algorithm>

#include <fmt/core.h>

#include <cover/judged_angle.hpp>

#include "base/words/and_more.hpp"

namespace cover {
namespace {

bool below_resolution(const RegionReport& region) {
  return std::any_of(region.notes.begin(), region.notes.end(),
                     [](const Note& note) { return note.kind == Note::Kind::below_resolution; });
}

/// Regions of the mesh that is there already (--onto) are as they are.
bool is_made_here(const Report& report, RegionId region) {
  return report.replaced.empty() ||
         std::any_of(report.replaced.begin(), report.replaced.end(),
                     [&](const Replaced& before) { return before.region == region; });
}

bool misses(const Report& report, const RegionReport& region) {
  return !region.bound_held && !below_resolution(region) && is_made_here(report, region.id);
}

template <class Test>
std::string names_of_regions_where(const Output& output, Test test) {
  constexpr std::size_t kListed = 5;
  std::string names;
  std::size_t count = 0;
  for (const RegionReport& region : output.report.regions) {
    if (!test(region)) continue;
    if (++count > kListed) continue;
    names += fmt::format("{}{} '{}'", names.empty() ? "" : ", ", region.id.value(),
                         output.table.region(region.id).name);
  }
  return fmt::format("region{} {}{}", count == 1 ? "" : "s", names, and_more(count, kListed));
}

}  // namespace

bool missed_bound(const Report& report) {
  return std::any_of(report.regions.begin(), report.regions.end(),
                     [&](const RegionReport& region) { return misses(report, region); });
}

std::string describe_missed_bound(const Output& output) {
  return "the proven bound on the largest angle is missed in " +
         names_of_regions_where(
             output, [&](const RegionReport& region) { return misses(output.report, region); });
}

std::vector<std::string> unmet_requirements(const Output& output, const Options& options) {
  const Requirements& require = options.require;
  std::vector<std::string> unmet;
  const auto add = [&](bool wanted, const char* what, auto test) {
    const auto& regions = output.report.regions;
    if (!wanted || std::none_of(regions.begin(), regions.end(), test)) return;
    unmet.push_back(fmt::format("{}, in {}", what, names_of_regions_where(output, test)));
  };
  add(require.bound, "bound (the proven bound on the largest angle)",
      [](const RegionReport& r) { return !r.bound_held; });
  const std::string limit =
      fmt::format("max-angle (no angle above {:g} degrees)", options.max_angle.in_degrees());
  add(require.max_angle, limit.c_str(), [&](const RegionReport& r) {
    return !meets(judged_nu(r.quality), options.max_angle.supplement());
  });
  add(require.delaunay,
      "delaunay (no inner edge fails the empty-circle test by more than rounding)",
      [](const RegionReport& r) { return r.box.non_delaunay_edges > 0; });
  add(require.non_obtuse, "non-obtuse (no triangle above 90 degrees)",
      [](const RegionReport& r) { return r.quality.obtuse > 0; });
  add(require.box_method, "box-method (no negative coupling of the box method)",
      [](const RegionReport& r) { return r.box.negative_couplings > 0; });
  return unmet;
}

}  // namespace cover
