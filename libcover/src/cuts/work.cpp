// Tested by tests/unit/cuts/boxes/cut_negative_couplings_test.cpp and
// tests/unit/cuts/after_meshing/thin_cuts_test.cpp.
#include "cuts/work.hpp"

#include <utility>

#include "cuts/cut_segments.hpp"
#include "quality/measure_again.hpp"
#include "region/whole_mesh.hpp"
#include "tasks/mesh_regions.hpp"

namespace cover {

Result<std::vector<std::size_t>> mesh_changed(Work& work, std::vector<RegionBoundary> boundaries,
                                              const Options& options, const Callbacks& callbacks) {
  std::vector<std::size_t> changed;
  std::vector<RegionBoundary> again;
  for (std::size_t r = 0; r < boundaries.size(); ++r) {
    if (boundaries[r].vertices == work.boundaries[r].vertices) continue;
    changed.push_back(r);
    again.push_back(boundaries[r]);
  }
  Result<std::vector<RegionMesh>> meshes = mesh_regions(again, options, callbacks);
  if (!meshes) return std::move(meshes).error();
  for (std::size_t k = 0; k < changed.size(); ++k)
    work.meshes[changed[k]] = std::move((*meshes)[k]);
  work.boundaries = std::move(boundaries);
  return changed;
}

void measure_again(Work& work, const Options& options, Unreached why) {
  for (std::size_t r = 0; r < work.meshes.size(); ++r)
    measure_again(work.boundaries[r], options, why, work.meshes[r]);
}

bool is_sound(const Work& work) {
  // Cuts may be too near to each other, or rounded to beyond what faces them.
  if (!triangulate_whole(work.pslg).conflicts.empty()) return false;
  for (std::size_t r = 0; r < work.meshes.size(); ++r)
    if (find_flaw(work.boundaries[r], work.meshes[r])) return false;
  return true;
}

}  // namespace cover
