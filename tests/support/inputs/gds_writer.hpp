// GDSII files made in tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cover::testing {

/// Appends records to a file; a test may put wrong ones in too.
class GdsWriter {
 public:
  using Points = std::vector<std::pair<std::int32_t, std::int32_t>>;

  /// Up to the first cell. The database unit is `unit` of the user's, `metres` long.
  explicit GdsWriter(double unit = 1e-3, double metres = 1e-9) {
    shorts(0x00, {600});
    shorts(0x01, std::vector<int>(12));
    text(0x02, "LIB");
    reals(0x03, {unit, metres});
  }

  GdsWriter& begin(const std::string& cell) {
    shorts(0x05, std::vector<int>(12));
    return text(0x06, cell);
  }
  GdsWriter& end() { return record(0x07, 0, ""); }
  /// The whole file.
  std::string finish() { return record(0x04, 0, "").bytes_; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

  GdsWriter& polygon(int layer, int type, Points points) {
    points.push_back(points.front());
    record(0x08, 0, "");
    shorts(0x0d, {layer}).shorts(0x0e, {type});
    return coordinates(points).record(0x11, 0, "");
  }
  GdsWriter& box(int layer, int type, std::int32_t x0, std::int32_t y0, std::int32_t x1,
                 std::int32_t y1) {
    return polygon(layer, type, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
  }
  GdsWriter& path(int layer, int type, std::int32_t width, int ends, const Points& points) {
    record(0x09, 0, "");
    shorts(0x0d, {layer}).shorts(0x0e, {type}).shorts(0x21, {ends}).longs(0x0f, {width});
    return coordinates(points).record(0x11, 0, "");
  }
  GdsWriter& label(int layer, int type, std::int32_t x, std::int32_t y, const std::string& words) {
    record(0x0c, 0, "");
    shorts(0x0d, {layer}).shorts(0x16, {type});
    return coordinates({{x, y}}).text(0x19, words).record(0x11, 0, "");
  }
  GdsWriter& reference(const std::string& cell, std::int32_t x, std::int32_t y, double angle = 0,
                       double magnification = 1, bool mirrored = false) {
    record(0x0a, 0, "");
    text(0x12, cell);
    return transform(angle, magnification, mirrored).coordinates({{x, y}}).record(0x11, 0, "");
  }
  GdsWriter& array(const std::string& cell, int columns, int rows, const Points& points,
                   double angle = 0) {
    record(0x0b, 0, "");
    text(0x12, cell);
    transform(angle, 1, false).shorts(0x13, {columns, rows});
    return coordinates(points).record(0x11, 0, "");
  }

  GdsWriter& shorts(int type, const std::vector<int>& values) {
    std::string data;
    for (const int v : values) data += big_endian(static_cast<std::uint64_t>(v), 2);
    return record(type, 2, data);
  }
  GdsWriter& longs(int type, const std::vector<std::int32_t>& values) {
    std::string data;
    for (const std::int32_t v : values) data += big_endian(static_cast<std::uint64_t>(v), 4);
    return record(type, 3, data);
  }
  GdsWriter& reals(int type, const std::vector<double>& values) {
    std::string data;
    for (const double v : values) data += real(v);
    return record(type, 5, data);
  }
  GdsWriter& text(int type, std::string data) {
    if (data.size() % 2 != 0) data += '\0';
    return record(type, 6, data);
  }
  GdsWriter& coordinates(const Points& points) {
    std::vector<std::int32_t> values;
    for (const auto& [x, y] : points) {
      values.push_back(x);
      values.push_back(y);
    }
    return longs(0x10, values);
  }
  GdsWriter& record(int type, int kind, const std::string& data) {
    bytes_ += big_endian(data.size() + 4, 2);
    bytes_ += static_cast<char>(type);
    bytes_ += static_cast<char>(kind);
    bytes_ += data;
    return *this;
  }

 private:
  GdsWriter& transform(double angle, double magnification, bool mirrored) {
    shorts(0x1a, {mirrored ? 0x8000 : 0});
    if (magnification != 1) reals(0x1b, {magnification});
    if (angle != 0) reals(0x1c, {angle});
    return *this;
  }
  static std::string big_endian(std::uint64_t value, int size) {
    std::string out;
    for (int k = size - 1; k >= 0; --k)
      out += static_cast<char>(value >> static_cast<unsigned>(8 * k) & 0xffU);
    return out;
  }
  static std::string real(double value) {
    if (value == 0) return std::string(8, '\0');
    int exponent = 64;
    double fraction = std::abs(value);
    for (; fraction >= 1; fraction /= 16) ++exponent;
    for (; fraction < 1.0 / 16; fraction *= 16) --exponent;
    const auto bits = static_cast<std::uint64_t>(std::ldexp(fraction, 56));
    return big_endian((value < 0 ? std::uint64_t{1} << 63U : 0) |
                          static_cast<std::uint64_t>(exponent) << 56U | bits,
                      8);
  }

  std::string bytes_;
};

}  // namespace cover::testing
