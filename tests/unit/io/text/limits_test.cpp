// What headers may announce: a few bytes must not take much memory or time, whatever they say.
#include "io/text/limits.hpp"

#include <gtest/gtest.h>

#include <fmt/core.h>
#include <zlib.h>

#include "io/vtk_files/parse_data_set.hpp"

namespace cover {
namespace {

Error error_of(const Result<DataSet>& data) {
  EXPECT_FALSE(data);
  return data ? Error{} : data.error();
}

Error xml(std::string_view text) { return error_of(parse_vtk_xml(text, "a.vtu")); }
Error legacy(std::string_view text) {
  return error_of(
      parse_legacy_vtk(fmt::format("# vtk DataFile Version 3.0\nt\n{}", text), "a.vtk"));
}

/// A grid of so many points and cells, in arrays that are written like `array`.
std::string grid(std::string_view points, std::string_view cells, std::string_view array) {
  return fmt::format(
      "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"><UnstructuredGrid><Piece "
      "NumberOfPoints=\"{}\" NumberOfCells=\"{}\"><Points><DataArray type=\"Float64\" "
      "NumberOfComponents=\"3\" {}</DataArray></Points><Cells><DataArray type=\"Int64\" "
      "Name=\"offsets\" {}</DataArray><DataArray type=\"Int64\" Name=\"connectivity\" "
      "{}</DataArray>"
      "<DataArray type=\"UInt8\" Name=\"types\" {}</DataArray></Cells></Piece></UnstructuredGrid>"
      "</VTKFile>",
      points, cells, array, array, array, array);
}

TEST(Limits, CountsOfXml) {
  const std::string_view ascii = "format=\"ascii\">0 0 0";
  EXPECT_TRUE(parse_vtk_xml(grid("1", "0", ascii), "a.vtu"));
  EXPECT_EQ(xml(grid("-1", "0", ascii)).message, "a.vtu: NumberOfPoints=\"-1\" is no count");
  EXPECT_EQ(xml(grid("1", "-1", ascii)).message, "a.vtu: NumberOfCells=\"-1\" is no count");
  EXPECT_EQ(xml(grid("1e3", "0", ascii)).code, ErrorCode::syntax);
  EXPECT_EQ(xml(grid("4", "0", ascii)).code, ErrorCode::truncated);
  for (const char* count : {"100000", "4294967295", "4294967296", "9223372036854775807"}) {
    EXPECT_NE(xml(grid(count, "0", ascii)).message, "");
    EXPECT_NE(xml(grid("1", count, ascii)).message, "");
    EXPECT_NE(xml(grid(count, count, "format=\"binary\">AAAAAAAA")).message, "");
  }
  EXPECT_EQ(xml(grid("9223372036854775807", "0", ascii)).code, ErrorCode::unsupported_format);
  EXPECT_EQ(xml(grid("1", "1", "NumberOfComponents=\"99999999999\" format=\"ascii\">0")).code,
            ErrorCode::syntax);
}

TEST(Limits, CountsOfLegacyFiles) {
  EXPECT_EQ(legacy("ASCII\nDATASET POLYDATA\nPOINTS 99999999 float\n0 0 0\n").code,
            ErrorCode::truncated);
  EXPECT_EQ(legacy("BINARY\nDATASET POLYDATA\nPOINTS 9223372036854775807 float\n0 0 0\n").code,
            ErrorCode::truncated);
  EXPECT_EQ(legacy("ASCII\nDATASET POLYDATA\nPOINTS -1 float\n").code, ErrorCode::syntax);
  EXPECT_EQ(legacy("ASCII\nDATASET POLYDATA\nPOINTS 1double CELLS\n").message,
            "a.vtk:5: expected the number of points, found '1double'");
  EXPECT_EQ(legacy("ASCII\nDATASET POLYDATA\nPOINTS 1 float 0 0 0 POLYGONS 1 4 3 0 0 1").message,
            "a.vtk: cell 0 has the point 1, which is not there: there are 1");
  EXPECT_EQ(legacy("ASCII\nDATASET POLYDATA\nPOINTS 1 float 0 0 0 POLYGONS 1 4 9 0 0 0").code,
            ErrorCode::syntax);
  EXPECT_EQ(legacy("ASCII\nDATASET POLYDATA\nFIELD f 99999999999\n").code, ErrorCode::truncated);
  EXPECT_EQ(legacy("BINARY\nDATASET POLYDATA\nFIELD f 1 a 3 99999999999 string\n").code,
            ErrorCode::truncated);
}

TEST(Limits, LatticesWithoutNumbers) {
  EXPECT_EQ(legacy("ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 100000 100000 1\nORIGIN 0 0 0\n"
                   "SPACING 1 1 1\n")
                .code,
            ErrorCode::unsupported_format);
  EXPECT_EQ(legacy("ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 9223372036854775807 2 2\n").code,
            ErrorCode::unsupported_format);
  EXPECT_EQ(legacy("ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 0 2 2\n").code, ErrorCode::syntax);
  EXPECT_EQ(xml("<VTKFile><ImageData WholeExtent=\"0 99999 0 99999 0 0\"><Piece/></ImageData>"
                "</VTKFile>")
                .code,
            ErrorCode::unsupported_format);
}

/// An appended array of zeros, as VTK's writers compress it.
std::string packed_zeros(std::size_t block, std::size_t blocks) {
  const std::string zeros(block, '\0');
  std::string packed(compressBound(block), '\0');
  uLongf size = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(zeros.data()), zeros.size());
  packed.resize(size);
  std::string out;
  const auto number = [&](std::size_t n) {
    for (unsigned k = 0; k < 4; ++k) out += static_cast<char>(n >> (8 * k));
  };
  number(blocks);
  number(block);
  number(0);
  for (std::size_t b = 0; b < blocks; ++b) number(packed.size());
  for (std::size_t b = 0; b < blocks; ++b) out += packed;
  return out;
}

TEST(Limits, WhatCompressedDataBecome) {
  const auto file = [](std::size_t points, const std::string& data) {
    return fmt::format(
               "<VTKFile compressor=\"vtkZLibDataCompressor\" byte_order=\"LittleEndian\">"
               "<UnstructuredGrid><Piece NumberOfPoints=\"{}\" NumberOfCells=\"0\"><Points>"
               "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" "
               "offset=\"0\"/></Points></Piece></UnstructuredGrid><AppendedData "
               "encoding=\"raw\">_",
               points) +
           data;
  };
  constexpr std::size_t kBlock = 24'000'000;
  const std::string one = packed_zeros(kBlock, 2);
  const auto sound = parse_vtk_xml(file(kBlock / 12, one), "a.vtu");
  ASSERT_TRUE(sound) << sound.error().message;
  EXPECT_EQ(sound->point_count(), kBlock / 12);
  // 600 kB that become 600 MB.
  const std::string bomb = packed_zeros(kBlock, 25);
  EXPECT_LT(bomb.size(), 1'000'000U);
  EXPECT_EQ(xml(file(25'000'000, bomb)).code, ErrorCode::unsupported_format);
  // What was announced is not in the blocks.
  EXPECT_EQ(xml(file(kBlock / 12 + 1, one)).code, ErrorCode::syntax);
  EXPECT_EQ(xml(file(kBlock / 12, one.substr(0, one.size() - 1))).code, ErrorCode::truncated);
}

}  // namespace
}  // namespace cover
