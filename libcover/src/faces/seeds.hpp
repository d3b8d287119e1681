// What the seeds of a PSLG say about its faces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <cover/pslg.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

#include "faces/face_measures.hpp"
#include "faces/faces.hpp"

namespace cover {

/// By face: whether it is void, and the region seed that speaks for it.
struct SeededFaces {
  std::vector<bool> is_void;
  std::vector<std::optional<std::size_t>> seed;  ///< index into Pslg::seeds; the first of several
  std::vector<std::optional<double>> size;       ///< the smallest that a seed wishes
  /// Void, or regions without a name, for want of any seed; where Pslg::seeds_may_miss.
  std::vector<std::uint32_t> missed;
};

/// Finds the faces of all seeds and decides which faces are void.
///
/// Repeated seeds are told in `notes`.
/// Errors: seed_on_segment, seed_in_void, conflicting_seeds, each with all its seeds.
/// Cost:   O(seeds * sqrt(n)) typically.
Result<SeededFaces> apply_seeds(const Pslg& pslg, const Faces& faces, std::vector<Note>& notes);

/// What faces without a seed are: void, or regions that no label of a drawing names, or no region
/// of a .poly.
enum class MissedFaces { are_void, lack_label, lack_region };

/// Tells of faces that may want a seed, all of one kind. Left out are those that are too thin for
/// one.
void warn_of_missed_faces(std::vector<std::uint32_t> missed, MissedFaces kind,
                          const std::vector<FaceMeasure>& measures, std::vector<Note>& notes);

}  // namespace cover
