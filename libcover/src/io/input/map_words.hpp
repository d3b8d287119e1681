// What readers of maps say, in one voice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cover/attribute.hpp>
#include <cover/input.hpp>
#include <cover/read_options.hpp>

namespace cover {

/// A warning for maps that are not projected.
inline constexpr const char* kInDegrees =
    "coordinates are longitudes and latitudes: lengths and angles are those of a plane of degrees; "
    "--crs EPSG:... projects them";

/// The same where nothing is said of them, as the standard of GeoJSON wants it.
inline constexpr const char* kMayBeDegrees =
    "no coordinate system is said, so by RFC 7946 coordinates are longitudes and latitudes, if "
    "this "
    "is a map: lengths and angles are those of a plane of degrees; --crs EPSG:... projects them";

/// Warns that a map is not projected; or, where the file says so of coordinates that cannot be
/// longitudes and latitudes, of that.
void tell_degrees(Input& input);

/// Adds the name of an attribute to Input::fields, unless it is there.
void note_field(Input& input, const std::string& name);

/// What of a map has no place in a drawing, counted to be told in the end.
class LeftOut {
 public:
  void add_surface() { ++surfaces_; }
  /// A feature without a geometry, or a geometry without coordinates: maps may have both.
  void add_empty() { ++empty_; }
  /// A point above or below the plane.
  void add_height() { ++heights_; }
  /// A polygon whose material is called as drawings call none.
  void add_void() { ++voids_; }
  /// A wished edge length that is none, in the feature of that number.
  void add_size(long feature);
  /// A wished edge length of a feature that has a line.
  void add_size_of_line() { ++sizes_of_lines_; }
  /// One of a feature that has a point.
  void add_size_of_point() { ++sizes_of_points_; }

  /// Appends a sentence each to the warnings of `input`, and to its changes where geometry is left
  /// out; `what` is what the format calls its columns: "property".
  void tell(std::string_view what, Input& input) const;

 private:
  std::size_t surfaces_ = 0, empty_ = 0, heights_ = 0;
  std::size_t voids_ = 0, sizes_ = 0, sizes_of_lines_ = 0, sizes_of_points_ = 0;
  long first_size_ = 0;
};

/// Whether a material is called as drawings and legends of pictures call the void.
bool is_word_for_void(std::string_view material);

/// Fields and layers that options name. What is in any part of a map is there: rivers have no land
/// use.
class AskedNames {
 public:
  /// Notes whether a part has one; where none has, all sentences tell.
  void note(const std::string& option, const std::string& name, bool is_there,
            const std::string& missing);
  /// Takes back what parts had: it is of no use there, as the sentence alone tells.
  void deny(const std::string& option, const std::string& name, const std::string& missing);
  /// An error where one is missing; none where another file may have it, which is left to whoever
  /// joins it with `input`.
  std::optional<Error> settle(const ReadOptions& options, Input& input) const;

 private:
  std::vector<AskedName> names_;
};

/// What is missing where no text is on a layer that should hold labels, with `layers` that have
/// texts, in order.
std::string no_text_on(std::string_view layer, std::vector<std::string> layers);

/// Appends a sentence where the array of an attribute cannot be called as the attribute.
void tell_renamed(const std::vector<Attribute>& attributes, std::vector<std::string>& warnings);

/// The number that a text spells, as tables have it whose columns are all text.
std::optional<double> number_in_words(std::string_view text);

/// Whether there is a double that is this number. Not every whole number beyond 2^53, as that of a
/// parcel may be, is one; -2^63, which stands for no value, is.
bool double_holds(std::int64_t whole);

/// The same of a text in a column that is kept, where whole numbers that no double holds are words.
std::optional<double> number_in_column(std::string_view text);

/// Appends a sentence for each column that is all text but spells numbers, and no codes such as
/// 007: one who expects the numbers gets those of the texts.
void tell_spelled_numbers(const std::vector<Attribute>& attributes,
                          std::vector<std::string>& warnings);

}  // namespace cover
