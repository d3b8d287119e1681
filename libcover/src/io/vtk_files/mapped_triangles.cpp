// Tested by tests/unit/stream/check_in_parts_test.cpp.
#include "io/vtk_files/mapped_triangles.hpp"

#include <bit>
#include <filesystem>

#include "io/hdf5/parse_hdf5.hpp"
#include "io/text/text.hpp"
#include "io/text/xml_tree.hpp"
#include "io/vtk_files/arrays/array_reader.hpp"
#include "io/vtk_files/data_set.hpp"

namespace cover {
namespace {

/// How many numbers are looked at before memory is given back.
constexpr std::size_t kAtATime = std::size_t{1} << 22;

/// `count` numbers of the type T that lie in the file.
template <class T>
std::optional<NumberView<T>> numbers(NumberType type, std::string_view bytes, std::size_t count) {
  if (type != number_type<T>() || bytes.size() / sizeof(T) < count) return std::nullopt;
  return NumberView<T>(bytes.data(), count);
}

/// Whether number k is what(k), for all of them.
template <class T, class What>
bool all_are(const NumberView<T>& numbers, const MappedFile& file, What what) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k] != what(k)) return false;
    if (k % kAtATime == kAtATime - 1) file.forget();
  }
  file.forget();
  return true;
}

bool are_triangles(const NumberView<std::uint8_t>& types, const MappedFile& file) {
  return all_are(types, file, [](std::size_t) { return cell_type::kTriangle; });
}

bool are_in_a_plane(const NumberView<double>& places, const MappedFile& file) {
  return all_are(places, file, [&](std::size_t k) { return places[k % 3 == 2 ? 2 : k]; });
}

std::optional<MappedTriangles> map_vtkhdf(MappedFile file, const std::string& path) {
  const Result<Hdf5Tree> tree = parse_hdf5(file.bytes(), path);
  if (!tree || tree->contains("/VTKHDF/Steps")) return std::nullopt;
  const auto find = [&]<class T>(T, const char* name) -> std::optional<NumberView<T>> {
    const auto found = tree->find(std::string("/VTKHDF/") + name);
    if (found == tree->end() || found->second.value.kind != Hdf5Value::Kind::numbers)
      return std::nullopt;
    const Hdf5Value& value = found->second.value;
    return numbers<T>(value.type, value.bytes, value.size());
  };
  const auto points = find(std::int64_t{}, "NumberOfPoints");
  const auto cells = find(std::int64_t{}, "NumberOfCells");
  const auto places = find(double{}, "Points");
  const auto corners = find(std::int64_t{}, "Connectivity");
  const auto offsets = find(std::int64_t{}, "Offsets");
  const auto types = find(std::uint8_t{}, "Types");
  const auto region = find(std::int32_t{}, "CellData/RegionId");
  const auto material = find(std::int32_t{}, "CellData/material");
  if (!points || !cells || !places || !corners || !offsets || !types || !region || !material)
    return std::nullopt;
  const std::size_t n = types->size(), p = places->size() / 3;
  if (points->size() != 1 || static_cast<std::size_t>((*points)[0]) != p || cells->size() != 1 ||
      static_cast<std::size_t>((*cells)[0]) != n || places->size() != 3 * p ||
      corners->size() != 3 * n || offsets->size() != n + 1 || region->size() != n ||
      material->size() != n)
    return std::nullopt;
  if (!are_triangles(*types, file) || !are_in_a_plane(*places, file) ||
      !all_are(*offsets, file, [](std::size_t k) { return static_cast<std::int64_t>(3 * k); }))
    return std::nullopt;
  return MappedTriangles{std::move(file), p, n, *places, *corners, *region, *material};
}

/// Finds the arrays of the one piece of a .vtu.
class VtuArrays {
 public:
  VtuArrays(const XmlElement& piece, ArrayReader& reader, std::string_view file)
      : piece_(piece), reader_(reader), file_(file) {}

  template <class T>
  std::optional<NumberView<T>> find(const char* parent, const char* name, std::size_t items,
                                    std::size_t components = 1) {
    const XmlElement* element = piece_.child(parent);
    const XmlElement* array = element == nullptr ? nullptr
                              : name == nullptr  ? element->child("DataArray")
                                                 : element->child("DataArray", name);
    if (array == nullptr || array->attribute("offset") == nullptr) return std::nullopt;
    const Result<std::size_t> each = reader_.components(*array);
    if (!each || *each != components) return std::nullopt;
    const Result<NumberArray> read = reader_.read(*array, items);
    if (!read) return std::nullopt;
    const char* begin = read->bytes().data();
    const bool lies_there = begin >= file_.data() && begin <= file_.data() + file_.size();
    return lies_there ? numbers<T>(read->type(), read->bytes(), items * components) : std::nullopt;
  }

 private:
  const XmlElement& piece_;
  ArrayReader& reader_;
  std::string_view file_;
};

std::optional<std::size_t> count(const XmlElement& piece, const char* name) {
  const auto number = parse_integer(piece.value(name));
  if (!number || *number < 0) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

std::optional<MappedTriangles> map_vtu(MappedFile file, const std::string& path) {
  const Result<XmlTree> tree = parse_xml(file.bytes(), path, "AppendedData");
  if (!tree || tree->root.attribute("compressor") != nullptr) return std::nullopt;
  const XmlElement* grid = tree->root.child("UnstructuredGrid");
  const XmlElement* data = tree->root.child("AppendedData");
  if (grid == nullptr || data == nullptr || data->value("encoding") != "raw" ||
      grid->children.size() != 1 || grid->children[0].name != "Piece")
    return std::nullopt;
  const XmlElement& piece = grid->children[0];
  const auto points = count(piece, "NumberOfPoints"), cells = count(piece, "NumberOfCells");
  Result<ArrayReader> reader = ArrayReader::create(file.bytes(), *tree, path);
  if (!reader || !points || !cells || *cells == 0) return std::nullopt;
  constexpr std::size_t kDimensions = 3;
  const std::size_t n = *cells;
  VtuArrays arrays(piece, *reader, file.bytes());
  const auto places = arrays.find<double>("Points", nullptr, *points, kDimensions);
  const auto corners = arrays.find<std::int64_t>("Cells", "connectivity", 3 * n);
  const auto offsets = arrays.find<std::int64_t>("Cells", "offsets", n);
  const auto types = arrays.find<std::uint8_t>("Cells", "types", n);
  const auto region = arrays.find<std::int32_t>("CellData", "RegionId", n);
  const auto material = arrays.find<std::int32_t>("CellData", "material", n);
  if (!places || !corners || !offsets || !types || !region || !material) return std::nullopt;
  if (!are_triangles(*types, file) || !are_in_a_plane(*places, file) ||
      !all_are(*offsets, file,
               [](std::size_t k) { return static_cast<std::int64_t>(3 * (k + 1)); }))
    return std::nullopt;
  return MappedTriangles{std::move(file), *points, n, *places, *corners, *region, *material};
}

}  // namespace

std::optional<MappedTriangles> map_triangles(const std::string& path) {
  const std::string extension = extension_of(path);
  if (std::endian::native != std::endian::little || (extension != ".vtu" && extension != ".vtkhdf"))
    return std::nullopt;
  std::optional<MappedFile> file = MappedFile::open(path);
  if (!file) return std::nullopt;
  return extension == ".vtu" ? map_vtu(*std::move(file), path) : map_vtkhdf(*std::move(file), path);
}

}  // namespace cover
