// Memory runs out at every place once, in workers too: an error that says so, nothing lost, no end
// of the process.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/read_input.hpp>
#include <cover/read_mesh.hpp>
#include <cover/remesh.hpp>
#include <cover/share_out.hpp>
#include <cover/write_mesh.hpp>

#include "failing_allocations.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

using testing::Allocations;
using testing::end_of_failing_allocations;
using testing::fail_allocation;

/// So many of the first allocations fail, one by one; then some of the others, by chance.
struct Which {
  std::size_t one_by_one = 150;
  std::size_t by_chance = 250;
};
constexpr Which kOfLongRuns{0, 20};

/// CGAL's Compact_container hands a new block to a list, and loses it where the list cannot grow
/// (Compact_container.h, allocate_new_block): a block of 16, 32, ... vertices or faces, at most one
/// for each failure, asked for just before it.
bool is_block_of_cgal(const Allocations& found) {
  return found.left == 1 && found.left_before_failure > 0 &&
         found.left_size == found.left_before_failure && found.left_size % (16 * 8) == 0;
}

/// What a run came to: a number that all good runs have in common, made without an allocation.
using Outcome = Result<std::uint64_t>;
using Run = std::function<Outcome()>;
/// A number for what a good run left outside of memory.
using Remainder = std::function<std::uint64_t()>;

struct RunCounts {
  std::size_t runs = 0;
  std::size_t errors = 0;
  std::size_t blocks_of_cgal = 0;
};

/// Runs `run` while one allocation after the other fails.
RunCounts let_allocations_fail(
    const Run& run, const Which& which = {}, const Remainder& remainder = [] { return 0; }) {
  RunCounts counts;
  fail_allocation(0);
  const Outcome good = run();
  const std::size_t all = end_of_failing_allocations().count;
  EXPECT_TRUE(good.has_value()) << good.error().message;
  if (!good.has_value()) return counts;
  const std::uint64_t rest = remainder();
  const std::uint64_t seed = testing::test_seed(61);
  std::mt19937_64 random(seed);
  const std::size_t most = which.one_by_one + which.by_chance;
  for (std::size_t k = 1; k <= std::min(all, most); ++k) {
    const bool one_by_one = all <= most || k <= which.one_by_one;
    const std::size_t at = one_by_one ? k : 1 + random() % all;
    SCOPED_TRACE(testing::seed_trace(seed) + ", allocation " + std::to_string(at) + " of " +
                 std::to_string(all));
    fail_allocation(at);
    std::optional<Outcome> outcome = run();
    // The message of an error is still there; it goes before what is left is counted.
    const bool has_value = outcome->has_value();
    const ErrorCode code = has_value ? ErrorCode::internal : outcome->error().code;
    std::array<char, 200> message{};
    if (!has_value) outcome->error().message.copy(message.data(), message.size() - 1);
    const bool is_same = has_value && outcome->value() == good.value();
    outcome.reset();
    const Allocations found = end_of_failing_allocations();
    ++counts.runs;
    if (has_value) {
      // Some algorithms of the C++ library do with less memory.
      EXPECT_TRUE(is_same && remainder() == rest);
    } else {
      ++counts.errors;
      EXPECT_EQ(code, ErrorCode::out_of_memory) << message.data();
      EXPECT_NE(std::string(message.data()).find("out of memory"), std::string::npos)
          << message.data();
    }
    if (is_block_of_cgal(found)) {
      ++counts.blocks_of_cgal;
      testing::free_block_before_failure();  // else leak checkers list it
    } else {
      EXPECT_EQ(found.left, 0U) << found.left_size << " bytes lost, " << found.left_before_failure
                                << " asked for just before";
    }
    if (::testing::Test::HasFailure()) break;
  }
  std::printf("%zu allocations, %zu of them failed, %zu errors, %zu blocks lost by CGAL\n", all,
              counts.runs, counts.errors, counts.blocks_of_cgal);
  return counts;
}

std::uint64_t number_of(const TriMesh& mesh) {
  std::uint64_t hash = mesh.n_faces();
  for (const auto v : mesh.vertices()) {
    const auto p = mesh.point(v);
    hash =
        (hash * 31 + std::bit_cast<std::uint64_t>(p[0])) * 31 + std::bit_cast<std::uint64_t>(p[1]);
  }
  return hash;
}

std::uint64_t number_of_files(const std::filesystem::path& folder) {
  std::uint64_t hash = 0;  // in whatever order
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::ostringstream text;
    if (entry.is_regular_file()) text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    hash += std::hash<std::string>()(entry.path().string() + text.str());
  }
  return hash;
}

class AllocationFaults : public ::testing::Test {
 protected:
  Input input_ = testing::checker(2, 3, 5);
  testing::TemporaryFolder folder_;
};

struct MethodCase {
  const char* name;
  Options options;
};

std::vector<MethodCase> cases() {
  std::vector<MethodCase> all(6);
  all[0].name = "quality";
  all[1].name = "almond";
  all[1].options.method = Method::almond;
  all[2].name = "disks";
  all[2].options.method = Method::almond;
  all[2].options.fill = Fill::disks;
  all[3].name = "nonobtuse";
  all[3].options.method = Method::nonobtuse;
  all[4].name = "split";
  all[4].options.split_interfaces = Angle::degrees(90);
  all[4].options.sizes = {{"", 0.2}};
  all[5].name = "box";
  all[5].options.box_method = true;
  return all;
}

TEST_F(AllocationFaults, EveryMethodEndsWithAnError) {
  // Regions of a thousand sides and points are a task of their own, tiny ones share one.
  const Input of_tasks = testing::checker(2, 125, 5);
  for (MethodCase& each : cases()) {
    // What is beside the regions is the same with one thread, and takes long for many sides.
    const bool long_too = each.name == std::string("quality") || each.name == std::string("almond");
    for (const unsigned threads : {1U, 3U}) {
      if (threads > 1 && !long_too) continue;
      SCOPED_TRACE(std::string(each.name) + ", threads " + std::to_string(threads));
      each.options.threads = threads;
      const Input& input = threads == 1 ? input_ : of_tasks;
      const RunCounts counts = let_allocations_fail(
          [&]() -> Outcome {
            Result<Output> output = cover_mesh(input, each.options);
            if (!output) return std::move(output).error();
            return number_of(output->mesh.tri());
          },
          threads == 1 ? Which{} : kOfLongRuns);
      EXPECT_GT(counts.errors, counts.runs / 2);
      if (HasFailure()) return;
    }
  }
}

TEST_F(AllocationFaults, EveryReaderEndsWithAnError) {
  const Output output = cover_mesh(input_).value();
  const std::filesystem::path& folder = folder_.path();
  ASSERT_TRUE(write_poly(output.pslg, output.table, (folder / "g.poly").string()));
  for (const char* name :
       {"m.vtu", "m.vtm", "m.msh", "m.mesh", "m.inp", "m.ele", "m.vtk", "m.xdmf"})
    ASSERT_TRUE(write_mesh(output, (folder / name).string())) << name;
  std::ofstream(folder / "g.json") << R"({"points": [[0, 0], [1, 0], [1, 1], [0, 1]],
      "segments": [[0, 1], [1, 2], [2, 3], [3, 0]],
      "polygons": [{"material": "a material that is long enough for a block of its own",
                    "rings": [[[2, 0], [3, 0], [3, 1]], [[2.5, 0.1], [2.6, 0.1], [2.6, 0.2]]]}]})";
  for (const char* name : {"g.poly", "g.json", "m.msh", "m.vtu", "m.vtk"}) {
    SCOPED_TRACE(std::string("input ") + name);
    const std::string path = (folder / name).string();
    let_allocations_fail([&]() -> Outcome {
      Result<Input> input = read_input(path);
      if (!input) return std::move(input).error();
      return input->points.size();
    });
    if (HasFailure()) return;
  }
  for (const char* name :
       {"m.vtu", "m.vtm", "m.msh", "m.mesh", "m.inp", "m.ele", "m.vtk", "m.xdmf"}) {
    SCOPED_TRACE(std::string("mesh ") + name);
    const std::string path = (folder / name).string();
    let_allocations_fail([&]() -> Outcome {
      Result<Output> mesh = read_output(path);
      if (!mesh) return std::move(mesh).error();
      return number_of(mesh->mesh.tri());
    });
    if (HasFailure()) return;
  }
}

TEST_F(AllocationFaults, EveryWriterEndsWithAnErrorAndKeepsTheFile) {
  const Output output = cover_mesh(input_).value();
  for (const std::string& extension : write_formats()) {
    // The JSON library ends the process where memory runs out while values are given back, for
    // which it makes a list. Files stay whole then too: see write_faults_test.
    if (extension == ".json") continue;
    SCOPED_TRACE(extension);
    const std::filesystem::path folder = folder_.path() / extension.substr(1);
    std::filesystem::create_directory(folder);
    const std::string path = (folder / ("m" + extension)).string();
    let_allocations_fail(
        [&]() -> Outcome {
          Status status = write_mesh(output, path);
          if (!status) return std::move(status).error();
          return 0;
        },
        {}, [&] { return number_of_files(folder); });
    if (HasFailure()) return;
  }
}

TEST_F(AllocationFaults, MeshingAgainEndsWithAnError) {
  const Output output = cover_mesh(input_).value();
  const TriangleSoup soup = triangle_soup(output.mesh);
  const std::vector<std::string> only{output.table.regions.front().name};
  let_allocations_fail([&]() -> Outcome {
    Result<Output> again = remesh(input_, soup, only);
    if (!again) return std::move(again).error();
    return number_of(again->mesh.tri());
  });
}

/// Meshes the first region elsewhere, which `elsewhere` does, and the others here.
ShareOut first_elsewhere(const std::function<Bytes(const Bytes&)>& elsewhere) {
  return [elsewhere](RegionJobs& jobs) {
    for (std::size_t k = 1; k < jobs.size(); ++k) jobs.mesh_here(k);
    jobs.accept(0, elsewhere(jobs.boundary(0)));
    return ok();
  };
}

/// The failures after the first are those of telling of it.
TEST_F(AllocationFaults, AProcessThatMeshesForAnotherTellsOfAllFailuresInARow) {
  std::size_t untold = 0;
  for (const std::size_t in_a_row : {1U, 2U, 3U, 8U}) {
    for (std::size_t at = 1; at <= 200; ++at) {
      SCOPED_TRACE(std::to_string(in_a_row) + " from allocation " + std::to_string(at) + " on");
      Callbacks callbacks;
      callbacks.share_out = first_elsewhere([&](const Bytes& boundary) {
        fail_allocation(at, in_a_row);
        Bytes bytes;
        EXPECT_NO_THROW(bytes = mesh_region_bytes(boundary, Options()));
        end_of_failing_allocations();
        untold += bytes.empty() ? 1 : 0;
        return bytes;
      });
      const Result<Output> output = cover_mesh(input_, {}, callbacks);
      if (!output) {
        EXPECT_EQ(output.error().code, ErrorCode::out_of_memory) << output.error().message;
      }
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(untold, 0U);
}

}  // namespace
}  // namespace cover
