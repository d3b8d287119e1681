// A file without a name: what goes in comes out, and nothing is left of it.
#include "io/files/spool_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

std::vector<int> numbers_from(int first, std::size_t count) {
  std::vector<int> all(count);
  for (std::size_t k = 0; k < count; ++k) all[k] = first + static_cast<int>(k);
  return all;
}

TEST(SpoolFile, ReadsWhatThreadsAppended) {
  const testing::TemporaryFolder folder;
  Result<SpoolFile> file = SpoolFile::beside(folder.path() / "x.vtu");
  ASSERT_TRUE(file);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  constexpr std::size_t kEach = 1000;
  std::vector<std::uint64_t> places(8);
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < places.size(); ++k) {
      threads.emplace_back([&, k] {
        const std::vector<int> numbers = numbers_from(static_cast<int>(k * kEach), kEach);
        places[k] = file->append(std::as_bytes(std::span(numbers)));
      });
    }
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    std::vector<int> read(kEach);
    ASSERT_TRUE(file->read(places[k], std::as_writable_bytes(std::span(read))));
    EXPECT_EQ(read, numbers_from(static_cast<int>(k * kEach), kEach));
  }
  EXPECT_TRUE(file->status());
}

TEST(SpoolFile, TellsOfWhatIsNotThere) {
  const testing::TemporaryFolder folder;
  Result<SpoolFile> file = SpoolFile::beside(folder.path() / "x.vtu");
  ASSERT_TRUE(file);
  std::vector<int> read(1);
  const Status status = file->read(0, std::as_writable_bytes(std::span(read)));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
  const Result<SpoolFile> nowhere = SpoolFile::beside(folder.path() / "none" / "x.vtu");
  ASSERT_FALSE(nowhere);
  EXPECT_NE(nowhere.error().message.find("x.vtu"), std::string::npos);
}

TEST(CheckRoom, ComparesWithTheDisk) {
  const testing::TemporaryFolder folder;
  EXPECT_TRUE(check_room(folder.path() / "x.vtu", 0));
  const Status full = check_room(folder.path() / "x.vtu", std::numeric_limits<double>::max());
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().code, ErrorCode::cannot_write);
  EXPECT_NE(full.error().message.find("it takes about 1.8e+302 MB, and the disk has "),
            std::string::npos)
      << full.error().message;
}

}  // namespace
}  // namespace cover
