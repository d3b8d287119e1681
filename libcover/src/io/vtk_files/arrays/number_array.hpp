// Arrays of numbers as files hold them: of any type, and left in the file's own bytes where these
// are in the order of this machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace cover {

enum class NumberType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
};

/// Of those that meshes are written and looked at with.
template <class T>
constexpr NumberType number_type() {
  if constexpr (std::is_same_v<T, double>) return NumberType::float64;
  if constexpr (std::is_same_v<T, std::int32_t>) return NumberType::int32;
  if constexpr (std::is_same_v<T, std::int64_t>) return NumberType::int64;
  if constexpr (std::is_same_v<T, std::uint8_t>) return NumberType::uint8;
}

/// Calls `use(T{})` with a value of the C++ type.
template <class Use>
decltype(auto) with_type(NumberType type, Use use) {
  switch (type) {
    case NumberType::int8:
      return use(std::int8_t{});
    case NumberType::uint8:
      return use(std::uint8_t{});
    case NumberType::int16:
      return use(std::int16_t{});
    case NumberType::uint16:
      return use(std::uint16_t{});
    case NumberType::int32:
      return use(std::int32_t{});
    case NumberType::uint32:
      return use(std::uint32_t{});
    case NumberType::int64:
      return use(std::int64_t{});
    case NumberType::uint64:
      return use(std::uint64_t{});
    case NumberType::float32:
      return use(float{});
    case NumberType::float64:
      break;
  }
  return use(double{});
}

inline std::size_t size_of(NumberType type) {
  return with_type(type, [](auto number) { return sizeof number; });
}

/// Numbers at any place in memory, aligned or not.
template <class T>
class NumberView {
 public:
  using Number = T;
  NumberView(const char* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] std::size_t size() const { return size_; }
  /// REQUIRES: k < size()
  T operator[](std::size_t k) const {
    T value;
    std::memcpy(&value, data_ + k * sizeof(T), sizeof(T));
    return value;
  }

 private:
  const char* data_;
  std::size_t size_;
};

/// A named array of `size()` numbers, `components` of them for each item. One whose file gives it
/// no numbers, as an array of strings, has a name alone, and no components.
class NumberArray {
 public:
  std::string name;
  std::size_t components = 0;

  NumberArray() = default;
  /// Numbers in somebody else's memory, which must outlive the array.
  NumberArray(NumberType type, std::string_view bytes)
      : type_(type), data_(bytes.data()), size_(bytes.size() / size_of(type)) {}
  /// Numbers of its own.
  /// REQUIRES: `bytes` holds `size` of them
  NumberArray(NumberType type, std::unique_ptr<char[]> bytes, std::size_t size)
      : type_(type), data_(bytes.get()), size_(size), own_(std::move(bytes)) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] NumberType type() const { return type_; }
  [[nodiscard]] std::string_view bytes() const { return {data_, size_ * size_of(type_)}; }

  /// Whether there is one number for each of `items`.
  [[nodiscard]] bool is_one_per(std::size_t items) const {
    return components == 1 && size_ == items;
  }

  /// Calls `use` with a NumberView of the numbers' type: for loops over all of them.
  template <class Use>
  decltype(auto) visit(Use use) const {
    return with_type(type_, [&](auto number) -> decltype(auto) {
      return use(NumberView<decltype(number)>(data_, size_));
    });
  }

 private:
  NumberType type_ = NumberType::uint8;
  const char* data_ = nullptr;
  std::size_t size_ = 0;
  std::unique_ptr<char[]> own_;
};

/// A number as an index below `end`; nothing if it is none.
template <class T>
std::optional<std::size_t> as_index(T number, std::size_t end) {
  if constexpr (std::is_floating_point_v<T>) {
    if (!(number >= 0) || !(static_cast<double>(number) < static_cast<double>(end))) return {};
  } else if constexpr (std::is_signed_v<T>) {
    if (number < 0) return {};
  }
  const auto index = static_cast<std::size_t>(number);  // NOLINT(bugprone-signed-char-misuse)
  if (index >= end || static_cast<T>(index) != number) return {};
  return index;
}

}  // namespace cover
