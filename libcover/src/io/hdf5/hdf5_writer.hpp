// Files in HDF5: groups, attributes, data sets.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cover/result.hpp>

#include "io/files/binary_writer.hpp"
#include "io/vtk_files/arrays/number_array.hpp"

namespace cover {

/// A data set of numbers, which are asked for when the file is written.
struct Hdf5Numbers {
  std::string path;  ///< in the file, from its root on; the groups above it are there
  NumberType type = NumberType::float64;
  std::vector<std::uint64_t> shape;
  std::function<void(BinaryWriter&)> write;  ///< as many numbers as the shape has
};

/// A data set of texts.
struct Hdf5Texts {
  std::string path;
  std::vector<std::string> texts;
};

/// An attribute of a group: whole numbers, or a text where there are none.
struct Hdf5Attribute {
  std::string group;
  std::string name;
  std::vector<std::int64_t> numbers;
  std::string text;
};

/// What a file holds, in the order in which it is made.
struct Hdf5Content {
  std::vector<std::string> groups;
  std::vector<Hdf5Attribute> attributes;
  std::vector<Hdf5Numbers> numbers;
  std::vector<Hdf5Texts> texts;
};

/// Writes a file of HDF5's oldest version, which everything reads: contiguous data sets, no times,
/// so that equal contents are equal bytes. Texts are in UTF-8.
///
/// Errors: out_of_memory
/// Threads: as HDF5's library, which Debian builds for many.
Status write_hdf5(const Hdf5Content& content, const ByteSink& sink);

}  // namespace cover
