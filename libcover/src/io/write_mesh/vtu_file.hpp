// VTK's XML format for one unstructured grid, as bytes.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "io/files/byte_sink.hpp"

namespace cover {

/// Gathers numbers into pieces that are worth a call.
class BinaryWriter {
 public:
  explicit BinaryWriter(const ByteSink& sink) : sink_(sink) { buffer_.reserve(2 * kFull); }
  ~BinaryWriter() = default;
  BinaryWriter(const BinaryWriter&) = delete;
  BinaryWriter& operator=(const BinaryWriter&) = delete;

  void put(std::string_view bytes) {
    buffer_.append(bytes);
    if (buffer_.size() >= kFull) flush();
  }
  template <class T>
  void put(T value) requires std::is_arithmetic_v<T> {
    put(std::string_view(reinterpret_cast<const char*>(&value), sizeof value));
  }
  void flush() {
    sink_(buffer_);
    buffer_.clear();
  }

 private:
  static constexpr std::size_t kFull = 1 << 16;

  const ByteSink& sink_;
  std::string buffer_;
};

/// One array of a grid: how it is announced, and its values when they are wanted.
struct VtuArray {
  std::string attributes;  ///< type, Name, NumberOfComponents
  std::uint64_t bytes = 0;
  std::function<void(BinaryWriter&)> write;
};

template <class T>
constexpr std::string_view vtu_type() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
}

/// The array of `value(0)`, ..., `value(size - 1)`, each a T.
template <class T, class Value>
VtuArray vtu_array(std::string_view name, std::size_t size, Value value) {
  return {fmt::format("type=\"{}\" Name=\"{}\"", vtu_type<T>(), name), size * sizeof(T),
          [size, value = std::move(value)](BinaryWriter& out) {
            for (std::size_t k = 0; k < size; ++k) out.put(static_cast<T>(value(k)));
          }};
}

/// A grid whose cells are all of one type.
struct VtuGrid {
  std::size_t points = 0;
  std::size_t cells = 0;
  std::string point_attributes;  ///< of the point data: which of them is what
  std::vector<VtuArray> point_data;
  std::string cell_attributes;
  std::vector<VtuArray> cell_data;
  VtuArray coordinates;
  std::vector<VtuArray> connectivity;  ///< connectivity, offsets, types
};

/// Writes a .vtu file: raw appended data, 64-bit sizes, not compressed, as VTK's own writer does
/// it but for the ranges of the arrays.
void write_vtu_bytes(const VtuGrid& grid, const ByteSink& sink);

}  // namespace cover
