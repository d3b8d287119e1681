// Regions that stay in the processes which mesh them: the file is that of one process.
#include <cover/kept_regions.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <cover/options.hpp>
#include <cover/stream_mesh.hpp>

#include "stream/keep_bytes.hpp"
#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

std::string bytes_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Other processes, which are none here: every region but each `ranks`-th goes to one of them.
class Others {
 public:
  explicit Others(std::size_t ranks) : kept_(ranks - 1) {}

  Callbacks callbacks() {
    Callbacks out;
    out.share_out = [this](RegionJobs& jobs) { return share_out(jobs); };
    out.write_elsewhere = [this](const Bytes& plan, const std::function<Status()>& here) {
      Status all = here();
      for (const std::optional<KeptRegions>& kept : kept_) {
        Status status = kept->write(plan, 2);
        if (all && !status) all = std::move(status);
      }
      return all;
    };
    return out;
  }

  bool agrees = true;
  bool was_agreed = false;

 private:
  Status share_out(RegionJobs& jobs) {
    const Result<Options> options = options_of_bytes(jobs.options());
    if (!options) return options.error();
    was_agreed = jobs.offer_to_keep([this](const Bytes& how) {
      for (std::optional<KeptRegions>& kept : kept_) {
        Result<KeptRegions> opened = KeptRegions::open(how);
        EXPECT_TRUE(opened);
        if (!opened) return false;
        kept.emplace(*std::move(opened));
      }
      return agrees;
    });
    for (std::size_t k = jobs.size(); k-- > 0;) {
      const std::size_t rank = k % (kept_.size() + 1);
      if (rank == kept_.size()) {
        jobs.mesh_here(k);
      } else if (!was_agreed) {
        jobs.accept(k, mesh_region_bytes(jobs.boundary(k), *options));
      } else {
        std::vector<Bytes> bytes{jobs.boundary(k)};
        kept_[rank]->mesh(std::vector{k}, bytes, *options, 1);
        jobs.accept(k, bytes.front());
      }
    }
    return ok();
  }

  std::vector<std::optional<KeptRegions>> kept_;
};

/// The report without what is measured in seconds.
std::string report_of(StreamedOutput output) {
  output.output.report.times.clear();
  for (RegionReport& region : output.output.report.regions) region.seconds = 0;
  return report_json(output);
}

void expect_same_file(const Input& input, const Options& options) {
  const testing::TemporaryFolder folder;
  const std::string alone = folder.path() / "alone.vtkhdf", kept = folder.path() / "kept.vtkhdf";
  const Result<StreamedOutput> one = stream_mesh(Input(input), options, {alone, 0});
  ASSERT_TRUE(one);
  ASSERT_TRUE(write_streamed_mesh(*one, alone));
  for (const std::size_t ranks : {2U, 3U, 7U}) {
    for (const bool agrees : {true, false}) {
      SCOPED_TRACE(::testing::Message() << ranks << " ranks, " << agrees);
      Others others(ranks);
      others.agrees = agrees;
      const Result<StreamedOutput> shared =
          stream_mesh(Input(input), options, {kept, 0, true}, others.callbacks());
      ASSERT_TRUE(shared) << shared.error().message;
      EXPECT_EQ(others.was_agreed, agrees);
      EXPECT_EQ(report_of(*shared), report_of(*one));
      const Status written = write_streamed_mesh(*shared, kept);
      ASSERT_TRUE(written) << written.error().message;
      EXPECT_TRUE(bytes_in(kept) == bytes_in(alone));
      const Status refused = write_streamed_mesh(*shared, folder.path() / "x.vtu");
      EXPECT_EQ(refused.has_value(), !agrees);
    }
  }
}

TEST(KeptRegions, MakeTheFileOfOneProcess) {
  for (const testing::RandomInput& device : testing::kRandomDevices) {
    SCOPED_TRACE(device.name);
    Options options;
    options.threads = 2;
    expect_same_file(device.make(5), options);
  }
}

/// Slits, loose edges, pinched vertices, isolated points, void; regions of many sizes.
TEST(KeptRegions, MakeTheFileOfAwkwardGraphs) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const Input input = testing::planar_graph(60, seed);
    Options options;
    options.threads = 1;
    options.sizes = {{"", 0, false, "0.1 + 0.05*x"}};
    const testing::TemporaryFolder folder;
    if (!stream_mesh(Input(input), options, {folder.path() / "x", 0})) continue;
    expect_same_file(input, options);
  }
}

TEST(KeptRegions, AreNotOfferedWhereMeshesMayNotStay) {
  const testing::TemporaryFolder folder;
  Others others(2);
  const Result<StreamedOutput> shared = stream_mesh(
      testing::checker(3, 2, 1), Options(), {folder.path() / "x.vtkhdf", 0}, others.callbacks());
  ASSERT_TRUE(shared);
  EXPECT_FALSE(others.was_agreed);
  EXPECT_TRUE(write_streamed_mesh(*shared, folder.path() / "x.vtu"));
}

TEST(KeptRegions, FailWithTheOtherProcess) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "x.vtkhdf";
  Others others(2);
  Callbacks callbacks = others.callbacks();
  callbacks.write_elsewhere = [](const Bytes&, const std::function<Status()>& here) -> Status {
    EXPECT_TRUE(here());
    return Error{ErrorCode::cannot_write, "rank 1: no space left", {}, {}};
  };
  const Result<StreamedOutput> shared =
      stream_mesh(testing::checker(3, 2, 1), Options(), {path, 0, true}, callbacks);
  ASSERT_TRUE(shared);
  const Status written = write_streamed_mesh(*shared, path);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message, "rank 1: no space left");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(KeptRegions, RefuseAFolderThatTheyDoNotSee) {
  const testing::TemporaryFolder folder;
  const std::string seen = folder.path() / "seen";
  std::ofstream(seen) << "12345678";
  const OfferToKeep offer{folder.path() / "x.vtkhdf", seen, 0, 10, 2};
  const Result<KeptRegions> other_word = KeptRegions::open(bytes_of(offer));
  ASSERT_FALSE(other_word);
  EXPECT_EQ(other_word.error().code, ErrorCode::cannot_write);
}

TEST(KeptRegions, RefuseBytesThatAreNotWhole) {
  const OfferToKeep offer{"/x/y.vtkhdf", "/x/.y", 7, 10, 2};
  Bytes bytes = bytes_of(offer);
  const auto read = value_of<OfferToKeep>(bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->beside, offer.beside);
  EXPECT_EQ(read->seen, offer.seen);
  EXPECT_EQ(read->regions, 2U);
  const ColumnPlan plan{"/x/.y", "y", 5, {{Column::places, 100}, {Column::types, 7}}, {{1, 2, 3}}};
  Bytes of_plan = bytes_of(plan);
  const auto read_plan = value_of<ColumnPlan>(of_plan);
  ASSERT_TRUE(read_plan);
  EXPECT_EQ(read_plan->columns[1].at, 7U);
  EXPECT_EQ(read_plan->regions[0].material, 3);
  while (!bytes.empty()) {
    bytes.pop_back();
    EXPECT_FALSE(value_of<OfferToKeep>(bytes)) << bytes.size();
  }
  while (!of_plan.empty()) {
    of_plan.pop_back();
    EXPECT_FALSE(value_of<ColumnPlan>(of_plan)) << of_plan.size();
  }
}

}  // namespace
}  // namespace cover
