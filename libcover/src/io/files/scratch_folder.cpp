// Locked as io/files/temporary_file does it. Tested by tests/unit/io/files/atomic_file_test.cpp.
#include <cover/files.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "io/files/names_in_folder.hpp"
#include "io/files/temporary_file.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

constexpr int kTrials = 100;
constexpr std::string_view kLetters = "XXXXXX";  // of mkdtemp

/// The open folder, locked; -1 where someone else has it, or it is not ours or gone. Without
/// `must_lock` a file system that has no locks will do.
int lock(const fs::path& path, bool must_lock) {
  const int file = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return -1;
  struct stat opened {};
  const bool locked = flock(file, LOCK_EX | LOCK_NB) == 0 || (!must_lock && errno != EWOULDBLOCK);
  if (locked && is_name_of(path, file) && fstat(file, &opened) == 0 && opened.st_uid == geteuid())
    return file;
  close(file);
  return -1;
}

void remove_dead_folders(const fs::path& folder, const std::string& head) {
  for (const std::string& name : names_in_folder(folder)) {
    if (!name.starts_with(head) || name.size() != head.size() + kLetters.size()) continue;
    const fs::path path = folder / name;
    const int file = lock(path, true);
    if (file < 0) continue;
    std::error_code ignored;
    fs::remove_all(path, ignored);
    close(file);
  }
}

}  // namespace

Result<ScratchFolder> ScratchFolder::beside(const std::string& target) {
  const fs::path path(target);
  const std::string head = fmt::format(".{}.", path.filename().string());
  remove_dead_folders(path.has_parent_path() ? path.parent_path() : fs::path("."), head);
  for (int k = 0; k < kTrials; ++k) {
    std::string name = path.parent_path() / fmt::format("{}{}", head, kLetters);
    if (mkdtemp(name.data()) == nullptr) return cannot_write(target, errno);
    if (const int file = lock(name, false); file >= 0) return ScratchFolder(name, file);
    // Taken for a dead one by another run.
    rmdir(name.c_str());
  }
  return cannot_write(target, ENOLCK);
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}

ScratchFolder& ScratchFolder::operator=(ScratchFolder&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(lock_, other.lock_);
  return *this;
}

ScratchFolder::~ScratchFolder() {
  try {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  } catch (const std::bad_alloc&) {
    // The next run removes it.
  }
  if (lock_ >= 0) close(lock_);
}

}  // namespace cover
