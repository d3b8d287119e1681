// Names in options, which stand in quotation marks where they have signs of the option.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace cover {

/// A name in quotation marks, where two stand for one, at the beginning of `text`; it is taken off.
inline std::optional<std::string> take_quoted(std::string_view& text) {
  std::string name;
  for (std::size_t k = 1; k < text.size(); ++k) {
    if (text[k] == '"') {
      if (!text.substr(k + 1).starts_with('"')) {
        text.remove_prefix(k + 1);
        return name;
      }
      ++k;
    }
    name += text[k];
  }
  return std::nullopt;
}

/// A name at the beginning of `text`, in quotation marks or up to one of `ends`; it is taken off.
inline std::optional<std::string> take_name(std::string_view& text, std::string_view ends) {
  std::optional<std::string> name;
  if (text.starts_with('"')) {
    name = take_quoted(text);
  } else {
    const std::size_t stop = std::min(text.find_first_of(ends), text.size());
    name = text.substr(0, stop);
    text.remove_prefix(stop);
  }
  if (name && name->empty()) return std::nullopt;
  return name;
}

/// As take_name() reads it.
inline std::string quoted(const std::string& name) {
  if (!name.starts_with('"') && name.find_first_of("=@") == name.npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string(2, c) : std::string(1, c);
  return text + '"';
}

}  // namespace cover
