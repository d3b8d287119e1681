// Not VTK's own writer, because that one does not look at what its stream says when the disk is
// full, heeds no stop, needs a copy of the whole mesh in its own classes, and takes a millisecond
// for a file, however small. Tested by vtu_file_test.cpp and, against VTK's reader, by
// tests/unit/io/write_mesh/vtk_formats/write_vtu_test.cpp.
#include "io/write_mesh/vtk_formats/vtu_file.hpp"

#include <algorithm>
#include <bit>
#include <span>
#include <string>

#include <fmt/core.h>

#include <cover/text.hpp>

namespace cover {
namespace {

/// How an array is announced.
std::string vtu_attributes(const VtuArray& array) {
  const char* type = array.type == NumberType::float64 ? "Float64"
                     : array.type == NumberType::int32 ? "Int32"
                     : array.type == NumberType::int64 ? "Int64"
                                                       : "UInt8";
  std::string text = fmt::format("type=\"{}\" Name=\"{}\"", type, escaped_markup(array.name));
  if (array.components > 1) text += fmt::format(" NumberOfComponents=\"{}\"", array.components);
  return text + array.more;
}

class VtuWriter {
 public:
  VtuWriter(const ByteSink& sink, const Team& team) : sink_(sink), team_(team), out_(sink) {}

  void write(const VtuGrid& grid) {
    out_.put(
        fmt::format("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" "
                    "header_type=\"UInt64\">\n  <UnstructuredGrid>\n",
                    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian"));
    if (grid.cut_vertices > 0) {
      out_.put(
          fmt::format("    <FieldData>\n      <DataArray type=\"Int64\" Name=\"CutVertices\" "
                      "NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n    </FieldData>\n",
                      grid.cut_vertices));
    }
    out_.put(fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", grid.points,
                         grid.cells));
    announce("PointData" + grid.point_attributes, "PointData", grid.point_data);
    announce("CellData" + grid.cell_attributes, "CellData", grid.cell_data);
    announce("Points", "Points", {&grid.coordinates, 1});
    announce("Cells", "Cells", grid.connectivity);
    out_.put("    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n   _");
    for (const VtuArray* array : announced_) put_array(*array);
    write_pieces();
    out_.put("\n  </AppendedData>\n</VTKFile>\n");
    out_.flush();
  }

 private:
  void announce(std::string_view start, std::string_view end, std::span<const VtuArray> arrays) {
    out_.put(fmt::format("      <{}>\n", start));
    for (const VtuArray& array : arrays) {
      out_.put(fmt::format("        <DataArray {} format=\"appended\" offset=\"{}\"/>\n",
                           vtu_attributes(array), offset_));
      offset_ += sizeof array.bytes + array.bytes;
      announced_.push_back(&array);
    }
    out_.put(fmt::format("      </{}>\n", end));
  }

  /// Some items of an array whose size stands in front of the first of them.
  struct Piece {
    const VtuArray* array;
    std::size_t first, last;
  };

  void put_array(const VtuArray& array) {
    if (!array.write.has_ranges()) {
      write_pieces();
      out_.put(array.bytes);
      array.write(out_);
      return;
    }
    constexpr std::size_t kPiece = 1 << 17;
    const std::size_t items = array.write.items(), step = array.write.items_in(kPiece);
    for (std::size_t first = 0; first == 0 || first < items; first += step)
      pieces_.push_back({&array, first, std::min(items, first + step)});
  }

  /// Those that were put, some at a time: while they are made, those before them are written.
  void write_pieces() {
    if (pieces_.empty()) return;
    constexpr std::size_t kPiecesAtATime = 32;
    const std::size_t step = team_.workers() > 1 ? kPiecesAtATime : 1;
    out_.flush();
    std::vector<std::string> made(step), written(step);
    for (std::size_t k = 0; k < pieces_.size() + step; k += step) {
      const std::size_t count = k < pieces_.size() ? std::min(step, pieces_.size() - k) : 0;
      team_.each(1 + count, [&](std::size_t part) {
        if (part > 0) return make(pieces_[k + part - 1], made[part - 1]);
        for (std::string& bytes : written) {
          if (!bytes.empty()) sink_(bytes);
          bytes.clear();
        }
      });
      made.swap(written);
    }
    pieces_.clear();
  }

  static void make(const Piece& piece, std::string& bytes) {
    const VtuArray& array = *piece.array;
    if (piece.first == 0)
      bytes.append(reinterpret_cast<const char*>(&array.bytes), sizeof array.bytes);
    array.write.append(piece.first, piece.last, bytes);
  }

  const ByteSink& sink_;
  const Team& team_;
  BinaryWriter out_;
  std::vector<Piece> pieces_;
  std::uint64_t offset_ = 0;
  std::vector<const VtuArray*> announced_;
};

/// An element of a .pvtu with the arrays that its pieces have.
std::string announced(std::string_view start, std::string_view end,
                      std::span<const VtuArray> arrays) {
  std::string text = fmt::format("    <{}>\n", start);
  for (const VtuArray& array : arrays)
    text += fmt::format("      <PDataArray {}/>\n", vtu_attributes(array));
  return text + fmt::format("    </{}>\n", end);
}

}  // namespace

std::string pvtu_text(const VtuGrid& piece, std::span<const std::string> files) {
  std::string text = fmt::format(
      "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt64\">\n  <PUnstructuredGrid GhostLevel=\"1\">\n",
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian");
  text += announced("PPointData" + piece.point_attributes, "PPointData", piece.point_data);
  text += announced("PCellData" + piece.cell_attributes, "PCellData", piece.cell_data);
  text += announced("PPoints", "PPoints", {&piece.coordinates, 1});
  for (const std::string& file : files)
    text += fmt::format("    <Piece Source=\"{}\"/>\n", escaped_markup(file));
  return text + "  </PUnstructuredGrid>\n</VTKFile>\n";
}

void write_vtu_bytes(const VtuGrid& grid, const ByteSink& sink, const Team& team) {
  VtuWriter(sink, team).write(grid);
}

}  // namespace cover
