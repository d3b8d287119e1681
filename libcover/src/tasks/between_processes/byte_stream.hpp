// Values as bytes, for other processes of the same program.
//
// Every member travels as it lies in memory: the machines of a run are of one kind. Structures are
// taken apart by structured bindings, each by an overload of `members` in this namespace, so that a
// new member which is not sent does not compile.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <cover/error.hpp>
#include <cover/options.hpp>
#include <cover/result.hpp>
#include <cover/share_out.hpp>

#include "base/faults/out_of_memory.hpp"

namespace cover {

template <class T, class Of>
concept Either = std::same_as<std::remove_const_t<T>, Of>;

template <Either<Error> T>
auto members(T& error) {
  auto& [code, message, where, inputs] = error;
  return std::tie(code, message, where, inputs);
}

template <Either<LayerRule> T>
auto members(T& rule) {
  auto& [line, region, first, growth, count] = rule;
  return std::tie(line, region, first, growth, count);
}

template <Either<PeriodicRule> T>
auto members(T& rule) {
  auto& [from, to, map, centre, angle] = rule;
  return std::tie(from, to, map, centre, angle);
}

/// As it lies in memory.
template <class T>
concept Plain = std::is_trivially_copyable_v<T>;

class ByteWriter {
 public:
  template <Plain T>
  void put(const T& value) {
    append(&value, sizeof value);
  }
  void put(const std::string& text) {
    put(text.size());
    append(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(values.size());
    if constexpr (Plain<T>) {
      append(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) put(value);
    }
  }
  template <class T>
  void put(const std::shared_ptr<const T>& value) {
    put(value != nullptr);
    if (value) put(*value);
  }
  template <class T>
  requires requires(const T& value) { members(value); }
  void put(const T& value) {
    std::apply([this](const auto&... member) { (this->put(member), ...); }, members(value));
  }
  [[nodiscard]] Bytes take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  Bytes bytes_;
};

/// Reads what a ByteWriter put. After the end, everything is empty, and whole() is false.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <Plain T>
  void get(T& value) {
    take(&value, sizeof value);
  }
  void get(bool& value) {  // other bytes than those of false and true are no value at all
    std::uint8_t byte = 0;
    get(byte);
    short_ = short_ || byte > 1;
    value = byte == 1;
  }
  void get(std::string& text) {
    text.resize(count(1));
    take(text.data(), text.size());
  }
  template <class T>
  void get(std::vector<T>& values) {
    values.resize(count(Plain<T> ? sizeof(T) : 1));
    if constexpr (Plain<T>) {
      take(values.data(), values.size() * sizeof(T));
    } else {
      for (T& value : values) get(value);
    }
  }
  template <class T>
  void get(std::shared_ptr<const T>& value) {
    bool is_there = false;
    get(is_there);
    if (!is_there) return;
    auto made = std::make_shared<T>();
    get(*made);
    value = std::move(made);
  }
  template <class T>
  requires requires(T& value) { members(value); }
  void get(T& value) {
    std::apply([this](auto&... member) { (this->get(member), ...); }, members(value));
  }
  /// Whether all was there, and nothing is left.
  [[nodiscard]] bool whole() const { return !short_ && rest_.empty(); }

 private:
  /// A number of elements that the rest can hold.
  std::size_t count(std::size_t bytes_each) {
    std::size_t n = 0;
    get(n);
    if (n <= rest_.size() / bytes_each) return n;
    short_ = true;
    return 0;
  }
  void take(void* data, std::size_t size) {
    if (size > rest_.size()) {
      short_ = true;
      rest_ = {};
      return;
    }
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  std::span<const std::byte> rest_;
  bool short_ = false;
};

/// The first byte of a value or of an error in its place.
enum class Answer : std::uint8_t { value, error };

template <class T>
Bytes bytes_of(const T& value) {
  ByteWriter writer;
  writer.put(value);
  return writer.take();
}

inline Error not_ours() {
  return {ErrorCode::internal, "another process sent what this one cannot read", {}, {}};
}

template <class T>
Result<T> value_of(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  T value;
  reader.get(value);
  if (!reader.whole()) return not_ours();
  return value;
}

/// A value or an error.
template <class T>
Bytes bytes_of_result(const Result<T>& result) {
  ByteWriter writer;
  writer.put(result ? Answer::value : Answer::error);
  if (result) {
    writer.put(*result);
  } else {
    writer.put(result.error());
  }
  return writer.take();
}

/// Nothing is what a process sends that has no memory to tell of an error.
template <class T>
Result<T> result_of_bytes(std::span<const std::byte> bytes) {
  if (bytes.empty()) return out_of_memory("another process");
  if (bytes.front() == std::byte{static_cast<std::uint8_t>(Answer::value)})
    return value_of<T>(bytes.subspan(1));
  ByteReader reader(bytes.subspan(1));
  Error sent;
  reader.get(sent);
  return reader.whole() ? std::move(sent) : not_ours();
}

}  // namespace cover
