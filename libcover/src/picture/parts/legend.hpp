// Which colour means what: the column on the right of a picture.
#pragma once

#include <string>
#include <vector>

#include "picture/drawing.hpp"

namespace cover {

/// Width of the column.
inline constexpr double kKeyWidth = 210;

/// Collects the regions of a picture.
class Legend {
 public:
  struct Row {
    Colour colour;
    std::string text;
  };

  void add(Colour colour, std::string region, std::string material) {
    entries_.push_back({colour, std::move(region), std::move(material)});
  }

  /// One row per region name or, if those are more than `most`, per material; rows that stand for
  /// several regions say for how many.
  [[nodiscard]] std::vector<Row> rows(std::size_t most) const;

 private:
  struct Entry {
    Colour colour;
    std::string region;
    std::string material;
  };

  [[nodiscard]] std::vector<Row> grouped_by(std::string Entry::*key) const;

  std::vector<Entry> entries_;
};

/// Draws the rows beside the plot, as many as there is room for.
void draw_legend(const Legend& legend, Drawing& drawing);

/// Draws value_colour() from `low` to `high` beside the plot, with ticks, and below it, where the
/// picture `has_gaps`, the colour of what has no value.
void draw_colour_bar(const std::string& title, double low, double high, bool has_gaps,
                     Drawing& drawing);

}  // namespace cover
