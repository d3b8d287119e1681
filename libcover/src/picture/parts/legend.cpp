// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/parts/legend.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>

#include "picture/parts/palette.hpp"

namespace cover {
namespace {

constexpr double kRow = 24;

std::string shortened(std::string text, double width) {
  bool cut = false;
  while (text_width(text, kText) > width && text.size() > 4) {
    do text.pop_back();  // whole letters of UTF-8
    while (!text.empty() && (text.back() & 0xC0) == 0x80);
    cut = true;
  }
  return cut ? text + "..." : text;
}

PaintedPatch rectangle(const PixelBox& b, Colour colour) {
  return {colour,
          false,
          {{Point{b.x0, b.y0}, Point{b.x1, b.y0}, Point{b.x1, b.y1}},
           {Point{b.x0, b.y0}, Point{b.x1, b.y1}, Point{b.x0, b.y1}}}};
}

void draw_row(const Legend::Row& row, double x, double y, Drawing& drawing) {
  const PixelBox swatch{x, y, x + 18, y + 16};
  drawing.items.emplace_back(rectangle(swatch, row.colour));
  Stroke border{kInk, 0.8, 1, false, {}};
  add_outline(swatch, border);
  drawing.items.emplace_back(std::move(border));
  drawing.items.emplace_back(Label{shortened(row.text, kKeyWidth - 26), {x + 26, y + 13}, kText});
}

}  // namespace

std::vector<Legend::Row> Legend::grouped_by(std::string Entry::*key) const {
  std::vector<Row> rows;
  std::vector<std::size_t> counts;
  std::map<std::string, std::size_t> index;
  for (const Entry& entry : entries_) {
    const auto [at, is_new] = index.try_emplace(entry.*key, rows.size());
    if (is_new) {
      rows.push_back({entry.colour, entry.*key});
      counts.push_back(0);
    }
    ++counts[at->second];
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (counts[i] > 1) rows[i].text += fmt::format(", {} regions", counts[i]);
  }
  return rows;
}

std::vector<Legend::Row> Legend::rows(std::size_t most) const {
  std::vector<Row> rows = grouped_by(&Entry::region);
  return rows.size() <= most ? rows : grouped_by(&Entry::material);
}

void draw_legend(const Legend& legend, Drawing& drawing) {
  const double x = drawing.plot.x1 + kMargin;
  double y = drawing.plot.y0 + 4;
  const auto room = static_cast<std::size_t>((drawing.plot.y1 - drawing.plot.y0) / kRow);
  const std::vector<Legend::Row> rows = legend.rows(room);
  for (std::size_t i = 0; i < rows.size(); ++i, y += kRow) {
    if (i + 1 >= room && rows.size() > room) {
      drawing.items.emplace_back(
          Label{fmt::format("and {} more", rows.size() - i), {x, y + 13}, kText});
      break;
    }
    draw_row(rows[i], x, y, drawing);
  }
}

void draw_colour_bar(const std::string& title, double low, double high, bool has_gaps,
                     Drawing& drawing) {
  const double x = drawing.plot.x1 + kMargin, top = drawing.plot.y0 + 34;
  const double height = std::min(260.0, drawing.plot.y1 - top - 10 - (has_gaps ? kRow + 8 : 0));
  if (has_gaps) draw_row({kNoValueColour, "no value"}, x, top + height + 16, drawing);
  Label head{shortened(title, kKeyWidth), {x, drawing.plot.y0 + 14}, kText};
  head.bold = true;
  drawing.items.emplace_back(std::move(head));
  constexpr int kBands = 65;
  for (int i = 0; i < kBands; ++i) {
    const double y = top + height * i / kBands;
    drawing.items.emplace_back(
        rectangle({x, y, x + 22, y + height / kBands + 0.5}, value_colour(1 - i / (kBands - 1.0))));
  }
  const auto tick = [&](double value, double y) {
    drawing.items.emplace_back(Stroke{kInk, 1, 1, false, {{Point{x + 22, y}, Point{x + 27, y}}}});
    drawing.items.emplace_back(Label{fmt::format("{:.4g}", value), {x + 32, y + 5}, kText});
  };
  tick(high, top);
  tick(low, top + height);
  // Round numbers between, where they do not touch those of the ends.
  if (!(high - low > 0) || !std::isfinite(high - low)) return;
  const double step = round_number((high - low) / 4);
  for (double k = std::ceil(low / step); k * step < high; ++k) {
    const double y = top + height * (high - k * step) / (high - low);
    if (y > top + kText && y < top + height - kText) tick(k * step, y);
  }
}

}  // namespace cover
