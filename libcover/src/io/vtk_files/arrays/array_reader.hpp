// The arrays of VTK's XML files: where their numbers stand, and how they are written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <cover/result.hpp>

#include "io/text/xml_tree.hpp"
#include "io/vtk_files/arrays/inflate.hpp"
#include "io/vtk_files/arrays/number_array.hpp"

namespace cover {

/// Decodes <DataArray> elements of one file.
class ArrayReader {
 public:
  /// Takes the byte order, the type of headers, the compressor and the appended data from a file's
  /// root. `text` and `source` must outlive the reader and its arrays.
  ///
  /// Errors: unsupported_format
  static Result<ArrayReader> create(std::string_view text, const XmlTree& tree,
                                    const std::string& source);

  /// The components of an array; 0 where its items are no numbers.
  ///
  /// Errors: syntax
  [[nodiscard]] Result<std::size_t> components(const XmlElement& array) const;

  /// The first `items` items of an array of numbers; more that the file has are passed over. Points
  /// into the text where the bytes can be taken as they are.
  ///
  /// Errors: syntax, truncated, unsupported_format, where what it has unfolds to more than
  ///         limits.hpp allows.
  /// Cost:   O(bytes of these items)
  Result<NumberArray> read(const XmlElement& array, std::size_t items);

  /// An error about the file.
  [[nodiscard]] Error error(ErrorCode code, std::string_view what) const;

 private:
  ArrayReader(const std::string& source, std::size_t file_size);

  [[nodiscard]] Error error_in(const XmlElement& array, ErrorCode code,
                               std::string_view what) const;
  Result<NumberArray> read_ascii_array(const XmlElement& array, NumberType type,
                                       std::size_t values) const;
  template <class Bytes>
  Result<NumberArray> read_bytes(const XmlElement& array, Bytes bytes, NumberType type,
                                 std::size_t values) const;
  template <class Bytes>
  Status inflate(const XmlElement& array, Bytes& bytes, char* out, std::size_t size) const;
  template <class Bytes>
  bool read_header(Bytes& bytes, std::uint64_t& number) const;

  const std::string& source_;
  std::size_t file_size_ = 0;
  std::size_t left_ = 0;  ///< what may still be unfolded, in bytes
  bool swap_ = false;
  std::size_t header_size_ = 4;
  Compression compression_ = Compression::none;
  std::string_view appended_;
  bool appended_base64_ = false;
};

}  // namespace cover
