#include "io/files/atomic_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

std::string content(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path).rdbuf();
  return out.str();
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(AtomicFile, AppearsOnlyOnCommit) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.txt";
  auto file = AtomicFile::create(path.string());
  ASSERT_TRUE(file) << file.error().message;
  file->write("one ");
  file->write("two");
  EXPECT_FALSE(fs::exists(path));
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(content(path), "one two");
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(AtomicFile, LeavesTheOldFileWhenNotCommitted) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.txt";
  std::ofstream(path) << "old";
  {
    auto file = AtomicFile::create(path.string());
    ASSERT_TRUE(file);
    file->write("new");
  }
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(AtomicFile, LetsALibraryWriteUnderTheTemporaryName) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.txt";
  auto file = AtomicFile::create(path.string());
  ASSERT_TRUE(file);
  file->release();
  std::ofstream(file->temporary_path()) << "by others";
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(content(path), "by others");
}

TEST(AtomicFile, SaysWhyAFileCannotBeWritten) {
  const TemporaryFolder folder;
  const auto missing = AtomicFile::create((folder.path() / "no" / "mesh.txt").string());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::cannot_write);
  EXPECT_NE(missing.error().message.find("mesh.txt: No such file or directory"), std::string::npos)
      << missing.error().message;
  EXPECT_FALSE(AtomicFile::create(folder.path().string()));
}

TEST(AtomicFile, WritesToADeviceDirectly) {
  auto file = AtomicFile::create("/dev/null");
  ASSERT_TRUE(file);
  file->write("gone");
  EXPECT_TRUE(file->commit());
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

}  // namespace
}  // namespace cover
