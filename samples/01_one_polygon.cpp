// One polygon in, triangles out: no vertex is put on its sides, and the largest angle is known.
#include <cover/cover_mesh.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

int main() {
  cover::Input input;
  constexpr std::uint32_t kCorners = 40;
  for (std::uint32_t i = 0; i < kCorners; ++i) {  // a star: every second corner is pulled in
    const double angle = 2 * std::numbers::pi * i / kCorners, radius = i % 2 == 0 ? 1 : 0.6;
    input.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    input.segments.push_back({.a = i, .b = (i + 1) % kCorners});
  }

  const cover::Result<cover::Output> output = cover::cover_mesh(input);
  if (!output) {
    std::fprintf(stderr, "%s\n", output.error().message.c_str());
    return 1;
  }
  const cover::RegionReport& region = output->report.regions.front();
  std::printf("%zu triangles, %zu vertices added, all inside\n", region.quality.triangles,
              region.steiner_vertices);
  std::printf("largest angle %.2f, proven %.2f, no mesh has less than %.2f\n",
              region.quality.largest_nu.supplement().in_degrees(),
              region.nu_bound.supplement().in_degrees(),
              std::max(60.0, region.nu_opt.supplement().in_degrees()));
  return region.bound_held ? 0 : 1;
}
