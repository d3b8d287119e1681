// The numbers of an array, for files that hold them as bytes.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

#include "io/files/binary_writer.hpp"

namespace cover {

/// Writes the numbers of one array: in order, or, if it knows them by number, any of them.
class ArrayWriter {
 public:
  /// Puts the bytes of the items first, ..., last - 1 to a place.
  using Fill = std::function<void(std::size_t first, std::size_t last, char* to)>;

  ArrayWriter() = default;
  /// One that writes all of them in order.
  template <std::invocable<BinaryWriter&> Write>
  requires(!std::same_as<std::remove_cvref_t<Write>, ArrayWriter>) ArrayWriter(Write write)
      : write_(std::move(write)) {}
  /// One that knows `items` of them, of so many bytes each.
  ArrayWriter(std::size_t items, std::size_t item_bytes, Fill fill)
      : items_(items), item_bytes_(item_bytes), fill_(std::move(fill)) {}

  /// Whether it knows items by number. What follows is of such a one.
  [[nodiscard]] bool has_ranges() const { return static_cast<bool>(fill_); }
  [[nodiscard]] std::size_t items() const { return items_; }
  /// Adds the bytes of some items.
  void append(std::size_t first, std::size_t last, std::string& bytes) const {
    const std::size_t size = bytes.size();
    bytes.resize(size + (last - first) * item_bytes_);
    fill_(first, last, bytes.data() + size);
  }
  /// How many items make a piece of so many bytes: at least one.
  [[nodiscard]] std::size_t items_in(std::size_t bytes) const {
    return std::max<std::size_t>(1, bytes / item_bytes_);
  }

  void operator()(BinaryWriter& out) const {
    if (!has_ranges()) return write_(out);
    constexpr std::size_t kPiece = 1 << 15;
    std::string bytes;
    for (std::size_t first = 0; first < items_; first += items_in(kPiece)) {
      bytes.clear();
      append(first, std::min(items_, first + items_in(kPiece)), bytes);
      out.put(bytes);
    }
  }

 private:
  std::function<void(BinaryWriter&)> write_;
  std::size_t items_ = 0, item_bytes_ = 1;
  Fill fill_;
};

/// That of `value(0)`, ..., `value(size - 1)`, each a T.
template <class T, class Value>
ArrayWriter array_of_values(std::size_t size, Value value) {
  return {size, sizeof(T),
          [value = std::move(value)](std::size_t first, std::size_t last, char* to) {
            for (std::size_t k = first; k < last; ++k, to += sizeof(T)) {
              const T number = static_cast<T>(value(k));
              std::memcpy(to, &number, sizeof(T));
            }
          }};
}

}  // namespace cover
