#include "io/images/image_borders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "geom/curves/smooth_chain.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"
#include "support/inputs/soups.hpp"

namespace cover {
namespace {

LabelImage image_of(std::size_t width, std::size_t height,
                    const std::function<std::uint32_t(std::size_t, std::size_t)>& label) {
  LabelImage image{width, height, {}, {}};
  std::uint32_t most = 0;
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      image.labels.push_back(label(x, y));
      most = std::max(most, image.labels.back());
    }
  for (std::uint32_t k = 0; k <= most; ++k) image.names.push_back({"m" + std::to_string(k), false});
  return image;
}

/// Which region each pixel is of, by flooding; -1 for void. Regions in the order of their first
/// pixels.
std::vector<int> flooded(const LabelImage& image, int& count) {
  const auto w = static_cast<int>(image.width), h = static_cast<int>(image.height);
  std::vector<int> of(image.labels.size(), -1);
  count = 0;
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * w + x); };
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      if (of[index(x, y)] >= 0 || image.names[image.labels[index(x, y)]].is_void) continue;
      std::vector<std::pair<int, int>> open{{x, y}};
      of[index(x, y)] = count;
      while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        for (const auto& [u, v] : {std::pair(i + 1, j), {i - 1, j}, {i, j + 1}, {i, j - 1}}) {
          if (u < 0 || v < 0 || u >= w || v >= h || of[index(u, v)] >= 0) continue;
          if (image.labels[index(u, v)] != image.labels[index(i, j)]) continue;
          of[index(u, v)] = count;
          open.emplace_back(u, v);
        }
      }
      ++count;
    }
  }
  return of;
}

/// Pairs of regions that touch along a side; -1 is the void.
using Contacts = std::set<std::pair<int, int>>;

struct Truth {
  int regions = 0;
  std::vector<int> of;
  Contacts contacts;
  std::map<int, std::vector<std::pair<Point, Point>>> sides;  ///< of pixels, by region
};

Truth truth_of(const LabelImage& image) {
  Truth truth;
  truth.of = flooded(image, truth.regions);
  const auto w = static_cast<int>(image.width), h = static_cast<int>(image.height);
  const auto at = [&](int x, int y) {
    return x < 0 || y < 0 || x >= w || y >= h ? -1 : truth.of[static_cast<std::size_t>(y * w + x)];
  };
  const auto add = [&](int a, int b, Point p, Point q) {
    if (a == b) return;
    truth.contacts.insert(std::minmax(a, b));
    for (const int r : {a, b}) truth.sides[r].emplace_back(p, q);
  };
  for (int y = 0; y <= h; ++y)
    for (int x = 0; x <= w; ++x) {
      const Point here{double(x), double(y)};
      add(at(x, y), at(x - 1, y), here, {x + 0.0, y + 1.0});
      add(at(x, y), at(x, y - 1), here, {x + 1.0, y + 0.0});
    }
  return truth;
}

double distance_to_all(Point p, const std::vector<std::pair<Point, Point>>& sides) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : sides) nearest = std::min(nearest, distance_to_segment(p, a, b));
  return nearest;
}

void expect_equal_topology(const LabelImage& image, const ImageBorders& borders,
                           const Truth& truth) {
  ASSERT_EQ(borders.polygons.size(), static_cast<std::size_t>(truth.regions));
  Input input;
  input.polygons = borders.polygons;
  const Result<testing::Cleaned> cleaned = testing::clean(input);
  ASSERT_TRUE(cleaned) << cleaned.error().message;
  EXPECT_TRUE(cleaned->report.changes.empty()) << cleaned->report.changes[0].message;
  ASSERT_EQ(cleaned->table.regions.size(), static_cast<std::size_t>(truth.regions));
  Contacts contacts;
  for (const SegmentSides& sides : cleaned->table.sides) {
    const auto region = [](RegionId id) {
      return id == kVoid ? -1 : static_cast<int>(id.value()) - 1;
    };
    contacts.insert(std::minmax(region(sides.left), region(sides.right)));
  }
  EXPECT_EQ(contacts, truth.contacts);
  for (int r = 0; r < truth.regions; ++r)
    EXPECT_EQ(cleaned->table.regions[static_cast<std::size_t>(r)].material_name,
              image
                  .names[image.labels[static_cast<std::size_t>(
                      std::find(truth.of.begin(), truth.of.end(), r) - truth.of.begin())]]
                  .name);
}

void expect_near(const ImageBorders& borders, const Truth& truth) {
  for (int r = 0; r < truth.regions; ++r) {
    std::vector<std::pair<Point, Point>> curve;
    for (const auto& ring : borders.polygons[static_cast<std::size_t>(r)].rings)
      for (std::size_t k = 0; k < ring.size(); ++k)
        curve.emplace_back(ring[k], ring[(k + 1) % ring.size()]);
    double most = 0;
    for (const auto& [a, b] : curve) most = std::max(most, distance_to_all(a, truth.sides.at(r)));
    for (const auto& [a, b] : truth.sides.at(r)) most = std::max(most, distance_to_all(a, curve));
    EXPECT_LE(most, kMostMoved) << r;
  }
}

void expect_right(const LabelImage& image) {
  const Truth truth = truth_of(image);
  for (const bool smooth : {false, true}) {
    const Result<ImageBorders> borders = borders_of(image, smooth, "i");
    ASSERT_TRUE(borders);
    expect_equal_topology(image, *borders, truth);
    if (smooth) expect_near(*borders, truth);
    if (smooth) continue;
    for (int r = 0; r < truth.regions; ++r) {
      double doubled = 0;
      for (const auto& ring : borders->polygons[static_cast<std::size_t>(r)].rings)
        for (std::size_t k = 0; k < ring.size(); ++k)
          doubled += cross(ring[k] - Point{}, ring[(k + 1) % ring.size()] - Point{});
      EXPECT_EQ(doubled / 2, std::count(truth.of.begin(), truth.of.end(), r));
    }
  }
}

TEST(ImageBorders, OnePixelAndOneRegion) {
  expect_right(image_of(1, 1, [](auto, auto) { return 0; }));
  expect_right(image_of(7, 3, [](auto, auto) { return 0; }));
  const Result<ImageBorders> one =
      borders_of(image_of(7, 3, [](auto, auto) { return 0; }), true, "i");
  EXPECT_EQ(one->polygons[0].rings,
            (std::vector<std::vector<Point>>{{{0, 0}, {7, 0}, {7, 3}, {0, 3}}}));
}

TEST(ImageBorders, EveryPictureOfThreeByThreePixels) {
  // Of up to three labels, the first one void in some.
  std::mt19937 random(1);
  for (int k = 0; k < 300; ++k) {
    LabelImage image =
        image_of(3, 3, [&](auto, auto) { return static_cast<std::uint32_t>(random() % 3); });
    image.names.resize(3);
    for (std::uint32_t n = 0; n < 3; ++n) image.names[n].name = "m" + std::to_string(n);
    image.names[0].is_void = k % 2 == 0;
    if (std::all_of(image.labels.begin(), image.labels.end(), [](auto l) { return l == 0; }))
      continue;
    SCOPED_TRACE(k);
    expect_right(image);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(ImageBorders, RandomPictures) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const std::uint32_t labels = 2 + seed % 4;
    if (seed % 3 == 0) {  // noise
      expect_right(image_of(
          17, 13, [&](auto, auto) { return static_cast<std::uint32_t>(random() % labels); }));
    } else {  // cells around points; with few labels, some hang together
      std::vector<Point> centres;
      const std::size_t count = seed % 3 == 1 ? 12 : 60;
      for (std::size_t k = 0; k < count; ++k)
        centres.push_back(
            {static_cast<double>(random() % 400) / 10, static_cast<double>(random() % 400) / 10});
      LabelImage image = image_of(40, 40, [&](std::size_t x, std::size_t y) {
        const Point p{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < count; ++k)
          if (length(p - centres[k]) < length(p - centres[nearest])) nearest = k;
        return static_cast<std::uint32_t>(nearest % labels);
      });
      image.names[0].is_void = seed % 2 == 0;
      expect_right(image);
    }
    if (::testing::Test::HasFailure()) return;
  }
}

/// Curves that run beside each other a pixel apart, and lines of one pixel.
TEST(ImageBorders, ThinThings) {
  expect_right(image_of(60, 60, [](std::size_t x, std::size_t y) {
    const double r = std::hypot(static_cast<double>(x) - 30, static_cast<double>(y) - 29.5);
    return static_cast<std::uint32_t>(r) % 2;
  }));
  expect_right(image_of(
      40, 40, [](std::size_t x, std::size_t y) { return x == y || x + y == 37 ? 1U : 0U; }));
  expect_right(image_of(
      40, 12, [](std::size_t x, std::size_t y) { return (x + 5 * y) % 11 < 2 ? 1U : 0U; }));
}

TEST(ImageBorders, JunctionsStay) {
  const LabelImage image = image_of(30, 30, [](std::size_t x, std::size_t y) {
    return x + y / 3 < 14 ? 0U : y < 11 + x / 5 ? 1U : 2U;
  });
  const Truth truth = truth_of(image);
  std::map<Point, std::set<int>> around;
  const auto at = [&](int x, int y) {
    return x < 0 || y < 0 || x >= 30 || y >= 30 ? -1
                                                : truth.of[static_cast<std::size_t>(y * 30 + x)];
  };
  const Result<ImageBorders> borders = borders_of(image, true, "i");
  std::set<Point> points;
  for (const InputPolygon& polygon : borders->polygons)
    for (const auto& ring : polygon.rings) points.insert(ring.begin(), ring.end());
  int junctions = 0;
  for (int y = 0; y <= 30; ++y)
    for (int x = 0; x <= 30; ++x) {
      const std::set<int> beside{at(x, y), at(x - 1, y), at(x, y - 1), at(x - 1, y - 1)};
      if (beside.size() < 3) continue;
      ++junctions;
      EXPECT_TRUE(points.contains({double(x), double(y)}));
    }
  EXPECT_EQ(junctions, 4);
}

TEST(ImageBorders, PhotographsAreRefused) {
  std::mt19937 random(1);
  const LabelImage noise =
      image_of(900, 900, [&](auto, auto) { return static_cast<std::uint32_t>(random() % 50); });
  EXPECT_EQ(borders_of(noise, true, "i").error().code, ErrorCode::unsupported_format);
}

}  // namespace
}  // namespace cover
