// The temporary file is created exclusively ("x" of fopen) under the first free name
// `.NAME.N.tmp` beside the target, so that two runs never share one and the rename stays on one
// file system. Tested by tests/unit/io/files/atomic_file_test.cpp.
#include "io/files/atomic_file.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace cover {
namespace {

namespace fs = std::filesystem;

constexpr int kMostNames = 10000;  // temporary files that crashed runs may have left behind

/// A device or a pipe: nothing that a rename should replace.
bool is_special(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

}  // namespace

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  AtomicFile out;
  out.path_ = path;
  const fs::path target(path);
  std::error_code ignored;
  if (fs::is_directory(target, ignored)) return out.failure(EISDIR);
  if (is_special(target)) {
    out.temporary_ = path;
    out.file_.reset(std::fopen(path.c_str(), "wb"));
    if (!out.file_) return out.failure(errno);
    return out;
  }
  for (int n = 0; n < kMostNames; ++n) {
    const fs::path name =
        target.parent_path() / fmt::format(".{}.{}.tmp", target.filename().string(), n);
    out.file_.reset(std::fopen(name.c_str(), "wbx"));
    if (out.file_) {
      out.temporary_ = name.string();
      return out;
    }
    if (errno != EEXIST) return out.failure(errno);
  }
  return out.failure(EEXIST);
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept { *this = std::move(other); }

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this != &other) {
    discard();
    path_ = std::move(other.path_);
    temporary_ = std::exchange(other.temporary_, {});
    file_ = std::move(other.file_);
    first_failure_ = other.first_failure_;
  }
  return *this;
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::discard() {
  if (temporary_.empty() || temporary_ == path_) return;
  file_.reset();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void AtomicFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() &&
      first_failure_ == 0) {
    first_failure_ = errno;
  }
}

void AtomicFile::release() {
  if (!file_) return;
  if (std::fclose(file_.release()) != 0 && first_failure_ == 0) first_failure_ = errno;
}

Status AtomicFile::commit() {
  release();
  if (first_failure_ != 0) return failure(first_failure_);
  if (temporary_ == path_) return ok();
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) return failure(errno);
  temporary_.clear();
  return ok();
}

Error AtomicFile::failure(int number) const {
  return {ErrorCode::cannot_write,
          fmt::format("cannot write {}: {}", path_, std::strerror(number)),
          {},
          {}};
}

}  // namespace cover
