// Tested by tests/cli/mesh_test.py, class Files.
#include "files/file_check.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include <cover/files.hpp>
#include <cover/write_mesh.hpp>

namespace cover::app {
namespace {

namespace fs = std::filesystem;

/// A device or a pipe: nothing is lost by writing to it.
bool is_special(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// Whether two names mean one file, which need not be there.
bool same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) ||
         fs::weakly_canonical(fs::absolute(a, ignored), ignored) ==
             fs::weakly_canonical(fs::absolute(b, ignored), ignored);
}

/// All files that a name stands for.
std::vector<fs::path> with_companions(const fs::path& path, bool is_written) {
  std::vector<fs::path> all{path};
  for (const std::string& companion : companions_of(path)) all.emplace_back(companion);
  // Points may stand in a file of their own.
  if (extension_of(path) == ".poly" && !is_written)
    all.push_back(fs::path(path).replace_extension(".node"));
  return all;
}

/// Whether the pieces of a .vtm need a folder that has the name of the file `in`.
bool needs_folder_of_name(const fs::path& out, const fs::path& in) {
  return extension_of(out) == ".vtm" && same(fs::path(out).replace_extension(), in);
}

/// Whether writing `out` would change the file `in`.
bool replaces(const fs::path& out, const fs::path& in, bool in_is_written) {
  for (const fs::path& a : with_companions(out, true)) {
    for (const fs::path& b : with_companions(in, in_is_written)) {
      if (same(a, b)) return true;
    }
  }
  // A piece of a .vtm.
  return extension_of(out) == ".vtm" && extension_of(in) == ".vtu" && in.has_parent_path() &&
         same(fs::path(out).replace_extension(), in.parent_path());
}

std::string quoted(const NamedFile& file) {
  return file.option.empty() ? fmt::format("'{}'", file.path)
                             : fmt::format("{} '{}'", file.option, file.path);
}

Error bad(std::string message) { return {ErrorCode::bad_option, std::move(message), {}, {}}; }

Status check_folder(const NamedFile& file) {
  const fs::path path(file.path);
  const auto failure = [&](int number) {
    return Error{
        ErrorCode::cannot_write,
        fmt::format("cannot write {}: {}", file.path, std::generic_category().message(number)),
        {},
        {}};
  };
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return failure(EISDIR);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  // Asked first: a file that is no program is one that may not be entered.
  if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored)) return failure(ENOTDIR);
  if (access(folder.c_str(), W_OK | X_OK) != 0) return failure(errno);
  return ok();
}

/// The manifest of X.vtu is X.json; where that is the geometry, the mesh needs another name.
const char* hint_at_manifest(const NamedFile& out) {
  return out.is_mesh && extension_of(out.path) == ".json"
             ? "; the manifest bears the name of the mesh: give both another one, or write a .vtm, "
               "which holds the names too"
             : "";
}

Status check_against(const NamedFile& out, const std::vector<NamedFile>& read) {
  for (const NamedFile& in : read) {
    if (in.path.empty() || in.path == "-" || (in.is_mesh && out.is_mesh)) continue;
    if (needs_folder_of_name(out.path, in.path))
      return bad(
          fmt::format("the pieces of {} go into a folder '{}', and the input is a file of "
                      "that name: give the mesh another one",
                      quoted(out), fs::path(out.path).replace_extension().string()));
    if (!replaces(out.path, in.path, false)) continue;
    return bad(fmt::format("writing {} would replace the input{}{}", quoted(out),
                           !in.option.empty()    ? fmt::format(", the file of {}", in.option)
                           : in.path != out.path ? fmt::format(" '{}'", in.path)
                                                 : "",
                           hint_at_manifest(out)));
  }
  return ok();
}

Status check_pair(const NamedFile& a, const NamedFile& b) {
  if (a.path == "-" || b.path == "-") {
    if (a.path == b.path) return bad("two files cannot be written to standard output");
  } else if (replaces(a.path, b.path, true) || replaces(b.path, a.path, true)) {
    return bad(fmt::format("{} and {} would replace each other", quoted(a), quoted(b)));
  }
  return ok();
}

}  // namespace

Status check_files(const std::vector<NamedFile>& read, const std::vector<NamedFile>& written) {
  if (std::count_if(read.begin(), read.end(), [](const NamedFile& in) { return in.path == "-"; }) >
      1)
    return bad("standard input can be read once, so '-' names one file");
  const auto is_file = [](const NamedFile& file) {
    return !file.path.empty() && !is_special(file.path);
  };
  for (auto out = written.begin(); out != written.end(); ++out) {
    if (!is_file(*out)) continue;
    for (auto other = written.begin(); other != out; ++other) {
      if (!is_file(*other)) continue;
      if (Status status = check_pair(*other, *out); !status) return status;
    }
    if (out->path == "-") continue;
    if (Status status = check_against(*out, read); !status) return status;
  }
  for (const NamedFile& out : written) {
    if (!is_file(out) || out.path == "-") continue;
    if (Status status = check_folder(out); !status) return status;
  }
  return ok();
}

}  // namespace cover::app
