// From drawings to clean PSLGs with their regions. The aims: 1e5 segments that do not cross in
// about a second, 1e5 with 1e5 crossings in a few, maps of thousands of regions in seconds; all
// near n log n. CPU times, which other programs on the machine disturb less.
//
// Counters: us_per_piece  per segment of the result
//           pieces        segments of the result
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "support/inputs/soups.hpp"

namespace cover {
namespace {

void add_segment(Input& input, Point a, Point b) {
  InputSegment s;
  s.a = static_cast<std::uint32_t>(input.points.size());
  s.b = s.a + 1;
  input.points.insert(input.points.end(), {a, b});
  input.segments.push_back(s);
}

void add_frame(Input& input) {
  const Point corners[] = {{-1, -1}, {2, -1}, {2, 2}, {-1, 2}};
  for (int k = 0; k < 4; ++k) add_segment(input, corners[k], corners[(k + 1) % 4]);
}

/// Short segments anywhere; about `crossings` times n of them cross.
Input random_segments(std::size_t n, double crossings) {
  std::mt19937_64 random(n);
  std::uniform_real_distribution<double> uniform(0, 1);
  // Two segments of length l in random directions cross with probability 2 l^2 / pi.
  const double l = std::sqrt(crossings * std::numbers::pi / static_cast<double>(n));
  Input input;
  add_frame(input);
  while (input.segments.size() < n + 4) {
    const Point a{uniform(random), uniform(random)};
    const double angle = 2 * std::numbers::pi * uniform(random);
    add_segment(input, a, {a.x + l * std::cos(angle), a.y + l * std::sin(angle)});
  }
  return input;
}

/// n segments that touch nothing, near a jittered grid.
Input clean_segments(std::size_t n) {
  std::mt19937_64 random(n);
  std::uniform_real_distribution<double> uniform(0.05, 0.95);
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  const double cell = 1.0 / static_cast<double>(side);
  Input input;
  add_frame(input);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = static_cast<double>(k % side), y = static_cast<double>(k / side);
    add_segment(input, {cell * (x + uniform(random)), cell * (y + uniform(random))},
                {cell * (x + uniform(random)), cell * (y + uniform(random))});
  }
  return input;
}

/// About n / 4 rectangles, each on top of some others.
Input painted_rectangles(std::size_t n) {
  std::mt19937_64 random(n);
  std::uniform_real_distribution<double> uniform(0, 1);
  const double l = 1.5 / std::sqrt(static_cast<double>(n) / 4);
  Input input;
  for (std::size_t k = 0; k < n / 4; ++k) {
    const double x = uniform(random), y = uniform(random);
    testing::add_polygon(input,
                         testing::rectangle(x, y, x + l * uniform(random), y + l * uniform(random)),
                         std::to_string(k % 7));
  }
  return input;
}

/// A turned brick wall of about n / 4 bricks: every border is stored twice and cut differently, and
/// corners miss the lines that they should be on by the last bit.
Input brick_wall(std::size_t n) {
  const auto side = static_cast<int>(std::sqrt(static_cast<double>(n) / 4));
  const double c = std::cos(0.3), s = std::sin(0.3);
  Input input;
  for (int row = 0; row < side; ++row) {
    for (int k = 0; k < side; ++k) {
      testing::Loop ring =
          testing::rectangle(k + row % 2 * 0.5, row / 3.0, k + 1 + row % 2 * 0.5, (row + 1) / 3.0);
      for (Point& p : ring) p = {c * p.x - s * p.y, s * p.x + c * p.y};
      testing::add_polygon(input, ring, std::to_string(k % 3));
    }
  }
  return input;
}

void measure(benchmark::State& state, const Input& input) {
  std::size_t pieces = 0;
  for (auto _ : state) {
    const auto out = testing::clean(input);
    if (!out) throw std::runtime_error(out.error().message);
    pieces = out->pslg.segments.size();
  }
  state.counters["pieces"] = static_cast<double>(pieces);
  state.counters["us_per_piece"] = benchmark::Counter(
      static_cast<double>(pieces) * 1e-6,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

std::size_t count(const benchmark::State& state) {
  return static_cast<std::size_t>(state.range(0));
}

void clean(benchmark::State& state) { measure(state, clean_segments(count(state))); }
void crossing(benchmark::State& state) { measure(state, random_segments(count(state), 1)); }
void painted(benchmark::State& state) { measure(state, painted_rectangles(count(state))); }
void bricks(benchmark::State& state) { measure(state, brick_wall(count(state))); }

void sizes(benchmark::internal::Benchmark* b) {
  b->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
}
BENCHMARK(clean)->Apply(sizes);
BENCHMARK(crossing)->Apply(sizes);
BENCHMARK(painted)->Apply(sizes);
BENCHMARK(bricks)->Apply(sizes);

}  // namespace
}  // namespace cover

BENCHMARK_MAIN();
