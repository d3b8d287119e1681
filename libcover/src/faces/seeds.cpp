// See seeds.hpp.
#include "faces/seeds.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>

#include <cover/text.hpp>

#include "base/faults/complaint.hpp"
#include "cdt/search/locate.hpp"
#include "faces/beyond_chords.hpp"
#include "geom/spatial_order.hpp"

namespace cover {
namespace {

/// Finds faces; a seed on a segment or at its end has none.
class FaceFinder {
 public:
  FaceFinder(const Pslg& pslg, const Faces& faces)
      : faces_(faces), locator_(faces.triangulation), ends_segment_(pslg.points.size()) {
    for (const Segment& s : pslg.segments) {
      ends_segment_[s.a.index()] = true;
      ends_segment_[s.b.index()] = true;
    }
  }

  std::optional<std::uint32_t> face_at(Point p) {
    const Location at = locator_.locate(p);
    if (at.kind == Location::Kind::outside) return kOutside;
    const Triangle& f = faces_.triangulation.triangles[at.triangle];
    if (at.kind == Location::Kind::on_edge && f.is_locked(at.index)) return {};
    if (at.kind == Location::Kind::on_vertex &&
        ends_segment_[f.v[static_cast<std::size_t>(at.index)]]) {
      return {};
    }
    return faces_.of_triangle[at.triangle];
  }

 private:
  const Faces& faces_;
  Locator locator_;
  std::vector<bool> ends_segment_;
};

/// A text of a drawing has no number there.
std::string name_of_text(std::string_view words, const std::string& layer, Point at) {
  return fmt::format("the text '{}' of layer {} at {}", words, layer, describe(at));
}

std::string name_of_seed(const RegionSeed& s) {
  // A label of a layout is the region alone.
  std::string words = s.material;
  if (!s.region.empty()) words += (words.empty() ? "" : "/") + s.region;
  if (!s.label_layer.empty()) return name_of_text(words, s.label_layer, s.at);
  if (!words.empty()) words = " '" + words + "'";
  return fmt::format("region seed {}{} at {}{}", s.id, words, describe(s.at), line_suffix(s.line));
}
std::string name_of_seed(const HoleSeed& s) {
  if (!s.label_layer.empty()) return name_of_text("void", s.label_layer, s.at);
  return fmt::format("hole seed {} at {}{}", s.id, describe(s.at), line_suffix(s.line));
}

InputRef ref_of(const RegionSeed& s) { return {InputKind::region_seed, s.id}; }
InputRef ref_of(const HoleSeed& s) { return {InputKind::hole, s.id}; }

/// The faces of some seeds, or a complaint about those on segments.
template <class Seed>
std::vector<std::uint32_t> faces_of(const std::vector<Seed>& seeds, FaceFinder& finder,
                                    const BeyondChords& beyond, Complaint& complaint) {
  std::vector<Point> places;
  places.reserve(seeds.size());
  for (const Seed& seed : seeds) places.push_back(seed.at);
  std::vector<std::optional<std::uint32_t>> found(seeds.size());
  // From each seed to one nearby: short walks.
  for (const std::uint32_t k : spatial_order(places)) found[k] = finder.face_at(places[k]);
  std::vector<std::uint32_t> out;
  out.reserve(seeds.size());
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    if (!found[k]) {
      const bool is_chord = beyond.holds(places[k], {});
      complaint.add(name_of_seed(seeds[k]) + " lies on a segment" +
                        (is_chord ? fmt::format(", the chord of an arc: {}", kFinerChords) : ""),
                    {places[k]}, {ref_of(seeds[k])});
    }
    out.push_back(found[k].value_or(kOutside));
  }
  return out;
}

std::vector<bool> find_void(const Pslg& pslg, const Faces& faces,
                            const std::vector<std::uint32_t>& hole_faces,
                            const std::vector<std::uint32_t>& seed_faces) {
  std::vector<bool> is_void(faces.count, false);
  if (pslg.void_rule == VoidRule::unseeded_faces && !pslg.seeds.empty()) {
    // Open faces have faces of their own only where the hull is the domain: they are meshed.
    for (std::size_t f = 0; f < faces.count; ++f) is_void[f] = !faces.open[f];
    for (const std::uint32_t f : seed_faces) is_void[f] = false;
  }
  for (const std::uint32_t f : hole_faces) is_void[f] = true;
  is_void[kOutside] = true;
  return is_void;
}

/// Two seeds of one face agree if what both say is the same.
bool agree(const RegionSeed& a, const RegionSeed& b) {
  return (a.material == b.material) &&
         (a.region == b.region || a.region.empty() || b.region.empty());
}

/// Which of two seeds are beyond a chord; empty: neither.
std::string_view which_of(bool first, bool second) {
  if (first && second) return "both lie";
  if (first) return "the first lies";
  return second ? "the second lies" : "";
}

/// Behind what is wrong with seeds.
std::string about_chords(std::string_view which) {
  if (which.empty()) return "";
  return fmt::format(" ({} between an arc and its chord: {})", which, kFinerChords);
}

void complain_of_conflict(const RegionSeed& first, const RegionSeed& second, std::string_view which,
                          Complaint& complaint) {
  complaint.add(
      fmt::format("{} and {} are in the same face but disagree on its {}{}", name_of_seed(first),
                  name_of_seed(second), first.material != second.material ? "material" : "region",
                  about_chords(which)),
      {first.at, second.at}, {ref_of(first), ref_of(second)});
}

/// A name that got to the wrong side of a chord, where nothing else speaks against it.
void warn_of_seeds_beyond_chords(const Pslg& pslg, const std::vector<bool>& is_beyond,
                                 std::vector<Note>& notes) {
  std::string first;
  std::vector<Point> where;
  for (std::size_t k = 0; k < is_beyond.size(); ++k) {
    if (!is_beyond[k]) continue;
    if (where.empty()) first = name_of_seed(pslg.seeds[k]);
    where.push_back(pslg.seeds[k].at);
  }
  if (where.empty()) return;
  const bool is_one = where.size() == 1;
  notes.push_back(
      {Note::Kind::warning, kVoid,
       fmt::format("{}{} between an arc and its chord, and {} for what is beyond the "
                   "chord; {}",
                   first, is_one ? " lies" : fmt::format(" and {} more lie", where.size() - 1),
                   is_one ? "holds" : "hold", kFinerChords),
       std::move(where)});
}

/// Takes the faces over from what the PSLG says of its sides.
SeededFaces take_sides(const Pslg& pslg, const Faces& faces) {
  SeededFaces out;
  out.seed.resize(faces.count);
  out.size.resize(faces.count);
  for (std::size_t f = 0; f < faces.count; ++f) out.is_void.push_back(!faces.open[f]);
  out.is_void[kOutside] = true;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t face = faces.of_segment[s][k], seed = pslg.side_seeds[s][k];
      if (seed == 0 || face == kOutside) continue;
      out.is_void[face] = false;
      out.seed[face] = seed - 1;
      out.size[face] = pslg.seeds[seed - 1].size;
    }
  }
  return out;
}

void warn_of_outer_holes(const Pslg& pslg, const std::vector<std::uint32_t>& hole_faces,
                         std::vector<Note>& notes) {
  for (std::size_t k = 0; k < pslg.holes.size(); ++k) {
    if (hole_faces[k] != kOutside) continue;
    notes.push_back(
        {Note::Kind::warning,
         kVoid,
         name_of_seed(pslg.holes[k]) + " lies outside of all segments: it makes nothing void",
         {pslg.holes[k].at}});
  }
}

/// Closed faces with neither a hole's seed nor a region's.
std::vector<std::uint32_t> faces_without_seed(const Faces& faces,
                                              const std::vector<std::uint32_t>& hole_faces,
                                              const std::vector<std::uint32_t>& seed_faces) {
  std::vector<bool> is_marked(faces.count, false);
  for (const std::uint32_t f : hole_faces) is_marked[f] = true;
  for (const std::uint32_t f : seed_faces) is_marked[f] = true;
  std::vector<std::uint32_t> found;
  for (std::uint32_t f = kOutside + 1; f < faces.count; ++f)
    if (!is_marked[f] && !faces.open[f]) found.push_back(f);
  return found;
}

}  // namespace

Result<SeededFaces> apply_seeds(const Pslg& pslg, const Faces& faces, std::vector<Note>& notes) {
  if (!pslg.side_seeds.empty()) return take_sides(pslg, faces);
  FaceFinder finder(pslg, faces);
  const BeyondChords beyond(pslg, faces);
  Complaint on_segment(ErrorCode::seed_on_segment, pslg.source);
  const auto hole_faces = faces_of(pslg.holes, finder, beyond, on_segment);
  const auto seed_faces = faces_of(pslg.seeds, finder, beyond, on_segment);
  if (!on_segment.empty()) return on_segment.error();

  warn_of_outer_holes(pslg, hole_faces, notes);
  SeededFaces out;
  out.is_void = find_void(pslg, faces, hole_faces, seed_faces);
  if (pslg.seeds_may_miss && !pslg.seeds.empty())
    out.missed = faces_without_seed(faces, hole_faces, seed_faces);
  out.seed.resize(faces.count);
  out.size.resize(faces.count);
  Complaint in_void(ErrorCode::seed_in_void, pslg.source);
  Complaint conflict(ErrorCode::conflicting_seeds, pslg.source);
  std::vector<bool> is_beyond;
  for (std::size_t k = 0; k < pslg.seeds.size(); ++k)
    is_beyond.push_back(beyond.holds(pslg.seeds[k].at, seed_faces[k]));
  for (std::size_t k = 0; k < pslg.seeds.size(); ++k) {
    const RegionSeed& seed = pslg.seeds[k];
    const std::uint32_t face = seed_faces[k];
    if (out.is_void[face]) {
      in_void.add(
          name_of_seed(seed) +
              (face == kOutside ? " lies outside of all segments, or what is around it is open"
                                : " lies in a hole") +
              about_chords(is_beyond[k] ? "it lies" : ""),
          {seed.at}, {ref_of(seed)});
      continue;
    }
    if (seed.size) out.size[face] = std::min(*seed.size, out.size[face].value_or(*seed.size));
    if (!out.seed[face]) {
      out.seed[face] = k;
      continue;
    }
    const RegionSeed& first = pslg.seeds[*out.seed[face]];
    if (agree(first, seed)) {
      notes.push_back({Note::Kind::warning,
                       kVoid,
                       fmt::format("{} repeats {}", name_of_seed(seed), name_of_seed(first)),
                       {seed.at}});
      if (first.region.empty() && !seed.region.empty()) out.seed[face] = k;
    } else {
      complain_of_conflict(first, seed, which_of(is_beyond[*out.seed[face]], is_beyond[k]),
                           conflict);
    }
  }
  if (!in_void.empty()) return in_void.error();
  if (!conflict.empty()) return conflict.error();
  warn_of_seeds_beyond_chords(pslg, is_beyond, notes);
  return out;
}

void warn_of_missed_faces(std::vector<std::uint32_t> missed, MissedFaces kind,
                          const std::vector<FaceMeasure>& measures, std::vector<Note>& notes) {
  std::erase_if(missed, [&](std::uint32_t f) { return !measures[f].inside; });
  if (missed.empty()) return;
  std::sort(missed.begin(), missed.end(), [&](std::uint32_t f, std::uint32_t g) {
    return std::pair(-measures[f].area, measures[f].smallest_side) <
           std::pair(-measures[g].area, measures[g].smallest_side);
  });
  std::vector<Point> where;
  for (const std::uint32_t f : missed) where.push_back(*measures[f].inside);
  const bool is_one = missed.size() == 1;
  const std::string faces = counted(missed.size(), "closed face") + (is_one ? " has" : " have");
  const std::string place = (is_one ? "at " : "the largest at ") + describe(where.front());
  std::string message =
      kind == MissedFaces::are_void
          ? fmt::format(
                "{} neither a region nor a hole given inside, {}: left void; a region "
                "meshes it, a hole says that it is meant",
                faces, place)
          : fmt::format("{} no {} inside, {} with an area of {:.6g}: {} 'unnamed'", faces,
                        kind == MissedFaces::lack_label ? "label" : "region given", place,
                        measures[missed.front()].area, is_one ? "it is" : "they are");
  notes.push_back({Note::Kind::warning, kVoid, std::move(message), std::move(where)});
}

}  // namespace cover
