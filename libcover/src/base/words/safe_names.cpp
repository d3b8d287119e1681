#include "base/words/safe_names.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

#include <fmt/core.h>

#include "base/words/characters.hpp"

namespace cover {
namespace {

bool is_safe(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_' || c == '-' ||
         c == '.';
}

/// How many bytes the character at the start of `text` has; 0 where that is no UTF-8.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xc0U) != 0x80) return 0;
  // Overlong forms, surrogates, and beyond the last character.
  if ((first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) >= 0xa0) ||
      (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) >= 0x90))
    return 0;
  return length;
}

/// The names that `form` makes of `names`, all different, none of those that are `taken` already,
/// none longer than `longest`; those that may stay do.
std::vector<std::string> unique_names(std::span<const std::string> names,
                                      std::string (*form)(std::string_view),
                                      std::set<std::string> taken = {},
                                      std::size_t longest = std::string::npos) {
  // Names that are unchanged come first, so that no made-up one takes theirs.
  std::vector<std::string> safe(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool may_stay = names[k].size() <= longest && form(names[k]) == names[k];
    if (may_stay && taken.insert(names[k]).second) safe[k] = names[k];
  }
  std::map<std::string, int> last;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!safe[k].empty()) continue;
    const std::string stem = form(names[k]).substr(0, longest);
    int& n = last.emplace(stem, 1).first->second;
    safe[k] = stem;
    while (!taken.insert(safe[k]).second) {
      const std::string ending = fmt::format("_{}", ++n);
      safe[k] = stem.substr(0, longest - ending.size()) + ending;
    }
  }
  return safe;
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

std::string legible_name(std::string_view name) {
  if (name.empty()) return "unnamed";
  std::string out;
  while (!name.empty()) {
    const std::size_t length = utf8_length(name);
    constexpr char kDelete = 0x7f;
    const bool is_bad = length == 0 || (length == 1 && (static_cast<unsigned char>(name[0]) < ' ' ||
                                                        name[0] == '"' || name[0] == kDelete));
    if (is_bad)
      out += '_';
    else
      out += name.substr(0, length);
    name.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

std::vector<std::string> unique_safe_names(std::span<const std::string> names) {
  return unique_names(names, safe_name);
}

std::vector<std::string> unique_safe_names(std::span<const std::string> names,
                                           const std::set<std::string>& taken,
                                           std::size_t longest) {
  return unique_names(names, safe_name, taken, longest);
}

std::vector<std::string> unique_legible_names(std::span<const std::string> names) {
  return unique_names(names, legible_name);
}

std::vector<std::string> unique_legible_names(std::span<const std::string> names,
                                              const std::set<std::string>& taken) {
  return unique_names(names, legible_name, taken);
}

}  // namespace cover
