// Attributes of a map's features, gathered feature by feature.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <cover/attribute.hpp>

namespace cover {

/// What one feature has of one attribute; std::monostate: nothing.
using AttributeValue = std::variant<std::monostate, double, std::int64_t, std::string>;

/// The number of a feature under this name, where no attribute has it.
inline constexpr const char* kFeatureId = "fid";

/// What a feature of a map is drawn as.
enum class FeatureShape : std::uint8_t { area = 1, line = 2, point = 4 };

/// A table with a row for each feature.
class AttributeTable {
 public:
  explicit AttributeTable(std::vector<std::string> names)
      : names_(std::move(names)), columns_(names_.size()) {}

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// Begins the row of the next feature, which messages call by its number, and returns what
  /// InputPolygon::feature is for it: 0 where there are no columns.
  std::uint32_t add_feature(long number);
  void set(std::size_t column, AttributeValue value) { columns_[column].back() = std::move(value); }
  /// Notes what a geometry of a feature is, which is 0 or what add_feature() returned.
  void add_shape(std::uint32_t feature, FeatureShape shape);
  /// Whether no feature has anything of it.
  [[nodiscard]] bool is_empty(std::size_t column) const;
  /// Where lines and points alone have anything of it, which no array of a mesh holds, the sentence
  /// that tells; `what` is what the format calls its columns.
  [[nodiscard]] std::optional<std::string> beside_areas(std::size_t column,
                                                        std::string_view what) const;

  /// The columns. One is text where any feature has a word, or a whole number that a double cannot
  /// hold, as the number of a parcel may be; numbers in it are written out. Texts that all spell
  /// numbers are numbers where another feature has one, else they are text: codes are written so.
  [[nodiscard]] std::vector<Attribute> attributes() const;
  /// Appends a sentence for each column of words and numbers, and for each with whole numbers that
  /// are words, as one who expects numbers gets those of words.
  void tell_mixed(std::vector<std::string>& warnings) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<AttributeValue>> columns_;
  std::vector<long> numbers_;         ///< by feature
  std::vector<std::uint8_t> shapes_;  ///< by feature, sums of FeatureShape
};

}  // namespace cover
