// The text of a large object in JSON.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace cover {

/// An object, member by member: all of a report at once takes ten times the memory of its text.
class ObjectText {
 public:
  void add(std::string_view name, const nlohmann::ordered_json& value) {
    begin(name);
    text_ += dump(value, 1);
  }

  /// A list of what `item` makes of 0, 1, ..., count - 1.
  template <class Item>
  void add_list(std::string_view name, std::size_t count, Item item) {
    begin(name);
    text_ += '[';
    for (std::size_t k = 0; k < count; ++k) {
      text_ += k == 0 ? "\n  " : ",\n  ";
      text_ += dump(item(k), 2);
    }
    text_ += count == 0 ? "]" : "\n ]";
  }

  std::string finish() {
    text_ += "\n}";
    return std::move(text_);
  }

 private:
  void begin(std::string_view name) {
    text_ += text_.empty() ? "{\n " : ",\n ";
    text_ += nlohmann::ordered_json(name).dump() + ": ";
  }

  /// Each line but the first goes in by `level` blanks. No other line begins in a text of JSON.
  static std::string dump(const nlohmann::ordered_json& value, std::size_t level) {
    // Names that are no UTF-8 must not make the report fail.
    const std::string flush =
        value.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    std::string text;
    for (const char c : flush) {
      text += c;
      if (c == '\n') text.append(level, ' ');
    }
    return text;
  }

  std::string text_;
};

}  // namespace cover
