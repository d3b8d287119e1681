// std::filesystem::directory_iterator of GCC's library ends the process where memory runs out.
// Tested by tests/unit/io/files/atomic_file_test.cpp and tests/faults.
#include "io/files/names_in_folder.hpp"

#include <dirent.h>
#include <sys/stat.h>

#include <memory>
#include <string_view>

namespace cover {

std::vector<std::string> names_in_folder(const std::filesystem::path& folder) {
  struct Close {
    void operator()(DIR* open) const { closedir(open); }
  };
  std::vector<std::string> names;
  const std::unique_ptr<DIR, Close> open(opendir(folder.empty() ? "." : folder.c_str()));
  if (!open) return names;
  while (const dirent* entry = readdir(open.get())) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  return names;
}

bool is_name_of(const std::filesystem::path& path, int file, bool through_links) {
  struct stat named {
  }, opened{};
  const int found = through_links ? stat(path.c_str(), &named) : lstat(path.c_str(), &named);
  return found == 0 && fstat(file, &opened) == 0 && named.st_ino == opened.st_ino &&
         named.st_dev == opened.st_dev;
}

}  // namespace cover
