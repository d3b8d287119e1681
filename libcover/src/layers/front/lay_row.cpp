// A row is made whole before the front changes: where a triangle of it would turn over, its edges
// get none. Tested by tests/unit/layers/front/layer_front_test.cpp.
#include <algorithm>
#include <optional>
#include <utility>

#include "cdt/triangulation.hpp"
#include "geom/predicates.hpp"
#include "layers/front/layer_front.hpp"

namespace cover::layers {
namespace {

/// The triangles of a quadrilateral, by its corners, Delaunay where both diagonals will do; nothing
/// if it is not convex enough to have any.
std::optional<std::array<std::array<std::size_t, 3>, 2>> split_quad(const std::array<Point, 4>& p) {
  using Halves = std::array<std::array<std::size_t, 3>, 2>;
  const auto are_positive = [&](const Halves& halves) {
    return std::all_of(halves.begin(), halves.end(), [&](const auto& t) {
      return orientation(p[t[0]], p[t[1]], p[t[2]]) == Sign::positive;
    });
  };
  Halves first{{{0, 1, 2}, {0, 2, 3}}}, second{{{0, 1, 3}, {1, 2, 3}}};
  if (orientation(p[0], p[1], p[2]) != Sign::positive ||
      in_circle(p[0], p[1], p[2], p[3]) == Sign::positive)
    std::swap(first, second);
  if (are_positive(first)) return first;
  if (are_positive(second)) return second;
  return std::nullopt;
}

}  // namespace

/// A row over a chain, made from its first edge to its last.
class LayerFront::RowMaker {
 public:
  RowMaker(LayerFront& front, const Chain& chain)
      : front_(front),
        chain_(chain),
        closing_(front.closing(chain)),
        below_(front.thickness_of(front.nodes_[chain.nodes.front()]).total(front.row_)),
        total_(front.thickness_of(front.nodes_[chain.nodes.front()]).total(front.row_ + 1)) {}

  /// Nothing where a triangle would turn over, or nothing be left of the chain; vertices that were
  /// added stay with the front.
  std::optional<Row> make() {
    if (std::find(closing_.begin(), closing_.end(), false) == closing_.end()) return std::nullopt;
    begin();
    for (std::size_t i = 0; i < chain_.nodes.size(); ++i) add_cell(i);
    if (!chain_.closed && chain_.last_fans) end_with_fan();
    return sound_ ? std::optional(std::move(row_)) : std::nullopt;
  }

 private:
  [[nodiscard]] const Node& node(std::uint32_t n) const { return front_.nodes_[n]; }

  void begin() {
    const std::uint32_t first = chain_.nodes.front();
    const std::uint32_t before = node(first).prev;
    if (chain_.closed) {
      add_vertices(first);
    } else if (chain_.first_fans) {
      add_end(node(before).vertex);
      add_slope(before);
      add_vertices(first);
      add_triangle(node(before).vertex, node(first).vertex, row_.vertices.back());
    } else {
      add_end(node(chain_.first_met ? before : first).vertex);
    }
  }

  /// The cell over edge `i` of the chain: a quadrilateral, or a triangle where the row tapers off
  /// or closes it.
  void add_cell(std::size_t i) {
    if (closing_[i]) return close_cell(i);
    const Node& below = node(chain_.nodes[i]);
    const std::uint32_t left = row_.vertices.back();
    const bool is_last = i + 1 == chain_.nodes.size() && !chain_.closed;
    const bool tapers_left = i == 0 && !chain_.closed && !chain_.first_met && !chain_.first_fans;
    const bool tapers_right = is_last && !chain_.last_met && !chain_.last_fans;
    Node edge;
    edge.rule = below.rule;
    edge.origin = below.origin;
    edge.beside = below.beside;
    edge.normal = below.normal;
    edge.reach = below.reach;
    edge.slope = tapers_left || tapers_right;
    if (edge.slope) edge.rule = 0;
    row_.edges.push_back(edge);
    const std::uint32_t a = below.vertex, b = node(below.next).vertex;
    const std::uint32_t right = add_right(i);
    if (tapers_left || tapers_right) {
      add_triangle(a, b, tapers_left ? right : left);
    } else {
      add_quad({a, b, right, left});
    }
  }

  /// A triangle over edge `i`, whose ends become one vertex.
  void close_cell(std::size_t i) {
    const Node& below = node(chain_.nodes[i]);
    const Node& after = node(below.next);
    Offset& top = row_.tops.back();
    if (squared_length(after.offset.along) > squared_length(top.along)) {
      top = after.offset;
      front_.added_[row_.vertices.back() - front_.boundary_.points.size()] = top.at(total_);
    }
    add_triangle(below.vertex, after.vertex, row_.vertices.back());
  }

  /// What the cell over edge `i` ends with.
  std::uint32_t add_right(std::size_t i) {
    const Node& below = node(chain_.nodes[i]);
    if (i + 1 < chain_.nodes.size()) {
      const std::size_t corner = row_.vertices.size();
      add_vertices(chain_.nodes[i + 1]);
      return row_.vertices[corner];
    }
    if (chain_.closed) return row_.vertices.front();
    if (chain_.last_fans) {
      add_vertices(below.next);
      return row_.vertices.back();
    }
    add_end(node(chain_.last_met ? node(below.next).next : below.next).vertex);
    return row_.vertices.back();
  }

  void end_with_fan() {
    const std::uint32_t slope = node(chain_.nodes.back()).next;
    const std::uint32_t end = node(node(slope).next).vertex;
    add_slope(slope);
    add_triangle(node(slope).vertex, end, row_.vertices.back());
    add_end(end);
  }

  /// The vertices over the start of edge `n`, and the cells between them.
  void add_vertices(std::uint32_t n) {
    const std::vector<Offset> tops = tops_of(node(n).offset, below_);
    for (std::size_t j = 0; j < tops.size(); ++j) {
      row_.tops.push_back(tops[j]);
      row_.vertices.push_back(front_.add_vertex(tops[j].at(total_), node(n).origin));
      if (j + 1 < tops.size()) add_edge_beside(n, normal_between(tops[j], tops[j + 1]));
    }
    const std::uint32_t v = node(n).vertex;
    const auto& vertices = row_.vertices;
    for (std::size_t j = vertices.size() - tops.size(); j + 1 < vertices.size(); ++j) {
      if (row_.tops[j + 1].kind == Offset::Kind::corner) {
        add_quad({v, vertices[j + 2], vertices[j + 1], vertices[j]});
        ++j;
      } else {
        add_triangle(v, vertices[j + 1], vertices[j]);
      }
    }
  }

  /// An edge over the vertex where edge `n` starts.
  void add_edge_beside(std::uint32_t n, Vector normal) {
    const std::uint32_t before = node(n).prev;
    Node edge;
    edge.rule = node(n).rule;
    edge.origin = node(n).origin;
    edge.beside = true;
    edge.normal = normal;
    edge.reach =
        std::max({node(n).reach, node(before).reach, length(front_.end_of(n) - front_.start_of(n)),
                  length(front_.start_of(n) - front_.start_of(before))});
    row_.edges.push_back(edge);
  }

  void add_end(std::uint32_t vertex) {
    row_.tops.emplace_back();
    row_.vertices.push_back(vertex);
  }

  void add_slope(std::uint32_t below) {
    row_.edges.push_back(node(below));
    row_.edges.back().beside = true;
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    sound_ &= orientation(front_.at(a), front_.at(b), front_.at(c)) == Sign::positive;
    row_.triangles.push_back({a, b, c});
  }

  void add_quad(const std::array<std::uint32_t, 4>& v) {
    const auto halves =
        split_quad({front_.at(v[0]), front_.at(v[1]), front_.at(v[2]), front_.at(v[3])});
    sound_ &= halves.has_value();
    if (!halves) return;
    for (const auto& t : *halves) row_.triangles.push_back({v[t[0]], v[t[1]], v[t[2]]});
  }

  LayerFront& front_;
  const Chain& chain_;
  std::vector<bool> closing_;  ///< by edge of the chain
  double below_, total_;       ///< thickness of the rows below, and with this one
  Row row_;
  bool sound_ = true;  ///< no triangle has turned over
};

std::uint32_t LayerFront::add_vertex(Point p, std::uint32_t side_below) {
  added_.push_back(p);
  below_.push_back(side_below);
  return static_cast<std::uint32_t>(boundary_.points.size() + added_.size() - 1);
}

void LayerFront::lay_chain(Chain chain) {
  std::erase_if(chain.nodes, [&](std::uint32_t n) { return nodes_[n].rule == 0; });
  if (chain.nodes.empty()) return;
  const std::uint32_t first = chain.nodes.front(), last = chain.nodes.back();
  if (!chain.closed) {
    chain.first_met = meets_before(first);
    chain.last_met = meets_after(last);
  }
  const bool ends_well = chain.first_met || chain.last_met || chain.first_fans || chain.last_fans;
  if (chain.nodes.size() == 1 && !chain.closed && !ends_well) return stop(first, LayerStop::end);
  const std::size_t added = added_.size();
  std::vector<bool> closes = closing(chain);
  if (chain.closed && closes.back()) {  // vertices that become one are to follow each other
    const auto begin = std::find(closes.rbegin(), closes.rend(), false).base() - closes.begin();
    std::rotate(chain.nodes.begin(), chain.nodes.begin() + begin, chain.nodes.end());
    std::rotate(closes.begin(), closes.begin() + begin, closes.end());
  }
  if (const std::optional<Row> row = RowMaker(*this, chain).make()) {
    triangles_.insert(triangles_.end(), row->triangles.begin(), row->triangles.end());
    link_row(chain, *row);
    for (std::size_t i = 0; i < closes.size(); ++i) {
      if (closes[i]) stop(chain.nodes[i], LayerStop::corner);
    }
    return;
  }
  added_.resize(added);
  below_.resize(added);
  for (const std::uint32_t n : chain.nodes) stop(n, LayerStop::turned);
}

void LayerFront::link_row(const Chain& chain, const Row& row) {
  const std::uint32_t first = chain.nodes.front(), last = chain.nodes.back();
  const std::uint32_t wall = nodes_[first].prev, beyond = nodes_[last].next;
  const std::size_t tops = row.vertices.size();
  for (const std::uint32_t n : chain.nodes) nodes_[n].alive = false;
  std::vector<std::uint32_t> at_top(tops, kNone);
  if (!chain.closed) {
    at_top.front() = chain.first_met || chain.first_fans ? wall : first;
    at_top.back() = chain.last_met || chain.last_fans ? nodes_[beyond].next : beyond;
    if (chain.last_fans) nodes_[beyond].alive = false;
    if (chain.first_met) stop(wall, LayerStop::corner);
    if (chain.last_met) {
      stop(beyond, LayerStop::corner);
      nodes_[beyond].alive = false;
    }
    nodes_[at_top.front()].alive = true;
  }
  for (std::size_t j = 0; j < tops; ++j) {
    if (at_top[j] != kNone) continue;
    at_top[j] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_.back().vertex = row.vertices[j];
    nodes_.back().offset = row.tops[j];
  }
  for (std::size_t j = 0; j < row.edges.size(); ++j) {
    const std::uint32_t n = at_top[j], after = at_top[(j + 1) % tops];
    Node node = row.edges[j];
    node.vertex = nodes_[n].vertex;
    node.offset = nodes_[n].offset;
    node.prev = nodes_[n].prev;
    node.next = after;
    node.side = kNone;
    node.rows = row_ + 1;
    if (!node.beside) {
      SideLayers& side = sides_[node.origin];
      if (node.rule == 0)
        side.stop = LayerStop::end;
      else
        side.rows = node.rows;
      if (node.rule != 0)
        tops_.push_back({node.vertex, nodes_[after].vertex, node.origin, node.rows});
    }
    set_next(node, length(at(nodes_[after].vertex) - at(node.vertex)));
    nodes_[n] = node;
  }
  for (std::size_t j = 0; j < row.edges.size(); ++j)
    nodes_[at_top[(j + 1) % tops]].prev = at_top[j];
}

}  // namespace cover::layers
