// Faces come from one triangulation of everything (faces.hpp); seeds decide which are void and what
// the others are made of; then regions are numbered and every segment and point is told what lies
// beside it.
// Tested by tests/unit/region/region_graph_test.cpp.
#include "region/region_graph.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include <cover/option_ranges.hpp>
#include <cover/text.hpp>

#include "base/containers/union_find.hpp"
#include "base/numbers.hpp"
#include "clean/ends/loose_ends.hpp"
#include "faces/face_measures.hpp"
#include "faces/faces.hpp"
#include "faces/materials.hpp"
#include "faces/seeds.hpp"
#include "geom/box.hpp"
#include "region/gaps/gaps.hpp"
#include "region/gaps/near_misses.hpp"
#include "region/interfaces.hpp"

namespace cover {
namespace {

/// The faces that are regions in the order of their ids: those with seeds in the order of the
/// seeds, then the others in geometric order.
std::vector<std::uint32_t> faces_in_order(const Pslg& pslg, const SeededFaces& seeded,
                                          const std::vector<FaceMeasure>& measures) {
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 1; f < seeded.is_void.size(); ++f) {
    if (!seeded.is_void[f]) faces.push_back(f);
  }
  const auto place = [&](std::uint32_t f) {
    return std::pair(seeded.seed[f].value_or(pslg.seeds.size()), measures[f].smallest_side);
  };
  std::sort(faces.begin(), faces.end(),
            [&](std::uint32_t f, std::uint32_t g) { return place(f) < place(g); });
  return faces;
}

/// Fills a RegionTable step by step.
class TableMaker {
 public:
  TableMaker(const Pslg& pslg, const Faces& faces, const SeededFaces& seeded)
      : pslg_(pslg), faces_(faces), seeded_(seeded), region_of_face_(faces.count) {}

  TriangulatedTable make(std::vector<Note>& notes, const Team& team) {
    add_regions(number_materials(pslg_.seeds, notes), team, notes);
    add_attributes();
    add_sides();
    std::vector<TriangulatedRegion> triangulated;
    // What each of them fills in is no other's.
    team.each(3, [&](std::size_t k) {
      if (k == 0) {
        build_interfaces(pslg_, table_);
      } else if (k == 1) {
        add_hull_sides();
        add_points();
      } else {
        warn_of_lines_in_void(notes);
        triangulated = triangulated_regions();
      }
    });
    warn_of_points_in_void(notes);
    return {std::move(table_), std::move(triangulated)};
  }

 private:
  [[nodiscard]] std::vector<TriangulatedRegion> triangulated_regions() const {
    std::vector<std::size_t> count(faces_.count, 0);
    for (const std::uint32_t face : faces_.of_triangle) ++count[face];
    std::vector<std::size_t> place(faces_.count, kNone);
    std::vector<TriangulatedRegion> regions;
    for (std::size_t f = 1; f < faces_.count; ++f) {
      if (region_of_face_[f] == kVoid) continue;
      place[f] = regions.size();
      regions.push_back({region_of_face_[f], {}});
      regions.back().triangles.reserve(count[f]);
    }
    for (std::size_t t = 0; t < faces_.of_triangle.size(); ++t) {
      const std::size_t k = place[faces_.of_triangle[t]];
      if (k != kNone) regions[k].triangles.push_back(faces_.triangulation.triangles[t].v);
    }
    return regions;
  }

  void add_regions(const Materials& materials, const Team& team, std::vector<Note>& notes) {
    const std::vector<FaceMeasure> measures = measure_faces(faces_, team);
    for (const std::uint32_t face : faces_in_order(pslg_, seeded_, measures)) {
      Region region;
      region.id = region_of_face_[face] = RegionId{table_.regions.size() + 1};
      if (const auto seed = seeded_.seed[face]) {
        region.material = materials.numbers[*seed];
        region.material_name = materials.names[*seed];
        region.name = pslg_.seeds[*seed].region;
        features_.push_back(pslg_.seeds[*seed].feature);
      } else {
        region.material = materials.unnamed;
        region.material_name = "unnamed";
        features_.push_back(0);
      }
      if (region.name.empty()) region.name = region.material_name;
      region.inside = measures[face].inside;
      region.area = measures[face].area;
      region.size = seeded_.size[face];
      if (!region.inside)
        warn_of_sliver(fmt::format("region '{}'", region.name), measures[face], notes);
      table_.regions.push_back(std::move(region));
    }
    for (std::size_t f = 1; f < faces_.count; ++f) {
      if (!seeded_.is_void[f]) continue;
      if (measures[f].inside) {
        table_.void_seeds.push_back(*measures[f].inside);
      } else {
        warn_of_sliver("a void", measures[f], notes);
      }
    }
    const bool has_labels =
        std::any_of(pslg_.seeds.begin(), pslg_.seeds.end(),
                    [](const RegionSeed& seed) { return !seed.label_layer.empty(); });
    const MissedFaces kind = pslg_.void_rule == VoidRule::unseeded_faces ? MissedFaces::are_void
                             : has_labels                                ? MissedFaces::lack_label
                                                                         : MissedFaces::lack_region;
    warn_of_missed_faces(seeded_.missed, kind, measures, notes);
  }

  /// What the features of the regions have.
  void add_attributes() {
    for (const Attribute& attribute : pslg_.attributes) {
      Attribute& own = table_.attributes.emplace_back(attribute);
      own.values.clear();
      for (const std::uint32_t feature : features_) {
        own.values.push_back(feature != 0        ? attribute.values[feature - 1]
                             : attribute.is_text ? 0
                                                 : kNoNumber);
      }
    }
  }

  /// Counts a side of `region`.
  void count_side(RegionId region) {
    if (region != kVoid) ++table_.region(region).sides;
  }

  void add_sides() {
    table_.sides.resize(pslg_.segments.size());
    for (std::size_t s = 0; s < pslg_.segments.size(); ++s) {
      SegmentSides& sides = table_.sides[s];
      sides.left = region_of_face_[faces_.of_segment[s][0]];
      sides.right = region_of_face_[faces_.of_segment[s][1]];
      count_side(sides.left);
      count_side(sides.right);
      if (sides.left == kVoid && sides.right == kVoid) table_.void_segments.emplace_back(s);
    }
  }

  /// Names the contacts, and with them the lines of the input, that do not come to bound anything.
  void warn_of_lines_in_void(std::vector<Note>& notes) const {
    std::vector<std::size_t> pieces(pslg_.names.size(), 0), in_void(pieces);
    std::vector<std::vector<Point>> where(pieces.size());
    for (const Segment& s : pslg_.segments) ++pieces[s.name];
    for (const SegmentId id : table_.void_segments) {
      const Segment& s = pslg_.segments[id.index()];
      if (in_void[s.name]++ == 0) {
        where[s.name] = {pslg_.points[s.a.index()], pslg_.points[s.b.index()]};
      }
    }
    for (std::size_t name = 1; name < pieces.size(); ++name) {
      if (in_void[name] == 0) continue;
      const std::string part = in_void[name] == pieces[name]
                                   ? "wholly in the void"
                                   : fmt::format("in the void with {} of its {}", in_void[name],
                                                 counted(pieces[name], "segment"));
      notes.push_back(
          {Note::Kind::warning, kVoid,
           fmt::format("'{}' lies {} and is left out there, first from {} to {}", pslg_.names[name],
                       part, describe(where[name][0]), describe(where[name][1])),
           std::move(where[name])});
    }
  }

  /// Tells of points that are drawn for themselves, as the wells of a map.
  void warn_of_points_in_void(std::vector<Note>& notes) const {
    if (table_.void_points.empty()) return;
    std::vector<bool> is_end(pslg_.points.size(), false);
    for (const Segment& s : pslg_.segments) is_end[s.a.index()] = is_end[s.b.index()] = true;
    std::vector<Point> where;
    for (const VertexId v : table_.void_points)
      if (!is_end[v.index()]) where.push_back(pslg_.points[v.index()]);
    if (where.empty()) return;
    const auto name = std::find_if(
        pslg_.named_points.begin(), pslg_.named_points.end(),
        [&](const NamedPoint& p) { return pslg_.points[p.vertex.index()] == where[0]; });
    std::string message =
        fmt::format("{} in the void and {} left out, the first{} at {}",
                    counted(where.size(), "point") + (where.size() == 1 ? " lies" : " lie"),
                    where.size() == 1 ? "is" : "are",
                    name == pslg_.named_points.end() ? "" : fmt::format(", '{}',", name->name),
                    describe(where.front()));
    notes.push_back({Note::Kind::warning, kVoid, std::move(message), std::move(where)});
  }

  void add_hull_sides() {
    for (std::size_t t = 0; t < faces_.of_triangle.size(); ++t) {
      const RegionId region = region_of_face_[faces_.of_triangle[t]];
      const Triangle& f = faces_.triangulation.triangles[t];
      for (const Corner i : kCorners) {
        if (region == kVoid || f.is_locked(i) || f.n[i] != kNone) continue;
        table_.hull_sides.push_back({VertexId{f.v[i.next()]}, VertexId{f.v[i.previous()]}, region});
        count_side(region);
      }
    }
  }

  void add_points() {
    std::vector<bool> on_segment(pslg_.points.size(), false);
    for (const Segment& s : pslg_.segments) {
      on_segment[s.a.index()] = true;
      on_segment[s.b.index()] = true;
    }
    for (const HullSide& s : table_.hull_sides) {
      on_segment[s.a.index()] = true;
      on_segment[s.b.index()] = true;
    }
    std::vector<RegionId> touched(pslg_.points.size());  // a region that each point touches
    for (std::size_t t = 0; t < faces_.of_triangle.size(); ++t) {
      const RegionId region = region_of_face_[faces_.of_triangle[t]];
      if (region == kVoid) continue;
      for (const std::uint32_t v : faces_.triangulation.triangles[t].v) touched[v] = region;
    }
    for (std::size_t v = 0; v < touched.size(); ++v) {
      if (touched[v] == kVoid) {
        table_.void_points.emplace_back(v);
      } else if (!on_segment[v]) {
        table_.isolated_points.push_back({VertexId{v}, touched[v]});
      }
    }
  }

  const Pslg& pslg_;
  const Faces& faces_;
  const SeededFaces& seeded_;
  std::vector<RegionId> region_of_face_;  ///< kVoid for void faces
  std::vector<std::uint32_t> features_;   ///< by region: RegionSeed::feature
  RegionTable table_;
};

Error nothing_enclosed(const Pslg& pslg, const char* what) {
  return {
      ErrorCode::nothing_enclosed, pslg.source.empty() ? what : pslg.source + ": " + what, {}, {}};
}

/// Gaps of at most this part of the drawing's size are named where lines are left out.
constexpr double kNamedGap = 0x1p-7;

/// "; only one segment ends at point 1 at (0, 0) and at point 4 at (0, 1)": where an outline is
/// open. Their places are appended to `where`, what they are in the input to `inputs`. Looks at the
/// points of `looked_at`.
std::string open_ends(const Pslg& pslg, const std::vector<bool>& looked_at,
                      std::vector<Point>& where, std::vector<InputRef>& inputs) {
  std::vector<std::size_t> degree(pslg.points.size(), 0);
  for (const Segment& s : pslg.segments) {
    ++degree[s.a.index()];
    ++degree[s.b.index()];
  }
  std::vector<std::string> names;
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (degree[v] != 1 || !looked_at[v]) continue;
    const std::string place = describe(pslg.points[v]);
    where.push_back(pslg.points[v]);
    if (pslg.point_ids[v] < 0) {
      names.push_back(place);
      continue;
    }
    names.push_back(fmt::format("point {} at {}", pslg.point_ids[v], place));
    inputs.push_back({InputKind::point, pslg.point_ids[v]});
  }
  if (names.empty()) return {};
  std::string out = "; only one segment ends at " + names[0];
  if (names.size() == 2) out += " and at " + names[1];
  if (names.size() > 2)
    out += fmt::format(", and so at {}", counted(names.size() - 1, "more point"));
  return out;
}

/// The gaps of at most `reach` beside loose ends that `looked_at` has.
std::vector<LooseGap> gaps_beside(const Pslg& pslg, std::span<const IndexPair> segments,
                                  const std::vector<bool>& looked_at, double reach) {
  std::vector<LooseGap> gaps = find_loose_gaps(pslg.points, segments, reach);
  std::erase_if(gaps, [&](const LooseGap& gap) { return !looked_at[gap.loose]; });
  return gaps;
}

/// "2 ends of lines nearly meet another, the first at (0, 1), 1e-09 away"
std::string nearly_meet(const Pslg& pslg, const std::vector<LooseGap>& gaps) {
  return fmt::format("{} of lines nearly meet{} another, the first at {}, {} away",
                     counted(gaps.size(), "end"), gaps.size() == 1 ? "s" : "",
                     describe(pslg.points[gaps[0].loose]), describe_roughly(gaps[0].distance));
}

/// What --weld takes for gaps in a drawing so large.
std::string weld_for(const std::vector<LooseGap>& gaps, double extent) {
  double widest = 0;
  for (const LooseGap& gap : gaps) widest = std::max(widest, gap.distance / extent);
  return weld_closing(widest);
}

Box box_of_ends(const Pslg& pslg, std::span<const IndexPair> segments) {
  Box box;
  for (const IndexPair& segment : segments) {
    for (const std::uint32_t v : segment) box.add(pslg.points[v]);
  }
  return box;
}

/// "1 segment encloses", "3 segments enclose".
std::string enclosing(std::size_t n) {
  return counted(n, "segment") + (n == 1 ? " encloses" : " enclose");
}

/// Segments in the void: an error where their ends nearly meet, as what is left of a drawing whose
/// lines miss each other, unless welding was decided upon; else a warning of open ends. Lines with
/// names are told of one by one.
std::optional<Error> tell_open(const Pslg& pslg, std::span<const IndexPair> segments,
                               const RegionTable& table, const Options& options,
                               std::vector<Note>& notes) {
  if (table.void_segments.empty() || !pslg.side_seeds.empty()) return std::nullopt;
  std::vector<bool> in_void(pslg.points.size(), false), unnamed(in_void);
  std::size_t count = 0;
  for (const SegmentId s : table.void_segments) {
    const bool has_name = pslg.segments[s.index()].name != 0;
    count += has_name ? 0 : 1;
    for (const std::uint32_t v : segments[s.index()]) {
      in_void[v] = true;
      if (!has_name) unnamed[v] = true;
    }
  }
  const double extent = box_of_ends(pslg, segments).extent();
  if (!options.weld) {
    const std::vector<LooseGap> small = gaps_beside(pslg, segments, in_void, kSmallGap * extent);
    if (!small.empty())
      return Error{ErrorCode::nothing_enclosed,
                   fmt::format("{}{} nothing, and {}: {} closes such gaps, --weld off meshes what "
                               "is closed",
                               pslg.source.empty() ? "" : pslg.source + ": ",
                               enclosing(table.void_segments.size()), nearly_meet(pslg, small),
                               weld_for(small, extent)),
                   {pslg.points[small[0].loose], pslg.points[small[0].other]},
                   {}};
  }
  Note note{Note::Kind::warning, kVoid, {}, {}};
  std::vector<InputRef> ends;
  const std::string open = open_ends(pslg, unnamed, note.where, ends);
  if (open.empty()) return std::nullopt;
  note.message = fmt::format("{} nothing and {} out of the mesh{}", enclosing(count),
                             count == 1 ? "stays" : "stay", open);
  const std::vector<LooseGap> gaps = gaps_beside(pslg, segments, unnamed, kNamedGap * extent);
  if (!gaps.empty())
    note.message +=
        fmt::format("; {} ({} closes such gaps)", nearly_meet(pslg, gaps), weld_for(gaps, extent));
  notes.push_back(std::move(note));
  return std::nullopt;
}

/// Whether enough different points for a triangle are left once gaps are closed.
bool leave_a_triangle(const std::vector<LooseGap>& gaps, std::size_t points) {
  UnionFind joined(points);
  for (const LooseGap& gap : gaps) joined.unite(gap.loose, gap.other);
  std::size_t left = 0;
  for (std::uint32_t v = 0; v < points; ++v) left += joined.find(v) == v ? 1 : 0;
  return left >= 3;
}

/// Gaps that keep outlines open.
void tell_gaps(const Pslg& pslg, std::span<const IndexPair> segments, Error& error) {
  const double extent = box_of_ends(pslg, segments).extent();
  const std::vector<LooseGap> gaps = find_loose_gaps(pslg.points, segments, kNamedGap * extent);
  if (!gaps.empty() && leave_a_triangle(gaps, pslg.points.size()))
    error.message +=
        fmt::format("; {}: {} closes such gaps", nearly_meet(pslg, gaps), weld_for(gaps, extent));
}

/// What might mesh it after all.
void tell_remedies(const Pslg& pslg, std::span<const IndexPair> segments, Error& error) {
  tell_gaps(pslg, segments, error);
  if (pslg.points.size() > 2) error.message += "; --hull meshes the convex hull around them";
}

}  // namespace

Result<TriangulatedTable> build_triangulated_table(const Pslg& pslg, const Options& options,
                                                   std::vector<Note>& notes,
                                                   std::optional<Triangulation> whole,
                                                   const Team& team) {
  std::vector<IndexPair> pairs;
  pairs.reserve(pslg.segments.size());
  for (const Segment& s : pslg.segments) pairs.push_back({s.a.value(), s.b.value()});
  const Faces faces = whole ? faces_of(*std::move(whole), pairs, options.hull, team)
                            : find_faces(pslg.points, pairs, options.hull);
  if (faces.of_triangle.empty()) {
    Error error = nothing_enclosed(pslg, pslg.points.size() < 3
                                             ? "there are fewer than three different points"
                                             : "all points lie on one line");
    if (options.weld.value_or(0) > 0) error.message += " after welding (--weld)";
    return error;
  }
  const auto with_near_misses = [&](Error error) {
    error.message += near_misses_behind(pslg, faces.triangulation);
    return error;
  };
  if (faces.count == 1) {
    Error error = nothing_enclosed(pslg, "the segments enclose nothing");
    error.message +=
        open_ends(pslg, std::vector<bool>(pslg.points.size(), true), error.where, error.inputs);
    tell_remedies(pslg, pairs, error);
    return with_near_misses(std::move(error));
  }
  Result<SeededFaces> seeded = apply_seeds(pslg, faces, notes);
  if (!seeded) {
    Error error = seeded.error();
    if (error.code == ErrorCode::seed_in_void) tell_gaps(pslg, pairs, error);
    return with_near_misses(std::move(error));
  }
  if (std::all_of(seeded->is_void.begin(), seeded->is_void.end(), [](bool v) { return v; })) {
    return nothing_enclosed(pslg, "the hole seeds leave no region");
  }
  TriangulatedTable made;
  std::vector<Note> of_gaps, of_table;
  team.each(3, [&](std::size_t k) {
    if (k == 0) {
      made = TableMaker(pslg, faces, *seeded).make(of_table, team);
    } else if (k == 1) {
      warn_of_near_misses(pslg, faces, seeded->is_void, team, notes);
    } else {
      warn_of_gaps(pslg, faces, *seeded, options.weld.value_or(kAutoWeld), of_gaps);
    }
  });
  for (std::vector<Note>* some : {&of_gaps, &of_table})
    std::move(some->begin(), some->end(), std::back_inserter(notes));
  if (auto error = tell_open(pslg, pairs, made.table, options, notes)) return *std::move(error);
  return made;
}

Result<RegionTable> build_region_table(const Pslg& pslg, const Options& options,
                                       std::vector<Note>& notes) {
  Result<TriangulatedTable> made = build_triangulated_table(pslg, options, notes, std::nullopt);
  if (!made) return std::move(made).error();
  return std::move(made->table);
}

}  // namespace cover
