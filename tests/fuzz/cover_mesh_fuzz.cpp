// Small geometry from bytes through the whole pipeline: a mesh that keeps every promise, or an
// error that is not ours.
//
// Bytes: a method, a power of two for the unit, a number of points; a pair of bytes per point, on a
// grid of 16 x 16, whose upper nibbles move it off by up to 15 ulps; then a pair of bytes per
// segment.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

namespace {

/// Takes bytes from the front.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  [[nodiscard]] bool empty() const { return left_ == 0; }
  int next() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

double coordinate(int byte, double unit) {
  double x = 1 + byte % 16;
  for (int k = 0; k < byte / 16; ++k) x = std::nextafter(x, 100.0);
  return x * unit;
}

cover::Input decode(Bytes& bytes) {
  const double unit = std::ldexp(1.0, bytes.next() - 128);
  const auto points = static_cast<std::uint32_t>(3 + bytes.next() % 30);
  cover::Input input;
  input.source = "fuzz";
  for (std::uint32_t k = 0; k < points; ++k) {
    const double x = coordinate(bytes.next(), unit);
    input.points.push_back({x, coordinate(bytes.next(), unit)});
  }
  while (!bytes.empty() && input.segments.size() < 60) {
    cover::InputSegment segment;
    segment.a = static_cast<std::uint32_t>(bytes.next()) % points;
    segment.b = static_cast<std::uint32_t>(bytes.next()) % points;
    segment.id = static_cast<long>(input.segments.size());
    input.segments.push_back(segment);
  }
  return input;
}

/// Each method, by its own name: what fills between almonds counts with that method only.
void choose_method(int byte, cover::Options& options) {
  constexpr int kMethods = 6;
  switch (byte % kMethods) {
    case 0:
      options.method = cover::Method::almond;
      break;
    case 1:
      options.method = cover::Method::quality;
      break;
    case 2:
      options.method = cover::Method::almond;
      options.fill = cover::Fill::disks;
      break;
    case 3:
      options.method = cover::Method::nonobtuse;
      break;
    case 4:
      options.method = cover::Method::almond;
      options.paper = true;
      break;
    default:
      options.box_method = true;
  }
}

[[noreturn]] void fail(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  cover::Options options;
  options.threads = 1;
  choose_method(bytes.next(), options);
  const cover::Input input = decode(bytes);
  const auto output = cover::cover_mesh(input, options);
  if (!output) {
    if (output.error().code == cover::ErrorCode::internal) fail(output.error().message);
    return 0;
  }
  // Where a region is below resolution the report says so, and the bound may not hold.
  cover::VerifyOptions verify;
  verify.bound = !options.paper;
  for (const auto& region : output->report.regions)
    for (const auto& note : region.notes)
      verify.bound &= note.kind != cover::Note::Kind::below_resolution;
  const auto found =
      cover::verify_cover(output->pslg, output->table, cover::triangle_soup(output->mesh), verify);
  if (!found.violations.empty()) fail(found.violations.front().message);
  return 0;
}
