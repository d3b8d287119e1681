// The front is a list of edges with the rest of the region on their left. A row goes on all edges
// at a time, so that layers from several sides share the room between them: first every cell of the
// row asks for its own thickness and half of it more, and where that overlaps the front or another
// cell, the edge below gets no row, now or later. What is left of a line are chains. Over a chain
// the row has a vertex for each vertex between two edges, more around corners (offsets); at its
// ends it tapers off, the last cell being a triangle, several rows in one vertex as long as angles
// are small there, unless the wall there goes up at about a right angle and has a vertex at the
// height of the row. In the mitre of an inner corner, edges of a line get shorter from row to row;
// where a row leaves nothing of one, its cell is a triangle.
// Tested by tests/unit/layers/front/layer_front_test.cpp.
#include "layers/front/layer_front.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <cover/angle.hpp>

#include "cdt/triangulation.hpp"
#include "geom/box.hpp"
#include "geom/predicates.hpp"
#include "geom/search/box_tree.hpp"
#include "layers/front/side_links.hpp"

namespace cover::layers {
namespace {

/// Of a layer's thickness: what stays free above it. A little less than half, so that where two
/// lines face each other, what is left between their layers may be a row that is a bit thinner.
constexpr double kFree = 0.45;
const double kSteepest = std::sin(Angle::degrees(kMitre / 2).in_radians());
constexpr double kSameHeight = 1e-6;  ///< of a layer's thickness: vertices of a wall that serve it

/// Whether a guard is a convex polygon, counter-clockwise.
bool is_convex(const Guard& guard) {
  const auto p = guard.points();
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (orientation(p[k], p[(k + 1) % p.size()], p[(k + 2) % p.size()]) != Sign::positive)
      return false;
  }
  return true;
}

}  // namespace

LayerFront::LayerFront(const RegionBoundary& boundary, std::span<const LayerRule> rules,
                       std::span<const int> most)
    : boundary_(boundary), rules_(rules), most_(most), sides_(boundary.sides.size()) {
  const double room = box_of(boundary.points).diagonal();
  for (std::uint32_t r = 0; r < rules.size(); ++r) {
    thickness_.emplace_back(rules[r], room);
    same_rule_.push_back(r);
    for (std::uint32_t q = 0; q < r && same_rule_[r] == r; ++q) {
      if (lays_the_same(rules[q], rules[r])) same_rule_[r] = q;
    }
  }
  link_sides();
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    if (nodes_[n].origin == kNone) continue;
    nodes_[n].rule = same_rule_[boundary.layers[n] - 1] + 1;
    set_next(nodes_[n], length(end_of(n) - start_of(n)));
  }
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    if (is_joined(n)) nodes_[n].offset = offset_at(n);
  }
  reach_out_of_corners();
}

/// Where a line was cut for layers of a wall, its pieces are as short as these; they count for as
/// long as the first piece that is not.
void LayerFront::reach_out_of_corners() {
  std::vector<Chain> all = chains();
  find_meetings(all);
  for (Chain& chain : all) {
    if (chain.closed) continue;
    const auto spread = [&] {
      const auto length_at = [&](std::size_t i) {
        return length(end_of(chain.nodes[i]) - start_of(chain.nodes[i]));
      };
      std::size_t last = 0;
      while (last + 1 < chain.nodes.size() && length_at(last + 1) >= length_at(last)) ++last;
      for (std::size_t i = 0; i < last; ++i) nodes_[chain.nodes[i]].reach = length_at(last);
    };
    const auto is_taken = [&](std::uint32_t n) {
      return nodes_[n].origin != kNone && sides_[n].stop == LayerStop::corner;
    };
    const std::uint32_t before = nodes_[chain.nodes.front()].prev;
    const std::uint32_t after = nodes_[chain.nodes.back()].next;
    if (chain.first_met || is_taken(before)) spread();
    std::reverse(chain.nodes.begin(), chain.nodes.end());
    if (chain.last_met || is_taken(after)) spread();
  }
}

void LayerFront::link_sides() {
  const auto count = static_cast<std::uint32_t>(boundary_.sides.size());
  const std::vector<std::uint32_t> next = next_sides(boundary_);
  nodes_.resize(count);
  for (std::uint32_t s = 0; s < count; ++s) {
    const auto& [a, b] = boundary_.sides[s];
    Node& node = nodes_[s];
    node.vertex = a;
    node.side = s;
    node.origin = boundary_.layers[s] != 0 ? s : kNone;
    node.normal = unit_normal(at(a), at(b));
    node.next = next[s];
  }
  for (std::uint32_t s = 0; s < count; ++s) nodes_[nodes_[s].next].prev = s;
}

Offset LayerFront::offset_at(std::uint32_t n) const {
  const Node& node = nodes_[n];
  const Node& before = nodes_[node.prev];
  const bool turn_back = nodes_[node.next].vertex == before.vertex;
  return offset_of(start_of(n), before.normal, node.normal, turn_back);
}

double LayerFront::thickness(std::uint32_t side, int rows) const {
  return thickness_[boundary_.layers[side] - 1].total(rows);
}

/// Whether a row goes on from the edge before `n` to that of `n`.
bool LayerFront::is_joined(std::uint32_t n) const {
  const Node& node = nodes_[n];
  const Node& before = nodes_[node.prev];
  if (node.rule == 0 || before.rule != node.rule || before.rows != node.rows || node.prev == n)
    return false;
  if (nodes_[node.next].vertex == before.vertex) return true;
  return turning_angle(before.normal, node.normal) < kInnerMitre;
}

/// The edges that get a row, in runs.
std::vector<LayerFront::Chain> LayerFront::chains() const {
  std::vector<Chain> out;
  std::vector<bool> seen(nodes_.size(), false);
  const auto walk = [&](std::uint32_t first, bool closed) {
    Chain chain;
    chain.closed = closed;
    for (std::uint32_t n = first; !seen[n]; n = nodes_[n].next) {
      if (!chain.nodes.empty() && !is_joined(n)) break;
      seen[n] = true;
      chain.nodes.push_back(n);
    }
    out.push_back(std::move(chain));
  };
  const auto is_due = [&](std::uint32_t n) {
    return nodes_[n].alive && nodes_[n].rule != 0 && nodes_[n].rows == row_ && !seen[n];
  };
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    if (is_due(n) && !is_joined(n)) walk(n, false);
  }
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    if (is_due(n)) walk(n, true);
  }
  return out;
}

/// Whether a wall goes up at about a right angle beside a chain's edge with normal `chain`, and has
/// a vertex, `top`, at the height of the next row.
bool LayerFront::meets(Vector chain, std::uint32_t wall, Point corner, Point top,
                       const Node& node) const {
  if (nodes_[wall].rule != 0 && nodes_[wall].rows == row_) return false;  // its own row comes first
  const double layer = thickness_of(node).layer(row_);
  return std::abs(dot(top - corner, chain) - layer) <= kSameHeight * layer;
}

bool LayerFront::meets_before(std::uint32_t n) const {
  const Node& node = nodes_[n];
  const std::uint32_t wall = node.prev;
  return std::abs(turning_angle(nodes_[wall].normal, node.normal) - 90) <= kSkew &&
         meets(node.normal, wall, start_of(n), start_of(wall), node);
}

bool LayerFront::meets_after(std::uint32_t n) const {
  const Node& node = nodes_[n];
  const std::uint32_t wall = node.next;
  return std::abs(turning_angle(node.normal, nodes_[wall].normal) - 90) <= kSkew &&
         meets(node.normal, wall, start_of(wall), end_of(wall), node);
}

/// Whether a row may end in the vertex where the one below ended, with a triangle more on that
/// slope, whose other end is node `at`: as long as angles beside it are no larger than in a mitre.
bool LayerFront::fans(std::uint32_t slope, std::uint32_t at, Point end) const {
  const Offset& offset = nodes_[at].offset;
  if (!nodes_[slope].slope || nodes_[slope].rows != row_ || row_ == 0) return false;
  if (offset.kind != Offset::Kind::plain) return false;
  const Vector down = end - start_of(at);
  return dot(down, offset.along) >= -kSteepest * length(down) * length(offset.along);
}

/// Finds out which chains end at a vertex of a wall. A wall that is the end of a later chain is
/// taken from it.
void LayerFront::find_meetings(std::vector<Chain>& chains) {
  std::vector<std::uint32_t> owner(nodes_.size(), kNone);
  for (std::uint32_t c = 0; c < chains.size(); ++c) {
    for (const std::uint32_t n : chains[c].nodes) owner[n] = c;
  }
  const auto take = [&](std::uint32_t c, std::uint32_t wall, auto is_met) {
    const std::uint32_t o = owner[wall];
    if (o == kNone) return is_met();
    if (o <= c || chains[o].closed) return false;
    const std::uint32_t rule = std::exchange(nodes_[wall].rule, 0);
    const bool met = is_met();
    nodes_[wall].rule = rule;
    if (!met) return false;
    stop(wall, LayerStop::corner);
    std::erase(chains[o].nodes, wall);
    owner[wall] = kNone;
    nodes_[wall].taken = true;
    return true;
  };
  for (std::uint32_t c = 0; c < chains.size(); ++c) {
    Chain& chain = chains[c];
    if (chain.closed || chain.nodes.empty()) continue;
    const std::uint32_t first = chain.nodes.front(), last = chain.nodes.back();
    chain.first_met = take(c, nodes_[first].prev, [&] { return meets_before(first); });
    chain.last_met = take(c, nodes_[last].next, [&] { return meets_after(last); });
    const std::uint32_t before = nodes_[first].prev, after = nodes_[last].next;
    chain.first_fans = fans(before, first, start_of(before));
    chain.last_fans = fans(after, after, end_of(after));
    const bool ends = chain.first_met || chain.last_met || chain.first_fans || chain.last_fans;
    const bool waits = nodes_[before].taken || nodes_[after].taken;
    if (chain.nodes.size() > 1 || ends || waits) continue;
    stop(last, LayerStop::end);
    chain.nodes.clear();
  }
  std::erase_if(chains, [](const Chain& chain) { return chain.nodes.empty(); });
}

void LayerFront::stop(std::uint32_t n, LayerStop why) {
  Node& node = nodes_[n];
  if (node.rule == 0) return;
  node.rule = 0;
  if (!node.beside) sides_[node.origin].stop = why;
}

/// By edge of a chain: whether the next row leaves nothing of it, as between an inner corner and
/// the foot of the row's vertex in the mitre there.
std::vector<bool> LayerFront::closing(const Chain& chain) const {
  std::vector<bool> out(chain.nodes.size(), false);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!chain.closed && (i == 0 || i + 1 == out.size())) continue;
    const Node& node = nodes_[chain.nodes[i]];
    const Offset &from = node.offset, &to = nodes_[node.next].offset;
    if (from.kind != Offset::Kind::plain || to.kind != Offset::Kind::plain) continue;
    const double total = thickness_of(node).total(row_ + 1);
    out[i] = length(to.at(total) - from.at(total)) <= kSameHeight * thickness_of(node).layer(row_);
  }
  return out;
}

/// The offset of the vertex where edge `i` of a chain starts; of vertices that become one, that in
/// the mitre, which goes farthest.
Offset LayerFront::offset_in(const Chain& chain, const std::vector<bool>& closing,
                             std::size_t i) const {
  const std::size_t count = chain.nodes.size();
  Offset out = nodes_[chain.nodes[i]].offset;
  const auto heed = [&](std::size_t k) {
    const Offset& other = nodes_[chain.nodes[k]].offset;
    if (squared_length(other.along) > squared_length(out.along)) out = other;
  };
  for (std::size_t k = (i + count - 1) % count; closing[k] && k != i; k = (k + count - 1) % count)
    heed(k);
  for (std::size_t k = i; closing[k] && (k + 1) % count != i; k = (k + 1) % count)
    heed((k + 1) % count);
  return out;
}

/// The room that a row on `chain` needs, by cell.
std::vector<LayerFront::Cell> LayerFront::cells_of(const Chain& chain) {
  const Node& node = nodes_[chain.nodes.front()];
  const Thickness& thickness = thickness_of(node);
  const double below = thickness.total(row_);
  const double high = below + (1 + kFree) * thickness.layer(row_);
  std::vector<Cell> cells;
  const std::size_t count = chain.nodes.size();
  const std::vector<bool> closes = closing(chain);
  const auto tops_at = [&](std::size_t i) {
    return tops_of(offset_in(chain, closes, i % count), below);
  };
  if (chain.first_fans) {
    const std::uint32_t n = chain.nodes.front();
    cells.push_back({{start_of(nodes_[n].prev), start_of(n), nodes_[n].offset.at(high)}, {n, n}});
  }
  if (chain.last_fans) {
    const std::uint32_t n = chain.nodes.back(), slope = nodes_[n].next;
    cells.push_back({{end_of(n), end_of(slope), nodes_[slope].offset.at(high)}, {n, n}});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t n = chain.nodes[i];
    const Point a = start_of(n), b = end_of(n);
    if (closes[i]) {
      const Point top = offset_in(chain, closes, i).at(thickness.total(row_ + 1));
      cells.push_back({{a, b, top}, {n, n}});
      continue;
    }
    Cell cell{{a, b}, {n, n}};
    if (i + 1 < count || chain.closed) {
      const std::vector<Offset> tops = tops_at(i + 1);
      const std::uint32_t after = chain.nodes[(i + 1) % count];
      for (std::size_t j = 0; j + 1 < tops.size(); ++j) {
        const bool is_square = tops[j + 1].kind == Offset::Kind::corner;
        cells.push_back(
            {is_square ? Guard{b, tops[j + 2].at(high), tops[j + 1].at(high), tops[j].at(high)}
                       : Guard{b, tops[j + 1].at(high), tops[j].at(high)},
             {n, after}});
        if (is_square) ++j;
      }
      cell.guard = {a, b, tops.front().at(high)};
    } else if (chain.last_met) {
      cell.guard = {a, b, end_of(nodes_[n].next)};
    } else if (chain.last_fans) {
      cell.guard = {a, b, nodes_[nodes_[n].next].offset.at(high)};
    }
    if (i > 0 || chain.closed || chain.first_fans) {
      const Point top = tops_at(i).back().at(high);
      cell.guard.corners[static_cast<std::size_t>(cell.guard.count++)] = top;
    } else if (chain.first_met) {
      const Point top = start_of(nodes_[n].prev);
      cell.guard.corners[static_cast<std::size_t>(cell.guard.count++)] = top;
    }
    if (cell.guard.count == 2)
      cell.guard = {a, b, midpoint(a, b) + (high - below) * nodes_[n].normal};
    cells.push_back(cell);
  }
  return cells;
}

/// Stops the edges whose cells have no room. Returns whether there were any.
bool LayerFront::make_room(const std::vector<Chain>& chains) {
  std::vector<Cell> cells;
  for (const Chain& chain : chains) {
    const std::vector<Cell> more = cells_of(chain);
    cells.insert(cells.end(), more.begin(), more.end());
  }
  std::vector<Guard> others;
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    if (nodes_[n].alive) others.push_back({start_of(n), end_of(n)});
  }
  std::vector<bool> on_side(boundary_.points.size(), false);
  for (const auto& [a, b] : boundary_.sides) on_side[a] = on_side[b] = true;
  for (std::size_t v = 0; v < on_side.size(); ++v) {
    if (!on_side[v]) others.push_back({boundary_.points[v]});
  }
  std::vector<Box> boxes_of_others, boxes;
  for (const Guard& guard : others) boxes_of_others.push_back(guard.box());
  for (const Cell& cell : cells) boxes.push_back(cell.guard.box());
  const BoxTree tree_of_others(boxes_of_others), tree(boxes);

  bool any = false;
  const auto stop_cell = [&](const Cell& cell, LayerStop why) {
    for (const std::uint32_t n : cell.nodes) stop(n, why);
    any = true;
  };
  for (std::uint32_t k = 0; k < cells.size(); ++k) {
    const Cell& cell = cells[k];
    if (!is_convex(cell.guard)) {
      stop_cell(cell, LayerStop::turned);
      continue;
    }
    bool is_free = true;
    tree_of_others.visit(
        boxes[k], [&](std::uint32_t o) { is_free = is_free && !overlap(cell.guard, others[o]); });
    tree.visit(boxes[k], [&](std::uint32_t o) {
      is_free = is_free && (o == k || !overlap(cell.guard, cells[o].guard));
    });
    if (!is_free) stop_cell(cell, LayerStop::room);
  }
  return any;
}

/// Says whether an edge of the front gets another row.
void LayerFront::set_next(Node& edge, double length) {
  if (edge.rule == 0) return;
  const Thickness& thickness = thickness_of(edge);
  const int count = rules_[edge.rule - 1].count;
  LayerStop why = LayerStop::none;
  if (count > 0 && edge.rows >= count) {
    edge.rule = 0;
  } else if (edge.rows >= most_[edge.origin]) {
    edge.rule = 0;
    why = LayerStop::withdrawn;
  } else if (edge.rows >= thickness.rows()) {
    edge.rule = 0;
    why = LayerStop::room;
  } else if (count == 0 && edge.rows > 0 &&
             thickness.layer(edge.rows) > std::max(length, edge.reach)) {
    edge.rule = 0;
    why = LayerStop::isotropic;
  }
  if (!edge.beside) sides_[edge.origin].stop = why;
}

void LayerFront::lay() {
  for (row_ = 0;; ++row_) {
    std::vector<Chain> due = chains();
    find_meetings(due);
    if (due.empty()) return;
    while (make_room(due)) {
      due = chains();
      find_meetings(due);
    }
    for (Chain& chain : due) lay_chain(std::move(chain));
  }
}

std::vector<SideLayers> LayerFront::sides_in(std::span<const std::pair<Point, Point>> edges) const {
  std::vector<SideLayers> left = sides_;
  for (const Top& top : tops_) {
    if (left[top.side].rows < top.row) continue;
    const std::pair<Point, Point> edge = std::minmax(at(top.a), at(top.b));
    if (!std::binary_search(edges.begin(), edges.end(), edge))
      left[top.side] = {top.row - 1, LayerStop::couplings};
  }
  return left;
}

std::vector<LayerFront::Edge> LayerFront::front() const {
  std::vector<Edge> out;
  for (const Node& node : nodes_) {
    if (node.alive) out.push_back({node.vertex, nodes_[node.next].vertex, node.side});
  }
  return out;
}

}  // namespace cover::layers
