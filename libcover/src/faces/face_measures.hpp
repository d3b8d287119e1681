// Area, an inner point and the place in the geometric order of every face.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <cover/point.hpp>
#include <cover/report.hpp>

#include "base/team.hpp"
#include "faces/faces.hpp"

namespace cover {

/// Figures of one face.
struct FaceMeasure {
  double area = 0;
  std::optional<Point> inside;            ///< strictly inside; none where no double is
  std::pair<Point, Point> smallest_side;  ///< of the sides with the face on their left
};

/// Measures all faces; what is said of the outside is meaningless.
///
/// `area` is a compensated sum; `inside` is checked with exact predicates. A face that is found to
/// hold no double but on its triangulation's edges gets a point there.
/// Cost: O(n).
std::vector<FaceMeasure> measure_faces(const Faces& faces, const Team& team = {});

/// Tells that `what`, a face, has no place inside.
void warn_of_sliver(const std::string& what, const FaceMeasure& measure, std::vector<Note>& notes);

}  // namespace cover
