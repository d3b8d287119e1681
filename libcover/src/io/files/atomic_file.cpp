// Tested by tests/unit/io/files/atomic_file_test.cpp.
#include "io/files/atomic_file.hpp"

#include <cerrno>
#include <utility>

namespace cover {
namespace {

namespace fs = std::filesystem;

/// A device, a pipe, or what someone else has opened: nothing that a rename should replace.
bool is_special(const fs::path& target) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  return fs::exists(status) && ((!fs::is_regular_file(status) && !fs::is_directory(status)) ||
                                fs::is_symlink(fs::symlink_status(target, ignored)));  // of /proc
}

}  // namespace

bool is_written_directly(const std::string& path) {
  const Result<fs::path> target = end_of_links(path);
  return target && is_special(*target);
}

Result<AtomicFile> AtomicFile::create(const std::string& path, std::stop_token stop) {
  // The system would take what stands before it.
  if (path.find('\0') != std::string::npos) return cannot_write(path, EINVAL);
  Result<fs::path> target = end_of_links(path);
  if (!target) return std::move(target).error();
  std::error_code ignored;
  if (fs::is_directory(*target, ignored)) return cannot_write(path, EISDIR);
  if (Status status = may_replace(*target, path); !status) return std::move(status).error();
  const bool special = is_special(*target);
  if (!special) remove_leftovers(target->parent_path(), target->filename().string());
  Result<TemporaryFile> file =
      special ? TemporaryFile::direct(path, std::move(stop))
              : TemporaryFile::beside(*target, path, owner_of(*target), std::move(stop));
  if (!file) return std::move(file).error();
  return AtomicFile(path, special ? fs::path() : *std::move(target), *std::move(file));
}

Status AtomicFile::commit() {
  if (Status status = replace(); !status) return status;
  return sync_place();
}

Status AtomicFile::replace() {
  file_.sync();
  return file_.rename(target_);
}

Status AtomicFile::sync_place() const {
  return target_.empty() ? ok() : sync_folder(target_.parent_path(), path_);
}

Status commit_together(std::span<AtomicFile* const> files) {
  Status all = ok();
  const auto keep = [&all](Status status) {
    if (!status && all) all = std::move(status);
  };
  for (AtomicFile* file : files) {
    keep(file->replace());
    if (!all && file == files.front()) return all;
  }
  for (const AtomicFile* file : files) keep(file->sync_place());
  return all;
}

Status replace_file(const std::string& path, std::string_view bytes) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return std::move(file).error();
  file->write(bytes);
  return file->commit();
}

}  // namespace cover
