// Tested by tests/unit/io/vtk_files/read_data_set_test.cpp.
#include "io/vtk_files/data_set.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "io/text/limits.hpp"

namespace cover {
namespace {

/// Numbers of points have 32 bits, and the highest is nobody's.
constexpr std::size_t kMostPoints = std::numeric_limits<std::uint32_t>::max() - 1;

Error wrong_data(std::string what) { return {ErrorCode::syntax, std::move(what), {}, {}}; }

/// A cell of the type has so many nodes, or more.
std::size_t least_nodes(int type) {
  switch (type) {
    case cell_type::kVertex:
      return 1;
    case cell_type::kLine:
    case cell_type::kQuadraticEdge:
      return 2;
    case cell_type::kTriangle:
    case cell_type::kQuadraticTriangle:
    case cell_type::kBiquadraticTriangle:
    case cell_type::kLagrangeTriangle:
    case cell_type::kBezierTriangle:
      return 3;
    case cell_type::kPixel:
    case cell_type::kQuad:
    case cell_type::kQuadraticQuad:
    case cell_type::kBiquadraticQuad:
    case cell_type::kQuadraticLinearQuad:
    case cell_type::kLagrangeQuad:
    case cell_type::kBezierQuad:
      return 4;
    default:
      return 0;
  }
}

/// The numbers of all parts, one behind the other; as doubles where their types differ.
NumberArray joined(const std::vector<const NumberArray*>& parts) {
  const NumberArray& first = *parts.front();
  const bool same = std::all_of(parts.begin(), parts.end(), [&](const NumberArray* part) {
    return part->type() == first.type();
  });
  const NumberType type = same ? first.type() : NumberType::float64;
  std::size_t size = 0;
  for (const NumberArray* part : parts) size += part->size();
  auto bytes = std::make_unique_for_overwrite<char[]>(size * size_of(type));
  char* out = bytes.get();
  for (const NumberArray* part : parts) {
    if (same) {
      out = std::copy(part->bytes().begin(), part->bytes().end(), out);
      continue;
    }
    part->visit([&](auto numbers) {
      for (std::size_t k = 0; k < numbers.size(); ++k, out += sizeof(double)) {
        const auto number = static_cast<double>(numbers[k]);
        std::memcpy(out, &number, sizeof number);
      }
    });
  }
  NumberArray all(type, std::move(bytes), size);
  all.name = first.name;
  all.components = first.components;
  return all;
}

const NumberArray* find_array(const std::vector<NumberArray>& arrays, std::string_view name,
                              std::size_t items) {
  for (const NumberArray& array : arrays)
    if (array.name == name && array.is_one_per(items)) return &array;
  return nullptr;
}

}  // namespace

Status DataSet::check_plane() const {
  for (std::size_t p = 0; p < point_count(); ++p) {
    const double height = point(0)[2], here = point(p)[2];
    if (here == height) continue;
    return Error{ErrorCode::unsupported_format,
                 fmt::format("the mesh is not in a plane z = constant: point 0 has z = {}, point "
                             "{} {}",
                             height, p, here),
                 {},
                 {}};
  }
  return ok();
}

const NumberArray* DataSet::array_of_points(std::string_view name) const {
  return find_array(point_arrays, name, point_count());
}

const NumberArray* DataSet::array_of_cells(std::string_view name) const {
  return find_array(cell_arrays, name, cell_count());
}

Status DataSet::add_points(const NumberArray& coordinates) {
  const std::size_t before = points_.size(), count = coordinates.size() / 3;
  if (count > kMostPoints - before)
    return wrong_data(fmt::format("more than {} points", kMostPoints));
  points_.resize(before + count);
  coordinates.visit([&](auto numbers) {
    for (std::size_t p = 0; p < count; ++p)
      points_[before + p] = {static_cast<double>(numbers[3 * p]),
                             static_cast<double>(numbers[3 * p + 1]),
                             static_cast<double>(numbers[3 * p + 2])};
  });
  return ok();
}

Status DataSet::add_cells(const NumberArray& connectivity, const std::vector<std::size_t>& offsets,
                          std::vector<std::uint8_t> types, std::size_t first_point) {
  const std::size_t count = types.size(), before = nodes_.size();
  if (offsets.back() > connectivity.size())
    return wrong_data(fmt::format("the cells need {} numbers of points, and there are {}",
                                  offsets.back(), connectivity.size()));
  for (std::size_t c = 0; c < count; ++c)
    if (offsets[c + 1] - offsets[c] < least_nodes(types[c]))
      return wrong_data(fmt::format("cell {} is of VTK's type {} and has {} points",
                                    types_.size() + c, types[c], offsets[c + 1] - offsets[c]));
  const std::size_t points = points_.size() - first_point;
  nodes_.resize(before + offsets.back());
  const std::size_t bad = connectivity.visit([&](auto numbers) {
    for (std::size_t k = 0; k < offsets.back(); ++k) {
      const auto node = as_index(numbers[k], points);
      if (!node) return k;
      nodes_[before + k] = static_cast<std::uint32_t>(first_point + *node);
    }
    return offsets.back();
  });
  if (bad < offsets.back()) {
    const auto cell = std::upper_bound(offsets.begin(), offsets.end(), bad) - offsets.begin() - 1;
    return Error{
        ErrorCode::syntax,
        fmt::format("cell {} has the point {}, which is not there: there are {}",
                    types_.size() + static_cast<std::size_t>(cell),
                    connectivity.visit([&](auto n) { return fmt::format("{}", n[bad]); }), points),
        {},
        {}};
  }
  first_.reserve(first_.size() + count);
  for (std::size_t c = 0; c < count; ++c) first_.push_back(before + offsets[c + 1]);
  if (types_.empty())
    types_ = std::move(types);
  else
    types_.insert(types_.end(), types.begin(), types.end());
  return ok();
}

void DataSet::set_lattice(const std::array<std::size_t, 3>& dimensions,
                          std::array<std::vector<double>, 3> axes) {
  const bool regular = !axes[0].empty();
  std::size_t wide = 0;
  lattice_cells_ = 1;
  for (const std::size_t n : dimensions) {
    lattice_cells_ *= std::max<std::size_t>(n - 1, 1);
    wide += n > 1 ? 1U : 0U;
  }
  using namespace cell_type;
  const std::array types{kVertex, kLine, regular ? kPixel : kQuad, regular ? kVoxel : kHexahedron};
  lattice_type_ = types[wide];
  dimensions_ = dimensions;
  axes_ = std::move(axes);
}

std::optional<DataSet::Pixels> DataSet::pixels() const {
  if (!is_even_ || !types_.empty() || lattice_type_ != cell_type::kPixel || dimensions_[2] != 1)
    return std::nullopt;
  return Pixels{dimensions_[0] - 1, dimensions_[1] - 1, lattice_point(0),
                lattice_point(lattice_points() - 1)};
}

DataSet::Coordinates DataSet::lattice_point(std::size_t p) const {
  const std::size_t row = p / dimensions_[0];
  return {axes_[0][p % dimensions_[0]], axes_[1][row % dimensions_[1]],
          axes_[2][row / dimensions_[1]]};
}

std::span<const std::uint32_t> DataSet::lattice_nodes(std::size_t c,
                                                      std::array<std::uint32_t, 8>& room) const {
  std::size_t corner = 0, stride = 1, count = 1;
  room[0] = 0;
  for (const std::size_t n : dimensions_) {
    if (n > 1) {
      corner += c % (n - 1) * stride;
      c /= n - 1;
      for (std::size_t k = 0; k < count; ++k)
        room[count + k] = room[k] + static_cast<std::uint32_t>(stride);
      count *= 2;
    }
    stride *= n;
  }
  for (std::size_t k = 0; k < count; ++k) room[k] += static_cast<std::uint32_t>(corner);
  // Pixels and voxels go by axes; quadrangles and hexahedra around.
  if (lattice_type_ == cell_type::kQuad || lattice_type_ == cell_type::kHexahedron)
    for (std::size_t k = 2; k < count; k += 4) std::swap(room[k], room[k + 1]);
  return {room.data(), count};
}

Result<std::vector<std::size_t>> as_offsets(const NumberArray& numbers, bool add_zero) {
  std::vector<std::size_t> offsets;
  offsets.reserve(numbers.size() + 1);
  if (add_zero) offsets.push_back(0);
  const std::size_t bad = numbers.visit([&](auto values) {
    constexpr std::size_t kMost = std::numeric_limits<std::int64_t>::max();
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto offset = as_index(values[k], kMost);
      const std::size_t least = offsets.empty() ? 0 : offsets.back();
      if (!offset || *offset < least || (offsets.empty() && *offset != 0)) return k;
      offsets.push_back(*offset);
    }
    return values.size();
  });
  if (bad < numbers.size())
    return wrong_data(
        fmt::format("offset {} of the cells is {}, where none is below the one before", bad,
                    numbers.visit([&](auto n) { return fmt::format("{}", n[bad]); })));
  if (offsets.empty()) offsets.push_back(0);
  return offsets;
}

Status check_lattice(const std::array<std::size_t, 3>& dimensions, std::size_t file_size) {
  const std::size_t most = std::min(kMostPoints, kLatticePoints * (file_size + 1));
  std::size_t points = 1;
  for (const std::size_t n : dimensions) {
    if (n == 0) return wrong_data("a lattice without points");
    if (points > most / n)
      return Error{ErrorCode::unsupported_format,
                   fmt::format("{} x {} x {} points are announced in a file of {} bytes, too few "
                               "for a number at each",
                               dimensions[0], dimensions[1], dimensions[2], file_size),
                   {},
                   {}};
    points *= n;
  }
  return ok();
}

Result<std::vector<std::uint8_t>> as_cell_types(const NumberArray& numbers) {
  std::vector<std::uint8_t> types;
  types.reserve(numbers.size());
  const std::size_t bad = numbers.visit([&](auto values) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto type = as_index(values[k], 256);
      if (!type) return k;
      types.push_back(static_cast<std::uint8_t>(*type));
    }
    return values.size();
  });
  if (bad < numbers.size())
    return wrong_data(fmt::format("cell {} has no type that VTK knows", bad));
  return types;
}

Result<std::vector<std::uint8_t>> surface_types(std::size_t kind,
                                                const std::vector<std::size_t>& offsets) {
  using namespace cell_type;
  const SurfaceCells& cells = kSurfaceCells[kind];
  std::vector<std::uint8_t> types;
  types.reserve(offsets.size() - 1);
  for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
    const std::size_t nodes = offsets[c + 1] - offsets[c];
    if (nodes < cells.least)
      return wrong_data(fmt::format("cell {} of {} has {} points", c, cells.keyword, nodes));
    const int polygon = nodes == 3 ? kTriangle : nodes == 4 ? kQuad : kPolygon;
    const std::array by_kind{nodes == 1 ? kVertex : kPolyVertex, nodes == 2 ? kLine : kPolyLine,
                             polygon, kTriangleStrip};
    types.push_back(static_cast<std::uint8_t>(by_kind[kind]));
  }
  return types;
}

std::vector<NumberArray> join_pieces(std::vector<std::vector<NumberArray>> pieces) {
  if (pieces.empty()) return {};
  std::vector<NumberArray> first = std::move(pieces.front());
  if (pieces.size() == 1) return first;
  std::map<std::string, std::vector<const NumberArray*>, std::less<>> parts;
  for (const NumberArray& array : first) parts.try_emplace(array.name, 1, &array);
  for (std::size_t p = 1; p < pieces.size(); ++p) {
    for (const NumberArray& array : pieces[p]) {
      const auto found = parts.find(array.name);
      // Once per piece, and only where no piece before lacks it.
      if (found != parts.end() && found->second.size() == p &&
          found->second.front()->components == array.components)
        found->second.push_back(&array);
    }
  }
  std::vector<NumberArray> out;
  for (const NumberArray& array : first) {
    const auto& all = parts.at(array.name);
    if (all.size() == pieces.size() && all.front() == &array) out.push_back(joined(all));
  }
  return out;
}

}  // namespace cover
