// Tested by tests/unit/io/input/attribute_table_test.cpp.
#include "io/input/attribute_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "base/numbers.hpp"

namespace cover {
namespace {

bool is_there(const AttributeValue& value) {
  return !std::holds_alternative<std::monostate>(value);
}

/// Whether it has to be a word.
bool is_word(const AttributeValue& value) {
  constexpr std::int64_t kLargest = std::int64_t{1} << std::numeric_limits<double>::digits;
  const auto* whole = std::get_if<std::int64_t>(&value);
  return std::holds_alternative<std::string>(value) ||
         (whole != nullptr && (*whole > kLargest || *whole < -kLargest));
}

double number_of(const AttributeValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
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

std::uint32_t AttributeTable::add_feature() {
  for (auto& column : columns_) column.emplace_back();
  ++features_;
  return columns_.empty() ? 0 : features_;
}

bool AttributeTable::is_empty(std::size_t column) const {
  return std::none_of(columns_[column].begin(), columns_[column].end(), is_there);
}

std::vector<Attribute> AttributeTable::attributes() const {
  std::vector<Attribute> out;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const auto& column = columns_[k];
    const bool text = std::any_of(column.begin(), column.end(), is_word);
    out.push_back(text ? words_of(column) : numbers_of(column));
    out.back().name = names_[k];
  }
  return out;
}

}  // namespace cover
