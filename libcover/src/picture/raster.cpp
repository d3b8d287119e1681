// Every pixel is sampled 3 x 3 times and averaged at the end. Triangles are thus seamless (a sample
// lies in one of them), which a coverage per triangle would not give.
// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/raster.hpp"

#include <algorithm>
#include <cmath>

#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr int kSamples = 3;

class Painter {
 public:
  explicit Painter(const Drawing& drawing) : drawing_(drawing) {
    fine_.width = drawing.width * kSamples;
    fine_.height = drawing.height * kSamples;
    fine_.rgb.assign(
        3 * static_cast<std::size_t>(fine_.width) * static_cast<std::size_t>(fine_.height), 255);
  }

  void operator()(const PaintedPatch& patch) {
    clip_to(patch.clipped);
    for (const auto& t : patch.triangles) polygon(t, patch.colour, 1);
  }

  void operator()(const Stroke& stroke) {
    clip_to(stroke.clipped);
    for (const auto& [a, b] : stroke.lines) line(a, b, stroke);
  }

  void operator()(const Ring& ring) {
    clip_to(false);
    const Point c = fine(ring.centre);
    const double r = ring.radius * kSamples, half = ring.width * kSamples / 2;
    const int reach = static_cast<int>(std::ceil(r + half));
    for (int y = static_cast<int>(c.y) - reach; y <= static_cast<int>(c.y) + reach; ++y) {
      for (int x = static_cast<int>(c.x) - reach; x <= static_cast<int>(c.x) + reach; ++x) {
        if (std::abs(length(Point{x + 0.5, y + 0.5} - c) - r) <= half) dot(x, y, ring.colour, 1);
      }
    }
  }

  void operator()(const Label&) {}

  [[nodiscard]] Image averaged() const {
    Image image{drawing_.width, drawing_.height, {}};
    image.rgb.resize(3 * static_cast<std::size_t>(image.width) *
                     static_cast<std::size_t>(image.height));
    const auto row = 3 * static_cast<std::size_t>(fine_.width);
    std::size_t out = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
          unsigned sum = 0;
          for (int dy = 0; dy < kSamples; ++dy) {
            for (int dx = 0; dx < kSamples; ++dx) {
              sum += fine_.rgb[static_cast<std::size_t>(y * kSamples + dy) * row +
                               3 * static_cast<std::size_t>(x * kSamples + dx) + channel];
            }
          }
          image.rgb[out++] = static_cast<std::uint8_t>((sum + 4) / (kSamples * kSamples));
        }
      }
    }
    return image;
  }

 private:
  static Point fine(Point p) { return {p.x * kSamples, p.y * kSamples}; }

  void clip_to(bool plot) {
    const PixelBox& b = drawing_.plot;
    x0_ = plot ? static_cast<int>(std::lround(b.x0 * kSamples)) : 0;
    y0_ = plot ? static_cast<int>(std::lround(b.y0 * kSamples)) : 0;
    x1_ = plot ? static_cast<int>(std::lround(b.x1 * kSamples)) : fine_.width;
    y1_ = plot ? static_cast<int>(std::lround(b.y1 * kSamples)) : fine_.height;
  }

  void dot(int x, int y, Colour colour, double share) {
    if (x >= x0_ && x < x1_ && y >= y0_ && y < y1_) fine_.blend(x, y, colour, share);
  }

  /// Fills a convex polygon: every sample whose centre is inside.
  template <std::size_t N>
  void polygon(const std::array<Point, N>& corners, Colour colour, double share) {
    std::array<Point, N> p;
    std::transform(corners.begin(), corners.end(), p.begin(), fine);
    double low = p[0].y, high = p[0].y;
    for (const Point q : p) {
      low = std::min(low, q.y);
      high = std::max(high, q.y);
    }
    const int first = std::max(y0_, static_cast<int>(std::ceil(std::max(low, -1.0) - 0.5)));
    const double last = std::min(high - 0.5, y1_ - 1.0);
    for (int y = first; y <= last; ++y) {
      double left = fine_.width, right = -1;
      for (std::size_t i = 0; i < N; ++i) {
        const Point a = p[i], b = p[(i + 1) % N];
        const double at = y + 0.5;
        if ((a.y <= at) == (b.y <= at)) continue;
        const double x = a.x + (at - a.y) / (b.y - a.y) * (b.x - a.x);
        left = std::min(left, x);
        right = std::max(right, x);
      }
      const int from = static_cast<int>(std::ceil(std::max(left, x0_ + 0.0) - 0.5));
      const double to = std::min(right - 0.5, x1_ - 1.0);
      for (int x = std::max(from, x0_); x < to; ++x) fine_.blend(x, y, colour, share);
    }
  }

  /// A bar with square ends; what is thinner than a sample is drawn one sample wide and paler.
  void line(Point a, Point b, const Stroke& stroke) {
    const double width = std::max(stroke.width, 1.0 / kSamples);
    const double share = stroke.opacity * stroke.width / width;
    const Vector along = b - a;
    const double len = length(along);
    if (len <= 0) return;
    // Wide lines reach half a width beyond their ends, so that bends have no gap.
    const Vector u = stroke.width >= 1 ? width / 2 / len * along : Vector{};
    const Vector n = width / 2 / len * left_normal(along);
    const Vector back{-u.x, -u.y}, right{-n.x, -n.y};
    polygon(std::array<Point, 4>{a + back + n, a + back + right, b + u + right, b + u + n},
            stroke.colour, share);
  }

  const Drawing& drawing_;
  Image fine_;
  int x0_ = 0, y0_ = 0, x1_ = 0, y1_ = 0;
};

}  // namespace

void Image::blend(int x, int y, Colour colour, double share) {
  if (x < 0 || y < 0 || x >= width || y >= height) return;
  std::uint8_t* at = &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x))];
  const auto mix = [&](std::uint8_t& c, std::uint8_t to) {
    c = static_cast<std::uint8_t>(std::lround(c + share * (to - c)));
  };
  mix(at[0], colour.r);
  mix(at[1], colour.g);
  mix(at[2], colour.b);
}

Image paint(const Drawing& drawing) {
  Painter painter(drawing);
  for (const DrawingItem& item : drawing.items) std::visit(painter, item);
  return painter.averaged();
}

}  // namespace cover
