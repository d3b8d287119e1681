// Tested by tests/unit/io/vtk_files/arrays/array_reader_test.cpp.
#include "io/vtk_files/arrays/array_reader.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include <fmt/core.h>

#include "io/text/limits.hpp"
#include "io/text/text.hpp"
#include "io/vtk_files/arrays/ascii_numbers.hpp"
#include "io/vtk_files/arrays/base64.hpp"
#include "io/vtk_files/arrays/byte_order.hpp"

namespace cover {
namespace {

/// Bytes that stand in the file as they are.
class RawBytes {
 public:
  explicit RawBytes(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] std::size_t most() const { return bytes_.size(); }
  bool read(char* out, std::size_t size) {
    if (size > bytes_.size()) return false;
    std::memcpy(out, take(size).data(), size);
    return true;
  }
  /// The next bytes where they are.
  /// REQUIRES: size <= most()
  std::string_view take(std::size_t size) {
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

 private:
  std::string_view bytes_;
};

constexpr std::string_view kBit = "Bit";

std::optional<NumberType> xml_type(std::string_view name) {
  constexpr std::pair<std::string_view, NumberType> kXmlTypes[] = {
      {"Int8", NumberType::int8},       {"UInt8", NumberType::uint8},
      {"Int16", NumberType::int16},     {"UInt16", NumberType::uint16},
      {"Int32", NumberType::int32},     {"UInt32", NumberType::uint32},
      {"Int64", NumberType::int64},     {"UInt64", NumberType::uint64},
      {"Float32", NumberType::float32}, {"Float64", NumberType::float64},
      {kBit, NumberType::uint8},  // eight of them in a byte
  };
  for (const auto& [known, type] : kXmlTypes)
    if (known == name) return type;
  return std::nullopt;
}

bool is_of_bits(const XmlElement& array) { return array.value("type") == kBit; }

}  // namespace

ArrayReader::ArrayReader(const std::string& source, std::size_t file_size)
    : source_(source), file_size_(file_size) {
  left_ = kFreeUnfolding + kUnfolding * file_size;
}

Error ArrayReader::error(ErrorCode code, std::string_view what) const {
  return {code, fmt::format("{}: {}", source_, what), {}, {}};
}

Error ArrayReader::error_in(const XmlElement& array, ErrorCode code, std::string_view what) const {
  return error(code, fmt::format("array '{}': {}", legible(array.value("Name")), what));
}

Result<ArrayReader> ArrayReader::create(std::string_view text, const XmlTree& tree,
                                        const std::string& source) {
  ArrayReader reader(source, text.size());
  const XmlElement& root = tree.root;
  const std::string_view order = root.value("byte_order");
  if (!order.empty() && order != "LittleEndian" && order != "BigEndian")
    return reader.error(ErrorCode::unsupported_format,
                        fmt::format("unknown byte_order '{}'", legible(order)));
  const bool is_big =
      order.empty() ? std::endian::native == std::endian::big : order == "BigEndian";
  reader.swap_ = is_big != (std::endian::native == std::endian::big);
  const std::string_view header = root.value("header_type");
  if (!header.empty() && header != "UInt32" && header != "UInt64")
    return reader.error(ErrorCode::unsupported_format,
                        fmt::format("unknown header_type '{}'", legible(header)));
  reader.header_size_ = header == "UInt64" ? 8 : 4;
  if (const std::string_view name = root.value("compressor"); !name.empty()) {
    const auto compression = compression_of(name);
    if (!compression)
      return reader.error(ErrorCode::unsupported_format,
                          fmt::format("unknown compressor '{}'", legible(name)));
    reader.compression_ = *compression;
  }
  if (const XmlElement* appended = root.child("AppendedData")) {
    reader.appended_base64_ = appended->value("encoding") == "base64";
    const std::size_t mark = tree.rest.find_first_not_of(" \t\r\n");
    if (mark == std::string_view::npos)
      return reader.error(ErrorCode::truncated,
                          "the file ends before its appended data: it was cut off");
    if (tree.rest[mark] != '_')
      return reader.error(ErrorCode::syntax, "the appended data do not begin with '_'");
    reader.appended_ = tree.rest.substr(mark + 1);
  }
  return reader;
}

Result<std::size_t> ArrayReader::components(const XmlElement& array) const {
  if (array.name != "DataArray" || !xml_type(array.value("type"))) return std::size_t{0};
  const std::string* text = array.attribute("NumberOfComponents");
  if (text == nullptr) return std::size_t{1};
  const auto count = parse_integer(*text);
  if (!count || *count < 0)
    return error_in(array, ErrorCode::syntax,
                    fmt::format("'{}' is no number of components", legible(*text)));
  return static_cast<std::size_t>(*count);
}

Result<NumberArray> ArrayReader::read(const XmlElement& array, std::size_t items) {
  const Result<std::size_t> each = components(array);
  if (!each) return each.error();
  const auto type = xml_type(array.value("type"));
  if (*each == 0 || !type)
    return error_in(
        array, ErrorCode::unsupported_format,
        fmt::format("numbers of the type '{}' are not read", legible(array.value("type"))));
  // Divided, so that nothing overflows: what may be unfolded is far below what a size_t holds.
  const std::size_t most = left_ / 8 / *each;
  if (items > most)
    return error_in(
        array, ErrorCode::unsupported_format,
        fmt::format("{} times {} numbers are announced, too many for a file of {} bytes "
                    "(compressed data may become {} times larger)",
                    items, *each, file_size_, kUnfolding));
  const std::size_t values = items * *each;
  left_ -= 8 * values;
  const auto finished = [&](Result<NumberArray> numbers) {
    if (!numbers) return numbers;
    numbers->name = array.value("Name");
    numbers->components = *each;
    return numbers;
  };
  if (const std::string* offset = array.attribute("offset")) {
    const auto at = parse_integer(*offset);
    if (!at || *at < 0)
      return error_in(array, ErrorCode::syntax, fmt::format("'{}' is no offset", legible(*offset)));
    if (static_cast<std::size_t>(*at) > appended_.size())
      return error_in(array, ErrorCode::truncated,
                      fmt::format("it begins at byte {} of the appended data, which have {}: the "
                                  "file was cut off",
                                  *at, appended_.size()));
    const std::string_view bytes = appended_.substr(static_cast<std::size_t>(*at));
    return finished(appended_base64_ ? read_bytes(array, Base64(bytes), *type, values)
                                     : read_bytes(array, RawBytes(bytes), *type, values));
  }
  if (array.value("format") == "binary")
    return finished(read_bytes(array, Base64(array.text), *type, values));
  return finished(read_ascii_array(array, *type, values));
}

Result<NumberArray> ArrayReader::read_ascii_array(const XmlElement& array, NumberType type,
                                                  std::size_t values) const {
  std::string_view text = array.text;
  if (values > text.size() / 2 + 1)
    return error_in(array, ErrorCode::truncated,
                    fmt::format("{} numbers are announced, and its text has {} characters", values,
                                text.size()));
  return with_type(type, [&](auto number) -> Result<NumberArray> {
    using T = decltype(number);
    auto numbers = std::make_unique_for_overwrite<char[]>(values * sizeof(T));
    // Memory of new char[] is aligned for any number.
    const std::size_t count = read_ascii(text, reinterpret_cast<T*>(numbers.get()), values);
    if (count == values) return NumberArray(type, std::move(numbers), values);
    if (text.empty())
      return error_in(array, ErrorCode::truncated,
                      fmt::format("it has {} of {} numbers", count, values));
    return error_in(array, ErrorCode::syntax,
                    fmt::format("number {} is '{}'", count,
                                legible(text.substr(0, text.find_first_of(" \t\r\n")))));
  });
}

template <class Bytes>
bool ArrayReader::read_header(Bytes& bytes, std::uint64_t& number) const {
  char raw[8];
  if (!bytes.read(raw, header_size_)) return false;
  if (swap_) std::reverse(raw, raw + header_size_);
  if (header_size_ == 4) {
    std::uint32_t narrow = 0;
    std::memcpy(&narrow, raw, 4);
    number = narrow;
  } else {
    std::memcpy(&number, raw, 8);
  }
  return true;
}

template <class Bytes>
Result<NumberArray> ArrayReader::read_bytes(const XmlElement& array, Bytes bytes, NumberType type,
                                            std::size_t values) const {
  const bool bits = is_of_bits(array);
  const std::size_t size = bits ? (values + 7) / 8 : values * size_of(type);
  if (size == 0) return NumberArray(type, std::string_view());
  std::unique_ptr<char[]> own;
  if (compression_ != Compression::none) {
    own = std::make_unique_for_overwrite<char[]>(size);
    if (Status status = inflate(array, bytes, own.get(), size); !status)
      return std::move(status).error();
  } else {
    std::uint64_t announced = 0;
    if (!read_header(bytes, announced))
      return error_in(array, ErrorCode::truncated, "it ends in its header: the file was cut off");
    if (announced < size)
      return error_in(array, ErrorCode::syntax,
                      fmt::format("its header announces {} bytes of {}", announced, size));
    if (size > bytes.most())
      return error_in(
          array, ErrorCode::truncated,
          fmt::format("it has {} of {} bytes: the file was cut off", bytes.most(), size));
    if constexpr (requires { bytes.take(size); }) {
      if (!bits && (!swap_ || size_of(type) == 1)) return NumberArray(type, bytes.take(size));
    }
    own = std::make_unique_for_overwrite<char[]>(size);
    if (!bytes.read(own.get(), size))
      return error_in(array, ErrorCode::syntax, "it is no base64, or ends too early");
  }
  if (bits)
    own = unpack_bits({own.get(), size}, values);
  else if (swap_)
    swap_bytes(own.get(), values, size_of(type));
  return NumberArray(type, std::move(own), values);
}

template <class Bytes>
Status ArrayReader::inflate(const XmlElement& array, Bytes& bytes, char* out,
                            std::size_t size) const {
  const auto cut_off = [&] {
    return error_in(array, ErrorCode::truncated,
                    "its compressed data end too early: the file was cut off, or is no base64");
  };
  std::uint64_t blocks = 0, block_size = 0, last_size = 0;
  if (!read_header(bytes, blocks) || !read_header(bytes, block_size) ||
      !read_header(bytes, last_size))
    return cut_off();
  if (blocks > bytes.most() / header_size_) return cut_off();
  std::vector<std::uint64_t> compressed(static_cast<std::size_t>(blocks));
  for (std::uint64_t& one : compressed)
    if (!read_header(bytes, one)) return cut_off();
  std::size_t done = 0;
  std::vector<char> room;
  for (std::size_t b = 0; b < compressed.size() && done < size; ++b) {
    const std::size_t packed = static_cast<std::size_t>(compressed[b]);
    if (packed > bytes.most()) return cut_off();
    std::string_view block;
    if constexpr (requires { bytes.take(packed); }) {
      block = bytes.take(packed);
    } else {
      if (packed > room.size()) room.resize(packed);
      if (!bytes.read(room.data(), packed)) return cut_off();
      block = {room.data(), packed};
    }
    const bool is_last = b + 1 == compressed.size() && last_size != 0;
    const std::uint64_t full = is_last ? last_size : block_size;
    const std::size_t wanted = static_cast<std::size_t>(std::min<std::uint64_t>(full, size - done));
    if (!inflate_block(compression_, block, out + done, wanted, wanted == full))
      return error_in(array, ErrorCode::syntax,
                      fmt::format("block {} of its compressed data is broken", b));
    done += wanted;
  }
  if (done < size)
    return error_in(array, ErrorCode::syntax,
                    fmt::format("its blocks hold {} of {} bytes", done, size));
  return ok();
}

}  // namespace cover
