// Geometry read elsewhere: in other processes, on other machines.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>
#include <cover/share_out.hpp>

namespace cover {

/// Files of one geometry, each read with the same options.
struct FilesToRead {
  std::vector<std::string> paths;
  ReadOptions options;
};

/// Reads files, here or elsewhere, and returns what is in them in their order. `here` reads one in
/// this process.
///
/// Errors: that of the first file that cannot be read
using ReadElsewhere = std::function<Result<std::vector<Input>>(
    const FilesToRead& files, const std::function<Result<Input>(const std::string& path)>& here)>;

/// For another process of this program, on a machine of the same kind.
///
/// Cost: O(n), some nanoseconds a point
Bytes bytes_of_files(const FilesToRead& files);
Bytes bytes_of_input(const Result<Input>& input);

/// Errors: internal if the bytes are not those of the function above
Result<FilesToRead> files_of_bytes(std::span<const std::byte> bytes);
/// Errors: the one that was sent, too
Result<Input> input_of_bytes(std::span<const std::byte> bytes);

}  // namespace cover
