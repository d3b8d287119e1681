// Tested by tests/unit/io/write_mesh/placed_file_test.cpp.
#include "io/write_mesh/placed_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "io/files/temporary_file.hpp"

namespace cover {
namespace {

constexpr std::size_t kBetweenStops = 1 << 20;  // bytes between two looks at the stop token

}  // namespace

Result<PlacedFile> PlacedFile::open(const std::filesystem::path& path, std::string shown,
                                    std::stop_token stop) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return cannot_write(shown, errno);
  return PlacedFile(file, std::move(shown), std::move(stop));
}

PlacedFile::PlacedFile(PlacedFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      shown_(std::move(other.shown_)),
      stop_(std::move(other.stop_)),
      failure_(other.failure_.load()) {}

PlacedFile::~PlacedFile() {
  if (file_ >= 0) close(file_);
}

void PlacedFile::fail(int number) {
  int none = 0;
  failure_.compare_exchange_strong(none, number);
}

void PlacedFile::resize(std::uint64_t size) {
  while (ftruncate(file_, static_cast<off_t>(size)) != 0)
    if (errno != EINTR) return fail(errno);
}

void PlacedFile::write(std::uint64_t at, std::string_view bytes) {
  [[maybe_unused]] const std::size_t all = bytes.size();
  while (!bytes.empty() && is_good()) {
    const ssize_t n =
        pwrite(file_, bytes.data(), std::min(bytes.size(), kBetweenStops), static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
    at += static_cast<std::uint64_t>(n);
  }
#ifdef SYNC_FILE_RANGE_WRITE
  // The disk begins at once, so that the sync at the end takes little time. What fails here fails
  // again in fsync.
  if (all >= kBetweenStops && is_good())
    (void)sync_file_range(file_, static_cast<off_t>(at - all), static_cast<off_t>(all),
                          SYNC_FILE_RANGE_WRITE);
#endif
}

Status PlacedFile::finish() {
  if (is_good() && fsync(file_) != 0) fail(errno);
  if (failure_ != 0) return cannot_write(shown_, failure_);
  if (!stop_.stop_requested()) return ok();
  return not_written(shown_);
}

}  // namespace cover
