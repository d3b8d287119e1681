// Compressed blocks, as VTK's writers make them: each is a stream of its own.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace cover {

enum class Compression { none, zlib, lz4, lzma };

/// What VTK calls its compressors; nothing for another name.
std::optional<Compression> compression_of(std::string_view vtk_name);

/// Inflates the first `size` bytes of a block into `out`, and not a byte more; false where they are
/// not to be had, or are `whole` and not all of the block, or do not fit its checksum.
///
/// REQUIRES: compression is not none
bool inflate_block(Compression compression, std::string_view block, char* out, std::size_t size,
                   bool whole);

}  // namespace cover
