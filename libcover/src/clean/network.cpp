// Tested by tests/unit/clean/soup_test.cpp.
#include "clean/network.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>

#include <cover/text.hpp>

#include "base/faults/complaint.hpp"

namespace cover {

namespace {

std::size_t hash(Point p) {
  // Adding zero makes the two zeros, which are equal, the same bits.
  const std::uint64_t x = std::bit_cast<std::uint64_t>(p.x + 0.0);
  const std::uint64_t y = std::bit_cast<std::uint64_t>(p.y + 0.0);
  std::uint64_t mixed = (x ^ std::rotl(y, 32)) * 0x9E3779B97F4A7C15U;
  mixed = (mixed ^ mixed >> 32) * 0xBF58476D1CE4E5B9U + y;
  return mixed ^ mixed >> 29;
}

}  // namespace

std::size_t PointPool::slot_of(Point p) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(p) & mask;
  while (slots_[slot] != kNone && points_[slots_[slot]] != p) slot = (slot + 1) & mask;
  return slot;
}

void PointPool::grow() {
  slots_.assign(std::max<std::size_t>(16, 2 * slots_.size()), kNone);
  for (std::uint32_t k = 0; k < points_.size(); ++k) slots_[slot_of(points_[k])] = k;
}

std::uint32_t PointPool::index_of(Point p) {
  if (2 * points_.size() >= slots_.size()) grow();
  std::uint32_t& index = slots_[slot_of(p)];
  if (index == kNone) {
    index = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
  }
  return index;
}

namespace {

class Gatherer {
 public:
  Gatherer(const Input& input, std::vector<Change>& changes) : input_(input), changes_(changes) {}

  Network gather(const std::vector<bool>& hidden) {
    add_points();
    add_segments();
    for (std::uint32_t p = 0; p < input_.polygons.size(); ++p) {
      add_polygon(p, !hidden.empty() && hidden[p]);
    }
    for (std::uint32_t l = 0; l < input_.lines.size(); ++l) add_line(l);
    network_.points = pool_.take();
    network_.input.resize(network_.points.size(), kNone);
    return std::move(network_);
  }

 private:
  /// The ends of segments with a length come first; other points are lone.
  void add_points() {
    std::vector<bool> is_end(input_.points.size(), false);
    for (const InputSegment& s : input_.segments) {
      if (input_.points[s.a] != input_.points[s.b]) is_end[s.a] = is_end[s.b] = true;
    }
    for (std::uint32_t k = 0; k < input_.points.size(); ++k) {
      if (is_end[k]) add_point(k);
    }
    const auto ends = static_cast<std::uint32_t>(network_.input.size());
    for (std::uint32_t k = 0; k < input_.points.size(); ++k) {
      if (!is_end[k]) add_point(k);
    }
    for (std::uint32_t v = ends; v < network_.input.size(); ++v) network_.lone.push_back(v);
    for (const PointName& name : input_.point_names)
      network_.named.push_back(pool_.index_of(input_.points[name.point]));
  }

  void add_point(std::uint32_t k) {
    const std::uint32_t index = pool_.index_of(input_.points[k]);
    if (index < network_.input.size()) return merge_points(k, network_.input[index]);
    network_.input.push_back(k);
  }

  void merge_points(std::uint32_t point, std::uint32_t first) {
    changes_.push_back({Change::Kind::merged,
                        fmt::format("{} and point {} have the same coordinates: they are one point",
                                    name_of_point(input_, point), point_id(input_, first)),
                        {input_.points[point]},
                        {{InputKind::point, point_id(input_, first)},
                         {InputKind::point, point_id(input_, point)}}});
  }

  void add_segments() {
    std::vector<std::array<std::uint32_t, 3>> keys;
    for (std::uint32_t s = 0; s < input_.segments.size(); ++s) {
      const InputSegment& segment = input_.segments[s];
      const Point pa = input_.points[segment.a], pb = input_.points[segment.b];
      if (pa == pb) {
        drop(s, fmt::format("{} at {} has length zero", name_of_segment(input_, s), describe(pa)),
             {pa});
        continue;
      }
      const std::uint32_t a = pool_.index_of(pa), b = pool_.index_of(pb);
      keys.push_back({std::min(a, b), std::max(a, b), s});
      add(a, b, {Origin::Kind::segment, s});
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t k = 1; k < keys.size(); ++k) {
      if (keys[k - 1][0] != keys[k][0] || keys[k - 1][1] != keys[k][1]) continue;
      drop(keys[k][2],
           fmt::format("{} is the same as segment {}{}", name_of_segment(input_, keys[k][2]),
                       input_.segments[keys[k - 1][2]].id,
                       file_suffix(input_, input_.segments[keys[k - 1][2]].file)),
           {pool_.points()[keys[k][0]], pool_.points()[keys[k][1]]});
    }
  }

  void drop(std::uint32_t segment, std::string message, std::vector<Point> where) {
    changes_.push_back({Change::Kind::dropped,
                        std::move(message),
                        std::move(where),
                        {{InputKind::segment, input_.segments[segment].id}}});
  }

  void add_polygon(std::uint32_t p, bool is_hidden) {
    const auto drop = [&](const std::string& what, std::vector<Point> where) {
      changes_.push_back({Change::Kind::dropped,
                          what + " has fewer than three different corners",
                          std::move(where),
                          {{InputKind::polygon, input_.polygons[p].id}}});
    };
    const auto& rings = input_.polygons[p].rings;
    const std::string name = name_of_polygon(input_, p);
    if (std::none_of(rings.begin(), rings.end(), has_three_corners)) return drop(name, {});
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const std::vector<Point>& ring = rings[r];
      if (!has_three_corners(ring)) {
        drop(fmt::format("ring {} of {}", r + 1, name), ring);
        continue;
      }
      if (is_hidden) continue;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        add_edge(ring[k], ring[k + 1 < ring.size() ? k + 1 : 0], {Origin::Kind::ring, p});
      }
    }
  }

  /// Whether there are three different points one after the other; else the ring encloses nothing.
  static bool has_three_corners(const std::vector<Point>& ring) {
    const auto second =
        std::find_if(ring.begin(), ring.end(), [&](Point q) { return q != ring[0]; });
    return std::any_of(second, ring.end(), [&](Point q) { return q != ring[0] && q != *second; });
  }

  void add_line(std::uint32_t l) {
    const std::vector<Point>& points = input_.lines[l].points;
    if (!points.empty() &&
        std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == points[0]; })) {
      changes_.push_back({Change::Kind::dropped,
                          fmt::format("the line '{}' at {} has length zero", input_.lines[l].name,
                                      describe(points[0])),
                          {points[0]},
                          {{InputKind::line, input_.lines[l].id}}});
    }
    for (std::size_t k = 1; k < points.size(); ++k) {
      add_edge(points[k - 1], points[k], {Origin::Kind::line, l});
    }
  }

  /// Repeated points, such as the closing point of a ring, are ordinary.
  void add_edge(Point from, Point to, Origin origin) {
    if (from == to) return;
    const std::uint32_t a = pool_.index_of(from);
    add(a, pool_.index_of(to), origin);
  }

  void add(std::uint32_t a, std::uint32_t b, Origin origin) {
    network_.strands.push_back({a, b, static_cast<std::uint32_t>(network_.raws.size())});
    network_.raws.push_back({pool_.points()[a], pool_.points()[b], origin});
  }

  const Input& input_;
  std::vector<Change>& changes_;
  PointPool pool_;
  Network network_;
};

}  // namespace

Network gather(const Input& input, std::vector<Change>& changes, const std::vector<bool>& hidden) {
  return Gatherer(input, changes).gather(hidden);
}

std::string name_of_polygon(const Input& input, std::uint32_t polygon) {
  const InputPolygon& p = input.polygons[polygon];
  const std::string& name = p.region.empty() ? p.material : p.region;
  return (name.empty() ? fmt::format("polygon {}", p.id)
                       : fmt::format("polygon {} '{}'", p.id, name)) +
         file_suffix(input, p.file);
}

std::string name_of_raw(const Input& input, const Network& network, std::uint32_t raw) {
  const Raw& r = network.raws[raw];
  const std::string ends = fmt::format("from {} to {}", describe(r.a), describe(r.b));
  switch (r.origin.kind) {
    case Origin::Kind::segment: {
      const InputSegment& s = input.segments[r.origin.index];
      return fmt::format("segment {} {}{}{}", s.id, ends, line_suffix(s.line),
                         file_suffix(input, s.file));
    }
    case Origin::Kind::ring:
      return fmt::format("the edge of {} {}", name_of_polygon(input, r.origin.index), ends);
    case Origin::Kind::line:
      break;
  }
  const InputLine& line = input.lines[r.origin.index];
  return fmt::format("the line '{}'{} {}", line.name, file_suffix(input, line.file), ends);
}

InputRef ref_of(const Input& input, Origin origin) {
  switch (origin.kind) {
    case Origin::Kind::segment:
      return {InputKind::segment, input.segments[origin.index].id};
    case Origin::Kind::ring:
      return {InputKind::polygon, input.polygons[origin.index].id};
    case Origin::Kind::line:
      break;
  }
  return {InputKind::line, input.lines[origin.index].id};
}

}  // namespace cover
