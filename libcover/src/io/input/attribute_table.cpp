// Tested by tests/unit/io/input/attribute_table_test.cpp.
#include "io/input/attribute_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "base/numbers.hpp"
#include "io/input/map_words.hpp"

namespace cover {
namespace {

bool is_there(const AttributeValue& value) {
  return !std::holds_alternative<std::monostate>(value);
}

bool is_text(const AttributeValue& value) { return std::holds_alternative<std::string>(value); }

/// Whether it has to be a word.
bool is_word(const AttributeValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return !double_holds(*whole);
  return is_text(value) && !number_in_column(std::get<std::string>(value));
}

/// Whether it is a whole number, but has to be a word.
bool is_long_number(const AttributeValue& value) {
  return is_word(value) && (!is_text(value) || number_in_words(std::get<std::string>(value)));
}

bool is_number(const AttributeValue& value) {
  return is_there(value) && !is_text(value) && !is_word(value);
}

double number_of(const AttributeValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* text = std::get_if<std::string>(&value)) return *number_in_column(*text);
  return is_there(value) ? std::get<double>(value) : kNoNumber;
}

std::string word_of(const AttributeValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(value);
}

Attribute numbers_of(const std::vector<AttributeValue>& column) {
  Attribute out;
  for (const AttributeValue& value : column) out.values.push_back(number_of(value));
  return out;
}

Attribute words_of(const std::vector<AttributeValue>& column) {
  Attribute out;
  out.is_text = true;
  std::unordered_map<std::string, std::size_t> known;
  for (const AttributeValue& value : column) {
    if (!is_there(value)) {
      out.values.push_back(0);
      continue;
    }
    const std::string word = word_of(value);
    const auto [entry, is_new] = known.emplace(word, known.size() + 1);
    if (is_new) out.words.push_back(word);
    out.values.push_back(static_cast<double>(entry->second));
  }
  return out;
}

}  // namespace

std::uint32_t AttributeTable::add_feature(long number) {
  if (columns_.empty()) return 0;
  for (auto& column : columns_) column.emplace_back();
  numbers_.push_back(number);
  shapes_.push_back(0);
  return static_cast<std::uint32_t>(numbers_.size());
}

void AttributeTable::add_shape(std::uint32_t feature, FeatureShape shape) {
  if (feature != 0) shapes_[feature - 1] |= static_cast<std::uint8_t>(shape);
}

bool AttributeTable::is_empty(std::size_t column) const {
  return std::none_of(columns_[column].begin(), columns_[column].end(), is_there);
}

std::optional<std::string> AttributeTable::beside_areas(std::size_t column,
                                                        std::string_view what) const {
  const std::vector<AttributeValue>& values = columns_[column];
  const auto is_drawn = [&](std::size_t feature, FeatureShape shape) {
    return (shapes_[feature] & static_cast<std::uint8_t>(shape)) != 0;
  };
  bool lines = false, points = false;
  std::optional<std::size_t> first;
  for (std::size_t f = 0; f < values.size(); ++f) {
    if (!is_there(values[f])) continue;
    if (is_drawn(f, FeatureShape::area)) return std::nullopt;
    if (!first && shapes_[f] != 0) first = f;
    lines |= is_drawn(f, FeatureShape::line);
    points |= is_drawn(f, FeatureShape::point);
  }
  if (!first) return std::nullopt;
  return fmt::format(
      "only {} have the {} '{}', the first of them feature {}: an array of a mesh holds what areas "
      "have",
      !lines    ? "points"
      : !points ? "lines"
                : "lines and points",
      what, names_[column], numbers_[*first]);
}

std::vector<Attribute> AttributeTable::attributes() const {
  std::vector<Attribute> out;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const auto& column = columns_[k];
    const bool is_words = std::any_of(column.begin(), column.end(), is_word) ||
                          (std::any_of(column.begin(), column.end(), is_text) &&
                           std::none_of(column.begin(), column.end(), is_number));
    out.push_back(is_words ? words_of(column) : numbers_of(column));
    out.back().name = names_[k];
  }
  return out;
}

void AttributeTable::tell_mixed(std::vector<std::string>& warnings) const {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const auto& column = columns_[k];
    const auto word = std::find_if(column.begin(), column.end(), [](const AttributeValue& value) {
      return is_word(value) && !is_long_number(value);
    });
    const auto number = std::find_if(column.begin(), column.end(), is_number);
    const auto feature = [&](auto value) {
      return numbers_[static_cast<std::size_t>(value - column.begin())];
    };
    if (word == column.end()) {
      // A column of texts alone is meant to be text.
      const auto is_told = [&](const AttributeValue& value) {
        return is_long_number(value) && (!is_text(value) || number != column.end());
      };
      const auto found = std::find_if(column.begin(), column.end(), is_told);
      if (found != column.end())
        warnings.push_back(fmt::format(
            "the attribute '{}' of feature {} is {}, a whole number that no double holds: its "
            "array numbers the different values 1, 2, ...",
            names_[k], feature(found), word_of(*found)));
      continue;
    }
    if (number == column.end()) continue;
    warnings.push_back(fmt::format(
        "the attribute '{}' is a number in some features, as {} in feature {}, and a word in "
        "others, as '{}' in feature {}: its array numbers the different values 1, 2, ...",
        names_[k], word_of(*number), feature(number), word_of(*word), feature(word)));
  }
}

}  // namespace cover
