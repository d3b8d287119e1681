#include "base/safe_names.hpp"

#include <cstddef>
#include <map>
#include <set>

#include <fmt/core.h>

namespace cover {
namespace {

bool is_safe(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.';
}

}  // namespace

std::string safe_name(std::string_view name) {
  if (name.empty()) return "unnamed";
  std::string safe(name);
  for (char& c : safe) {
    if (!is_safe(c)) c = '_';
  }
  return safe;
}

std::vector<std::string> unique_safe_names(std::span<const std::string> names) {
  // Names that are unchanged come first, so that no made-up one takes theirs.
  std::set<std::string> taken;
  std::vector<std::string> safe(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (safe_name(names[k]) == names[k] && taken.insert(names[k]).second) safe[k] = names[k];
  }
  std::map<std::string, int> last;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!safe[k].empty()) continue;
    const std::string stem = safe_name(names[k]);
    int& n = last.emplace(stem, 1).first->second;
    safe[k] = stem;
    while (!taken.insert(safe[k]).second) safe[k] = fmt::format("{}_{}", stem, ++n);
  }
  return safe;
}

}  // namespace cover
