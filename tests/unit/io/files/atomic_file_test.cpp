#include "io/files/atomic_file.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <sstream>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

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

TEST(AtomicFile, KeepsSymbolicLinks) {
  const TemporaryFolder folder;
  const fs::path link = folder.path() / "link.txt", inner = folder.path() / "inner";
  fs::create_directory(inner);
  const fs::path target = inner / "mesh.txt";
  fs::create_symlink("second.txt", link);
  fs::create_symlink("inner/mesh.txt", folder.path() / "second.txt");
  for (const char* text :
       {"first", "again"}) {  // where the links lead nowhere, and where there is one
    auto file = AtomicFile::create(link.string());
    ASSERT_TRUE(file) << file.error().message;
    file->write(text);
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(content(target), text);
    EXPECT_TRUE(fs::is_symlink(link));
  }
  EXPECT_EQ(files_in(inner), 1U);
  fs::create_symlink("circle.txt", folder.path() / "circle.txt");
  const auto endless = AtomicFile::create((folder.path() / "circle.txt").string());
  ASSERT_FALSE(endless);
  EXPECT_EQ(endless.error().code, ErrorCode::cannot_write);
}

TEST(AtomicFile, HandsPermissionsOn) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.txt";
  for (const auto mode : {fs::perms(0600), fs::perms(0664), fs::perms(0444)}) {
    std::ofstream(path) << "old";
    fs::permissions(path, mode);
    auto file = AtomicFile::create(path.string());
    ASSERT_TRUE(file);
    // Nobody reads in the meantime what they could not read before.
    for (const auto& entry : fs::directory_iterator(folder.path()))
      EXPECT_EQ(entry.status().permissions() & ~mode & fs::perms(0044), fs::perms::none);
    file->write("new");
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(content(path), "new");
    EXPECT_EQ(fs::status(path).permissions(), mode);
    fs::remove(path);
  }
}

TEST(AtomicFile, RemovesWhatKilledRunsLeftBehind) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.txt";
  for (const char* name : {".mesh.txt.0.tmp", ".mesh.txt.17.tmp"}) (void)folder.write(name, "half");
  const std::vector<std::string> foreign{".other.txt.0.tmp", ".mesh.txt.x.tmp", ".mesh.txt.tmp",
                                         "mesh.txt.0.tmp"};
  for (const std::string& name : foreign) (void)folder.write(name, "not ours");
  auto in_work = AtomicFile::create(path.string());
  ASSERT_TRUE(in_work);
  EXPECT_EQ(files_in(folder.path()), foreign.size() + 1);
  auto file = AtomicFile::create(path.string());
  ASSERT_TRUE(file);
  EXPECT_EQ(files_in(folder.path()), foreign.size() + 2);
  ASSERT_TRUE(file->commit());
  in_work->write("last");
  ASSERT_TRUE(in_work->commit());
  EXPECT_EQ(content(path), "last");
  EXPECT_EQ(files_in(folder.path()), foreign.size() + 1);
}

TEST(AtomicFile, NamesMayBeAsLongAsAFolderTakesThem) {
  const TemporaryFolder folder;
  for (const std::size_t length : {245U, 246U, 255U}) {
    const fs::path path = folder.path() / std::string(length, 'n');
    for (const char* const words : {"one", "two"}) {
      auto file = AtomicFile::create(path.string());
      ASSERT_TRUE(file) << file.error().message;
      file->write(words);
      ASSERT_TRUE(file->commit());
      EXPECT_EQ(content(path), words);
    }
    fs::remove(path);
    EXPECT_EQ(files_in(folder.path()), 0U);
  }
}

TEST(AtomicFile, HeedsAStop) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "mesh.txt";
  std::ofstream(path) << "old";
  for (const bool before : {true, false}) {
    std::stop_source stop;
    auto file = AtomicFile::create(path.string(), stop.get_token());
    ASSERT_TRUE(file);
    if (before) stop.request_stop();
    file->write("new");
    stop.request_stop();
    const Status status = file->commit();
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::cancelled);
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(files_in(folder.path()), 1U);
  }
}

TEST(AtomicFile, SaysThatTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const TemporaryFolder folder;
  const fs::path link = folder.path() / "mesh.txt";
  fs::create_symlink("/dev/full", link);
  auto file = AtomicFile::create(link.string());
  ASSERT_TRUE(file);
  file->write("new");
  const Status status = file->commit();
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
  EXPECT_NE(status.error().message.find("No space left on device"), std::string::npos);
}

TEST(AtomicFile, RefusesNamesWithAZeroByte) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a").string() + std::string("\0b.vtu", 6);
  EXPECT_FALSE(AtomicFile::create(path));
  EXPECT_EQ(files_in(folder.path()), 0U);
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

TEST(AtomicFile, FilesThatBelongTogetherStayOldWhereTheFirstCannotBeRenamed) {
  const TemporaryFolder folder;
  const fs::path first = folder.path() / "first", second = folder.path() / "second";
  for (const bool blocked : {true, false}) {
    std::ofstream(second) << "old";
    auto a = AtomicFile::create(first.string()), b = AtomicFile::create(second.string());
    ASSERT_TRUE(a && b);
    a->write("new");
    b->write("new");
    ASSERT_TRUE(a->prepare() && b->prepare());
    // A file cannot take the place of a folder.
    if (blocked) fs::create_directory(first);
    EXPECT_EQ(static_cast<bool>(commit_together(std::array{&*a, &*b})), !blocked);
    EXPECT_EQ(content(second), blocked ? "old" : "new");
    if (blocked) fs::remove(first);
  }
  EXPECT_EQ(content(first), "new");
  EXPECT_EQ(files_in(folder.path()), 2U);
}

TEST(AtomicFile, WritesToADeviceDirectly) {
  auto file = AtomicFile::create("/dev/null");
  ASSERT_TRUE(file);
  file->write("gone");
  EXPECT_TRUE(file->commit());
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST(AtomicFile, APipeWithoutAReaderOrWithASlowOneHeedsStops) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::stop_source stop;
  std::jthread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop.request_stop();
  });
  const auto nobody = AtomicFile::create(path, stop.get_token());
  ASSERT_FALSE(nobody);
  EXPECT_EQ(nobody.error().code, ErrorCode::cancelled);
  later.join();
  const std::string much(1 << 20, 'x');  // more than a pipe holds
  for (const bool reads : {true, false}) {
    stop = {};
    std::string got;
    std::promise<void> written;
    std::jthread reader([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      std::ifstream pipe(path);
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      if (reads) {
        got.assign(std::istreambuf_iterator<char>(pipe), {});
      } else {
        stop.request_stop();
        written.get_future().wait();
      }
    });
    Status status = ok();
    {
      auto file = AtomicFile::create(path, stop.get_token());
      ASSERT_TRUE(file) << file.error().message;
      file->write(much);
      status = file->commit();
    }
    written.set_value();
    reader.join();
    if (reads) {
      EXPECT_TRUE(status);
      EXPECT_TRUE(got == much);
    } else {
      ASSERT_FALSE(status);
      EXPECT_EQ(status.error().code, ErrorCode::cancelled);
    }
  }
  EXPECT_TRUE(fs::is_fifo(path));
}

}  // namespace
}  // namespace cover
