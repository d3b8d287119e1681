// Pieces are put together to one data set, of which the mesh is taken.
// Tested by tests/unit/io/read_mesh/read_mesh_test.cpp.
#include "io/read_mesh/formats/pieces/read_pvtu.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/faults/errors.hpp"
#include "base/none.hpp"
#include "io/read_mesh/formats/mesh_of_data_set.hpp"
#include "io/read_mesh/formats/pieces/piece_files.hpp"
#include "io/text/text.hpp"
#include "io/text/xml_tree.hpp"

namespace cover {
namespace {

/// A number of each item in the whole, below `end`; nothing if one has none.
std::optional<std::vector<std::uint32_t>> numbers_in_whole(const NumberArray* array,
                                                           std::size_t items, std::size_t end) {
  std::vector<std::uint32_t> numbers;
  if (items == 0) return numbers;  // such a piece has no arrays
  if (array == nullptr || !array->is_one_per(items)) return std::nullopt;
  numbers.reserve(items);
  const bool is_sound = array->visit([&](auto values) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::optional<std::size_t> number = as_index(values[k], end);
      if (!number) return false;
      numbers.push_back(static_cast<std::uint32_t>(*number));
    }
    return true;
  });
  return is_sound ? std::optional(std::move(numbers)) : std::nullopt;
}

NumberArray array_of(std::string name, std::size_t components, const std::vector<double>& values) {
  const std::size_t bytes = values.size() * sizeof(double);
  auto own = std::make_unique<char[]>(bytes);
  if (bytes > 0) std::memcpy(own.get(), values.data(), bytes);
  NumberArray array(NumberType::float64, std::move(own), values.size());
  array.name = std::move(name);
  array.components = components;
  return array;
}

/// An item of a piece.
struct Place {
  std::uint32_t piece = 0;
  std::uint32_t item = 0;
};

/// The mesh of which the pieces are made.
class Whole {
 public:
  Whole(std::string path, std::vector<DataSetFile> pieces)
      : path_(std::move(path)), pieces_(std::move(pieces)) {}

  Result<MeshFile> mesh() {
    if (Status status = number_points(); !status) return std::move(status).error();
    if (Status status = number_cells(); !status) return std::move(status).error();
    DataSet whole;
    if (Status status = add_points(whole); !status)
      return in_file(path_, std::move(status).error());
    if (Status status = add_cells(whole); !status) return in_file(path_, std::move(status).error());
    whole.point_arrays = joined(&DataSet::point_arrays, points_,
                                [](const DataSet& data) { return data.point_count(); });
    whole.cell_arrays = joined(&DataSet::cell_arrays, cells_,
                               [](const DataSet& data) { return data.cell_count(); });
    for (const DataSetFile& piece : pieces_)
      whole.cut_vertices = std::max(whole.cut_vertices, piece.data.cut_vertices);
    return mesh_of(whole, path_);
  }

 private:
  [[nodiscard]] const DataSet& data(std::size_t piece) const { return pieces_[piece].data; }

  Error not_whole(std::string_view what) const {
    return wrong_file(path_, fmt::format("its pieces do not tell {} of the whole mesh", what));
  }

  Status number_points() {
    std::size_t all = 0;
    for (const DataSetFile& piece : pieces_) all += piece.data.point_count();
    all = std::min<std::size_t>(all, kNone);
    std::vector<bool> is_there;
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      const std::size_t count = data(k).point_count();
      auto numbers = numbers_in_whole(data(k).array_of_points("GlobalNodeId"), count, all);
      if (!numbers) return not_whole("the numbers that vertices have (GlobalNodeId)");
      for (std::uint32_t p = 0; p < count; ++p) {
        const std::uint32_t number = (*numbers)[p];
        if (number >= points_.size()) points_.resize(number + 1), is_there.resize(number + 1);
        const DataSet::Coordinates x = data(k).point(p);
        if (!std::isfinite(x[0]) || !std::isfinite(x[1]))
          return Error{ErrorCode::non_finite_coordinate,
                       fmt::format("{}: vertex {} has no finite coordinates", path_, number),
                       {},
                       {}};
        if (is_there[number] && coordinates_of(points_[number]) != x)
          return wrong_file(path_, fmt::format("vertex {} is at two places", number));
        if (!is_there[number]) points_[number] = {k, p};
        is_there[number] = true;
      }
      point_numbers_.push_back(*std::move(numbers));
    }
    if (std::find(is_there.begin(), is_there.end(), false) != is_there.end())
      return not_whole("all vertices");
    return ok();
  }

  Status number_cells() {
    std::size_t all = 0;
    for (const DataSetFile& piece : pieces_) all += piece.data.cell_count();
    all = std::min<std::size_t>(all, kNone);
    std::vector<bool> is_there;
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      const std::size_t count = data(k).cell_count();
      const auto numbers = numbers_in_whole(data(k).array_of_cells("GlobalCellId"), count, all);
      const auto ghosts = numbers_in_whole(data(k).array_of_cells("vtkGhostType"), count, 256);
      if (!numbers || !ghosts)
        return not_whole("the numbers that triangles have (GlobalCellId, vtkGhostType)");
      for (std::uint32_t c = 0; c < count; ++c) {
        constexpr std::uint32_t kDuplicate = 1;
        if (((*ghosts)[c] & kDuplicate) != 0) continue;
        const std::uint32_t number = (*numbers)[c];
        if (number >= cells_.size()) cells_.resize(number + 1), is_there.resize(number + 1);
        if (is_there[number])
          return wrong_file(path_, fmt::format("triangle {} is in two pieces", number));
        cells_[number] = {k, c};
        is_there[number] = true;
      }
    }
    if (std::find(is_there.begin(), is_there.end(), false) != is_there.end())
      return not_whole("all triangles");
    return ok();
  }

  [[nodiscard]] DataSet::Coordinates coordinates_of(const Place& place) const {
    return data(place.piece).point(place.item);
  }

  Status add_points(DataSet& whole) const {
    std::vector<double> coordinates;
    coordinates.reserve(3 * points_.size());
    for (const Place& place : points_) {
      const DataSet::Coordinates x = coordinates_of(place);
      coordinates.insert(coordinates.end(), x.begin(), x.end());
    }
    return whole.add_points(array_of("", 3, coordinates));
  }

  Status add_cells(DataSet& whole) const {
    std::vector<double> connectivity;
    std::vector<std::size_t> offsets{0};
    std::vector<std::uint8_t> types;
    std::array<std::uint32_t, 8> room{};
    for (const Place& place : cells_) {
      for (const std::uint32_t node : data(place.piece).nodes(place.item, room))
        connectivity.push_back(point_numbers_[place.piece][node]);
      offsets.push_back(connectivity.size());
      types.push_back(static_cast<std::uint8_t>(data(place.piece).type(place.item)));
    }
    return whole.add_cells(array_of("", 1, connectivity), offsets, std::move(types), 0);
  }

  /// The arrays that all pieces have which are not empty, their numbers in the order of the whole.
  /// The pieces lose them.
  template <class Count>
  std::vector<NumberArray> joined(std::vector<NumberArray> DataSet::*arrays,
                                  std::span<const Place> places, const Count& count) {
    std::vector<std::vector<NumberArray>> of_pieces;
    std::vector<std::size_t> first;  // item of each piece, behind those of the pieces before
    std::size_t items = 0;
    for (DataSetFile& piece : pieces_) {
      first.push_back(items);
      const std::size_t own = count(piece.data);
      items += own;
      if (own == 0) continue;
      std::vector<NumberArray>& all = piece.data.*arrays;
      std::erase_if(all, [&](const NumberArray& array) {
        // In the whole there are no ghosts.
        return array.name == "vtkGhostType" || !array.is_one_per(own);
      });
      of_pieces.push_back(std::move(all));
    }
    std::vector<NumberArray> out;
    for (const NumberArray& array : join_pieces(std::move(of_pieces))) {
      std::vector<double> values;
      values.reserve(places.size());
      array.visit([&](auto numbers) {
        for (const Place& place : places)
          values.push_back(static_cast<double>(numbers[first[place.piece] + place.item]));
      });
      out.push_back(array_of(array.name, 1, values));
    }
    return out;
  }

  std::string path_;
  std::vector<DataSetFile> pieces_;
  std::vector<Place> points_, cells_;  ///< where those of the whole are, by their numbers
  std::vector<std::vector<std::uint32_t>> point_numbers_;  ///< in the whole, by piece
};

}  // namespace

Result<MeshFile> read_pvtu_mesh(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  const Result<XmlTree> tree = parse_xml(*text, path);
  if (!tree) return tree.error();
  const XmlElement* grid = tree->root.child("PUnstructuredGrid");
  if (tree->root.name != "VTKFile" || grid == nullptr)
    return wrong_file(path, "not a valid VTK file: no grid in pieces");
  PieceFiles files(path);
  std::vector<DataSetFile> pieces;
  for (const XmlElement& element : grid->children) {
    if (element.name != "Piece") continue;
    Result<DataSetFile> piece = files.read(element.value("Source"));
    if (!piece) return std::move(piece).error();
    pieces.push_back(*std::move(piece));
  }
  if (pieces.empty()) return wrong_file(path, "no pieces in it");
  return Whole(path, std::move(pieces)).mesh();
}

}  // namespace cover
