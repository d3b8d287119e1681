#include "words/text_table.hpp"

#include <algorithm>

#include <cover/text.hpp>

namespace cover::app {
namespace {

/// Characters of UTF-8 text: the bytes that do not continue one.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

void TextTable::add(std::vector<std::string> cells) {
  for (std::string& cell : cells) cell = printable(cell);
  rows_.push_back(std::move(cells));
}

std::string TextTable::text(const std::string& indent) const {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    std::size_t w = width(columns_[c].title);
    for (const auto& row : rows_) w = std::max(w, width(row[c]));
    widths.push_back(w);
  }
  std::string out;
  const auto line = [&](auto cell) {
    std::string row = indent;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const std::string& text = cell(c);
      const std::string space(widths[c] - width(text), ' ');
      row += columns_[c].align == Align::left ? text + space : space + text;
      row += "  ";
    }
    row.erase(row.find_last_not_of(' ') + 1);
    out += row + '\n';
  };
  line([&](std::size_t c) -> const std::string& { return columns_[c].title; });
  for (const auto& cells : rows_)
    line([&](std::size_t c) -> const std::string& { return cells[c]; });
  return out;
}

}  // namespace cover::app
