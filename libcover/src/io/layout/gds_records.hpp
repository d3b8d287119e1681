// The records of a GDSII file: length, type, kind of data, data; all numbers big-endian.
// Source: Calma, GDSII Stream Format Manual, release 6.0 (1987).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <cover/result.hpp>

namespace cover {

/// What a record is about; types that mean nothing to geometry are not listed.
enum class GdsType : std::uint8_t {
  header = 0x00,
  library_name = 0x02,
  units = 0x03,
  end_library = 0x04,
  begin_cell = 0x05,
  cell_name = 0x06,
  end_cell = 0x07,
  boundary = 0x08,
  path = 0x09,
  reference = 0x0a,
  array = 0x0b,
  text = 0x0c,
  layer = 0x0d,
  data_type = 0x0e,
  width = 0x0f,
  coordinates = 0x10,
  end_element = 0x11,
  referred_name = 0x12,
  columns_rows = 0x13,
  node = 0x15,
  text_type = 0x16,
  string = 0x19,
  transform = 0x1a,
  magnification = 0x1b,
  angle = 0x1c,
  path_type = 0x21,
  box = 0x2d,
  box_type = 0x2e,
  begin_extension = 0x30,
  end_extension = 0x31,
};

/// One record. Numbers are asked for by place; what is not there is zero.
class GdsRecord {
 public:
  GdsRecord() = default;
  GdsRecord(GdsType type, std::string_view data, std::size_t at)
      : type_(type), data_(data), at_(at) {}

  [[nodiscard]] GdsType type() const { return type_; }
  /// Place of its first byte in the file.
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] std::size_t bytes() const { return data_.size(); }
  [[nodiscard]] std::int16_t short_at(std::size_t index) const;
  [[nodiscard]] std::int32_t long_at(std::size_t index) const;
  /// A number of 8 bytes: sign, exponent of 16 in excess of 64, 56 bits behind the point.
  [[nodiscard]] double real_at(std::size_t index) const;
  /// Without the zero that makes its length even.
  [[nodiscard]] std::string text() const;

 private:
  GdsType type_ = GdsType::header;
  std::string_view data_;
  std::size_t at_ = 0;
};

/// Goes through a file.
class GdsRecords {
 public:
  /// `bytes` must outlive the reader and what it returns.
  GdsRecords(std::string_view bytes, std::string source);

  /// The next record.
  ///
  /// Errors: truncated, where the file ends before the record does or before ENDLIB; syntax, where
  ///         a record announces fewer bytes than its head has
  Result<GdsRecord> next();

  /// An error "source: byte N: what" about a record.
  [[nodiscard]] Error error(ErrorCode code, const GdsRecord& record, std::string_view what) const;

  /// Bytes that are left.
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string_view bytes_;
  std::string source_;
  std::size_t at_ = 0;
};

}  // namespace cover
