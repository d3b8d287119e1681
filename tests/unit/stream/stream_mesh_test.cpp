// A mesh on the disk gives the files of the same mesh in memory, byte for byte.
#include <cover/stream_mesh.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>

#include <cover/cover_mesh.hpp>
#include <cover/option_table.hpp>
#include <cover/plane_field.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Leaves out of a report what is measured in seconds.
void forget_times(Output& output) {
  output.report.times.clear();
  for (RegionReport& region : output.report.regions) region.seconds = 0;
}

/// Every file of a mesh on the disk is that of the same mesh in memory; so is the report.
void expect_same(const Input& input, const Options& options) {
  const testing::TemporaryFolder folder;
  Result<Output> whole = cover_mesh(input, options);
  ASSERT_TRUE(whole);
  ASSERT_EQ(needs_whole_mesh(input, options), "");
  Result<StreamedOutput> streamed = stream_mesh(Input(input), options, {folder.path() / "x", 0});
  ASSERT_TRUE(streamed) << streamed.error().message;
  ASSERT_TRUE(streamed->is_streamed());
  EXPECT_EQ(streamed->output.mesh.triangles(), 0U);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  forget_times(*whole);
  forget_times(streamed->output);
  EXPECT_EQ(report_json(*streamed), report_json(*whole));
  EXPECT_FALSE(write_mesh(streamed->output, folder.path() / "none.vtu"));
  for (const char* extension : {".vtu", ".vtkhdf", ".msh"}) {
    for (const char* msh : {"2.2", "4.1"}) {
      for (const bool inner : {true, false}) {
        for (const char* ids : {"", "region", "material", "name"}) {
          SCOPED_TRACE(::testing::Message() << extension << msh << inner << ids);
          WriteOptions format;
          format.msh = msh;
          format.inner_lines = inner;
          format.ids = ids;
          const std::string a = folder.path() / (std::string("a") + extension);
          const std::string b = folder.path() / (std::string("b") + extension);
          ASSERT_EQ(needs_whole_mesh(a, format), "");
          ASSERT_TRUE(write_mesh(*whole, a, format));
          ASSERT_TRUE(write_streamed_mesh(*streamed, b, format));
          EXPECT_TRUE(content(a) == content(b));
          EXPECT_GT(content(b).size(), 500U);
          if (std::string(extension) != ".msh") break;
        }
      }
    }
  }
}

Options with_threads(unsigned threads, Method method = Method::quality) {
  Options options;
  options.threads = threads;
  options.method = method;
  return options;
}

TEST(StreamMesh, WritesTheFilesOfTheMeshInMemory) {
  for (const testing::RandomInput& device : testing::kRandomDevices) {
    for (const Method method : {Method::quality, Method::almond}) {
      for (const unsigned threads : {1U, 3U}) {
        SCOPED_TRACE(device.name);
        expect_same(device.make(5), with_threads(threads, method));
      }
    }
  }
}

/// Slits, loose edges, pinched vertices, isolated points, void, markers.
TEST(StreamMesh, WritesAwkwardGraphsAsInMemory) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Input input = testing::planar_graph(60, seed);
    for (std::size_t s = 0; s < input.segments.size(); ++s) {
      input.segments[s].marker = s % 5 == 0 ? 7 : 0;
      if (s % 7 == 0) input.segments[s].name = "contact";
    }
    const Options options = with_threads(2);
    if (const Result<Output> whole = cover_mesh(input, options); !whole) continue;
    expect_same(input, options);
  }
}

TEST(StreamMesh, TakesSizesAndCutsBeforeMeshing) {
  Options options = with_threads(2);
  options.sizes = {{"1", 0.05, false, ""}, {"", 0, false, "0.1 + 0.05*x"}};
  expect_same(testing::checker(4, 5, 3), options);
}

TEST(StreamMesh, HoldsAMeshThatIsSmall) {
  const testing::TemporaryFolder folder;
  const Result<StreamedOutput> streamed =
      stream_mesh(testing::checker(3, 4, 1), with_threads(1), {folder.path() / "x", 1e6});
  ASSERT_TRUE(streamed);
  EXPECT_FALSE(streamed->is_streamed());
  EXPECT_GT(streamed->output.mesh.triangles(), 100U);
}

TEST(StreamMesh, SaysWhatNeedsTheWholeMesh) {
  const Input input = testing::checker(2, 3, 1);
  Options options;
  EXPECT_EQ(needs_whole_mesh(input, options), "");
  options.split_interfaces = Angle::degrees(95);
  EXPECT_NE(needs_whole_mesh(input, options).find("cutting"), std::string::npos);
  options = {};
  options.method = Method::nonobtuse;
  EXPECT_NE(needs_whole_mesh(input, options).find("nonobtuse"), std::string::npos);
  options = {};
  options.hull = true;
  EXPECT_NE(needs_whole_mesh(input, options), "");
  Input map = input, doped = input;
  map.attributes.push_back({"use", false, {}, {1}});
  EXPECT_NE(needs_whole_mesh(map, {}).find("attributes"), std::string::npos);
  doped.field = std::make_shared<const PlaneField>();
  EXPECT_NE(needs_whole_mesh(doped, {}).find("values"), std::string::npos);
  EXPECT_NE(needs_whole_mesh("x.vtu", WriteOptions{.order = 2}), "");
  EXPECT_NE(needs_whole_mesh("x.svg", {}).find(".svg"), std::string::npos);
}

/// In every stage, and as with a mesh in memory: nothing of it is an error of cover.
TEST(StreamMesh, WhatTheProgressFunctionThrowsReachesTheCaller) {
  const testing::TemporaryFolder folder;
  for (const char* stage : {"clean", "regions", "mesh"}) {
    Callbacks callbacks;
    callbacks.progress = [&](const Progress& progress) {
      if (progress.stage == stage) throw std::runtime_error("enough");
    };
    EXPECT_THROW(
        (void)stream_mesh(testing::checker(6, 6, 16), {}, {folder.path() / "x", 0}, callbacks),
        std::runtime_error)
        << stage;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << stage;
  }
}

TEST(StreamMesh, FailsWhereThereIsNoFolder) {
  const testing::TemporaryFolder folder;
  const Result<StreamedOutput> nowhere = stream_mesh(testing::checker(2, 3, 1), with_threads(1),
                                                     {folder.path() / "none" / "x.vtu", 0});
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ErrorCode::cannot_write);
}

TEST(StreamMesh, RefusesWhatNeedsTheWholeMesh) {
  const testing::TemporaryFolder folder;
  Options disks, hull, cut;
  disks.method = Method::nonobtuse;
  hull.hull = true;
  cut.split_interfaces = Angle::degrees(90);
  for (const Options& options : {disks, hull, cut}) {
    const Result<StreamedOutput> streamed =
        stream_mesh(testing::checker(2, 3, 1), options, {folder.path() / "x", 0});
    ASSERT_FALSE(streamed);
    EXPECT_EQ(streamed.error().code, ErrorCode::bad_option) << streamed.error().message;
  }
}

TEST(StreamMesh, RefusesFilesThatNeedTheWholeMesh) {
  const testing::TemporaryFolder folder;
  const Result<StreamedOutput> streamed =
      stream_mesh(testing::checker(2, 3, 1), {}, {folder.path() / "x", 0});
  ASSERT_TRUE(streamed);
  WriteOptions version;
  version.msh = "9";
  for (const auto& [output, name, options] :
       {std::tuple(*streamed, "st.vtm", WriteOptions()), std::tuple(*streamed, "st.msh", version),
        std::tuple(StreamedOutput(), "st.vtu", WriteOptions())}) {
    const Status status = write_streamed_mesh(output, folder.path() / name, options);
    ASSERT_FALSE(status) << name;
    EXPECT_EQ(status.error().code, ErrorCode::bad_option) << status.error().message;
  }
}

}  // namespace
}  // namespace cover
