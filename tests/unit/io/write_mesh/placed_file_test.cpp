// Parts of a file written by several threads, and what goes wrong there.
#include "io/write_mesh/placed_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

std::string read_back(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(PlacedFile, HasWhatThreadsWroteAndZeros) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "x";
  std::ofstream(path).close();
  Result<PlacedFile> file = PlacedFile::open(path, "x");
  ASSERT_TRUE(file);
  constexpr std::size_t kPart = 3 << 20, kParts = 5;
  file->resize(kPart * kParts + 7);
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < kParts; ++k)
      threads.emplace_back(
          [&file, k] { file->write(k * kPart, std::string(kPart, static_cast<char>('a' + k))); });
  }
  ASSERT_TRUE(file->finish());
  std::string expected;
  for (std::size_t k = 0; k < kParts; ++k)
    expected += std::string(kPart, static_cast<char>('a' + k));
  expected += std::string(7, '\0');
  EXPECT_TRUE(read_back(path) == expected);
}

TEST(PlacedFile, TellsWhatFailed) {
  const testing::TemporaryFolder folder;
  const Result<PlacedFile> none = PlacedFile::open(folder.path() / "none", "shown.vtkhdf");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("shown.vtkhdf"), std::string::npos);

  Result<PlacedFile> full = PlacedFile::open("/dev/full", "shown.vtkhdf");
  ASSERT_TRUE(full);
  full->write(0, "abc");
  EXPECT_FALSE(full->is_good());
  const Status failed = full->finish();
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::cannot_write);
}

TEST(PlacedFile, HeedsAStop) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "x";
  std::ofstream(path).close();
  std::stop_source stop;
  Result<PlacedFile> file = PlacedFile::open(path, "x", stop.get_token());
  ASSERT_TRUE(file);
  file->write(0, "abc");
  stop.request_stop();
  file->write(3, "def");
  const Status stopped = file->finish();
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
  EXPECT_EQ(read_back(path), "abc");
}

}  // namespace
}  // namespace cover
