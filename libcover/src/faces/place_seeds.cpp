// See place_seeds.hpp.
#include "faces/place_seeds.hpp"

#include <algorithm>
#include <utility>

#include "faces/faces.hpp"
#include "faces/seeds.hpp"

namespace cover {

Result<Pslg> place_seeds(const Input& input, Pslg pslg, std::vector<Note>& notes) {
  std::vector<IndexPair> pairs;
  for (const Segment& s : pslg.segments) pairs.push_back({s.a.value(), s.b.value()});
  const Faces faces = find_faces(pslg.points, pairs, false);
  // What the seeds alone say, found by their places.
  const auto side_seeds = std::exchange(pslg.side_seeds, {});
  auto polygon_seeds = std::exchange(pslg.seeds, input.seeds);
  pslg.holes = input.holes;
  Result<SeededFaces> seeded = apply_seeds(pslg, faces, notes);
  if (!seeded) return std::move(seeded).error();

  std::vector<std::uint32_t> of_face(faces.count, 0);  // what `side_seeds` has
  for (std::size_t s = 0; s < side_seeds.size(); ++s) {
    for (std::size_t k = 0; k < 2; ++k) of_face[faces.of_segment[s][k]] = side_seeds[s][k];
  }
  pslg.seeds = std::move(polygon_seeds);
  pslg.holes.clear();
  std::vector<std::pair<std::size_t, std::size_t>> seeds;  // with their faces, in order
  for (std::size_t f = 1; f < faces.count; ++f) {
    if (seeded->is_void[f]) of_face[f] = 0;
    if (seeded->seed[f]) seeds.emplace_back(*seeded->seed[f], f);
  }
  std::sort(seeds.begin(), seeds.end());
  for (const auto& [k, f] : seeds) {
    RegionSeed seed = input.seeds[k];
    seed.size = seeded->size[f];
    if (of_face[f] != 0) {
      const RegionSeed& polygon = pslg.seeds[of_face[f] - 1];
      const bool same = seed.material.empty() || seed.material == polygon.material;
      if (same) seed.material = polygon.material;
      if (same && seed.region.empty()) seed.region = polygon.region;
      if (same && polygon.size)
        seed.size = std::min(*polygon.size, seed.size.value_or(*polygon.size));
    }
    pslg.seeds.push_back(std::move(seed));
    of_face[f] = static_cast<std::uint32_t>(pslg.seeds.size());
  }
  of_face[kOutside] = 0;
  pslg.side_seeds.resize(side_seeds.size());
  for (std::size_t s = 0; s < side_seeds.size(); ++s) {
    const auto [left, right] = faces.of_segment[s];
    pslg.side_seeds[s] = {of_face[left], of_face[right]};
  }
  return pslg;
}

}  // namespace cover
