// Tested by tests/unit/dxf/group_text_test.cpp.
#include "dxf/group_text.hpp"

#include <iconv.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <optional>

#include <cover/text.hpp>

namespace cover {
namespace {

class Converter {
 public:
  explicit Converter(const std::string& from) : handle_(iconv_open("UTF-8", from.c_str())) {}
  ~Converter() {
    if (is_there()) iconv_close(handle_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  /// Nothing if `text` is none of the character set, or that is not known.
  [[nodiscard]] std::optional<std::string> operator()(std::string_view text) const {
    if (!is_there()) return std::nullopt;
    std::string in(text);
    constexpr std::size_t kMostBytes = 4;  // of a character in UTF-8
    std::string out(kMostBytes * (text.size() + 1), '\0');
    char *from = in.data(), *to = out.data();
    std::size_t left = in.size(), room = out.size();
    constexpr auto kFailed = static_cast<std::size_t>(-1);
    if (iconv(handle_, &from, &left, &to, &room) == kFailed || left > 0) return std::nullopt;
    // Where letters are composed, the last one is held back until this.
    if (iconv(handle_, nullptr, nullptr, &to, &room) == kFailed) return std::nullopt;
    out.resize(out.size() - room);
    // Other groups would come of line breaks.
    const auto is_control = [](char c) { return (c >= 0 && c < ' ' && c != '\t') || c == 0x7f; };
    if (std::any_of(out.begin(), out.end(), is_control)) return std::nullopt;
    return out;
  }

 private:
  [[nodiscard]] bool is_there() const {
    return handle_ != std::bit_cast<iconv_t>(std::intptr_t{-1});
  }
  iconv_t handle_;
};

std::string charset_of(std::string_view code_page) {
  std::string name(code_page);
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  for (const std::string_view prefix : {"ANSI_", "DOS"})
    if (name.starts_with(prefix)) return "CP" + name.substr(prefix.size());
  if (name == "KSC5601") return "CP949";
  if (name == "MAC-ROMAN") return "MACINTOSH";
  return name.empty() || name == "ASCII" ? "CP1252" : name;
}

void append(std::string& out, std::uint32_t character) {
  const auto byte = [&](std::uint32_t value) { out += static_cast<char>(value); };
  if (character < 0x80) return byte(character);
  if (character < 0x800) {
    byte(0xC0 | character >> 6);
  } else {
    byte(0xE0 | character >> 12);
    byte(0x80 | (character >> 6 & 0x3F));
  }
  byte(0x80 | (character & 0x3F));
}

/// With \U+XXXX as the character with that number, unless it is half of a pair or a control.
std::string with_characters(std::string_view text) {
  constexpr std::string_view kMark = "\\U+";
  constexpr std::size_t kDigits = 4;
  std::string out;
  while (!text.empty()) {
    const std::size_t at = std::min(text.find(kMark), text.size());
    out += text.substr(0, at);
    text.remove_prefix(at);
    if (text.empty()) break;
    const std::string_view digits = text.substr(kMark.size(), kDigits);
    std::uint32_t character = 0;
    const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), character, 16);
    const bool is_one = digits.size() == kDigits && end.ptr == digits.data() + kDigits &&
                        character >= 0x20 && (character < 0xD800 || character > 0xDFFF);
    const std::size_t taken = is_one ? kMark.size() + kDigits : 1;
    if (is_one)
      append(out, character);
    else
      out += text.front();
    text.remove_prefix(taken);
  }
  return out;
}

/// The character whose number three digits are; 0: they are none, or it is a control.
std::uint32_t numbered_character(std::string_view digits) {
  std::uint32_t character = 0;
  const char* const end = digits.data() + digits.size();
  if (digits.size() != 3 || std::from_chars(digits.data(), end, character).ptr != end) return 0;
  const bool is_control = character < 0x20 || (character >= 0x7F && character < 0xA0);
  return is_control || character > 0xFF ? 0 : character;
}

}  // namespace

std::string with_symbols(std::string_view text) {
  constexpr std::string_view kMark = "%%";
  std::string out;
  while (!text.empty()) {
    const std::size_t at = std::min(text.find(kMark), text.size());
    out += text.substr(0, at);
    text.remove_prefix(at);
    if (text.empty()) break;
    const std::string_view code = text.substr(kMark.size());
    const char letter = code.empty() ? '\0' : lower(code.substr(0, 1)).front();
    const std::uint32_t character = numbered_character(code.substr(0, 3));
    std::size_t taken = kMark.size() + 1;
    if (letter == 'c') {
      append(out, 0x2300);
    } else if (letter == 'd') {
      append(out, 0xB0);
    } else if (letter == 'p') {
      append(out, 0xB1);
    } else if (letter == '%') {
      out += '%';
    } else if (character != 0) {
      append(out, character);
      taken = kMark.size() + 3;
    } else if (letter == '\0' || std::string_view("uok").find(letter) == std::string_view::npos) {
      out += kMark;
      taken = kMark.size();
    }
    text.remove_prefix(taken);
  }
  return out;
}

std::string group_text_in_utf8(std::string_view value, std::string_view code_page) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  std::string text(value);
  if (!std::all_of(value.begin(), value.end(), is_ascii) && !Converter("UTF-8")(value))
    text = Converter(charset_of(code_page))(value).value_or(text);
  return with_characters(text);
}

}  // namespace cover
