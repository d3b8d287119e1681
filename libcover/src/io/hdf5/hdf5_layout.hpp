// A file of HDF5's library without a file: what the library would write, but for the data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string_view>

#include "io/hdf5/hdf5_library.hpp"

namespace cover {

/// The bytes that the library writes, by their places. Data sets that nothing is written to take
/// no room.
class Hdf5Bytes {
 public:
  /// Overwrites what is there; where memory does not last, lacks_memory tells.
  void write(std::uint64_t at, std::string_view bytes);
  /// What was written, and zeros.
  void read(std::uint64_t at, std::size_t size, char* out) const;

  std::uint64_t end = 0;  ///< length of the file
  bool lacks_memory = false;
  std::shared_ptr<void> file;  ///< what the driver calls an open file; one at a time

 private:
  static constexpr std::size_t kPage = 4096;
  using Page = std::array<char, kPage>;

  std::map<std::uint64_t, std::unique_ptr<Page>> pages_;  ///< by number
};

/// A driver of HDF5's library that puts files into Hdf5Bytes. The library gets to write structures
/// only; data sets are laid out early, with no fill values, and whoever has the layout writes them.
/// So a file goes to its place like any other, from its first byte to its last, and nothing that a
/// disk does can go wrong inside of the library, which takes such failures badly.
///
/// Threads: as HDF5's library.
class Hdf5Layout {
 public:
  explicit Hdf5Layout(const Hdf5Library& hdf5);
  ~Hdf5Layout();
  Hdf5Layout(const Hdf5Layout&) = delete;
  Hdf5Layout& operator=(const Hdf5Layout&) = delete;

  /// A new file; negative where the library fails.
  hid_t create();
  /// All of the file, once it is closed.
  [[nodiscard]] std::shared_ptr<const Hdf5Bytes> bytes() const { return bytes_; }

 private:
  const Hdf5Library& hdf5_;
  std::shared_ptr<Hdf5Bytes> bytes_;
  hid_t driver_;
};

}  // namespace cover
