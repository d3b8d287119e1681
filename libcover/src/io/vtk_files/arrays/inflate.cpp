// Tested by tests/unit/io/vtk_files/arrays/array_reader_test.cpp.
#include "io/vtk_files/arrays/inflate.hpp"

#include <limits>

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

namespace cover {
namespace {

/// What a stream of lzma may have for its dictionary: its highest level asks for 65 MB.
constexpr std::uint64_t kLzmaMemory = std::uint64_t{128} << 20U;

bool inflate_zlib(std::string_view block, char* out, std::size_t size, bool whole) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return false;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block.data()));  // it only reads
  stream.avail_in = static_cast<uInt>(block.size());
  stream.next_out = reinterpret_cast<Bytef*>(out);
  stream.avail_out = static_cast<uInt>(size);
  const int status = inflate(&stream, Z_FINISH);
  const bool all = stream.avail_out == 0 && (status == Z_STREAM_END ||
                                             (!whole && (status == Z_OK || status == Z_BUF_ERROR)));
  inflateEnd(&stream);
  return all;
}

bool inflate_lz4(std::string_view block, char* out, std::size_t size, bool whole) {
  const int bytes = static_cast<int>(size);
  if (whole)
    return LZ4_decompress_safe(block.data(), out, static_cast<int>(block.size()), bytes) == bytes;
  return LZ4_decompress_safe_partial(block.data(), out, static_cast<int>(block.size()), bytes,
                                     bytes) == bytes;
}

bool inflate_lzma(std::string_view block, char* out, std::size_t size, bool whole) {
  lzma_stream stream = LZMA_STREAM_INIT;
  if (lzma_stream_decoder(&stream, kLzmaMemory, 0) != LZMA_OK) return false;
  stream.next_in = reinterpret_cast<const std::uint8_t*>(block.data());
  stream.avail_in = block.size();
  stream.next_out = reinterpret_cast<std::uint8_t*>(out);
  stream.avail_out = size;
  const lzma_ret status = lzma_code(&stream, LZMA_FINISH);
  const bool all =
      stream.avail_out == 0 && (status == LZMA_STREAM_END || (!whole && status == LZMA_OK));
  lzma_end(&stream);
  return all;
}

}  // namespace

std::optional<Compression> compression_of(std::string_view vtk_name) {
  if (vtk_name == "vtkZLibDataCompressor") return Compression::zlib;
  if (vtk_name == "vtkLZ4DataCompressor") return Compression::lz4;
  if (vtk_name == "vtkLZMADataCompressor") return Compression::lzma;
  return std::nullopt;
}

bool inflate_block(Compression compression, std::string_view block, char* out, std::size_t size,
                   bool whole) {
  // zlib and lz4 count with ints; VTK's blocks are of 32 kB, and its own counts of a block too.
  constexpr std::size_t kMost = std::numeric_limits<int>::max();
  if (block.size() > kMost || size > kMost) return false;
  if (size == 0) return true;
  if (compression == Compression::zlib) return inflate_zlib(block, out, size, whole);
  if (compression == Compression::lz4) return inflate_lz4(block, out, size, whole);
  return inflate_lzma(block, out, size, whole);
}

}  // namespace cover
