// Seeds that are on the wrong side of a chord: a drawing has them on the other side of its arc.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <cover/point.hpp>
#include <cover/pslg.hpp>

#include "faces/faces.hpp"
#include "geom/search/box_tree.hpp"

namespace cover {

/// The chords of arcs, and what lies between both.
class BeyondChords {
 public:
  /// REQUIRES: `faces` are those of `pslg`; both outlive this object
  BeyondChords(const Pslg& pslg, const Faces& faces);

  /// Whether a place in `face`, none where it lies on a segment, lies between an arc and its chord,
  /// with no other segment between it and the chord's face.
  [[nodiscard]] bool holds(Point p, std::optional<std::uint32_t> face) const;

 private:
  const Pslg& pslg_;
  const Faces& faces_;
  std::vector<std::uint32_t> chords_;  ///< segments
  BoxTree boxes_;                      ///< around them and their arcs
};

/// What mends that.
inline constexpr const char* kFinerChords =
    "finer chords mend that (a smaller --chord-angle or --chord-error of DXF, chord_error of JSON)";

}  // namespace cover
