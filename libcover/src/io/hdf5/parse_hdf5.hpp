// Files in HDF5, read without its library, which bears no hostile files.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <cover/result.hpp>

#include "io/vtk_files/arrays/number_array.hpp"

namespace cover {

/// An attribute or a data set: numbers in the file's own bytes, or texts.
struct Hdf5Value {
  enum class Kind { numbers, texts, other };
  Kind kind = Kind::other;
  NumberType type = NumberType::uint8;
  std::vector<std::uint64_t> shape;  ///< empty: a scalar
  std::string_view bytes;            ///< of numbers
  std::vector<std::string> texts;
  std::string why;  ///< of `other`: what is not read

  [[nodiscard]] std::uint64_t size() const {
    std::uint64_t all = 1;
    for (const std::uint64_t n : shape) all *= n;
    return all;
  }
};

/// A group or a data set.
struct Hdf5Object {
  bool is_group = false;
  Hdf5Value value;  ///< of a data set
  std::map<std::string, Hdf5Value, std::less<>> attributes;
};

/// Objects by their paths, as "/VTKHDF/Points"; the root is "/".
using Hdf5Tree = std::map<std::string, Hdf5Object, std::less<>>;

/// The groups and contiguous data sets of a file; `text` must outlive the tree. Numbers are those
/// of little-endian machines. Data sets in chunks, compressed ones and other types are named, but
/// not read; so are links to other files. Each object counts once, and data sets share no bytes.
///
/// Errors: syntax, truncated, unsupported_format
/// Cost:   O(n log n) in the length of the text, whatever stands in it
Result<Hdf5Tree> parse_hdf5(std::string_view text, const std::string& source);

}  // namespace cover
