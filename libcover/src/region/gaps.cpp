// Tested by tests/unit/clean/paint_test.cpp.
#include "region/gaps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/describe.hpp"
#include "faces/face_measures.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// A void is thin where its area is less than this part of the area of the circle with its
/// perimeter. A strip of 1 : 30 has 0.1, the lens between an arc of 20 degrees and its chord 0.09.
constexpr double kThin = 0.1;

/// What is known of a void from the segments around it.
struct Void {
  double perimeter = 0;
  std::uint32_t seed = 0;   ///< of a region beside it
  bool is_between = false;  ///< there are others beside it
};

/// A tolerance of welding that is certainly above a width, with one digit: what is found of widths
/// is about half too little.
double tolerance_above(double width, const std::vector<Point>& points) {
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double relative = 2 * width / std::max(high.x - low.x, high.y - low.y);
  const double unit = std::pow(10, std::floor(std::log10(relative)));
  return std::ceil(relative / unit) * unit;
}

}  // namespace

void warn_of_gaps(const Pslg& pslg, const Faces& faces, const SeededFaces& seeded,
                  std::vector<Note>& notes) {
  if (pslg.side_seeds.empty()) return;
  std::vector<Void> voids(faces.count);
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment& segment = pslg.segments[s];
    const double piece = length(pslg.points[segment.b.index()] - pslg.points[segment.a.index()]);
    for (std::size_t k = 0; k < 2; ++k) {
      Void& v = voids[faces.of_segment[s][k]];
      const std::uint32_t beside = pslg.side_seeds[s][1 - k];
      v.perimeter += piece;
      v.is_between |= v.seed != 0 && beside != 0 && beside != v.seed;
      if (beside != 0) v.seed = beside;
    }
  }
  const auto is_gap = [&](std::size_t f) { return seeded.is_void[f] && voids[f].is_between; };
  std::size_t gaps = 0;
  for (std::size_t f = 1; f < faces.count; ++f) gaps += is_gap(f);
  if (gaps == 0) return;
  const std::vector<FaceMeasure> measures = measure_faces(faces);
  double area = 0, largest = 0, widest = 0;
  std::vector<Point> where;
  for (std::size_t f = 1; f < faces.count; ++f) {
    const Void& v = voids[f];
    const double round = v.perimeter * v.perimeter / (4 * std::numbers::pi);
    if (!is_gap(f) || measures[f].area > kThin * round) continue;
    area += measures[f].area;
    widest = std::max(widest, 2 * measures[f].area / v.perimeter);  // that of a strip
    where.push_back(measures[f].inside.value_or(measures[f].smallest_side.first));
    if (measures[f].area > largest) {
      largest = measures[f].area;
      std::swap(where.front(), where.back());
    }
  }
  if (where.empty()) return;
  notes.push_back({Note::Kind::warning, kVoid,
                   fmt::format("polygons leave {} between them, with an area of {} together, the "
                               "largest at {}: where a common border is drawn in two ways, let one "
                               "polygon run on below the other, or close gaps of this width with "
                               "--weld {:.0e}",
                               counted(where.size(), "thin void"), describe_roughly(area),
                               describe(where.front()), tolerance_above(widest, pslg.points)),
                   std::move(where)});
}

}  // namespace cover
