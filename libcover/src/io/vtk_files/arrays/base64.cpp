// Tested by tests/unit/io/vtk_files/arrays/array_reader_test.cpp.
#include "io/vtk_files/arrays/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "io/vtk_files/arrays/ascii_numbers.hpp"

namespace cover {
namespace {

constexpr std::uint8_t kNoLetter = 255, kPadding = 254;

constexpr std::array<std::uint8_t, 256> kValues = [] {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoLetter);
  for (std::size_t k = 0; k < kLetters.size(); ++k)
    values[static_cast<unsigned char>(kLetters[k])] = static_cast<std::uint8_t>(k);
  values['='] = kPadding;
  return values;
}();

std::uint8_t value_of(char letter) { return kValues[static_cast<unsigned char>(letter)]; }

/// Three bytes out of four values. False if one of them is none.
bool decode(const char* letters, char* out) {
  const std::uint32_t a = value_of(letters[0]), b = value_of(letters[1]), c = value_of(letters[2]),
                      d = value_of(letters[3]);
  if (((a | b | c | d) & 0xC0U) != 0) return false;
  const std::uint32_t bits = a << 18U | b << 12U | c << 6U | d;
  out[0] = static_cast<char>(bits >> 16U);
  out[1] = static_cast<char>(bits >> 8U);
  out[2] = static_cast<char>(bits);
  return true;
}

}  // namespace

bool Base64::next() {
  std::array<char, 4> letters{};
  std::size_t count = 0, used = 0;
  for (; used < text_.size() && count < 4; ++used)
    if (!is_blank(text_[used])) letters[count++] = text_[used];
  if (count < 4) return false;
  std::size_t padding = 0;
  while (padding < 2 && letters[3 - padding] == '=') letters[3 - padding++] = 'A';
  if (!decode(letters.data(), bytes_)) return false;
  text_.remove_prefix(used);
  filled_ = held_ = 3 - padding;
  return true;
}

bool Base64::read(char* out, std::size_t size) {
  while (size > 0) {
    if (held_ > 0) {
      const std::size_t taken = std::min(held_, size);
      std::memcpy(out, bytes_ + (filled_ - held_), taken);
      held_ -= taken;
      out += taken;
      size -= taken;
      continue;
    }
    // Most of the text has no blanks and no padding.
    while (size >= 3 && text_.size() >= 4 && decode(text_.data(), out)) {
      text_.remove_prefix(4);
      out += 3;
      size -= 3;
    }
    if (size > 0 && !next()) return false;
  }
  return true;
}

}  // namespace cover
