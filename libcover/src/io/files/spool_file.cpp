// Tested by tests/unit/io/files/spool_file_test.cpp.
#include "io/files/spool_file.hpp"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "io/files/temporary_file.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kOwnerOnly = 0600;
constexpr int kMostSpools = 10000;

/// Where a file stands that is to replace `target`.
fs::path folder_of(const std::string& target) {
  std::error_code ignored;
  const Result<fs::path> end = end_of_links(target);
  if (!end || (fs::exists(*end, ignored) && !fs::is_regular_file(*end, ignored)))
    return fs::temp_directory_path(ignored);
  return end->has_parent_path() ? end->parent_path() : fs::path(".");
}

/// A file whose name is gone as soon as it is there, for systems that make none without. Who is
/// killed in between leaves what remove_leftovers() finds.
int open_and_unlink(const fs::path& folder, const std::string& name) {
  for (int n = 0; n < kMostSpools; ++n) {
    const fs::path path = folder / temporary_name(name, n);
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kOwnerOnly);
    if (file >= 0) unlink(path.c_str());
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

}  // namespace

Result<SpoolFile> SpoolFile::beside(const std::string& target) {
  const fs::path folder = folder_of(target);
  int file = -1;
#ifdef O_TMPFILE
  file = open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, kOwnerOnly);
#endif
  if (file < 0) file = open_and_unlink(folder, fs::path(target).filename().string());
  if (file < 0) return cannot_write(target, errno);
  return SpoolFile(file, target);
}

SpoolFile::SpoolFile(SpoolFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      shown_(std::move(other.shown_)),
      end_(other.end_.load()),
      failure_(other.failure_.load()) {}

SpoolFile::~SpoolFile() {
  if (file_ >= 0) close(file_);
}

std::uint64_t SpoolFile::append(std::span<const std::byte> bytes) {
  const std::uint64_t begin = end_.fetch_add(bytes.size());
  std::uint64_t at = begin;
  while (!bytes.empty() && failure_ == 0) {
    const ssize_t n = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      int none = 0;
      failure_.compare_exchange_strong(none, errno);
      break;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(n));
    at += static_cast<std::uint64_t>(n);
  }
  return begin;
}

Status SpoolFile::read(std::uint64_t at, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t n = pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return cannot_write(shown_, n < 0 ? errno : EIO);
    bytes = bytes.subspan(static_cast<std::size_t>(n));
    at += static_cast<std::uint64_t>(n);
  }
  return ok();
}

Status SpoolFile::status() const {
  return failure_ == 0 ? ok() : Status(cannot_write(shown_, failure_));
}

Status check_room(const std::string& target, double bytes) {
  constexpr double kMegabyte = 1e6;
  struct statvfs disk {};
  if (statvfs(folder_of(target).c_str(), &disk) != 0) return ok();  // whoever writes will see
  const double free = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
  if (bytes <= free) return ok();
  return Error{
      ErrorCode::cannot_write,
      fmt::format("cannot write {}: it takes about {:.3g} MB, and the disk has {:.3g} left", target,
                  bytes / kMegabyte, free / kMegabyte),
      {},
      {}};
}

}  // namespace cover
