// The end of a list that names only its first items.
// Tested by tests/unit/base/words/and_more_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/core.h>

namespace cover {

/// " and 3 more", with the `separator` of the items before it: what a list ends with that names at
/// most `named` of `all` its items; empty where it names all.
inline std::string and_more(std::size_t all, std::size_t named, std::string_view separator = "") {
  return all > named ? fmt::format("{} and {} more", separator, all - named) : std::string();
}

}  // namespace cover
