// Attributes of a map's features, gathered feature by feature.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <cover/attribute.hpp>

namespace cover {

/// What one feature has of one attribute; std::monostate: nothing.
using AttributeValue = std::variant<std::monostate, double, std::int64_t, std::string>;

/// The number of a feature under this name, where no attribute has it.
inline constexpr const char* kFeatureId = "fid";

/// A table with a row for each feature.
class AttributeTable {
 public:
  explicit AttributeTable(std::vector<std::string> names)
      : names_(std::move(names)), columns_(names_.size()) {}

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// Begins the row of the next feature and returns what InputPolygon::feature is for it: 0 where
  /// there are no columns.
  std::uint32_t add_feature();
  void set(std::size_t column, AttributeValue value) { columns_[column].back() = std::move(value); }
  /// Whether no feature has anything of it.
  [[nodiscard]] bool is_empty(std::size_t column) const;

  /// The columns. One is text where any feature has a text, or a whole number that a double cannot
  /// hold, as the number of a parcel may be; numbers in it are written out.
  [[nodiscard]] std::vector<Attribute> attributes() const;

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<AttributeValue>> columns_;
  std::uint32_t features_ = 0;
};

}  // namespace cover
