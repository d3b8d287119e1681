// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtm_test.cpp and tests/faults.
#include "io/files/piece_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include <cover/files.hpp>

#include "base/content_hash.hpp"
#include "base/words/characters.hpp"
#include "io/files/names_in_folder.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHashDigits = 16;

/// Whether a file has so many bytes, with this hash: a power failure may have left less.
bool holds(const fs::path& path, std::size_t size, const ContentHash& hash) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode) ||
      static_cast<std::size_t>(status.st_size) != size)
    return false;
  std::ifstream file(path, std::ios::binary);
  std::string piece(1 << 16, '\0');
  ContentHash found;
  while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())), file.gcount() > 0)
    found.add(std::string_view(piece).substr(0, static_cast<std::size_t>(file.gcount())));
  return found.text() == hash.text();
}

bool is_hash_digit(char c) { return is_digit(c) || (c >= 'a' && c <= 'f'); }

/// Whether we give this name to a piece of STEM.vtm: STEM_K_HASH.vtu; or with `old`, VTK:
/// STEM_K.vtu.
bool is_piece(std::string_view name, const std::string& stem, bool old) {
  const std::string head = stem + '_';
  constexpr std::string_view kTail = ".vtu";
  if (!name.starts_with(head) || !name.ends_with(kTail)) return false;
  if (name.size() <= head.size() + kTail.size()) return false;
  name = name.substr(head.size(), name.size() - head.size() - kTail.size());
  if (!old) {
    if (name.size() < kHashDigits + 2) return false;
    const std::string_view hash = name.substr(name.size() - kHashDigits);
    if (!std::all_of(hash.begin(), hash.end(), is_hash_digit)) return false;
    name.remove_suffix(kHashDigits);
    if (name.back() != '_') return false;
    name.remove_suffix(1);
  }
  return std::all_of(name.begin(), name.end(), is_digit);
}

/// The names of files in a .vtm, without their folder.
std::unordered_set<std::string> names_in(const fs::path& vtm) {
  std::ostringstream text;
  text << std::ifstream(vtm, std::ios::binary).rdbuf();
  const std::string all = text.str();
  constexpr std::string_view kFile = "file=\"";
  std::unordered_set<std::string> names;
  for (std::size_t at = all.find(kFile); at != all.npos; at = all.find(kFile, at)) {
    at += kFile.size();
    const std::size_t end = all.find('"', at);
    if (end == all.npos) break;
    names.insert(fs::path(all.substr(at, end - at)).filename());
  }
  return names;
}

/// Permissions of a folder from which whoever may read a file of these can read it.
mode_t of_folder(const std::optional<FileOwner>& owner) {
  constexpr mode_t kAll = 0777, kOwn = 0700, kRead = 0444;
  return owner ? (owner->mode & kAll) | ((owner->mode & kRead) >> 2U) | kOwn : kAll;
}

}  // namespace

Result<PieceFolder> PieceFolder::open(const fs::path& target, const std::string& shown,
                                      std::stop_token stop) {
  PieceFolder out;
  out.target_ = target;
  out.stem_ = target.stem();
  // A .vtm and a .pvtu of one name have folders of their own.
  if (extension_of(target) == ".pvtu") out.stem_ += ".parts";
  out.folder_ = target.parent_path() / out.stem_;
  out.shown_ = shown;
  out.stop_ = std::move(stop);
  out.owner_ = owner_of(target);
  if (Status status = may_replace(target, shown); !status) return std::move(status).error();
  if (Status status = out.lock(); !status) return std::move(status).error();
  remove_leftovers(out.folder_, out.stem_);
  remove_leftovers(target.parent_path(), target.filename().string());
  out.named_before_ = names_in(target);
  return out;
}

Status PieceFolder::lock() {
  const fs::path& path = folder_;
  const auto failure = [&](int number) {
    return cannot_write(fmt::format("{}, with its pieces in the folder {}", shown_, path.string()),
                        number);
  };
  while (true) {
    if (mkdir(path.c_str(), of_folder(owner_)) == 0) {
      is_made_ = true;
    } else if (errno != EEXIST) {
      return failure(errno);
    }
    lock_ = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_ < 0) return failure(errno);
    while (flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      if (stop_.stop_requested()) return not_written(shown_);
      constexpr std::chrono::milliseconds kPause(20);
      std::this_thread::sleep_for(kPause);
    }
    // Who had the lock may have removed the folder.
    if (is_name_of(path, lock_, true)) return ok();
    close(std::exchange(lock_, -1));
    is_made_ = false;
  }
}

PieceFolder::PieceFolder(PieceFolder&& other) noexcept
    : target_(std::move(other.target_)),
      stem_(std::move(other.stem_)),
      folder_(std::move(other.folder_)),
      shown_(std::move(other.shown_)),
      stop_(std::move(other.stop_)),
      owner_(other.owner_),
      lock_(std::exchange(other.lock_, -1)),
      is_made_(other.is_made_),
      named_before_(std::move(other.named_before_)),
      pieces_(std::move(other.pieces_)),
      made_(std::move(other.made_)) {}

PieceFolder::~PieceFolder() {
  if (lock_ < 0) return;
  // Without an allocation, which may fail.
  for (const std::string& piece : made_) unlinkat(lock_, piece.c_str(), 0);
  if (is_made_) rmdir(folder_.c_str());
  close(lock_);
}

/// A small piece is put together in memory first: of thousands, most may be there already, and
/// replacing a file makes the file system wait for the disk.
Result<std::string> PieceFolder::add(const std::function<void(const ByteSink&)>& write) {
  constexpr std::size_t kSmall = 1 << 20;
  std::string small;
  std::optional<Result<TemporaryFile>> file;
  const auto create = [&] {
    file.emplace(TemporaryFile::beside(folder_ / stem_, shown_, owner_, stop_));
    if (*file) (*file)->write(small);
  };
  ContentHash hash;
  std::size_t size = 0;
  write([&](std::string_view bytes) {
    hash.add(bytes);
    size += bytes.size();
    if (!file && size > kSmall) create();
    if (!file)
      small += bytes;
    else if (*file)
      (*file)->write(bytes);
  });
  std::string name = fmt::format("{}_{}_{}.vtu", stem_, pieces_.size(), hash.text());
  const fs::path path = folder_ / name;
  if (stop_.stop_requested()) return not_written(shown_);
  if (!holds(path, size, hash)) {
    if (!file) create();
    if (!*file) return std::move(*file).error();
    const bool is_new = access(path.c_str(), F_OK) != 0;
    if (is_new) made_.push_back(name);
    if (Status status = (*file)->rename(path); !status) return std::move(status).error();
  }
  pieces_.push_back(name);
  return fmt::format("{}/{}", stem_, name);
}

/// Has the pieces on the disk before a file names them. One after the other costs a millisecond
/// each; where they are many, the whole file system at once costs less.
Status PieceFolder::sync_pieces() {
  constexpr std::size_t kFew = 100;
#ifdef __linux__
  if (pieces_.size() > kFew) {
    return syncfs(lock_) == 0 ? ok() : Status(cannot_write(shown_, errno));
  }
#endif
  for (const std::string& piece : pieces_) {
    const int file = ::open((folder_ / piece).c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return cannot_write(shown_, errno);
    const int number = fsync(file) == 0 ? 0 : errno;
    close(file);
    if (number != 0) return cannot_write(shown_, number);
    if (stop_.stop_requested()) return not_written(shown_);
  }
  return sync_folder(folder_, shown_);
}

Status PieceFolder::commit(std::string_view text) {
  Result<TemporaryFile> file = TemporaryFile::beside(target_, shown_, owner_, stop_);
  if (!file) return std::move(file).error();
  file->write(text);
  file->sync();
  if (Status status = sync_pieces(); !status) return status;
  if (Status status = file->rename(target_); !status) return status;
  made_.clear();
  is_made_ = false;
  remove_old_pieces();
  return sync_folder(target_.parent_path(), shown_);
}

void PieceFolder::remove_old_pieces() {
  const std::unordered_set<std::string> now(pieces_.begin(), pieces_.end());
  for (const std::string& name : names_in_folder(folder_)) {
    // Without a hash, ParaView numbers the files of a time series in the same way.
    const bool ours = is_piece(name, stem_, false) ||
                      (is_piece(name, stem_, true) && named_before_.contains(name));
    if (ours && !now.contains(name)) unlinkat(lock_, name.c_str(), 0);
  }
}

}  // namespace cover
