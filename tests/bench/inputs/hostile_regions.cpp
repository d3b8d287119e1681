// Random regions of every awkward kind (tests/support/inputs/random_regions) as files.
//
//   bench_hostile_regions SEED COUNT FOLDER     writes FOLDER/0.poly, FOLDER/1.poly, ...
#include <fmt/os.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include "support/inputs/random_regions.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::mt19937_64 random(std::strtoull(argv[1], nullptr, 10));
  const int count = std::atoi(argv[2]);
  for (int k = 0; k < count; ++k) {
    const auto [kind, boundary] = cover::testing::random_region(random);
    std::vector<cover::IndexPair> segments;
    for (const auto& [a, b] : boundary.sides) segments.push_back({std::min(a, b), std::max(a, b)});
    std::sort(segments.begin(), segments.end());
    segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
    auto file = fmt::output_file(fmt::format("{}/{}.poly", argv[3], k));
    file.print("# {}\n{} 2 0 0\n", kind, boundary.points.size());
    for (std::size_t v = 0; v < boundary.points.size(); ++v)
      file.print("{} {:.17g} {:.17g}\n", v + 1, boundary.points[v].x, boundary.points[v].y);
    file.print("{} 0\n", segments.size());
    for (std::size_t s = 0; s < segments.size(); ++s)
      file.print("{} {} {}\n", s + 1, segments[s][0] + 1, segments[s][1] + 1);
    file.print("0\n");
  }
  return 0;
}
