// What readers of maps say, in one voice.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cover/attribute.hpp>

namespace cover {

/// A warning for maps that are not projected.
inline constexpr const char* kInDegrees =
    "coordinates are longitudes and latitudes: lengths and angles are those of a plane of degrees; "
    "--crs EPSG:... projects them";

/// What of a map has no place in a drawing, counted to be told in the end.
class LeftOut {
 public:
  void add_point() { ++points_; }
  void add_surface() { ++surfaces_; }
  /// A wished edge length that is none, in the feature of that number.
  void add_size(long feature);
  /// A wished edge length of a feature that has a line.
  void add_size_of_line() { ++sizes_of_lines_; }

  /// Appends a sentence each; `what` is what the format calls its columns: "property".
  void tell(std::string_view what, std::vector<std::string>& warnings) const;

 private:
  std::size_t points_ = 0, surfaces_ = 0, sizes_ = 0, sizes_of_lines_ = 0;
  long first_size_ = 0;
};

/// Appends a sentence where the array of an attribute cannot be called as the attribute.
void tell_renamed(const std::vector<Attribute>& attributes, std::vector<std::string>& warnings);

/// The number that a text spells, as tables have it whose columns are all text.
std::optional<double> number_in_words(std::string_view text);

}  // namespace cover
