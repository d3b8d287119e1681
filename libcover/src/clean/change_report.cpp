// Tested by tests/unit/clean/soup_test.cpp.
#include "clean/change_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>

#include <cover/text.hpp>

#include "base/containers/give_back.hpp"
#include "base/containers/order.hpp"
#include "base/faults/complaint.hpp"
#include "base/words/and_more.hpp"

namespace cover {
namespace {

constexpr std::size_t kPlaces = 5;     ///< named in one sentence; the rest is counted
constexpr std::size_t kSentences = 3;  ///< of each kind of change in a note

/// "from (0, 0) to (1, 0), from (1, 0) to (1, 1) and 3 more" of pairs of ends.
std::string list_of_edges(const std::vector<Point>& ends) {
  std::string out;
  for (std::size_t k = 0; k < std::min(kPlaces, ends.size() / 2); ++k) {
    out += fmt::format("{}from {} to {}", k > 0 ? ", " : "", describe(ends[2 * k]),
                       describe(ends[2 * k + 1]));
  }
  return out + and_more(ends.size() / 2, kPlaces);
}

struct Headline {
  Change::Kind kind;
  std::string_view what;
};
constexpr std::array<Headline, 4> kHeadlines{{{Change::Kind::merged, "merged"},
                                              {Change::Kind::dropped, "dropped"},
                                              {Change::Kind::welded, "welded"},
                                              {Change::Kind::split, "split"}}};

/// The network's points, those that are a corner of a polygon marked.
std::vector<bool> corners_of_polygons(const Network& network) {
  std::vector<Point> corners;
  for (const Raw& raw : network.raws) {
    if (raw.origin.kind != Origin::Kind::ring) continue;
    corners.push_back(raw.a);
    corners.push_back(raw.b);
  }
  std::sort(corners.begin(), corners.end());
  std::vector<bool> is_corner;
  for (const Point& p : network.points)
    is_corner.push_back(std::binary_search(corners.begin(), corners.end(), p));
  return is_corner;
}

/// By point of the network: its place in the order of coordinates.
std::vector<std::uint32_t> ranks_of_points(const Network& network) {
  return places_in(sorted_numbers(network.points.size(), [&](std::uint32_t v, std::uint32_t w) {
    return network.points[v] < network.points[w];
  }));
}

/// The lines of `edges` by the line that they are a copy of, such as a border that two neighbours
/// store: the first of the copies.
std::vector<std::uint32_t> first_copies(const Network& network) {
  const auto line = [&](std::uint32_t r) {
    return std::pair<Point, Point>(std::minmax(network.raws[r].a, network.raws[r].b));
  };
  const std::vector<std::uint32_t> order = sorted_numbers(
      network.raws.size(), [&](std::uint32_t q, std::uint32_t r) { return line(q) < line(r); });
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_copy = k > 0 && line(order[k - 1]) == line(order[k]);
    first[order[k]] = is_copy ? first[order[k - 1]] : order[k];
  }
  return first;
}

/// A line that was cut, and where.
struct CutLine {
  std::uint32_t raw = kNone;  ///< the first of its copies that was
  std::vector<std::uint32_t> points =
      {};  ///< of the network, each at most as often as edges end there
};

}  // namespace

std::string list_of_places(const std::vector<Point>& where) {
  std::string out;
  for (std::size_t k = 0; k < std::min(kPlaces, where.size()); ++k) {
    out += (k > 0 ? ", " : "") + describe(where[k]);
  }
  if (where.size() > kPlaces) {
    out += " and " + counted(where.size() - kPlaces, "more place");
  }
  return out;
}

void report_splits(const Input& input, const Network& network,
                   const std::vector<VisibleEdge>& edges, std::vector<Change>& changes) {
  const std::vector<bool> is_corner = corners_of_polygons(network);
  const std::vector<std::uint32_t> copy_of = first_copies(network);
  std::vector<CutLine> cuts(network.raws.size());  // by the first of copies
  for (const VisibleEdge& edge : edges) {
    for (const std::uint32_t r : edge.raws) {
      const Raw& raw = network.raws[r];
      for (const std::uint32_t v : {edge.a, edge.b}) {
        const Point p = network.points[v];
        if (p == raw.a || p == raw.b) continue;
        // That a polygon's side ends in the middle of another's is what painting is for.
        if (raw.origin.kind == Origin::Kind::ring && is_corner[v]) continue;
        CutLine& cut = cuts[copy_of[r]];
        cut.raw = std::min(cut.raw, r);
        cut.points.push_back(v);
      }
    }
  }
  std::erase_if(cuts, [](const CutLine& cut) { return cut.points.empty(); });
  std::sort(cuts.begin(), cuts.end(),
            [](const CutLine& c, const CutLine& d) { return c.raw < d.raw; });
  const std::vector<std::uint32_t> rank = ranks_of_points(network);
  for (CutLine& cut : cuts) {
    std::sort(cut.points.begin(), cut.points.end(),
              [&](std::uint32_t v, std::uint32_t w) { return rank[v] < rank[w]; });
    cut.points.erase(std::unique(cut.points.begin(), cut.points.end()), cut.points.end());
    std::vector<Point> where;
    where.reserve(cut.points.size());
    for (const std::uint32_t v : cut.points) where.push_back(network.points[v]);
    give_back(cut.points);
    const std::uint32_t raw = cut.raw;
    std::string message =
        fmt::format("{} was split at {}", name_of_raw(input, network, raw), list_of_places(where));
    changes.push_back({Change::Kind::split,
                       std::move(message),
                       std::move(where),
                       {ref_of(input, network.raws[raw].origin)}});
  }
}

namespace {

/// By polygon: places where two of its lines cross.
std::map<std::uint32_t, std::vector<Point>> own_crossings(const Network& network) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>>
      inner;  // point, polygon, raw
  for (const Strand& s : network.strands) {
    const Raw& raw = network.raws[s.raw];
    if (raw.origin.kind != Origin::Kind::ring) continue;
    for (const std::uint32_t v : {s.a, s.b}) {
      const Point p = network.points[v];
      if (p != raw.a && p != raw.b) inner.emplace_back(v, raw.origin.index, s.raw);
    }
  }
  sort_unique(inner);
  std::map<std::uint32_t, std::vector<Point>> out;
  for (std::size_t k = 1; k < inner.size(); ++k) {
    const auto& [v, polygon, raw] = inner[k];
    if (std::get<0>(inner[k - 1]) != v || std::get<1>(inner[k - 1]) != polygon) continue;
    std::vector<Point>& places = out[polygon];
    if (places.empty() || places.back() != network.points[v]) places.push_back(network.points[v]);
  }
  return out;
}

/// Where polygons bound anything, and where they do not.
struct Coverage {
  /// By polygon: ends of the edges on which it lies an even number of times, of those that show.
  std::map<std::uint32_t, std::vector<Point>> folds;
  std::vector<bool> has_inside;  ///< by polygon: an edge with it on one side alone
};

Coverage look_at_edges(const Network& network, const EdgeGraph& graph,
                       const std::vector<EdgeOwners>& owners, std::size_t polygons) {
  Coverage out;
  out.has_inside.assign(polygons, false);
  std::vector<std::uint32_t> buffer;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    each_polygon_on(graph, network, e, buffer, [&](std::uint32_t polygon, std::ptrdiff_t times) {
      const bool is_odd = times % 2 != 0;
      if (is_odd) out.has_inside[polygon] = true;
      if (is_odd || owners[e][0] != owners[e][1]) return;
      out.folds[polygon].push_back(network.points[graph.edges[e][0]]);
      out.folds[polygon].push_back(network.points[graph.edges[e][1]]);
    });
  }
  return out;
}

}  // namespace

void report_polygons(const Input& input, const std::vector<bool>& hidden, const Network& network,
                     const EdgeGraph& graph, const std::vector<EdgeOwners>& owners,
                     Report& report) {
  const auto warn = [&](std::string message, std::vector<Point> where) {
    report.notes.push_back({Note::Kind::warning, kVoid, std::move(message), std::move(where)});
  };
  for (auto& [polygon, where] : own_crossings(network)) {
    std::string message = fmt::format("{} crosses itself at {}; its inside is taken as even-odd",
                                      name_of_polygon(input, polygon), list_of_places(where));
    warn(std::move(message), where);
  }
  Coverage coverage = look_at_edges(network, graph, owners, input.polygons.size());
  for (auto& [polygon, where] : coverage.folds) {
    report.changes.push_back(
        {Change::Kind::dropped,
         fmt::format("{} folds back on itself along {}, {}: nothing is separated there",
                     name_of_polygon(input, polygon), counted(where.size() / 2, "edge"),
                     list_of_edges(where)),
         where,
         {ref_of(input, {Origin::Kind::ring, polygon})}});
  }
  std::vector<bool> seen(input.polygons.size(), false);
  for (const EdgeOwners& sides : owners) {
    for (const std::uint32_t p : sides) {
      if (p != kNone) seen[p] = true;
    }
  }
  std::vector<std::size_t> edges(input.polygons.size(), 0);  // those with fewer than 3 were dropped
  for (const Raw& raw : network.raws) {
    if (raw.origin.kind == Origin::Kind::ring) ++edges[raw.origin.index];
  }
  for (std::uint32_t p = 0; p < seen.size(); ++p) {
    if (!hidden[p] && (seen[p] || edges[p] <= 2)) continue;
    warn(name_of_polygon(input, p) + (hidden[p] || coverage.has_inside[p]
                                          ? " is wholly covered by others"
                                          : " has no inside: its edges cancel each other"),
         {});
  }
}

void report_merged_values(const Input& input, const Painting& painting, std::vector<Note>& notes) {
  const auto differ = [&](std::uint32_t p, std::uint32_t q) {
    const InputPolygon &one = input.polygons[p], &other = input.polygons[q];
    if (one.region != other.region) return true;
    return one.feature != other.feature &&
           std::any_of(input.attributes.begin(), input.attributes.end(), [&](const Attribute& a) {
             return comparable_value(a, one.feature) != comparable_value(a, other.feature);
           });
  };
  std::map<std::uint32_t, std::uint32_t> lost;  // the polygon that counts, by one that does not
  for (std::size_t e = 0; e < painting.owners.size(); ++e) {
    for (const std::size_t side : {0U, 1U}) {
      const std::uint32_t p = painting.owners[e][side], first = painting.regions[e][side];
      if (p != first && differ(p, first)) lost.emplace(p, first);
    }
  }
  if (lost.empty()) return;
  const auto [p, first] = *lost.begin();
  notes.push_back({Note::Kind::warning,
                   kVoid,
                   fmt::format("the names or attributes of {} are left out: merged with others, "
                               "whose first gives its own to the region; so {} gives way to {}",
                               counted(lost.size(), "polygon"), name_of_polygon(input, p),
                               name_of_polygon(input, first)),
                   {}});
}

void sum_up(const std::vector<Change>& changes, std::vector<Note>& notes) {
  for (const auto& [kind, what] : kHeadlines) {
    Note note{Note::Kind::change, kVoid, {}, {}};
    std::size_t count = 0;
    for (const Change& change : changes) {
      if (change.kind != kind) continue;
      if (++count <= kSentences) note.message += (count > 1 ? "; " : "") + change.message;
      note.where.insert(note.where.end(), change.where.begin(), change.where.end());
    }
    if (count == 0) continue;
    note.message =
        fmt::format("{} {}: {}{}", count, what, note.message, and_more(count, kSentences, ";"));
    notes.push_back(std::move(note));
  }
}

std::optional<Error> changes_as_error(const Input& input, const std::vector<Change>& changes) {
  if (changes.empty()) return {};
  Complaint complaint(ErrorCode::changed_input, input.source);
  for (const Change& change : changes) complaint.add(change.message, change.where, change.inputs);
  return complaint.error();
}

}  // namespace cover
