// A clean PSLG is taken over as it is. Anything else goes through the stages of a network:
//
//   gather -> weld, cut -> paint polygons -> drop what is hidden -> assemble -> seeds over polygons
//
// Before all that, arcs get ends of chords where they touch, where other lines end on them, and
// where their chords would cross those of arcs beside them.
// Even-odd parity is kept by every stage, so it is enough to count it at the end, on the very edges
// that are handed on: no face is lost or doubled by rounding.
// Tested by tests/unit/clean/pslg_test.cpp and soup_test.cpp.
#include "clean/pslg.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/core.h>

#include <cover/option_ranges.hpp>
#include <cover/text.hpp>

#include "base/faults/complaint.hpp"
#include "base/faults/machine_memory.hpp"
#include "base/words/and_more.hpp"
#include "clean/arcs/crossing_chords.hpp"
#include "clean/arcs/meet_arcs.hpp"
#include "clean/arcs/touching_arcs.hpp"
#include "clean/change_report.hpp"
#include "clean/check_input.hpp"
#include "clean/check_pslg.hpp"
#include "clean/ends/loose_ends.hpp"
#include "clean/ends/weld.hpp"
#include "clean/network.hpp"
#include "clean/node_edges.hpp"
#include "clean/paint/assemble.hpp"
#include "clean/paint/hidden_polygons.hpp"
#include "clean/paint/merge_materials.hpp"
#include "clean/paint/paint.hpp"
#include "clean/paint/visible_edges.hpp"
#include "clean/remember_arcs.hpp"
#include "faces/place_seeds.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

void take_over_points(const Input& input, Pslg& pslg) {
  pslg.points = input.points;
  pslg.point_ids.reserve(input.points.size());
  for (std::size_t k = 0; k < input.points.size(); ++k) {
    pslg.point_ids.push_back(point_id(input, k));
  }
  pslg.point_markers = input.point_markers;
  pslg.point_markers.resize(input.points.size());
  for (const PointName& name : input.point_names)
    pslg.named_points.push_back({VertexId{name.point}, name.name});
}

void take_over_segments(const Input& input, Pslg& pslg) {
  std::map<std::string, std::uint32_t> name_index{{"", 0}};
  auto name = name_index.begin();
  pslg.segments.reserve(input.segments.size());
  for (const InputSegment& s : input.segments) {
    if (s.name != name->first) {  // mostly it is that of the segment before
      const auto next = static_cast<std::uint32_t>(pslg.names.size());
      name = name_index.try_emplace(s.name, next).first;
      if (name->second == next) pslg.names.push_back(s.name);
    }
    pslg.segments.push_back({VertexId{s.a}, VertexId{s.b}, s.marker, name->second, s.id});
  }
}

double weld_of(const Input& input, const Options& options) {
  return options.weld.value_or(input.polygons.empty() ? 0 : kAutoWeld);
}

/// The points and segments of a clean input.
Pslg take_over(const Input& input, const Team& team) {
  Pslg pslg;
  pslg.source = input.source;
  team.each(2, [&](std::size_t k) {
    if (k == 0) {
      take_over_segments(input, pslg);
    } else {
      take_over_points(input, pslg);
    }
  });
  pslg.seeds = input.seeds;
  pslg.holes = input.holes;
  pslg.void_rule = input.void_rule;
  pslg.seeds_may_miss = input.seeds_may_miss;
  return pslg;
}

/// What is seen of polygons: its graph, whose its edges are, and Painting::sizes.
struct Painted {
  EdgeGraph graph;
  std::vector<EdgeOwners> owners;
  std::vector<std::optional<double>> sizes;
};

/// Drops what other polygons hide and makes the graph of the rest, which `network` is then.
Result<Painted> paint_over(const Input& input, const Options& options,
                           const std::vector<bool>& hidden, Network& network,
                           const EdgeGraph& graph, Report& report, const Team& team) {
  const bool merge = options.merge_materials;
  Result<Painting> painted = paint(input, options.overlap, merge, network, graph);
  if (!painted) return std::move(painted).error();
  report_polygons(input, hidden, network, graph, painted->owners, report);
  report_merged_values(input, *painted, report.notes);
  Painted out;
  out.sizes = std::move(painted->sizes);
  const VisibleEdges visible = visible_edges(network, graph, *painted);
  report_splits(input, network, visible.edges, report.changes);
  network = network_of(visible.edges, network);
  if (!visible.any_united) {
    for (const VisibleEdge& e : visible.edges) {
      out.owners.push_back(e.a < e.b ? e.owners : EdgeOwners{e.owners[1], e.owners[0]});
    }
    out.graph = index_edges(network);
    return out;
  }
  // Pieces that were united again may differ from the line they make up by rounding.
  out.graph = node_edges(network, true, team);
  painted = paint(input, options.overlap, merge, network, out.graph);
  if (!painted) return std::move(painted).error();
  out.owners = std::move(painted->owners);
  return out;
}

/// Cleans what is no PSLG yet, as is known of segments alone.
Result<Pslg> clean_up(const Input& input, const Options& options, Report& report,
                      const Team& team) {
  const std::vector<bool> hidden = hidden_polygons(input, options.overlap);
  Network network = gather(input, report.changes, hidden);
  const double weld = weld_of(input, options);
  EdgeGraph graph =
      weld > 0 ? weld_and_node(input, weld, network, report.changes, !options.weld)
               : node_edges(network, !input.polygons.empty() || !input.lines.empty(), team);
  Painted seen;
  if (input.polygons.empty()) {
    const std::vector<EdgeOwners> none(graph.edges.size(), {kNone, kNone});
    report_splits(input, network, visible_edges(network, graph, {none, none, {}}).edges,
                  report.changes);
  } else {
    Result<Painted> painted = paint_over(input, options, hidden, network, graph, report, team);
    if (!painted) return std::move(painted).error();
    seen = *std::move(painted);
    graph = std::move(seen.graph);
  }
  Pslg pslg = assemble(input, network, graph, seen.owners, report.notes);
  if (seen.owners.empty()) return pslg;  // no polygon is seen
  for (std::size_t p = 0; p < seen.sizes.size(); ++p) pslg.seeds[p].size = seen.sizes[p];
  return pslg;
}

/// Tells of segments that are hardly longer than rounding, which welding makes points.
void warn_of_rounding(const Pslg& pslg, std::vector<Note>& notes) {
  const double most = rounding_of(pslg.points);
  std::vector<Point> where;
  double shortest = most;
  for (const Segment& s : pslg.segments) {
    const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
    if (!(length(b - a) <= most)) continue;
    shortest = std::min(shortest, length(b - a));
    where.push_back(a);
  }
  if (where.empty()) return;
  notes.push_back({Note::Kind::warning, kVoid,
                   fmt::format("{} no longer than rounding, the first near {} and the shortest {} "
                               "long: angles beside them are degenerate; --weld auto makes such "
                               "segments points",
                               where.size() == 1 ? "1 segment is"
                                                 : fmt::format("{} segments are", where.size()),
                               describe(where.front()), describe_roughly(shortest)),
                   where});
}

/// Whether there is anything but void beside the segments.
bool has_region(const Pslg& pslg) {
  return std::any_of(pslg.side_seeds.begin(), pslg.side_seeds.end(),
                     [](const auto& sides) { return sides[0] != 0 || sides[1] != 0; });
}

/// What was told of polygons, as the end of a sentence.
std::string why(const Report& report) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> told;
  for (const Change& change : report.changes) {
    if (change.kind == Change::Kind::dropped) told.push_back(change.message);
  }
  for (const Note& note : report.notes) {
    if (note.kind == Note::Kind::warning) told.push_back(note.message);
  }
  std::string out;
  for (std::size_t k = 0; k < std::min(kMost, told.size()); ++k) out += "; " + told[k];
  out += and_more(told.size(), kMost, ";");
  const bool was_welded = std::any_of(report.changes.begin(), report.changes.end(),
                                      [](const auto& c) { return c.kind == Change::Kind::welded; });
  return out +
         (was_welded ? "; ends nearer than --weld were united before: --weld off leaves them" : "");
}

bool is_empty(const Input& input) {
  return input.segments.empty() && input.polygons.empty() && input.lines.empty();
}

/// What messages call it: programs that fill an input need not say.
std::string name_of(const Input& input) {
  return input.source.empty() ? std::string("the input") : input.source;
}

/// The error where many lines are one but for rounding.
Error crowd(const Input& input, const Options& options, Point where) {
  const bool is_welded = weld_of(input, options) > 0;
  return {ErrorCode::coordinate_out_of_range,
          fmt::format("{}: near {} so many lines lie within rounding of each other that their "
                      "pieces cannot be told apart; {}",
                      name_of(input), describe(where),
                      is_welded ? "a larger --weld unites ends that are farther apart"
                                : "--weld auto unites ends that miss each other by rounding"),
          {where},
          {}};
}

/// An error where lines cross again and again once they are rounded.
Result<Pslg> clean_up_unless_endless(const Input& input, const Options& options, Report& report,
                                     const Team& team) {
  try {
    return clean_up(input, options, report, team);
  } catch (const RoundingCascade& cascade) {
    if (cascade.is_crowd()) return crowd(input, options, cascade.where());
    return Error{
        ErrorCode::coordinate_out_of_range,
        fmt::format("{}: near {} lines lie so close together that their crossings, rounded "
                    "to doubles, make further ones without an end in sight; move the "
                    "drawing away from 0, or draw there what can be told apart",
                    name_of(input), describe(cascade.where())),
        {cascade.where()},
        {}};
  } catch (const TooManyCrossings& crossings) {
    return Error{
        ErrorCode::out_of_memory,
        fmt::format("{}: the lines cross each other at more than {:.2g} places, which takes more "
                    "than {:.3g} GB of memory, and there are {:.3g}; leave out what is drawn on "
                    "top of itself, or take a part of the drawing",
                    name_of(input), crossings.at_least(),
                    crossings.at_least() * kBytesPerCrossing / kGigabyte,
                    machine_memory() / kGigabyte),
        {},
        {}};
  }
}

/// Makes a PSLG of an input whose arcs meet what ends on them.
Result<Pslg> make_pslg_of_chords(const Input& input, const Options& options, Report& report,
                                 std::optional<Triangulation>* whole, const Team& team) {
  const bool is_plain = input.polygons.empty() && input.lines.empty();
  if (is_plain && !options.weld) {
    if (const auto joined = join_loose_ends(input, report.changes)) {
      if (options.strict) return *changes_as_error(input, report.changes);
      Options as_it_is = options;
      as_it_is.weld = 0;
      return make_pslg_of_chords(*joined, as_it_is, report, whole, team);
    }
  }
  if (options.overlap != Overlap::last && input.polygons.empty()) {
    report.notes.push_back({Note::Kind::warning,
                            kVoid,
                            "--overlap does nothing: it counts with polygons, and there are none",
                            {}});
  }
  std::optional<Triangulation> triangulation =
      is_plain ? triangulation_if_pslg(input, team) : std::nullopt;
  const bool is_clean = triangulation.has_value();
  if (is_plain && !is_clean && options.strict) {
    if (auto error = find_unclean(input)) return *error;
  }
  const bool keep = is_clean && options.weld.value_or(0) <= 0;
  Result<Pslg> pslg =
      keep ? take_over(input, team) : clean_up_unless_endless(input, options, report, team);
  const bool is_seeded = !input.seeds.empty() || !input.holes.empty();
  if (pslg && is_seeded && !input.polygons.empty()) {
    pslg = place_seeds(input, *std::move(pslg), report.notes);
  }
  if (pslg && options.merge_materials && (is_seeded || input.polygons.empty())) {
    pslg = merge_materials(*std::move(pslg), report);
  }
  if (!pslg) return pslg;
  if (!input.polygons.empty() && !has_region(*pslg)) {
    return Error{ErrorCode::nothing_enclosed,
                 fmt::format("{}: no polygon covers anything{}", name_of(input), why(report)),
                 {},
                 {}};
  }
  report.changes.insert(report.changes.begin(), input.changes.begin(), input.changes.end());
  if (options.strict) {
    if (auto error = changes_as_error(input, report.changes)) return *error;
  }
  if (weld_of(input, options) <= 0) warn_of_rounding(*pslg, report.notes);
  pslg->attributes = input.attributes;
  sum_up(report.changes, report.notes);
  remember_arcs(input, weld_of(input, options), *pslg, report.notes);
  const bool is_as_it_was = keep && pslg->segments.size() == input.segments.size();
  if (whole != nullptr && is_as_it_was) *whole = std::move(triangulation);
  return pslg;
}

}  // namespace

Result<Pslg> make_pslg(const Input& input, const Options& options, Report& report,
                       std::optional<Triangulation>* whole, const Team& team) {
  if (auto error = find_contradiction(input)) return *error;
  if (auto error = find_unusable(input)) return *error;
  if (auto error = find_bad_arcs(input)) return *error;
  if (is_empty(input) && !options.hull) {
    return Error{ErrorCode::no_segments,
                 fmt::format("{}: there are no segments and no polygons{}{}{}", name_of(input),
                             input.points.size() > 2 ? "; --hull meshes the points" : "",
                             input.warnings.empty() ? "" : "; ", listed(input.warnings)),
                 {},
                 {}};
  }
  const double weld = weld_of(input, options);
  TouchingCircles touching;
  const auto joined = join_touching_arcs(input, weld, touching, report.changes);
  const bool any_moved =
      std::any_of(report.changes.begin(), report.changes.end(),
                  [](const Change& c) { return c.kind == Change::Kind::welded; });
  if (any_moved && options.strict) return *changes_as_error(input, report.changes);
  const Input& with_places = joined ? *joined : input;
  const auto met = meet_arcs(with_places, weld, report.changes, report.notes);
  const Input& of_chords = met ? *met : with_places;
  const auto parted = part_crossing_chords(of_chords, touching, report.notes);
  return make_pslg_of_chords(parted ? *parted : of_chords, options, report, whole, team);
}

}  // namespace cover
