// Tested by tests/unit/clean/paint/paint_test.cpp.
#include "region/gaps/gaps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <cover/text.hpp>

#include "faces/face_measures.hpp"
#include "geom/box.hpp"
#include "geom/vector.hpp"
#include "region/gaps/open_gaps.hpp"

namespace cover {
namespace {

/// A void is thin where its area is less than this part of the area of the circle with its
/// perimeter. A strip of 1 : 30 has 0.1, the lens between an arc of 20 degrees and its chord 0.09.
constexpr double kThin = 0.1;

/// Nor is a void an error of drawing that is as wide as this part of the polygons beside it: 20 m
/// between lots of 50 m are a street.
constexpr double kStreet = 0.2;

/// What is known of a void from the segments around it.
struct Void {
  double perimeter = 0;
  std::uint32_t seed = 0;   ///< of a region beside it
  bool is_between = false;  ///< there are others beside it
};

bool is_thin(double area, double perimeter) {
  return area <= kThin * perimeter * perimeter / (4 * std::numbers::pi);
}

/// Voids that are so many times as wide as the next narrower ones are meant: errors of drawing have
/// one size.
constexpr double kMeant = 8;

/// Welding moves no end by more than the shortest line there divided by this (clean/ends/weld.hpp).
constexpr double kHeldBack = 8;

/// A thin void, as wide as a strip of its area and perimeter.
struct Gap {
  double width = 0;
  double area = 0;
  Point where;
  bool is_open = false;  ///< a part of a wider void

  friend auto operator<=>(const Gap&, const Gap&) = default;
};

/// Leaves out the gaps, sorted by width, above the widest step between two widths, if it is wide.
/// What is meant is not most of them: few gaps that rounding made do not excuse hundreds of others.
/// Returns: how many they were
std::size_t leave_out_meant(std::vector<Gap>& gaps) {
  std::size_t first = gaps.size();
  double widest_step = kMeant;
  for (std::size_t k = std::max<std::size_t>((gaps.size() + 1) / 2, 1); k < gaps.size(); ++k) {
    if (gaps[k].width < widest_step * gaps[k - 1].width) continue;
    widest_step = gaps[k].width / gaps[k - 1].width;
    first = k;
  }
  const std::size_t meant = gaps.size() - first;
  gaps.resize(first);
  return meant;
}

/// A tolerance of welding that closes voids of a width, with one digit: what is found of widths is
/// about half too little, and corners that are to be one lie farther apart than borders, by as much
/// along them as across. (Of 32 tilings with corners off by as much everywhere, 29 close at once;
/// with half of it 14.)
double tolerance_above(double width, double extent) {
  constexpr double kCorners = 4;
  const double relative = kCorners * width / extent;
  const double unit = std::pow(10, std::floor(std::log10(relative)));
  return std::ceil(relative / unit) * unit;
}

/// By face; of one that is no void, its perimeter counts alone.
std::vector<Void> voids_of(const Pslg& pslg, const Faces& faces) {
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
  return voids;
}

/// For each void one by the width of the polygons beside it, their mean along its walls.
std::vector<double> per_width_beside(const Pslg& pslg, const Faces& faces,
                                     const FacesBeside& beside) {
  std::vector<double> per_width(faces.count, 0), walls(faces.count, 0);
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment& segment = pslg.segments[s];
    const double piece = length(pslg.points[segment.b.index()] - pslg.points[segment.a.index()]);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t face = faces.of_segment[s][k], behind = faces.of_segment[s][1 - k];
      if (beside.owner[face] != 0 || beside.owner[behind] == 0) continue;
      per_width[face] += piece / beside.width[behind];
      walls[face] += piece;
    }
  }
  for (std::size_t f = 0; f < faces.count; ++f)
    if (walls[f] > 0) per_width[f] /= walls[f];
  return per_width;
}

/// Thin voids between polygons, and thin parts of wider ones.
struct Thin {
  std::vector<Gap> gaps;
  std::size_t meant = 0;  ///< voids as wide as streets; narrower parts may be among the gaps
};

Thin find_thin(const Pslg& pslg, const Faces& faces, const SeededFaces& seeded,
               std::span<const Void> voids) {
  std::vector<bool> is_between(faces.count);
  for (std::size_t f = 0; f < faces.count; ++f)
    is_between[f] = seeded.is_void[f] && voids[f].is_between;
  if (std::find(is_between.begin(), is_between.end(), true) == is_between.end()) return {};
  const std::vector<FaceMeasure> measures = measure_faces(faces);
  FacesBeside beside;
  for (std::size_t f = 0; f < faces.count; ++f) {
    beside.width.push_back(2 * measures[f].area / voids[f].perimeter);
    const bool is_polygon = !seeded.is_void[f] && seeded.seed[f];
    beside.owner.push_back(is_polygon ? static_cast<std::uint32_t>(*seeded.seed[f]) + 1 : 0);
  }
  const auto is_thin_void = [&](std::size_t f) {
    return f != kOutside && is_between[f] && is_thin(measures[f].area, voids[f].perimeter);
  };
  beside.is_looked_at = is_between;
  Thin thin;
  std::vector<bool> is_of_two_widths(faces.count);
  for (const OpenGap& gap : open_gaps(faces, beside)) {
    // Streets among narrow gaps that open to them are thin as a whole as well.
    if (is_thin_void(gap.face) && gap.width() * kMeant > beside.width[gap.face]) continue;
    if (!is_thin(gap.area, gap.length)) continue;
    thin.gaps.push_back({gap.width(), gap.area, gap.where, true});
    is_of_two_widths[gap.face] = true;
  }
  const std::vector<double> per_width = per_width_beside(pslg, faces, beside);
  for (std::size_t f = kOutside + 1; f < faces.count; ++f) {
    if (!is_thin_void(f)) continue;
    if (is_of_two_widths[f] || beside.width[f] * per_width[f] > kStreet) {
      ++thin.meant;
    } else {
      thin.gaps.push_back({beside.width[f], measures[f].area,
                           measures[f].inside.value_or(measures[f].smallest_side.first), false});
    }
  }
  return thin;
}

/// What to do about gaps of which `widest` is the widest.
std::string advice(double widest, double extent, double weld) {
  const double tolerance = tolerance_above(widest, extent);
  if (!(tolerance > weld)) return "; --weld is held back there by the shortest lines";
  return fmt::format(
      ", or close gaps of this width with --weld {:.0e}, which is held back beside "
      "lines shorter than {}",
      tolerance, describe_roughly(kHeldBack * tolerance * extent));
}

}  // namespace

void warn_of_gaps(const Pslg& pslg, const Faces& faces, const SeededFaces& seeded, double weld,
                  std::vector<Note>& notes) {
  if (pslg.side_seeds.empty()) return;
  Thin thin = find_thin(pslg, faces, seeded, voids_of(pslg, faces));
  std::vector<Gap>& found = thin.gaps;
  if (found.empty()) return;
  std::sort(found.begin(), found.end());
  const std::size_t meant = thin.meant + leave_out_meant(found);
  const double widest = found.back().width;
  // The largest first.
  std::sort(found.begin(), found.end(), [](const Gap& a, const Gap& b) {
    return a.area != b.area ? a.area > b.area : a.where < b.where;
  });
  double area = 0;
  std::size_t open = 0;
  std::vector<Point> where;
  for (const Gap& gap : found) {
    area += gap.area;
    open += gap.is_open ? 1 : 0;
    where.push_back(gap.where);
  }
  notes.push_back(
      {Note::Kind::warning, kVoid,
       fmt::format(
           "polygons leave {} between them{}, with an area of {} together, the largest at {}{}: "
           "where a common border is drawn in two ways, let one polygon run on below the other{}",
           counted(where.size(), "thin void"),
           open == 0              ? std::string()
           : open == where.size() ? std::string(", open at an end")
                                  : fmt::format(", {} of them open at an end", open),
           describe_roughly(area), describe(where.front()),
           meant == 0
               ? std::string()
               : fmt::format(" ({} far wider {})", meant,
                             meant == 1 ? "one is taken as meant" : "ones are taken as meant"),
           advice(widest, box_of(pslg.points).extent(), weld)),
       std::move(where)});
}

}  // namespace cover
