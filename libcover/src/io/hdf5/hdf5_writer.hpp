// Files in HDF5: groups, attributes, data sets.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cover/result.hpp>

#include "io/files/binary_writer.hpp"
#include "io/vtk_files/arrays/number_array.hpp"

namespace cover {

class Hdf5Bytes;

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

/// A file that is laid out: where each data set goes, and what stands between them.
struct Hdf5Plan {
  /// The place of a data set that has numbers.
  struct Extent {
    std::uint64_t at = 0;
    const Hdf5Numbers* data = nullptr;
    std::uint64_t bytes = 0;
  };
  std::vector<Extent> extents;  ///< in the order of the file
  std::uint64_t size = 0;       ///< of the file
  std::shared_ptr<const Hdf5Bytes> structures;

  /// Everything that is no data set: bytes and their place, piece by piece.
  void each_structure(
      const std::function<void(std::uint64_t at, std::string_view bytes)>& use) const;
};

/// Lays a file out, for whoever writes its parts to their places; refers to `content`.
///
/// Errors, Threads: as write_hdf5()
Result<Hdf5Plan> lay_out_hdf5(const Hdf5Content& content);

/// Writes a file of HDF5's oldest version, which everything reads: contiguous data sets, no times,
/// so that equal contents are equal bytes. Texts are in UTF-8.
///
/// Errors: out_of_memory; unsupported_format, where HDF5's library is not there
/// Threads: as HDF5's library, which Debian builds for many.
Status write_hdf5(const Hdf5Content& content, const ByteSink& sink);

}  // namespace cover
