// Numbers into a file as bytes.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>

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

}  // namespace cover
