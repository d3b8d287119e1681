#include "io/vtk_files/arrays/array_reader.hpp"

#include <gtest/gtest.h>

#include <fmt/core.h>

#include "io/vtk_files/arrays/base64.hpp"

namespace cover {
namespace {

const std::string kSource = "a.vtu";

/// The numbers of the array in `<VTKFile ...><DataArray .../>`, or the error's message.
struct Read {
  std::vector<double> numbers;
  std::string error;
};

Read read(std::string_view attributes, std::string_view array, std::size_t items,
          std::string_view appended = "") {
  const std::string text = fmt::format(
      "<VTKFile {}><DataArray Name=\"n\" {}</DataArray>{}</VTKFile>", attributes, array, appended);
  const Result<XmlTree> tree = parse_xml(text, kSource, "AppendedData");
  if (!tree) return {{}, tree.error().message};
  Result<ArrayReader> reader = ArrayReader::create(text, *tree, kSource);
  if (!reader) return {{}, reader.error().message};
  const Result<NumberArray> found = reader->read(*tree->root.child("DataArray"), items);
  if (!found) return {{}, found.error().message};
  EXPECT_EQ(found->name, "n");
  Read out;
  found->visit([&](auto numbers) {
    for (std::size_t k = 0; k < numbers.size(); ++k)
      out.numbers.push_back(static_cast<double>(numbers[k]));
  });
  return out;
}

TEST(Base64, DecodesOverBlanksAndPadding) {
  char out[8] = {};
  Base64 text(" TW Fu\nTQ==TWE=TWFu");
  ASSERT_TRUE(text.read(out, 4));
  EXPECT_EQ(std::string(out, 4), "ManM");
  ASSERT_TRUE(text.read(out, 2));
  EXPECT_EQ(std::string(out, 2), "Ma");
  ASSERT_TRUE(text.read(out, 1));
  ASSERT_TRUE(text.read(out + 1, 2));
  EXPECT_EQ(std::string(out, 3), "Man");
  EXPECT_FALSE(text.read(out, 1));
  EXPECT_FALSE(Base64("T-Fu").read(out, 3));
  EXPECT_FALSE(Base64("TWF").read(out, 2));
  EXPECT_FALSE(Base64("====").read(out, 1));
}

TEST(ArrayReader, Ascii) {
  EXPECT_EQ(read("", "type=\"Float64\" format=\"ascii\"> 1 +2.5\n-1e3 nan 1e999 ", 5).numbers[4],
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(read("", "type=\"Int8\">-128 127 0", 2).numbers, (std::vector<double>{-128, 127}));
  EXPECT_EQ(read("", "type=\"Int8\">-129", 1).error, "a.vtu: array 'n': number 0 is '-129'");
  EXPECT_EQ(read("", "type=\"Int32\">1 2.5 3", 3).error, "a.vtu: array 'n': number 1 is '2.5'");
  EXPECT_EQ(read("", "type=\"Int32\">1   2", 3).error, "a.vtu: array 'n': it has 2 of 3 numbers");
  EXPECT_EQ(read("", "type=\"Int32\">1", 3).error,
            "a.vtu: array 'n': 3 numbers are announced, and its text has 1 characters");
  EXPECT_EQ(read("", "type=\"Complex\">1", 1).error,
            "a.vtu: array 'n': numbers of the type 'Complex' are not read");
}

TEST(ArrayReader, InlineBytes) {
  // 4 bytes of header, then the Int16 1 and 2: in one text, and in two.
  const std::string_view little = "byte_order=\"LittleEndian\"";
  EXPECT_EQ(read(little, "type=\"Int16\" format=\"binary\">BAAAAAEAAgA=", 2).numbers,
            (std::vector<double>{1, 2}));
  EXPECT_EQ(read(little, "type=\"Int16\" format=\"binary\">BAAAAA==AQACAA==", 2).numbers,
            (std::vector<double>{1, 2}));
  EXPECT_EQ(
      read("byte_order=\"BigEndian\"", "type=\"Int16\" format=\"binary\">AAAABAABAAI=", 2).numbers,
      (std::vector<double>{1, 2}));
  EXPECT_EQ(read("byte_order=\"LittleEndian\" header_type=\"UInt64\"",
                 "type=\"UInt8\" format=\"binary\">AgAAAAAAAAAHCA==", 2)
                .numbers,
            (std::vector<double>{7, 8}));
  EXPECT_EQ(read(little, "type=\"Bit\" format=\"binary\">AgAAAFSA", 9).numbers,
            (std::vector<double>{0, 1, 0, 1, 0, 1, 0, 0, 1}));
  EXPECT_EQ(read(little, "type=\"Int16\" format=\"binary\">BAAAAAEAAgA=", 3).error,
            "a.vtu: array 'n': its header announces 4 bytes of 6");
  EXPECT_EQ(read(little, "type=\"Int16\" format=\"binary\">BAA", 1).error,
            "a.vtu: array 'n': it ends in its header: the file was cut off");
  EXPECT_EQ(read("header_type=\"UInt16\"", "type=\"Int16\">1", 1).error,
            "a.vtu: unknown header_type 'UInt16'");
  EXPECT_EQ(read("byte_order=\"Middle\"", "type=\"Int16\">1", 1).error,
            "a.vtu: unknown byte_order 'Middle'");
  EXPECT_EQ(read("compressor=\"zip\"", "type=\"Int16\">1", 1).error,
            "a.vtu: unknown compressor 'zip'");
}

TEST(ArrayReader, AppendedBytes) {
  const std::string_view little = "byte_order=\"LittleEndian\"";
  const std::string bytes =
      std::string("<AppendedData encoding=\"raw\">\n _") + std::string("\0\0\2\0\0\0\7\10", 8);
  EXPECT_EQ(read(little, "type=\"UInt8\" offset=\"2\">", 2, bytes).numbers,
            (std::vector<double>{7, 8}));
  EXPECT_EQ(read(little, "type=\"UInt8\" offset=\"9999\">", 2, bytes).error.substr(0, 44),
            "a.vtu: array 'n': it begins at byte 9999 of ");
  EXPECT_EQ(read(little, "type=\"UInt8\" offset=\"-1\">", 2, bytes).error,
            "a.vtu: array 'n': '-1' is no offset");
  EXPECT_EQ(read(little, "type=\"UInt8\" offset=\"8\">", 2,
                 "<AppendedData encoding=\"base64\">_AAAAAAAAAgAAAAcI")
                .numbers,
            (std::vector<double>{7, 8}));
  EXPECT_EQ(read(little, "type=\"UInt8\" offset=\"0\">", 2, "<AppendedData>x").error,
            "a.vtu: the appended data do not begin with '_'");
}

}  // namespace
}  // namespace cover
