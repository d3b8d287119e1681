// The whole call: promises on many regions, the same mesh for any number of threads, order of the
// input, unit and origin; cancelling, progress, options out of range.
#include <cover/cover_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>

#include <cover/judged_angle.hpp>
#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"
#include "tasks/for_each_region.hpp"

namespace cover {
namespace {

using testing::must_mesh;
using testing::Shape;
using testing::shape_of;
using testing::violations;

/// Points without segments, whose hull is meshed.
Input scattered(const std::vector<Point>& points) { return testing::segments_between(points, {}); }

/// Meshes the hull of `input` in one thread, and looks for broken promises.
Verification mesh_hull(const Input& input, Result<Output>& output) {
  Options options;
  options.hull = true;
  options.threads = 1;
  output = cover_mesh(input, options);
  EXPECT_TRUE(output.has_value()) << output.error().message;
  if (!output) return {};
  VerifyOptions verify;
  verify.hull = true;
  const Verification found =
      verify_cover(output->pslg, output->table, triangle_soup(output->mesh), verify);
  EXPECT_TRUE(found.violations.empty()) << found.violations.front().message;
  return found;
}

TEST(CoverMesh, MeshesTheHullOfPointsThatAreNearALine) {
  // The second method splits sides of the hull; the first one goes on from there.
  const std::vector<std::vector<Point>> inputs{{{1, 5}, {7, 4}, {2, 0}, {6, 9}},
                                               {{0, 0}, {1, 8}, {2, 9}, {0, 1}},
                                               {{4, 900}, {7, 500}, {2, 100}, {6, 800}},
                                               {{4, 2}, {4, 0}, {6, 1}, {8, 1}, {12, 2}, {12, 0}}};
  for (const std::vector<Point>& points : inputs) {
    Result<Output> output = Output();
    EXPECT_EQ(mesh_hull(scattered(points), output).regions, 1U);
  }
}

TEST(CoverMesh, MeshesTheHullOfPointsThatOnlyRoundingKeepsOffALine) {
  // Split sides are rounded outwards: cavities then had vertices inside, which were lost.
  Options options;
  options.hull = true;
  options.threads = 1;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<Point> points;
    for (int k = 0; k < 100; ++k) {
      const double t = place(random);
      points.push_back({3.7 * t + 0.1, 1.3 * t + 0.7});
    }
    const Result<Output> output = cover_mesh(scattered(points), options);
    ASSERT_TRUE(output.has_value()) << output.error().message;
    VerifyOptions verify;
    verify.hull = true;
    const Verification found =
        verify_cover(output->pslg, output->table, triangle_soup(output->mesh), verify);
    EXPECT_TRUE(found.violations.empty()) << seed << ": " << found.violations.front().message;
    EXPECT_EQ(found.regions, 1U);
  }
}

TEST(CoverMesh, TheVerifierExcusesOnTheHullWhatTheReportExcuses) {
  Options options;
  options.hull = true;
  options.method = Method::almond;
  options.threads = 1;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(0, 1);
    const double turn = 6 * place(random);
    std::vector<Point> points;
    for (int k = 0; k < 200; ++k) {
      const double t = 1e-9 * place(random);
      points.push_back({t * std::cos(turn), t * std::sin(turn)});
    }
    const Result<Output> output = cover_mesh(scattered(points), options);
    ASSERT_TRUE(output.has_value()) << output.error().message;
    const auto& notes = output->report.regions.at(0).notes;
    const bool is_told = std::any_of(notes.begin(), notes.end(), [](const Note& note) {
      return note.kind == Note::Kind::bound_missed;
    });
    VerifyOptions verify;
    verify.hull = true;
    const Verification found =
        verify_cover(output->pslg, output->table, triangle_soup(output->mesh), verify);
    EXPECT_EQ(!found.violations.empty(), is_told) << seed;
  }
}

TEST(CoverMesh, DisksInTheHullOfATurnedLatticeLeaveNoRingOpen) {
  // Points that rounding keeps off the sides of the hull; disks about them touched nothing.
  Options options;
  options.hull = true;
  options.fill = Fill::disks;
  options.threads = 1;
  constexpr double kTurn = 0.872798298841068;
  const double c = std::cos(kTurn), s = std::sin(kTurn);
  std::vector<Point> points;
  for (int k = 0; k < 30; ++k) {
    const double x = k % 7 / 10.0, y = k / 7 / 10.0;
    points.push_back({(x * c - y * s) * 1e-3 + 1, (x * s + y * c) * 1e-3 + 1});
  }
  const Result<Output> output = cover_mesh(scattered(points), options);
  ASSERT_TRUE(output.has_value()) << output.error().message;
  VerifyOptions verify;
  verify.hull = true;
  const Verification found =
      verify_cover(output->pslg, output->table, triangle_soup(output->mesh), verify);
  EXPECT_TRUE(found.violations.empty()) << found.violations.front().message;
}

TEST(CoverMesh, SliversOnTheHullThatDoublesCannotDivideAreNamed) {
  // Decimals on one line are no doubles on one line: (30.4, 9.45) lies 7e-16 inside the hull.
  const Input input = testing::segments_between({{31, 9.21}, {30.2, 9.53}, {30.4, 9.45}, {30, 8}},
                                                {{0, 2}, {2, 1}, {1, 3}, {3, 0}});
  Result<Output> output = Output();
  EXPECT_EQ(mesh_hull(input, output).within_rounding, 1U);
  ASSERT_TRUE(output);
  ASSERT_EQ(output->report.regions.size(), 2U);
  int named = 0;
  for (const RegionReport& region : output->report.regions) {
    for (const Note& note : region.notes) {
      EXPECT_NE(note.kind, Note::Kind::bound_missed) << note.message;
      named += note.kind == Note::Kind::below_resolution ? 1 : 0;
    }
  }
  EXPECT_EQ(named, 1);
}

TEST(CoverMesh, ABoundThatIsMissedBesideASliverIsTold) {
  // The same triangle, as far inside the hull as vertices have room.
  Input input = testing::segments_between({{0, 0}, {2, 0}, {1, 1e-3}, {1, 4}},
                                          {{0, 2}, {2, 1}, {1, 3}, {3, 0}});
  Options options;
  options.hull = true;
  const Result<Output> output = cover_mesh(input, options);
  ASSERT_TRUE(output.has_value()) << output.error().message;
  VerifyOptions verify;
  verify.hull = true;
  EXPECT_EQ(verify_cover(output->pslg, output->table, triangle_soup(output->mesh), verify)
                .violation_count,
            0U);
  TriangleSoup plain;  // no vertex splits the side of the hull
  plain.points = {{0, 0}, {2, 0}, {1, 1e-3}, {1, 4}};
  plain.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}};
  verify.materials = false;
  const Verification found = verify_cover(output->pslg, output->table, plain, verify);
  ASSERT_EQ(found.violation_count, 1U);
  EXPECT_EQ(found.violations.front().promise, 3);
}

TEST(CoverMesh, CutsThatRoundingBreaksAreTakenBack) {
  // Segments that end some units in the last place from each other: feet on them coincide.
  Options options;
  options.split_interfaces = Angle::degrees(90);
  options.threads = 1;
  const double ulp = 0x1p-50;
  const Result<Output> output = cover_mesh(
      testing::segments_between({{0, 0},
                                 {8, 4},
                                 {8, 4 + 4 * ulp},
                                 {0, 2 * ulp},
                                 {3, 1.5 + 8 * ulp},
                                 {5, 2.5 + 9 * ulp},
                                 {4, 9}},
                                {{0, 1}, {1, 2}, {2, 5}, {5, 4}, {4, 3}, {3, 0}, {2, 6}, {6, 3}}),
      options);
  ASSERT_TRUE(output.has_value()) << output.error().message;
  const Verification found = verify_cover(output->pslg, output->table, triangle_soup(output->mesh));
  for (const Violation& v : found.violations) EXPECT_EQ(v.promise, 3) << v.message;
}

TEST(CoverMesh, KeepsItsPromises) {
  const Output output = must_mesh(testing::checker(6, 5, 3));
  EXPECT_EQ(violations(output), "");
  EXPECT_EQ(output.report.regions.size(), 36U);
  EXPECT_EQ(output.table.regions.size(), 36U);
  EXPECT_NEAR(output.report.quality.area, 1, 1e-12);
  EXPECT_EQ(output.report.quality.triangles, output.mesh.tri().n_faces());
  EXPECT_EQ(output.report.input_points + output.report.steiner_vertices,
            output.mesh.tri().n_vertices());
}

TEST(CoverMesh, InputPointsAreThoseOfTheInputHoweverManyCutsThereAre) {
  const Input input = testing::random_cells(12, 23);
  const Output whole = must_mesh(input);
  EXPECT_EQ(whole.report.input_points, whole.pslg.points.size());
  EXPECT_EQ(whole.report.input_segments, whole.pslg.segments.size());
  Options options;
  options.split_interfaces = Angle::degrees(90);
  const Output cut = must_mesh(input, options);
  EXPECT_EQ(cut.report.input_points, whole.report.input_points);
  EXPECT_EQ(cut.report.input_segments, whole.report.input_segments);
  EXPECT_GT(cut.pslg.points.size(), cut.report.input_points);
}

TEST(CoverMesh, AnInputThatIsHandedOverIsGivenBack) {
  Input input = testing::checker(4, 5, 3);
  const Result<Output> kept = cover_mesh(input);
  ASSERT_TRUE(kept);
  EXPECT_FALSE(input.segments.empty());
  const Result<Output> consumed = cover_mesh(std::move(input));
  ASSERT_TRUE(consumed);
  EXPECT_EQ(shape_of(triangle_soup(consumed->mesh)), shape_of(triangle_soup(kept->mesh)));
  EXPECT_EQ(input.points.capacity(), 0U);  // NOLINT(bugprone-use-after-move): that is the promise
  EXPECT_EQ(input.segments.capacity(), 0U);
}

TEST(CoverMesh, SmallRegionsWithFineSizesAreSharedAmongThreads) {
  RegionBoundary square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.sides = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  square.size = 0.01;
  const std::vector<RegionBoundary> squares(4, square);
  std::mutex mutex;
  std::condition_variable another;
  std::set<std::thread::id> threads;
  const Status status = for_each_region(squares, 2, "mesh", {}, [&](std::size_t) {
    std::unique_lock lock(mutex);
    threads.insert(std::this_thread::get_id());
    another.notify_all();
    another.wait_for(lock, std::chrono::seconds(20), [&] { return threads.size() == 2; });
  });
  EXPECT_TRUE(status);
  EXPECT_EQ(threads.size(), 2U);
}

TEST(Result, ValuesAreMovedOutOfTemporaries) {
  Result<std::vector<int>> result = std::vector<int>{1, 2, 3};
  const int* const before = result->data();
  const std::vector<int> value = *std::move(result);
  EXPECT_EQ(value.data(), before);
}

TEST(CoverMesh, SameMeshForAnyNumberOfThreadsAndAnyRepeat) {
  const Input input = testing::checker(8, 6, 11);
  Options options;
  options.threads = 1;
  const TriangleSoup first = triangle_soup(must_mesh(input, options).mesh);
  for (const unsigned threads : {1U, 2U, 2U, 8U, 8U}) {
    options.threads = threads;
    const TriangleSoup again = triangle_soup(must_mesh(input, options).mesh);
    EXPECT_EQ(first.points, again.points);
    EXPECT_EQ(first.triangles, again.triangles);
    EXPECT_EQ(first.region, again.region);
    EXPECT_EQ(first.material, again.material);
  }
}

/// A region that is large enough to be divided, beside small ones.
TEST(CoverMesh, SameMeshOfALargeRegionForAnyNumberOfThreads) {
  const Input input = testing::input_of(testing::smooth_star(40'000, 1));
  Options options;
  options.threads = 1;
  const Output first = must_mesh(input, options);
  const TriangleSoup soup = triangle_soup(first.mesh);
  EXPECT_GT(soup.triangles.size(), 100'000U);  // see Sharing
  EXPECT_EQ(verify_cover(first.pslg, first.table, soup).violation_count, 0U);
  EXPECT_LE(first.report.quality.largest_nu.supplement().in_degrees(), 100 + 1e-9);
  EXPECT_GE(first.report.quality.smallest.in_degrees(), 20 - 1e-9);
  for (const unsigned threads : {2U, 3U, 8U}) {
    options.threads = threads;
    const Output output = must_mesh(input, options);
    const TriangleSoup again = triangle_soup(output.mesh);
    EXPECT_EQ(soup.points, again.points);
    EXPECT_EQ(soup.triangles, again.triangles);
    EXPECT_EQ(first.report.quality.area, output.report.quality.area);
    EXPECT_EQ(first.report.regions[0].limits.largest_nu,
              output.report.regions[0].limits.largest_nu);
    EXPECT_EQ(first.report.regions[0].limits.smallest, output.report.regions[0].limits.smallest);
  }
}

TEST(CoverMesh, LimitsAreThoseOfTheMeshThatCutsLeft) {
  Options boxes, thin;
  boxes.box_method = true;
  boxes.split_interfaces = Angle::degrees(100);
  thin.split_interfaces = Angle::degrees(90);
  thin.max_angle = Angle::degrees(90);
  std::size_t cut = 0, missed = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const Input input = testing::planar_graph(16, seed);
    for (const Options& options : {boxes, thin}) {
      const Output output = must_mesh(input, options);
      if (output.pslg.points.size() > output.report.input_points) ++cut;
      for (const RegionReport& region : output.report.regions) {
        const bool is_met = judged_nu(region.quality) >= options.max_angle.supplement();
        EXPECT_EQ(region.limits.of_largest == Standing::met, is_met) << "seed " << seed;
        EXPECT_GE(region.limits.largest_nu, judged_nu(region.quality)) << "seed " << seed;
        if (!is_met) ++missed;
      }
    }
  }
  EXPECT_GE(cut, 3U);
  EXPECT_GE(missed, 1U);
}

TEST(CoverMesh, SameMeshForAnyOrderOfTheInput) {
  const Input input = testing::checker(5, 6, 12);
  const Shape shape = shape_of(triangle_soup(must_mesh(input).mesh));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_EQ(shape_of(triangle_soup(must_mesh(testing::shuffled(input, seed)).mesh)), shape);
  }
}

TEST(CoverMesh, NothingDependsOnTheUnit) {
  const Input input = testing::checker(4, 7, 13);
  const TriangleSoup plain = triangle_soup(must_mesh(input).mesh);
  for (const double factor : {0x1p30, 0x1p-30}) {
    const TriangleSoup scaled = triangle_soup(must_mesh(testing::transformed(input, factor)).mesh);
    EXPECT_EQ(scaled.triangles, plain.triangles);
    EXPECT_EQ(shape_of(scaled, factor), shape_of(plain));
  }
}

TEST(CoverMesh, ARegionAloneIsMeshedAsInsideTheWhole) {
  const Input whole = testing::checker(5, 6, 14);
  const Output output = must_mesh(whole);
  const TriangleSoup soup = triangle_soup(output.mesh);
  for (const RegionId id : {RegionId{1}, RegionId{7}, RegionId{25}}) {
    const Input alone = testing::region_alone(output, id);
    EXPECT_EQ(shape_of(triangle_soup(must_mesh(alone).mesh)), shape_of(testing::part_of(soup, id)));
  }
}

TEST(CoverMesh, StopsWhenAsked) {
  const Input input = testing::checker(10, 6, 15);
  std::stop_source stop;
  Callbacks callbacks;
  callbacks.stop = stop.get_token();
  callbacks.progress = [&](const Progress&) { stop.request_stop(); };
  const Result<Output> output = cover_mesh(input, {}, callbacks);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, ErrorCode::cancelled);
}

TEST(CoverMesh, ReportsProgressFromOneThreadAtATime) {
  const Input input = testing::checker(12, 6, 16);
  Options options;
  options.threads = 4;
  std::atomic<int> inside = 0;
  std::map<std::string, Progress> last;
  bool in_order = true, alone = true;
  Callbacks callbacks;
  callbacks.progress = [&](const Progress& p) {
    alone = alone && ++inside == 1;
    Progress& before = last[std::string(p.stage)];
    in_order = in_order && before.done <= p.done && p.done <= p.total;
    before = p;
    --inside;
  };
  ASSERT_TRUE(cover_mesh(input, options, callbacks));
  EXPECT_TRUE(alone);
  EXPECT_TRUE(in_order);
  ASSERT_TRUE(last.contains("mesh"));
  EXPECT_EQ(last["mesh"].done, last["mesh"].total);
}

TEST(CoverMesh, TellsOfProgressWithinALargeRegionSoThatItCanBeStopped) {
  Input input = testing::checker(1, 2, 1);
  Options options;
  options.split_interfaces = Angle::degrees(90);
  options.sizes = {{"", 1e-3}};
  std::stop_source stop;
  Callbacks callbacks;
  callbacks.stop = stop.get_token();
  int begun = 0;
  callbacks.progress = [&](const Progress& p) {
    if (p.stage == "mesh" && p.total > 0 && p.done == 0 && ++begun == 2) stop.request_stop();
  };
  const Result<Output> output = cover_mesh(input, options, callbacks);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, ErrorCode::cancelled);
  EXPECT_EQ(begun, 2);
}

TEST(CoverMesh, TellsOfCutsAndThinningSoThatTheyCanBeStopped) {
  const Input input = testing::random_cells(60, 1);
  Options options;
  options.split_interfaces = Angle::degrees(90);
  options.max_angle = Angle::degrees(90);
  for (const char* stage : {"cut", "thin"}) {
    std::stop_source stop;
    Callbacks callbacks;
    callbacks.stop = stop.get_token();
    bool was_told = false;
    callbacks.progress = [&](const Progress& p) {
      if (p.stage != stage) return;
      was_told = true;
      stop.request_stop();
    };
    const Result<Output> output = cover_mesh(input, options, callbacks);
    EXPECT_TRUE(was_told) << stage;
    ASSERT_FALSE(output) << stage;
    EXPECT_EQ(output.error().code, ErrorCode::cancelled) << stage;
  }
}

TEST(CoverMesh, WhatTheProgressFunctionThrowsReachesTheCaller) {
  const Input input = testing::checker(12, 6, 16);
  Options options;
  options.threads = 3;
  Callbacks callbacks;
  int calls = 0;
  callbacks.progress = [&](const Progress&) {
    ++calls;
    throw std::runtime_error("enough");
  };
  EXPECT_THROW((void)cover_mesh(input, options, callbacks), std::runtime_error);
  EXPECT_EQ(calls, 1);
}

TEST(CoverMesh, WhatASizeFunctionThrowsAtAnyCallIsAnError) {
  const Input input = testing::checker(2, 3, 18);
  for (int at = 1;; at = 1 + at * 5 / 4) {
    int calls = 0;
    Options options;
    options.box_method = true;
    options.threads = 1;
    options.size_field = [&](Point) -> double {
      if (++calls == at) throw std::runtime_error("no data here");
      return 0.3;
    };
    const Result<Output> output = cover_mesh(input, options);
    if (calls < at) break;
    ASSERT_FALSE(output) << at;
    EXPECT_EQ(output.error().code, ErrorCode::bad_option) << at << output.error().message;
  }
}

TEST(CoverMesh, WhatASizeFunctionThrowsIsAnErrorThatSaysSo) {
  const Input input = testing::checker(3, 3, 18);
  Options options;
  options.threads = 3;
  for (const bool split : {false, true}) {
    if (split) options.split_interfaces = Angle::degrees(90);
    options.size_field = [](Point) -> double { throw std::runtime_error("no data here"); };
    const Result<Output> failed = cover_mesh(input, options);
    ASSERT_FALSE(failed.has_value());
    EXPECT_EQ(failed.error().code, ErrorCode::bad_option) << failed.error().message;
    EXPECT_NE(failed.error().message.find("no data here"), std::string::npos);
    EXPECT_EQ(failed.error().message.find("error in cover"), std::string::npos);
    EXPECT_EQ(failed.error().where.size(), 1U);
    options.size_field = [](Point) -> double { throw 7; };
    EXPECT_EQ(cover_mesh(input, options).error().code, ErrorCode::bad_option);
    options.size_field = [](Point) -> double { throw std::bad_alloc(); };
    EXPECT_EQ(cover_mesh(input, options).error().code, ErrorCode::out_of_memory);
  }
}

TEST(CoverMesh, WhatASizeFunctionThrowsOnASegmentOnlyIsAnErrorToo) {
  Options options;
  options.size_field = [](Point p) -> double {
    if (p.y == 0 && p.x > 0 && p.x < 10) throw std::runtime_error("no data here");
    return 2;
  };
  const Result<Output> failed =
      cover_mesh(testing::input_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), options);
  ASSERT_FALSE(failed.has_value());
  EXPECT_EQ(failed.error().code, ErrorCode::bad_option);
  EXPECT_NE(failed.error().message.find("no data here"), std::string::npos);
}

TEST(CoverMesh, RefusesOptionsOutOfRange) {
  const Input input = testing::checker(1, 2, 1);
  const auto code = [&](auto change) {
    Options options;
    change(options);
    const Result<Output> output = cover_mesh(input, options);
    return output ? ErrorCode::internal : output.error().code;
  };
  EXPECT_EQ(code([](Options& o) { o.pieces = 1; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](Options& o) { o.paper = true; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](Options& o) { o.max_angle = Angle::degrees(60); }), ErrorCode::bad_option);
  EXPECT_EQ(code([](Options& o) { o.max_angle = Angle::degrees(std::nan("")); }),
            ErrorCode::bad_option);
  EXPECT_EQ(code([](Options& o) { o.min_angle = Angle::degrees(60); }), ErrorCode::bad_option);
  EXPECT_EQ(code([](Options& o) { o.growth = 1; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](Options& o) { o.weld = -1e-9; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](Options& o) { o.split_interfaces = Angle::degrees(30); }),
            ErrorCode::bad_option);
  EXPECT_EQ(code([](Options& o) { o.sizes = {{"Si", 0, false}}; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](Options& o) { o.pieces = 1001; }), ErrorCode::bad_option);
  // The limits themselves, where they are legal.
  Options limits;
  limits.min_angle = Angle::degrees(0);
  limits.split_interfaces = Angle::degrees(60);
  limits.weld = 0;
  EXPECT_TRUE(cover_mesh(input, limits));
  Options sixty;
  sixty.max_angle = Angle::degrees(60);
  EXPECT_EQ(cover_mesh(input, sixty).error().message,
            "max_angle is 60 degrees, but must be above 60 and below 180");
}

TEST(CoverMesh, BadInputIsAnError) {
  Input input;
  EXPECT_EQ(cover_mesh(input).error().code, ErrorCode::no_segments);
  EXPECT_EQ(prepare(input).error().code, ErrorCode::no_segments);
}

TEST(Prepare, FindsTheLowerBoundsOfCoverMesh) {
  const Input input = testing::checker(4, 5, 17);
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  const Output output = must_mesh(input);
  ASSERT_EQ(prepared->report.regions.size(), output.report.regions.size());
  for (std::size_t r = 0; r < output.report.regions.size(); ++r) {
    EXPECT_EQ(prepared->report.regions[r].id, output.report.regions[r].id);
    EXPECT_GT(prepared->report.regions[r].nu_opt.in_degrees(), 0);
    EXPECT_EQ(prepared->report.regions[r].quality.triangles, 0U);
  }
}

}  // namespace
}  // namespace cover
