// Tested by tests/unit/io/layout/read_gds_test.cpp.
#include "io/layout/gds_records.hpp"

#include <cmath>

#include <fmt/core.h>

namespace cover {
namespace {

/// `size` bytes from `at` as a big-endian number; zero beyond the end.
std::uint64_t big_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  if (at + size > bytes.size()) return 0;
  std::uint64_t value = 0;
  for (const char c : bytes.substr(at, size)) value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

}  // namespace

std::int16_t GdsRecord::short_at(std::size_t index) const {
  return static_cast<std::int16_t>(big_endian(data_, 2 * index, 2));
}

std::int32_t GdsRecord::long_at(std::size_t index) const {
  return static_cast<std::int32_t>(big_endian(data_, 4 * index, 4));
}

double GdsRecord::real_at(std::size_t index) const {
  const std::uint64_t bits = big_endian(data_, 8 * index, 8);
  const double fraction = static_cast<double>(bits & ((std::uint64_t{1} << 56U) - 1));
  const int exponent = static_cast<int>(bits >> 56U & 0x7fU) - 64;
  const double size = std::ldexp(fraction, 4 * exponent - 56);
  return (bits >> 63U) != 0 ? -size : size;
}

std::string GdsRecord::text() const { return std::string(data_.substr(0, data_.find('\0'))); }

GdsRecords::GdsRecords(std::string_view bytes, std::string source)
    : bytes_(bytes), source_(std::move(source)) {}

Result<GdsRecord> GdsRecords::next() {
  constexpr std::size_t kHead = 4;
  const GdsRecord here(GdsType::header, {}, at_);
  if (at_ == bytes_.size())
    return error(ErrorCode::truncated, here, "the file ends before its record ENDLIB");
  if (left() < kHead)
    return error(ErrorCode::truncated, here, "the file ends within the head of a record");
  const std::size_t length = big_endian(bytes_, at_, 2);
  if (length < kHead)
    return error(ErrorCode::syntax, here,
                 fmt::format("a record announces {} bytes, fewer than its head has", length));
  if (length > left())
    return error(ErrorCode::truncated, here,
                 fmt::format("a record announces {} bytes where {} are left", length, left()));
  const auto type = static_cast<GdsType>(static_cast<unsigned char>(bytes_[at_ + 2]));
  const GdsRecord record(type, bytes_.substr(at_ + kHead, length - kHead), at_);
  at_ += length;
  return record;
}

Error GdsRecords::error(ErrorCode code, const GdsRecord& record, std::string_view what) const {
  return {code, fmt::format("{}: byte {}: {}", source_, record.at(), what), {}, {}};
}

}  // namespace cover
