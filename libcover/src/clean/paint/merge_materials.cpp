// Tested by tests/unit/clean/soup_test.cpp.
#include "clean/paint/merge_materials.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <cover/text.hpp>

#include "base/containers/union_find.hpp"
#include "faces/face_measures.hpp"
#include "faces/faces.hpp"
#include "faces/materials.hpp"
#include "faces/seeds.hpp"

namespace cover {
namespace {

std::vector<IndexPair> pairs_of(const Pslg& pslg) {
  std::vector<IndexPair> pairs;
  for (const Segment& s : pslg.segments) pairs.push_back({s.a.value(), s.b.value()});
  return pairs;
}

/// By face: its seed plus one, 0 for the void. Faces without a seed get one that is added to the
/// PSLG: a face of the material that unseeded faces have.
std::vector<std::uint32_t> seeds_by_face(const Faces& faces, const SeededFaces& seeded,
                                         Pslg& pslg) {
  std::vector<std::uint32_t> out(faces.count, 0);
  std::vector<Note> told_later;
  const auto unnamed = std::to_string(number_materials(pslg.seeds, told_later).unnamed);
  std::uint32_t extra = 0;
  for (std::size_t f = 1; f < faces.count; ++f) {
    if (seeded.is_void[f]) continue;
    if (seeded.seed[f]) {
      out[f] = static_cast<std::uint32_t>(*seeded.seed[f] + 1);
      continue;
    }
    if (extra == 0) {
      RegionSeed seed;
      seed.at = measure_faces(faces)[f].inside.value_or(Point{});
      seed.material = unnamed;
      seed.region = "unnamed";
      pslg.seeds.push_back(std::move(seed));
      extra = static_cast<std::uint32_t>(pslg.seeds.size());
    }
    out[f] = extra;
  }
  return out;
}

/// Tells of named segments that alone keep faces apart, as borders between layers of a drawing.
template <class AreApart>
void tell_of_names(const Pslg& pslg, const Faces& faces, AreApart are_apart, Report& report) {
  std::size_t count = 0;
  std::optional<std::size_t> first;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const auto [left, right] = faces.of_segment[s];
    if (pslg.segments[s].name == 0 || !are_apart(left, right)) continue;
    if (!first) first = s;
    ++count;
  }
  if (!first) return;
  const Segment& segment = pslg.segments[*first];
  const Point a = pslg.points[segment.a.index()], b = pslg.points[segment.b.index()];
  report.notes.push_back(
      {Note::Kind::warning,
       kVoid,
       fmt::format("{} one material on both sides and {} for the name, so regions are not merged "
                   "there: the first, '{}', is from {} to {}",
                   counted(count, "segment") + (count == 1 ? " has" : " have"),
                   count == 1 ? "stays" : "stay", pslg.names[segment.name], describe(a),
                   describe(b)),
       {a, b}});
}

}  // namespace

Result<Pslg> merge_materials(Pslg pslg, Report& report) {
  const Faces faces = find_faces(pslg.points, pairs_of(pslg), false);
  std::vector<Note> told_later;
  const Result<SeededFaces> seeded = apply_seeds(pslg, faces, told_later);
  if (!seeded) return seeded.error();
  std::vector<std::uint32_t> seed = seeds_by_face(faces, *seeded, pslg);

  // By number: a number may be spelled in two ways.
  const std::vector<std::int32_t> number = number_materials(pslg.seeds, told_later).numbers;
  const auto same_material = [&](std::uint32_t x, std::uint32_t y) {
    if (x == 0 || y == 0) return false;
    const auto has_none = [&](std::uint32_t z) { return pslg.seeds[z - 1].material.empty(); };
    return x == y || (!has_none(x) && !has_none(y) && number[x - 1] == number[y - 1]);
  };
  UnionFind united(faces.count);
  std::vector<std::uint32_t> first_seed = seed;  // by face that stands for its set
  std::vector<std::size_t> kept;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const auto [left, right] = faces.of_segment[s];
    const Segment& segment = pslg.segments[s];
    if (left == right || segment.name != 0 || !same_material(seed[left], seed[right])) {
      kept.push_back(s);
      continue;
    }
    const std::uint32_t first =
        std::min(first_seed[united.find(left)], first_seed[united.find(right)]);
    united.unite(left, right);
    first_seed[united.find(left)] = first;
    const Point a = pslg.points[segment.a.index()], b = pslg.points[segment.b.index()];
    report.changes.push_back(
        {Change::Kind::merged,
         fmt::format("the segment between {} and {} has material '{}' on both sides", describe(a),
                     describe(b), pslg.seeds[seed[left] - 1].material),
         {a, b},
         {{InputKind::segment, segment.id}}});
  }
  tell_of_names(
      pslg, faces,
      [&](std::uint32_t left, std::uint32_t right) {
        return same_material(seed[left], seed[right]) && united.find(left) != united.find(right);
      },
      report);
  std::vector<Segment> segments;
  pslg.side_seeds.clear();
  for (const std::size_t s : kept) {
    segments.push_back(pslg.segments[s]);
    const auto [left, right] = faces.of_segment[s];
    pslg.side_seeds.push_back({first_seed[united.find(left)], first_seed[united.find(right)]});
  }
  pslg.segments = std::move(segments);
  return pslg;
}

}  // namespace cover
