// What keeps a mesh in memory, and meshes that are made each way.
#include "commands/mesh/make_mesh.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <spdlog/logger.h>
#include <CLI/CLI.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace cover::app {
namespace {

/// A command that writes files.
struct Writing {
  explicit Writing(const std::vector<std::string>& words) {
    files.add_meshes(app, "stdout");
    files.add_reports(app, "Files");
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  }

  CLI::App app;
  OutputFiles files;
};

std::string why(const MeshPlan& plan, const std::vector<std::string>& words) {
  return what_needs_all_in_memory(plan, Writing(words).files, testing::checker(2, 2, 5), {});
}

TEST(MakeMesh, TellsWhatNeedsTheWholeMesh) {
  EXPECT_EQ(why({}, {"-o", "a.vtu", "--report", "a.json"}), "");
  EXPECT_EQ(why({{"1"}, "b.vtu", "auto"}, {"-o", "a.vtu"}), "--onto");
  EXPECT_EQ(why({}, {"-o", "-"}), "writing to standard output");
  EXPECT_EQ(why({}, {"-o", "a.vtu", "--report", "a.html"}), "a report that shows the mesh");
  EXPECT_NE(why({}, {"-o", "a.svg"}), "");
}

TEST(MakeMesh, StaysOnTheDiskIfThatIsAsked) {
  const testing::TemporaryFolder folder;
  const Writing one({"-o", folder.path() / "a.vtu"});
  spdlog::logger silent("silent");
  MeshPlan plan;
  for (const char* stream : {"on", "auto", "off"}) {
    plan.stream = stream;
    const Result<StreamedOutput> made =
        make_mesh(plan, one.files, testing::checker(2, 2, 5), {}, {}, silent);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->is_streamed(), plan.stream == "on");
    EXPECT_GT(made->counts.triangles, 0u);
  }
  plan.stream = "on";
  const Writing piped({"-o", "-"});
  const Result<StreamedOutput> refused =
      make_mesh(plan, piped.files, testing::checker(2, 2, 5), {}, {}, silent);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_option);
}

}  // namespace
}  // namespace cover::app
