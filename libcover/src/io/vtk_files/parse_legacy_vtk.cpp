// VTK reads these files word by word, wherever lines break, and so does this.
// Tested by tests/unit/io/vtk_files/read_data_set_test.cpp.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/faults/errors.hpp"
#include "base/words/characters.hpp"
#include "io/text/text.hpp"
#include "io/vtk_files/arrays/ascii_numbers.hpp"
#include "io/vtk_files/arrays/byte_order.hpp"
#include "io/vtk_files/parse_data_set.hpp"

namespace cover {
namespace {

int hexadecimal(char digit) {
  if (is_digit(digit)) return digit - '0';
  if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
  return digit >= 'A' && digit <= 'F' ? digit - 'A' + 10 : -1;
}

/// Names are written with %20 for a blank, and so on.
std::string decoded(std::string_view name) {
  std::string out;
  for (std::size_t k = 0; k < name.size(); ++k) {
    const int high = name[k] == '%' && k + 2 < name.size() ? hexadecimal(name[k + 1]) : -1;
    const int low = high < 0 ? -1 : hexadecimal(name[k + 2]);
    out += low < 0 ? name[k] : static_cast<char>(16 * high + low);
    if (low >= 0) k += 2;
  }
  return out;
}

/// A type of numbers in a legacy file.
struct LegacyType {
  std::string_view name;
  NumberType type;
  bool bits = false;
};

constexpr std::array kTypes{
    LegacyType{"bit", NumberType::uint8, true},    LegacyType{"char", NumberType::int8},
    LegacyType{"signed_char", NumberType::int8},   LegacyType{"unsigned_char", NumberType::uint8},
    LegacyType{"short", NumberType::int16},        LegacyType{"unsigned_short", NumberType::uint16},
    LegacyType{"int", NumberType::int32},          LegacyType{"unsigned_int", NumberType::uint32},
    LegacyType{"long", NumberType::int64},         LegacyType{"unsigned_long", NumberType::uint64},
    LegacyType{"vtktypeint64", NumberType::int64}, LegacyType{"vtktypeuint64", NumberType::uint64},
    LegacyType{"vtkidtype", NumberType::int32},  // VTK narrows its ids
    LegacyType{"float", NumberType::float32},      LegacyType{"double", NumberType::float64},
};

const LegacyType* legacy_type(std::string_view name) {
  const std::string known = lower(name);
  const auto* const found = std::find_if(
      kTypes.begin(), kTypes.end(), [&](const LegacyType& type) { return type.name == known; });
  return found == kTypes.end() ? nullptr : found;
}

/// Cells as a legacy file has them.
struct LegacyCells {
  std::vector<std::size_t> offsets{0};
  NumberArray nodes;
};

class LegacyParser {
 public:
  LegacyParser(std::string_view text, const std::string& source)
      : text_(text), source_(source), rest_(text) {}

  Result<DataSet> parse() {
    Status status = read_head();
    while (status) {
      word_ = rest_;
      const std::string_view keyword = word();
      if (keyword.empty()) break;
      status = read_section(lower(keyword));
    }
    if (status) status = finish();
    if (!status) return std::move(status).error();
    return std::move(data_);
  }

 private:
  enum class Items { none, points, cells };

  /// An error at the last word that was read.
  [[nodiscard]] Error error(ErrorCode code, std::string_view what) const {
    const auto line = 1 + std::count(text_.begin(), text_.end() - std::ssize(word_), '\n');
    return {code, fmt::format("{}:{}: {}", source_, line, what), {}, {}};
  }
  [[nodiscard]] Error wrong(std::string_view what) const { return error(ErrorCode::syntax, what); }
  std::string_view line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view out = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return out;
  }

  void skip_blanks() {
    std::size_t k = 0;
    while (k < rest_.size() && is_blank(rest_[k])) ++k;
    rest_.remove_prefix(k);
  }

  /// The next word, empty at the end of the file.
  std::string_view word() {
    skip_blanks();
    word_ = rest_;
    std::size_t end = 0;
    while (end < rest_.size() && !is_blank(rest_[end])) ++end;
    const std::string_view out = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return out;
  }

  Result<std::size_t> count(std::string_view what) {
    const std::string_view found = word();
    const auto number = parse_integer(found);
    if (!number && found.empty())
      return error(ErrorCode::truncated, fmt::format("the file ends before {}", what));
    if (!number || *number < 0)
      return wrong(fmt::format("expected {}, found '{}'", what, legible(found)));
    return static_cast<std::size_t>(*number);
  }

  Status read_head() {
    constexpr std::string_view kHead = "# vtk DataFile Version ";
    word_ = rest_;
    std::string_view first = line();
    if (!first.starts_with(kHead))
      return wrong("no file of VTK: it does not begin with '# vtk DataFile Version'");
    first.remove_prefix(kHead.size());
    const std::string_view version = first.substr(0, first.find_first_of(". \t\r"));
    const auto number = parse_integer(version);
    if (!number) return wrong(fmt::format("'{}' is no version", legible(first)));
    has_offsets_ = *number >= 5;
    (void)line();  // the title
    const std::string_view written = word();
    const std::string mode = lower(written);
    if (mode != "ascii" && mode != "binary")
      return wrong(fmt::format("expected ASCII or BINARY, found '{}'", legible(written)));
    binary_ = mode == "binary";
    if (lower(word()) != "dataset") return wrong("there is no DATASET in it");
    const std::string_view kind = word();
    kind_ = lower(kind);
    constexpr std::array kKinds{"unstructured_grid", "polydata", "structured_points",
                                "structured_grid", "rectilinear_grid"};
    if (std::find(kKinds.begin(), kKinds.end(), kind_) == kKinds.end())
      return error(ErrorCode::unsupported_format,
                   fmt::format("VTK's data set '{}' is not read", legible(kind)));
    return ok();
  }

  Status read_section(const std::string& keyword) {
    if (keyword == "metadata") return skip_metadata();
    if (keyword == "field") return read_field();
    if (keyword == "cell_data" || keyword == "point_data") return start_arrays(keyword);
    if (items_ != Items::none) return read_attribute(keyword);
    if (keyword == "points") return read_points();
    if (keyword == "cells") return read_cells(cells_);
    if (keyword == "cell_types") return read_types();
    if (keyword == "dimensions") return read_dimensions();
    if (keyword == "spacing" || keyword == "aspect_ratio") return read_three(spacing_);
    if (keyword == "origin") return read_three(origin_);
    constexpr std::array kAxes{"x_coordinates", "y_coordinates", "z_coordinates"};
    for (std::size_t k = 0; k < kAxes.size(); ++k)
      if (keyword == kAxes[k]) return read_axis(axes_[k]);
    for (std::size_t k = 0; k < kSurfaceCells.size(); ++k)
      if (keyword == lower(kSurfaceCells[k].keyword)) return read_cells(surface_[k]);
    return wrong(fmt::format("unknown keyword '{}'", legible(keyword)));
  }

  /// Keys of arrays, which nobody needs: up to an empty line.
  Status skip_metadata() {
    (void)line();
    while (!rest_.empty()) {
      const std::string_view text = line();
      if (std::all_of(text.begin(), text.end(), is_blank)) break;
    }
    return ok();
  }

  /// Numbers behind the line at whose end the parser is.
  ///
  /// REQUIRES: components > 0
  Result<NumberArray> numbers(const LegacyType& type, std::size_t items, std::size_t components) {
    // In text or in bits, a number takes an eighth of a byte or more.
    const std::size_t most = 8 * rest_.size();
    const auto cut_off = [&] {
      return error(ErrorCode::truncated,
                   fmt::format("{} times {} numbers are announced, and the file ends before", items,
                               components));
    };
    if (items > most / components) return cut_off();
    const std::size_t values = items * components;
    const auto finished = [&](NumberArray array) {
      array.components = components;
      return array;
    };
    if (!binary_) {
      if (values > rest_.size() / 2 + 1) return cut_off();
      return with_type(type.type, [&](auto number) -> Result<NumberArray> {
        using T = decltype(number);
        auto own = std::make_unique_for_overwrite<char[]>(values * sizeof(T));
        const std::size_t read = read_ascii(rest_, reinterpret_cast<T*>(own.get()), values);
        if (read == values) return finished(NumberArray(type.type, std::move(own), values));
        if (rest_.empty()) return cut_off();
        const std::string_view found = word();
        return wrong(
            fmt::format("expected a number (of type {}), found '{}'", type.name, legible(found)));
      });
    }
    (void)line();
    const std::size_t size = type.bits ? (values + 7) / 8 : values * size_of(type.type);
    if (size > rest_.size()) return cut_off();
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    if (type.bits) return finished(NumberArray(type.type, unpack_bits(bytes, values), values));
    if (std::endian::native == std::endian::big || size_of(type.type) == 1)
      return finished(NumberArray(type.type, bytes));
    auto own = std::make_unique_for_overwrite<char[]>(size);
    std::copy(bytes.begin(), bytes.end(), own.get());
    swap_bytes(own.get(), values, size_of(type.type));
    return finished(NumberArray(type.type, std::move(own), values));
  }

  Result<const LegacyType*> type_word() {
    const std::string_view found = word();
    const LegacyType* type = legacy_type(found);
    if (type == nullptr) return wrong(fmt::format("'{}' is no type of numbers", legible(found)));
    return type;
  }

  Status read_points() {
    const auto points = count("the number of points");
    if (!points) return points.error();
    const auto type = type_word();
    if (!type) return type.error();
    if (data_.point_count() > 0) return wrong("POINTS a second time");
    const auto coordinates = numbers(**type, *points, 3);
    if (!coordinates) return coordinates.error();
    Status status = data_.add_points(*coordinates);
    return status ? ok() : Status(in_file(source_, status.error()));
  }

  /// An array of a version from 5 on: its name and type, then `size` integers.
  Result<NumberArray> read_part(std::string_view name, std::size_t size) {
    const std::string_view found = word();
    if (lower(found) != name)
      return wrong(fmt::format("expected {}, found '{}'", name, legible(found)));
    const auto type = type_word();
    if (!type) return type.error();
    // Here VTK writes its ids as they are.
    constexpr LegacyType kId{"vtkidtype", NumberType::int64};
    return numbers((*type)->name == kId.name ? kId : **type, size, 1);
  }

  Status read_cells(LegacyCells& cells) {
    const auto first = count("the number of cells"), second = count("the size of their list");
    if (!first) return first.error();
    if (!second) return second.error();
    cells = LegacyCells();
    if (has_offsets_) {
      const auto offsets = read_part("offsets", *first);
      if (!offsets) return offsets.error();
      auto sound = as_offsets(*offsets, false);
      if (!sound) return in_file(source_, sound.error());
      auto nodes = read_part("connectivity", *second);
      if (!nodes) return std::move(nodes).error();
      cells = {std::move(*sound), std::move(*nodes)};
      return ok();
    }
    constexpr LegacyType kInt{"int", NumberType::int32};
    const auto list = numbers(kInt, *second, 1);
    if (!list) return list.error();
    return split(NumberView<std::int32_t>(list->bytes().data(), list->size()), *first, cells);
  }

  /// Cells out of a list where the number of its nodes stands in front of each.
  Status split(NumberView<std::int32_t> list, std::size_t count, LegacyCells& cells) const {
    if (count > list.size())
      return wrong(fmt::format("{} cells in a list of {} numbers", count, list.size()));
    const std::size_t size = list.size() - count;
    auto own = std::make_unique_for_overwrite<char[]>(size * sizeof(std::int32_t));
    cells.offsets.reserve(count + 1);
    std::size_t at = 0, taken = 0;
    for (std::size_t c = 0; c < count; ++c) {
      const auto nodes = at < list.size() ? as_index(list[at], list.size() - at) : std::nullopt;
      if (!nodes || *nodes > size - taken)
        return wrong(
            fmt::format("cell {} has more points than the list of {} numbers", c, list.size()));
      for (std::size_t k = 0; k < *nodes; ++k) {
        const std::int32_t node = list[at + 1 + k];
        std::memcpy(own.get() + (taken + k) * sizeof node, &node, sizeof node);
      }
      at += 1 + *nodes;
      taken += *nodes;
      cells.offsets.push_back(taken);
    }
    if (at != list.size())
      return wrong(
          fmt::format("{} cells take {} of {} numbers of their list", count, at, list.size()));
    cells.nodes = NumberArray(NumberType::int32, std::move(own), taken);
    return ok();
  }

  Status read_types() {
    const auto cells = count("the number of cell types");
    if (!cells) return cells.error();
    constexpr LegacyType kInt{"int", NumberType::int32};
    auto types = numbers(kInt, *cells, 1);
    if (!types) return std::move(types).error();
    auto bytes = as_cell_types(*types);
    if (!bytes) return in_file(source_, bytes.error());
    types_ = std::move(*bytes);
    return ok();
  }

  Status read_dimensions() {
    for (std::size_t& n : dimensions_) {
      const auto points = count("a dimension");
      if (!points) return points.error();
      n = *points;
    }
    return ok();
  }

  Status read_three(std::array<double, 3>& values) {
    for (double& value : values) {
      const std::string_view found = word();
      const auto number = parse_double(found);
      if (!number) return wrong(fmt::format("expected a number, found '{}'", legible(found)));
      value = *number;
    }
    return ok();
  }

  Status read_axis(std::vector<double>& axis) {
    const auto places = count("the number of coordinates");
    if (!places) return places.error();
    const auto type = type_word();
    if (!type) return type.error();
    const auto coordinates = numbers(**type, *places, 1);
    if (!coordinates) return coordinates.error();
    axis.clear();
    coordinates->visit([&](auto values) {
      for (std::size_t k = 0; k < values.size(); ++k)
        axis.push_back(static_cast<double>(values[k]));
    });
    return ok();
  }

  Status start_arrays(const std::string& keyword) {
    const auto announced = count("the number of items");
    if (!announced) return announced.error();
    items_ = keyword == "cell_data" ? Items::cells : Items::points;
    announced_ = *announced;
    // Cells are put together at the end; there is no telling yet how many there should be.
    (items_ == Items::cells ? cell_items_ : point_items_) = announced_;
    return ok();
  }

  void keep(std::string_view name, NumberArray array) {
    array.name = decoded(name);
    auto& arrays = items_ == Items::points ? data_.point_arrays : data_.cell_arrays;
    if (items_ == Items::points || items_ == Items::cells) arrays.push_back(std::move(array));
  }

  /// An attribute called `name` of one array.
  Status read_one(std::string_view name, const LegacyType& type, std::size_t components) {
    if (components == 0 || components > 9)
      return wrong(fmt::format("an attribute with {} components", components));
    Result<NumberArray> array = numbers(type, announced_, components);
    if (!array) return std::move(array).error();
    keep(name, std::move(*array));
    return ok();
  }

  Status read_attribute(const std::string& keyword) {
    if (keyword == "scalars") return read_scalars();
    if (keyword == "lookup_table") return skip_lookup_table();
    if (keyword == "color_scalars") return read_colours();
    constexpr std::array<std::pair<std::string_view, std::size_t>, 7> kFixed{{
        {"vectors", 3},
        {"normals", 3},
        {"tensors", 9},
        {"tensors6", 6},
        {"global_ids", 1},
        {"pedigree_ids", 1},
        {"edge_flags", 1},
    }};
    for (const auto& [known, components] : kFixed) {
      if (keyword != known) continue;
      const std::string_view name = word();
      const std::string_view type_name = word();
      if (keyword == "pedigree_ids" && is_of_words(type_name))
        return skip_words(announced_, type_name);
      const LegacyType* type = legacy_type(type_name);
      if (type == nullptr)
        return wrong(fmt::format("'{}' is no type of numbers", legible(type_name)));
      return read_one(name, *type, components);
    }
    if (keyword == "texture_coordinates") {
      const std::string_view name = word();
      const auto dimension = count("the dimension of texture coordinates");
      if (!dimension) return dimension.error();
      const auto type = type_word();
      if (!type) return type.error();
      return read_one(name, **type, *dimension);
    }
    return wrong(fmt::format("unknown keyword '{}'", legible(keyword)));
  }

  Status read_scalars() {
    const std::string_view name = word();
    const auto type = type_word();
    if (!type) return type.error();
    std::string_view more = line();
    std::size_t components = 1;
    if (more.find_first_not_of(" \t\r") != std::string_view::npos) {
      const std::string_view digits = more.substr(more.find_first_not_of(" \t\r"));
      const auto number = parse_integer(digits.substr(0, digits.find_first_of(" \t\r")));
      if (!number || *number < 1)
        return wrong(fmt::format("'{}' is no number of components", legible(digits)));
      components = static_cast<std::size_t>(*number);
    }
    if (lower(word()) != "lookup_table") return wrong("SCALARS without a LOOKUP_TABLE");
    (void)word();
    return read_one(name, **type, components);
  }

  Status skip_lookup_table() {
    (void)word();
    const auto size = count("the size of a lookup table");
    if (!size) return size.error();
    constexpr LegacyType kByte{"unsigned_char", NumberType::uint8};
    constexpr LegacyType kFloat{"float", NumberType::float32};
    const auto colours = numbers(binary_ ? kByte : kFloat, *size, 4);
    return colours ? ok() : Status(colours.error());
  }

  Status read_colours() {
    const std::string_view name = word();
    const auto components = count("the number of colours");
    if (!components) return components.error();
    if (*components == 0 || *components > 4)
      return wrong(fmt::format("colours with {} components", *components));
    constexpr LegacyType kByte{"unsigned_char", NumberType::uint8};
    if (binary_) return read_one(name, kByte, *components);
    constexpr LegacyType kFloat{"float", NumberType::float32};
    const auto shares = numbers(kFloat, announced_, *components);
    if (!shares) return shares.error();
    // In text a byte is written as its part of 255. An array of bytes is written so, too.
    auto bytes = std::make_unique_for_overwrite<char[]>(shares->size());
    shares->visit([&](auto values) {
      for (std::size_t k = 0; k < values.size(); ++k) {
        const double share = 255 * static_cast<double>(values[k]) + 0.5;
        bytes[k] = static_cast<char>(share >= 0 && share < 256 ? static_cast<std::uint8_t>(share)
                                                               : std::uint8_t{0});
      }
    });
    NumberArray colours(NumberType::uint8, std::move(bytes), shares->size());
    colours.components = *components;
    keep(name, std::move(colours));
    return ok();
  }

  static bool is_of_words(std::string_view type) {
    const std::string known = lower(type);
    return known == "string" || known == "utf8_string" || known == "variant";
  }

  Status read_field() {
    (void)word();  // its name
    const auto arrays = count("the number of arrays");
    if (!arrays) return arrays.error();
    for (std::size_t k = 0; k < *arrays; ++k) {
      std::string_view name = word();
      while (lower(name) == "metadata") {
        (void)skip_metadata();
        name = word();
      }
      if (name.empty()) return error(ErrorCode::truncated, "the file ends within a FIELD");
      if (name == "NULL_ARRAY") continue;
      const auto components = count("the number of components");
      if (!components) return components.error();
      const auto tuples = count("the number of items");
      if (!tuples) return tuples.error();
      const std::string_view type_name = word();
      if (is_of_words(type_name)) {
        if (*components != 0 && *tuples > rest_.size() / *components)
          return error(ErrorCode::truncated, "the file ends within a FIELD");
        if (Status status = skip_words(*components * *tuples, type_name); !status) return status;
        NumberArray without_numbers;
        keep(name, std::move(without_numbers));
        continue;
      }
      const LegacyType* type = legacy_type(type_name);
      if (type == nullptr)
        return wrong(fmt::format("'{}' is no type of numbers", legible(type_name)));
      if (*components == 0) continue;
      Result<NumberArray> array = numbers(*type, *tuples, *components);
      if (!array) return std::move(array).error();
      keep(name, std::move(*array));
    }
    return ok();
  }

  /// Strings and variants: lines of text, or with their length in front.
  Status skip_words(std::size_t values, std::string_view type) {
    const auto cut_off = [&] {
      return error(ErrorCode::truncated, "the file ends within an array of strings");
    };
    (void)line();
    if (!binary_ || lower(type) == "variant") {
      for (; values > 0; --values) {
        if (rest_.empty()) return cut_off();
        (void)line();
      }
      return ok();
    }
    for (; values > 0; --values) {
      if (rest_.empty()) return cut_off();
      // The two highest bits tell how many bytes the length has: 8, 4, 2 or 1.
      const auto lead = static_cast<unsigned char>(rest_[0]);
      const std::size_t bytes = std::size_t{8} >> (lead >> 6U);
      if (bytes > rest_.size()) return cut_off();
      std::uint64_t length = lead & 0x3FU;
      for (std::size_t k = 1; k < bytes; ++k)
        length = length << 8U | static_cast<unsigned char>(rest_[k]);
      rest_.remove_prefix(bytes);
      if (length > rest_.size()) return cut_off();
      rest_.remove_prefix(static_cast<std::size_t>(length));
    }
    return ok();
  }

  Status finish() {
    Status status = kind_ == "unstructured_grid" ? finish_grid()
                    : kind_ == "polydata"        ? finish_surface()
                                                 : finish_lattice();
    if (!status) return in_file(source_, status.error());
    const auto fits = [](std::optional<std::size_t> announced, std::size_t there) {
      return !announced || *announced == there;
    };
    if (!fits(point_items_, data_.point_count()))
      return wrong_file(source_, fmt::format("POINT_DATA of {} points, and there are {}",
                                             *point_items_, data_.point_count()));
    if (!fits(cell_items_, data_.cell_count()))
      return wrong_file(source_, fmt::format("CELL_DATA of {} cells, and there are {}",
                                             *cell_items_, data_.cell_count()));
    return ok();
  }

  Status finish_grid() {
    if (types_.size() != cells_.offsets.size() - 1)
      return Error{ErrorCode::syntax,
                   fmt::format("there are {} cells and {} types of cells",
                               cells_.offsets.size() - 1, types_.size()),
                   {},
                   {}};
    return data_.add_cells(cells_.nodes, cells_.offsets, std::move(types_), 0);
  }

  Status finish_surface() {
    for (std::size_t kind = 0; kind < surface_.size(); ++kind) {
      auto types = surface_types(kind, surface_[kind].offsets);
      if (!types) return std::move(types).error();
      Status status =
          data_.add_cells(surface_[kind].nodes, surface_[kind].offsets, std::move(*types), 0);
      if (!status) return status;
    }
    return ok();
  }

  Status finish_lattice() {
    if (kind_ == "rectilinear_grid") {
      for (std::size_t k = 0; k < 3; ++k) {
        if (axes_[k].empty()) axes_[k].push_back(0);
        if (axes_[k].size() != dimensions_[k])
          return Error{
              ErrorCode::syntax,
              fmt::format("a dimension of {} and {} coordinates", dimensions_[k], axes_[k].size()),
              {},
              {}};
      }
    }
    if (Status status = check_lattice(dimensions_, text_.size()); !status) return status;
    if (kind_ == "structured_points") {
      for (std::size_t k = 0; k < 3; ++k) {
        axes_[k].clear();
        for (std::size_t i = 0; i < dimensions_[k]; ++i)
          axes_[k].push_back(origin_[k] + spacing_[k] * static_cast<double>(i));
      }
    } else if (kind_ == "structured_grid") {
      for (auto& axis : axes_) axis.clear();
      const std::size_t points = dimensions_[0] * dimensions_[1] * dimensions_[2];
      if (points != data_.point_count())
        return Error{ErrorCode::syntax,
                     fmt::format("the dimensions are those of {} points, and there are {}", points,
                                 data_.point_count()),
                     {},
                     {}};
    }
    if (kind_ != "structured_grid" && data_.point_count() > 0)
      return Error{ErrorCode::syntax, "POINTS in a regular grid", {}, {}};
    data_.set_lattice(dimensions_, std::move(axes_));
    if (kind_ == "structured_points") data_.set_even();
    return ok();
  }

  std::string_view text_;
  const std::string& source_;
  std::string_view rest_;
  std::string_view word_;  ///< the text from the last word on
  std::string kind_;
  bool binary_ = false;
  bool has_offsets_ = false;
  Items items_ = Items::none;
  std::size_t announced_ = 0;
  std::optional<std::size_t> point_items_, cell_items_;
  DataSet data_;
  LegacyCells cells_;
  std::vector<std::uint8_t> types_;
  std::array<LegacyCells, kSurfaceCells.size()> surface_;
  std::array<std::size_t, 3> dimensions_{1, 1, 1};
  std::array<double, 3> origin_{0, 0, 0}, spacing_{1, 1, 1};
  std::array<std::vector<double>, 3> axes_;
};

}  // namespace

Result<DataSet> parse_legacy_vtk(std::string_view text, const std::string& source) {
  return LegacyParser(text, source).parse();
}

}  // namespace cover
