// Numbers in text, blank-separated.
#pragma once

#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "base/words/parse_number.hpp"

namespace cover {

inline bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Reads up to `count` numbers into `out` and takes them off `text`. Returns how many it read:
/// where fewer, `text` begins with what is no number of this type, or is empty. Floating-point
/// numbers out of range become infinite or zero.
///
/// Cost: O(length of what is read)
template <class T>
std::size_t read_ascii(std::string_view& text, T* out, std::size_t count) {
  const char* at = text.data();
  const char* const end = at + text.size();
  std::size_t read = 0;
  for (;;) {
    while (at != end && is_blank(*at)) ++at;
    if (read == count || at == end) break;
    const char* const start = *at == '+' && end - at > 1 && at[1] != '-' ? at + 1 : at;
    T value{};
    auto [stop, error] = std::from_chars(start, end, value);
    if constexpr (std::is_floating_point_v<T>) {
      if (error == std::errc::result_out_of_range) {
        const std::string_view word(start, static_cast<std::size_t>(stop - start));
        value = static_cast<T>(nearest_in_range(word));
        error = std::errc();
      }
    }
    if (error != std::errc() || (stop != end && !is_blank(*stop))) break;
    out[read++] = value;
    at = stop;
  }
  text.remove_prefix(static_cast<std::size_t>(at - text.data()));
  return read;
}

}  // namespace cover
