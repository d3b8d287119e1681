// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtkhdf_test.cpp.
#include "io/vtk_files/read_vtkhdf.hpp"

#include <utility>

#include <fmt/core.h>

#include "base/faults/errors.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

using Kind = Hdf5Value::Kind;

NumberArray array_of(const Hdf5Value& value, std::string name) {
  NumberArray array(value.type, value.bytes);
  array.name = std::move(name);
  array.components = value.shape.size() > 1 ? value.size() / value.shape[0] : 1;
  return array;
}

/// Takes the grid out of the tree.
class GridReader {
 public:
  GridReader(const Hdf5Tree& tree, const std::string& path, DataSet& data)
      : tree_(tree), path_(path), data_(data) {}

  Status read() {
    if (Status status = check_type(); !status) return status;
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds", "Points",
                             "Connectivity", "Offsets", "Types"}) {
      const auto found = tree_.find(fmt::format("/VTKHDF/{}", name));
      if (found == tree_.end()) return wrong_file(path_, fmt::format("no {} in it", name));
      if (Status status = check_numbers(name, found->second.value); !status) return status;
    }
    const Hdf5Value& points = value("Points");
    if (points.shape.size() != 2 || points.shape[1] != 3)
      return wrong_file(path_, "its points have not three coordinates each");
    const Hdf5Value& pieces = value("NumberOfPoints");
    if (value("NumberOfCells").size() != pieces.size() ||
        value("NumberOfConnectivityIds").size() != pieces.size())
      return wrong_file(path_, "its counts are not those of as many pieces");
    for (std::size_t p = 0; p < pieces.size(); ++p)
      if (Status status = read_piece(p); !status) return status;
    add_arrays("/VTKHDF/CellData/", data_.cell_arrays);
    add_arrays("/VTKHDF/PointData/", data_.point_arrays);
    return ok();
  }

 private:
  Status check_type() const {
    const auto root = tree_.find("/VTKHDF");
    if (root == tree_.end()) return wrong_file(path_, "no group VTKHDF in it");
    const auto& attributes = root->second.attributes;
    const auto type = attributes.find("Type");
    if (type == attributes.end() || type->second.texts.empty())
      return wrong_file(path_, "its group VTKHDF has no type");
    if (type->second.texts[0] != "UnstructuredGrid" || tree_.contains("/VTKHDF/Steps"))
      return Error{ErrorCode::unsupported_format,
                   fmt::format("{}: it holds {}, and only an UnstructuredGrid without time steps "
                               "is read",
                               path_, legible(type->second.texts[0])),
                   {},
                   {}};
    return ok();
  }

  Status check_numbers(const char* name, const Hdf5Value& value) const {
    if (value.kind == Kind::numbers) return ok();
    return Error{ErrorCode::unsupported_format,
                 fmt::format("{}: its {} are not read ({}); 'h5repack -l CONTI -f NONE' makes them "
                             "legible",
                             path_, name, value.why.empty() ? "texts" : value.why),
                 {},
                 {}};
  }

  [[nodiscard]] const Hdf5Value& value(const char* name) const {
    return tree_.find(fmt::format("/VTKHDF/{}", name))->second.value;
  }

  [[nodiscard]] std::size_t count(const char* name, std::size_t piece) const {
    constexpr std::size_t kMost = std::size_t{1} << 48U;
    return array_of(value(name), name).visit([&](auto numbers) {
      return as_index(numbers[piece], kMost).value_or(kMost);
    });
  }

  /// The numbers of the next piece; nothing where they are not there.
  [[nodiscard]] std::optional<NumberArray> next(const char* name, std::size_t numbers,
                                                std::size_t& from) const {
    const Hdf5Value& all = value(name);
    const std::size_t size = size_of(all.type), there = all.bytes.size() / size;
    if (numbers > there - from) return std::nullopt;
    NumberArray out(all.type, all.bytes.substr(from * size, numbers * size));
    from += numbers;
    return out;
  }

  Status read_piece(std::size_t piece) {
    const std::size_t points = count("NumberOfPoints", piece),
                      cells = count("NumberOfCells", piece);
    const auto places = next("Points", 3 * points, points_);
    const auto nodes = next("Connectivity", count("NumberOfConnectivityIds", piece), nodes_);
    const auto ends = next("Offsets", cells + 1, offsets_);
    const auto types = next("Types", cells, types_);
    if (!places || !nodes || !ends || !types)
      return wrong_file(path_, fmt::format("piece {} has more than is there", piece));
    const std::size_t first = data_.point_count();
    if (Status status = data_.add_points(*places); !status) return named(std::move(status));
    Result<std::vector<std::size_t>> offsets = as_offsets(*ends, false);
    if (!offsets) return named(std::move(offsets).error());
    Result<std::vector<std::uint8_t>> kinds = as_cell_types(*types);
    if (!kinds) return named(std::move(kinds).error());
    return named(data_.add_cells(*nodes, *offsets, std::move(*kinds), first));
  }

  /// The same, with the name of the file.
  [[nodiscard]] Status named(Status status) const {
    if (status) return status;
    Error error = std::move(status).error();
    error.message = path_ + ": " + error.message;
    return error;
  }

  void add_arrays(std::string_view folder, std::vector<NumberArray>& arrays) const {
    for (auto at = tree_.lower_bound(folder); at != tree_.end() && at->first.starts_with(folder);
         ++at) {
      std::string name = at->first.substr(folder.size());
      if (at->second.value.kind == Kind::numbers) {
        arrays.push_back(array_of(at->second.value, std::move(name)));
      } else {
        arrays.emplace_back().name = std::move(name);
      }
    }
  }

  const Hdf5Tree& tree_;
  const std::string& path_;
  DataSet& data_;
  std::size_t points_ = 0, nodes_ = 0, offsets_ = 0, types_ = 0;  ///< read so far
};

}  // namespace

const Hdf5Value* VtkHdfFile::field(std::string_view name, Kind kind) const {
  const auto found = tree.find(fmt::format("/VTKHDF/FieldData/{}", name));
  return found != tree.end() && found->second.value.kind == kind ? &found->second.value : nullptr;
}

Result<VtkHdfFile> read_vtkhdf(const std::string& path) {
  Result<std::string> content = read_file(path);
  if (!content) return std::move(content).error();
  VtkHdfFile file{std::make_unique<const std::string>(std::move(*content)), {}, {}};
  Result<Hdf5Tree> tree = parse_hdf5(*file.text, path);
  if (!tree) return std::move(tree).error();
  file.tree = std::move(*tree);
  if (Status status = GridReader(file.tree, path, file.data).read(); !status)
    return std::move(status).error();
  return file;
}

}  // namespace cover
