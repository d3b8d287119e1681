// What files may announce. A file is somebody else's: whatever its header says, reading takes
// memory and time in proportion to the bytes that are there.
//
// clang-format off
// | what | limit |
// |------------------------------------------|-----------------------------------------------------|
// | points, nodes of cells | below 2^32 - 1, as their numbers have 32 bits |
// | numbers announced in text | half the characters that are left, and one |
// | numbers announced as bytes | the bytes that are left; base64: 3/4 of them |
// | what compressed or shared data unfold to | kUnfolding bytes for each of the file's, and |
// | | kFreeUnfolding |
// | points of a lattice (STRUCTURED_POINTS) | kLatticePoints for each byte of the file |
// | elements of XML, one in the other | kXmlDepth |
// | elements of XML in all | kXmlElements |
// | entities and external files of XML | none |
// | values in JSON, one in the other | none: they are read without recursion |
// | pixels of a picture | kImagePixels, and kImageUnfolding for each byte |
// | regions in a picture | kImageRegions |
// | lists or calls of a drawing program, one | kSchemeDepth |
// | in the other | |
// | its evaluations | kSchemeSteps |
// | what it puts together: characters, items | kSchemeText |
// | files of a .vtm | each once |
// | shapes of a layout or drawing that cells | as many as the file has itself, and kLayoutShapes, |
// | or blocks repeat, and their points | kLayoutPoints |
// | cells or blocks, one in the other | kCellDepth |
// | crossings of lines | those that memory surely holds (TooManyCrossings) |
// clang-format on
//
// Tested by tests/unit/io/text/limits_test.cpp.
#pragma once

#include <cstddef>

namespace cover {

/// Meshes that VTK's writers compress become 2 to 40 times smaller; zlib at its best makes 1 byte
/// of 1032, lzma of many more.
inline constexpr std::size_t kUnfolding = 100;
inline constexpr std::size_t kFreeUnfolding = std::size_t{64} << 20U;
/// Each cell or point of a lattice has at least one number, of at least one byte; a row of n cells
/// has 2 (n + 1) points.
inline constexpr std::size_t kLatticePoints = 4;
inline constexpr std::size_t kXmlDepth = 64;
inline constexpr std::size_t kXmlElements = 1'000'000;
/// Pixels of a picture: these, and so many for each byte of the file.
inline constexpr std::size_t kImagePixels = std::size_t{1} << 23U;
inline constexpr std::size_t kImageUnfolding = 1000;
inline constexpr std::size_t kImageRegions = std::size_t{1} << 18U;
/// Commands of drawing programs: lists, or calls, one in the other; evaluations; characters of a
/// text, or items of a list, that they put together.
inline constexpr std::size_t kSchemeDepth = 100;
inline constexpr std::size_t kSchemeSteps = 200'000;
inline constexpr std::size_t kSchemeText = 10'000;
/// A few bytes of a layout put a cell into rows and columns of another one.
inline constexpr std::size_t kLayoutShapes = std::size_t{1} << 21U;
inline constexpr std::size_t kLayoutPoints = std::size_t{1} << 24U;
inline constexpr std::size_t kCellDepth = 256;

}  // namespace cover
