// The lock is flock's, which the system gives back whatever ends a process. Whoever removes what
// another run has left behind locks it first, and then looks whether the name still means what it
// has locked; whoever has just created a file does the same. So nobody's work is removed. On file
// systems without locks nothing is removed at all.
// Tested by tests/unit/io/files/atomic_file_test.cpp and tests/faults.
#include "io/files/temporary_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "base/content_hash.hpp"
#include "base/words/characters.hpp"
#include "io/files/names_in_folder.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

constexpr int kMostNames = 10000;        // of runs that write to one name at the same time
constexpr int kMostLinks = 40;           // as the kernel has it
constexpr std::size_t kPiece = 1 << 20;  // bytes between two looks at the stop token
constexpr std::int64_t kPush =
    16 << 20;  // bytes that may wait for the disk: a second on a slow one

constexpr int kWait = 20;  // milliseconds between two looks at the stop token, where a pipe waits

constexpr mode_t kPermissions = 0777;
constexpr mode_t kNewFile = 0666;  // less the umask

/// What stands for a file's name in those of its temporary files: the name, unless these would be
/// longer than a folder takes.
std::string stem_of(std::string_view name) {
  constexpr std::size_t kMost = NAME_MAX - std::string_view("..9999.tmp").size(), kKept = 200;
  if (name.size() <= kMost) return std::string(name);
  ContentHash hash;
  hash.add(name);
  return std::string(name.substr(0, kKept)) + hash.text();
}

/// Whether `file` is `.STEM.N.tmp`.
bool is_temporary(std::string_view file, std::string_view stem) {
  constexpr std::string_view kTail = ".tmp";
  if (!file.starts_with('.') || !file.ends_with(kTail)) return false;
  file.remove_suffix(kTail.size());
  file.remove_prefix(1);
  const std::size_t dot = file.rfind('.');
  if (dot == file.npos || dot + 1 == file.size()) return false;
  return file.substr(0, dot) == stem &&
         std::all_of(file.begin() + static_cast<std::ptrdiff_t>(dot) + 1, file.end(), is_digit);
}

void remove_if_dead(const fs::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return;
  if (flock(file, LOCK_EX | LOCK_NB) == 0 && is_name_of(path, file)) unlink(path.c_str());
  close(file);
}

bool is_pipe(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
}

/// Opens what is no regular file. Neither that nor a later write() waits in the system, where no
/// stop would be heeded: a pipe may have no reader yet, or a slow one.
Result<int> open_directly(const std::string& target, const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const int file = open(target.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NONBLOCK);
    if (file >= 0) return file;
    const int number = errno;
    if (number == EINTR) continue;
    if (number != ENXIO || !is_pipe(target)) return cannot_write(target, number);
    poll(nullptr, 0, kWait);
  }
  return not_written(target);
}

/// Waits a while for a reader to make room.
void wait_for_room(int file) {
  pollfd wanted{file, POLLOUT, 0};
  poll(&wanted, 1, kWait);
}

bool is_of_proc(const fs::path& path) {
  return path.lexically_normal().string().starts_with("/proc/");
}

}  // namespace

std::string temporary_name(std::string_view name, int n) {
  return fmt::format(".{}.{}.tmp", stem_of(name), n);
}

Error cannot_write(const std::string& path, int number) {
  return {ErrorCode::cannot_write,
          fmt::format("cannot write {}: {}", path, std::generic_category().message(number)),
          {},
          {}};
}

Error not_written(const std::string& path) {
  return {ErrorCode::cancelled, fmt::format("interrupted; {} was not written", path), {}, {}};
}

Result<fs::path> end_of_links(const fs::path& path) {
  fs::path at = path;
  std::error_code code;
  for (int k = 0; k < kMostLinks; ++k) {
    if (is_of_proc(at) || !fs::is_symlink(fs::symlink_status(at, code))) return at;
    const fs::path to = fs::read_symlink(at, code);
    if (code) return cannot_write(path, code.value());
    at = to.is_absolute() ? to : at.parent_path() / to;
  }
  return cannot_write(path, ELOOP);
}

std::optional<FileOwner> owner_of(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileOwner{status.st_mode & kPermissions, status.st_uid, status.st_gid};
}

Status may_replace(const fs::path& target, const std::string& shown) {
  if (faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) == 0 || errno == ENOENT) return ok();
  return cannot_write(shown, errno);
}

Result<TemporaryFile> TemporaryFile::beside(const fs::path& target, const std::string& shown,
                                            const std::optional<FileOwner>& owner,
                                            std::stop_token stop) {
  TemporaryFile out;
  out.stop_ = std::move(stop);
  out.owner_ = owner;
  out.shown_ = shown;
  // What the old file keeps from others, the new one does too, from its first byte on.
  const mode_t mode = owner ? owner->mode & kNewFile : kNewFile;
  for (int n = 0; n < kMostNames; ++n) {
    fs::path name = target.parent_path() / temporary_name(target.filename().string(), n);
    out.file_ = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (out.file_ < 0) {
      if (errno != EEXIST) return cannot_write(shown, errno);
      continue;
    }
    const bool is_taken = flock(out.file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!is_taken && is_name_of(name, out.file_)) {
      out.path_ = std::move(name);  // which needs no memory, so that the file is surely removed
      return out;
    }
    close(std::exchange(out.file_, -1));  // taken for a dead one and removed by another run
  }
  return cannot_write(shown, EEXIST);
}

Result<TemporaryFile> TemporaryFile::direct(const std::string& target, std::stop_token stop) {
  TemporaryFile out;
  out.stop_ = std::move(stop);
  out.is_direct_ = true;
  out.shown_ = target;
  const Result<int> file = open_directly(target, out.stop_);
  if (!file) return file.error();
  out.file_ = *file;
  return out;
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept { *this = std::move(other); }

TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept {
  if (this != &other) {
    discard();
    file_ = std::exchange(other.file_, -1);
    path_ = std::exchange(other.path_, {});
    shown_ = std::move(other.shown_);
    is_direct_ = other.is_direct_;
    stop_ = std::move(other.stop_);
    owner_ = other.owner_;
    failure_ = other.failure_;
    is_synced_ = other.is_synced_;
    written_ = other.written_;
    pushed_ = other.pushed_;
  }
  return *this;
}

TemporaryFile::~TemporaryFile() { discard(); }

void TemporaryFile::discard() {
  if (!path_.empty()) unlink(path_.c_str());
  path_.clear();
  if (file_ >= 0) close(std::exchange(file_, -1));
}

void TemporaryFile::write(std::string_view bytes) {
  while (!bytes.empty() && failure_ == 0) {
    if (stop_.stop_requested()) return fail(ECANCELED);
    const ssize_t n = ::write(file_, bytes.data(), std::min(bytes.size(), kPiece));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EAGAIN && is_direct_) {
      wait_for_room(file_);
      continue;
    }
    if (n < 0) return fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
    written_ += n;
    push_to_disk();
  }
}

/// The disk is never more than two of these pieces behind, so that the sync at the end takes no
/// time in which nobody would heed a stop.
void TemporaryFile::push_to_disk() {
#ifdef SYNC_FILE_RANGE_WRITE
  if (is_direct_ || written_ - pushed_ < kPush) return;
  // What fails here fails again in fsync.
  if (pushed_ >= kPush) {
    (void)sync_file_range(
        file_, pushed_ - kPush, kPush,
        SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER);
  }
  (void)sync_file_range(file_, pushed_, kPush, SYNC_FILE_RANGE_WRITE);
  pushed_ += kPush;
#endif
}

void TemporaryFile::sync() {
  if (failure_ == 0 && !is_direct_ && !is_synced_ && fsync(file_) != 0) fail(errno);
  is_synced_ = true;
}

void TemporaryFile::take_over_owner() {
  if (failure_ != 0 || !owner_ || is_direct_) return;
  // Whoever may not give files away keeps them.
  struct stat status {};
  if (fstat(file_, &status) != 0) fail(errno);
  if ((status.st_uid != owner_->user || status.st_gid != owner_->group) &&
      fchown(file_, owner_->user, owner_->group) != 0 && errno != EPERM)
    fail(errno);
  if (fchmod(file_, owner_->mode) != 0 && errno != EPERM) fail(errno);
  owner_.reset();
}

Status TemporaryFile::prepare() {
  take_over_owner();
  sync();
  Status status = check();
  stop_ = {};
  return status;
}

Status TemporaryFile::check() {
  if (stop_.stop_requested()) fail(ECANCELED);
  if (failure_ == 0) return ok();
  if (failure_ == ECANCELED) return not_written(shown_);
  return cannot_write(shown_, failure_);
}

Status TemporaryFile::rename(const fs::path& target) {
  if (Status status = check(); !status) {
    discard();
    return status;
  }
  take_over_owner();
  if (failure_ == 0 && !is_direct_ && ::rename(path_.c_str(), target.c_str()) != 0) fail(errno);
  if (failure_ == 0) path_.clear();
  const int number = failure_;
  // The lock goes with the name. What close may fail with, fsync has told.
  if (is_direct_ && close(std::exchange(file_, -1)) != 0 && number == 0)
    return cannot_write(shown_, errno);
  discard();
  return number == 0 ? ok() : Status(cannot_write(shown_, number));
}

void remove_leftovers(const fs::path& folder, std::string_view name) {
  const std::string stem = stem_of(name);
  // Names first: what is removed while a folder is read may make it skip others.
  for (const std::string& found : names_in_folder(folder)) {
    if (is_temporary(found, stem)) remove_if_dead(folder / found);
  }
}

Status sync_folder(const fs::path& folder, const std::string& shown) {
  const int file = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0 && errno == EACCES) return ok();  // one that may be written to but not listed
  if (file < 0) return cannot_write(shown, errno);
  // Not every file system can do it for folders.
  const int number = fsync(file) != 0 && errno != EINVAL && errno != ENOTSUP ? errno : 0;
  close(file);
  return number == 0 ? ok() : Status(cannot_write(shown, number));
}

}  // namespace cover
