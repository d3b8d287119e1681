// Regions that travel as bytes to another process and back: the mesh and its report are the same.
#include <cover/share_out.hpp>

#include <gtest/gtest.h>

#include <mutex>
#include <new>
#include <stdexcept>

#include <cover/cover_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

using testing::shape_of;

/// Every second region elsewhere, as another process would mesh it.
Status half_elsewhere(RegionJobs& jobs) {
  const Result<Options> options = options_of_bytes(jobs.options());
  if (!options) return options.error();
  for (std::size_t k = jobs.size(); k-- > 0;) {
    if (k % 2 == 0) {
      jobs.accept(k, mesh_region_bytes(jobs.boundary(k), *options));
    } else {
      jobs.mesh_here(k);
    }
  }
  return ok();
}

/// The same on three threads each: a few at a time here, all others elsewhere.
Status half_elsewhere_with_threads(RegionJobs& jobs) {
  const Result<Options> options = options_of_bytes(jobs.options());
  if (!options) return options.error();
  std::vector<Bytes> bytes;
  for (std::size_t k = 0; k < jobs.size(); k += 2) bytes.push_back(jobs.boundary(k));
  mesh_region_bytes(bytes, *options, 3);
  for (std::size_t k = 0; k < bytes.size(); ++k) jobs.accept(2 * k, bytes[k]);
  std::mutex mutex;
  std::size_t next = 1;
  jobs.mesh_here(3, [&] {
    const std::lock_guard lock(mutex);
    std::vector<std::size_t> taken;
    for (; next < jobs.size() && taken.size() < 2; next += 2) taken.push_back(next);
    return taken;
  });
  return ok();
}

/// The report without what is measured in seconds.
std::string report_of(Output output) {
  output.report.times.clear();
  for (RegionReport& region : output.report.regions) region.seconds = 0;
  return report_json(output);
}

TEST(ShareOut, TheMeshIsTheSameWhereverARegionIsMeshed) {
  for (const testing::RandomInput& device : testing::kRandomDevices) {
    for (const Method method : {Method::quality, Method::almond}) {
      for (const bool cut : {false, true}) {
        SCOPED_TRACE(device.name);
        const Input input = device.make(7);
        Options options;
        options.method = method;
        options.threads = 1;
        options.sizes = {{"1", 0.05, false, ""}, {"", 0, false, "0.1 + 0.05*x"}};
        options.max_angle = Angle::degrees(101.3);
        if (cut) options.split_interfaces = Angle::degrees(95);
        Callbacks callbacks;
        const Result<Output> here = cover_mesh(input, options);
        for (const ShareOut& share_out :
             {ShareOut(half_elsewhere), ShareOut(half_elsewhere_with_threads)}) {
          callbacks.share_out = share_out;
          const Result<Output> shared = cover_mesh(input, options, callbacks);
          ASSERT_EQ(here.has_value(), shared.has_value());
          if (!here) continue;
          EXPECT_EQ(shape_of(triangle_soup(here->mesh)), shape_of(triangle_soup(shared->mesh)));
          EXPECT_EQ(report_of(*here), report_of(*shared));
        }
      }
    }
  }
}

TEST(ShareOut, TellsTheErrorOfTheWay) {
  Callbacks callbacks;
  callbacks.share_out = [](RegionJobs&) -> Status {
    return Error{ErrorCode::internal, "rank 3 is gone", {}, {}};
  };
  const Result<Output> output = cover_mesh(testing::checker(2, 2, 1), Options(), callbacks);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().message, "rank 3 is gone");
}

TEST(ShareOut, RefusesBytesThatAreNotWhole) {
  Bytes boundary;
  Callbacks callbacks;
  callbacks.share_out = [&](RegionJobs& jobs) -> Status {
    boundary = jobs.boundary(0);
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      Bytes mesh = mesh_region_bytes(jobs.boundary(k), Options());
      mesh.pop_back();
      jobs.accept(k, mesh);
    }
    return ok();
  };
  const Result<Output> output = cover_mesh(testing::checker(2, 2, 1), Options(), callbacks);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, ErrorCode::internal);
  ASSERT_FALSE(boundary.empty());
  for (std::size_t size = 0; size < boundary.size(); ++size) {
    const Bytes answer = mesh_region_bytes(std::span(boundary).first(size), Options());
    EXPECT_EQ(answer.front(), std::byte{1}) << size;  // an error
  }
}

TEST(ShareOut, WhatTheProgressFunctionThrowsReachesTheCaller) {
  for (const ShareOut& share_out :
       {ShareOut(half_elsewhere), ShareOut(half_elsewhere_with_threads)}) {
    Callbacks callbacks;
    callbacks.share_out = share_out;
    callbacks.progress = [](const Progress& progress) {
      if (progress.stage == "mesh" && progress.done > 0) throw std::runtime_error("enough");
    };
    EXPECT_THROW((void)cover_mesh(testing::checker(4, 4, 1), Options(), callbacks),
                 std::runtime_error);
  }
}

TEST(ShareOut, WhatTheProgressFunctionThrowsStopsThemAndComesBeforeErrors) {
  Callbacks callbacks;
  bool was_stopped = false;
  callbacks.share_out = [&](RegionJobs& jobs) -> Status {
    jobs.mesh_here(0);
    was_stopped = jobs.stop().stop_requested();
    return Error{ErrorCode::internal, "rank 3 is gone", {}, {}};
  };
  callbacks.progress = [](const Progress& progress) {
    if (progress.stage == "mesh") throw std::runtime_error("enough");
  };
  EXPECT_THROW((void)cover_mesh(testing::checker(4, 4, 1), Options(), callbacks),
               std::runtime_error);
  EXPECT_TRUE(was_stopped);
}

TEST(ShareOut, WhatIsThrownByWhoTakesRegionsIsAnError) {
  Callbacks callbacks;
  callbacks.share_out = [](RegionJobs& jobs) {
    jobs.mesh_here(2, []() -> std::vector<std::size_t> { throw std::bad_alloc(); });
    return ok();
  };
  const Result<Output> output = cover_mesh(testing::checker(2, 2, 1), Options(), callbacks);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, ErrorCode::out_of_memory);
}

TEST(ShareOut, ARegionThatIsLeftOutIsAnError) {
  Callbacks callbacks;
  callbacks.share_out = [](RegionJobs& jobs) {
    for (std::size_t k = 1; k < jobs.size(); ++k) jobs.mesh_here(k);
    return ok();
  };
  EXPECT_FALSE(cover_mesh(testing::checker(2, 2, 1), Options(), callbacks));
}

TEST(ShareOut, ALargeRegionIsTheSameWithoutWhatIsKnownOfIt) {
  const Input star = testing::input_of(testing::smooth_star(60'000, 1));
  Options options;
  options.method = Method::almond;
  Callbacks elsewhere;
  elsewhere.share_out = half_elsewhere;
  const auto away = cover_mesh(star, options, elsewhere);
  ASSERT_TRUE(away);
  const TriangleSoup found = triangle_soup(away->mesh);
  for (const unsigned threads : {1U, 3U}) {
    options.threads = threads;
    const auto here = cover_mesh(star, options);
    ASSERT_TRUE(here);
    const TriangleSoup soup = triangle_soup(here->mesh);
    EXPECT_TRUE(soup.points == found.points && soup.triangles == found.triangles) << threads;
  }
}

}  // namespace
}  // namespace cover
