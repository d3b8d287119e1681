// Cutting: every part numbers its vertices by a hash table of its own; the whole is only read.
// Putting back: a part keeps the places of its triangles and free vertices, and what it has more
// goes to the end of the whole, part after part. So each writes places that are its own.
// Tested by tests/unit/quality/mutable/blocks_test.cpp.
#include "quality/mutable/blocks.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <optional>
#include <utility>

#include "geom/box.hpp"

namespace cover {
namespace {

constexpr std::size_t kSamples = 256;    ///< triangles of a part that say where the tree divides
constexpr std::size_t kRange = 1 << 15;  ///< triangles that are looked at in one go

/// From numbers in the whole to those in a part: a hash table with open addresses, since a part
/// looks up six numbers for each triangle.
class NumberTable {
 public:
  explicit NumberTable(std::size_t expected)
      : slots_(std::bit_ceil(2 * expected + 2), Slot{kNone, kNone}) {}

  /// The number of `key`, which is `next` if it had none.
  std::uint32_t number(std::uint32_t key, std::uint32_t next) {
    Slot& slot = find(key);
    if (slot.key == key) return slot.number;
    slot = {key, next};
    if (2 * ++count_ > slots_.size()) grow();
    return next;
  }
  /// REQUIRES: it has one
  std::uint32_t operator[](std::uint32_t key) { return find(key).number; }

 private:
  struct Slot {
    std::uint32_t key, number;
  };

  /// Where `key` is, or is to be.
  Slot& find(std::uint32_t key) {
    const std::uint32_t hash = key * 0x9E3779B1U;  // Fibonacci hashing: the first bits count
    std::size_t k = hash >> (32 - std::countr_zero(slots_.size()));
    while (slots_[k].key != kNone && slots_[k].key != key) k = (k + 1) & (slots_.size() - 1);
    return slots_[k];
  }
  void grow() {
    const std::vector<Slot> old =
        std::exchange(slots_, std::vector<Slot>(2 * slots_.size(), Slot{kNone, kNone}));
    for (const Slot& slot : old) {
      if (slot.key != kNone) find(slot.key) = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

Point middle_of(const MutableMesh& mesh, std::uint32_t t) {
  const Point a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

/// Parts of the plane with about as many triangles each.
class Tree {
 public:
  Tree(const MutableMesh& mesh, std::size_t parts) {
    const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / (kSamples * parts));
    std::vector<Point> middles;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += step) {
      const auto t = static_cast<std::uint32_t>(k);
      if (!mesh.is_hole(t)) middles.push_back(middle_of(mesh, t));
    }
    divide(middles, parts);
  }

  [[nodiscard]] std::uint32_t part_at(Point p) const {
    const Node* node = nodes_.data();
    while (node->beyond != 0) {
      const bool is_beyond = node->is_x ? p.x >= node->at : p.y >= node->at;
      node = is_beyond ? &nodes_[node->beyond] : node + 1;
    }
    return node->part;
  }

 private:
  struct Node {
    double at = 0;
    bool is_x = false;
    std::uint32_t beyond = 0;  ///< the node above `at`; that below is the next one. 0: a part
    std::uint32_t part = 0;
  };

  void divide(std::span<Point> middles, std::size_t parts) {
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    if (parts < 2 || middles.size() < 2) {
      nodes_[node].part = parts_++;
      return;
    }
    const Box box = box_of(middles);
    const bool is_x = box.high.x - box.low.x >= box.high.y - box.low.y;
    const std::size_t below = parts / 2, place = middles.size() * below / parts;
    const auto coordinate = [is_x](Point p) { return is_x ? p.x : p.y; };
    std::nth_element(middles.begin(), middles.begin() + static_cast<std::ptrdiff_t>(place),
                     middles.end(),
                     [&](Point p, Point q) { return coordinate(p) < coordinate(q); });
    nodes_[node].at = coordinate(middles[place]);
    nodes_[node].is_x = is_x;
    divide(middles.first(place), below);
    nodes_[node].beyond = static_cast<std::uint32_t>(nodes_.size());
    divide(middles.subspan(place), parts - below);
  }

  std::vector<Node> nodes_;
  std::uint32_t parts_ = 0;
};

/// The parts of a mesh between fixed vertices alone. Its triangles reach from one end of the region
/// to the other, and neighbours have their middles far apart: any line through the plane would have
/// a border beside half of them. But going from triangle to triangle is going along a tree, but for
/// holes, of which whole branches are taken off.
///
/// ENSURES: numbers below `parts`, all of them from 0 to the largest; kNone for holes
std::vector<std::uint32_t> branches_of(const MutableMesh& mesh, std::size_t parts) {
  const std::size_t count = mesh.triangles.size();
  const std::size_t least = (mesh.triangle_count() + parts - 1) / parts;
  std::vector<std::uint32_t> order, parent(count, kNone), label(count, kNone);
  order.reserve(mesh.triangle_count());
  std::vector<std::uint32_t> size(count, 0);  // of what hangs on a triangle; 0: not seen
  for (std::uint32_t root = 0; root < count; ++root) {
    if (mesh.is_hole(root) || size[root] != 0) continue;
    size[root] = 1;
    order.push_back(root);
    for (std::size_t k = order.size() - 1; k < order.size(); ++k) {
      for (const std::uint32_t n : mesh.triangles[order[k]].n) {
        if (is_side(n) || size[n] != 0) continue;
        size[n] = 1;
        parent[n] = order[k];
        order.push_back(n);
      }
    }
  }
  std::uint32_t next = 0;
  for (std::size_t k = order.size(); k-- > 0;) {
    const std::uint32_t t = order[k];
    if (size[t] >= least) {
      label[t] = next++;
    } else if (parent[t] != kNone) {
      size[parent[t]] += size[t];
    }
  }
  for (const std::uint32_t t : order) {  // what is left at the roots is one part
    if (label[t] == kNone) label[t] = parent[t] == kNone ? next : label[parent[t]];
  }
  return label;
}

class BlockWork {
 public:
  BlockWork(MutableMesh& whole, const Sharing& sharing)
      : whole_(whole), team_(sharing.team), blocks_(block_count(whole, sharing)) {}

  Borders run(const std::function<void(Block&)>& work,
              const std::function<void(const Block&)>& done) {
    label();
    team_.each(blocks_.size(), [&](std::size_t k) {
      cut(k);
      MutableMesh& mesh = blocks_[k].block.mesh;
      work(blocks_[k].block);
      mesh.sides = {};  // they take as much as all else, and the whole has them
      mesh.allowances = {};
    });
    make_room();
    team_.each(blocks_.size(), [&](std::size_t k) { put_back(blocks_[k]); });
    team_.each(blocks_.size(), [&](std::size_t k) { join(blocks_[k]); });
    team_.each(blocks_.size(), [&](std::size_t k) { measure_again(blocks_[k]); });
    for (const Part& part : blocks_) set_homes(part);
    Borders borders = borders_now();
    if (done) {
      for (const Part& part : blocks_) done(part.block);
    }
    return borders;
  }

 private:
  /// An edge to another part, seen from this one.
  struct BorderEdge {
    std::uint32_t half_edge = 0;  ///< 3 t + i, in the whole before
    std::uint32_t across = 0;     ///< the same of the triangle beyond
    std::uint32_t triangle = 0;   ///< the place in the whole now
    std::uint8_t edge = 0;
  };
  struct Part {
    Block block;
    std::vector<BorderEdge> border;         ///< by side from first_border on: by half_edge
    std::vector<std::uint32_t> whole_side;  ///< by side below: that of the whole
    std::uint32_t own_vertices = 0;         ///< that it had at first
  };

  void label() {
    const std::size_t count = whole_.triangles.size();
    const bool by_branches = whole_.points.size() == whole_.fixed_vertices();
    std::optional<Tree> tree;
    if (by_branches) {
      label_ = branches_of(whole_, blocks_.size());
      std::uint32_t most = 0;
      for (const std::uint32_t label : label_) most = label == kNone ? most : std::max(most, label);
      blocks_.resize(most + 1);
    } else {
      tree.emplace(whole_, blocks_.size());
      label_.resize(count);
    }
    number_.resize(count);
    const std::size_t ranges = Team::ranges(count, kRange);
    std::vector<std::vector<std::uint32_t>> before(ranges);  // by range, by part
    team_.each_range(count, kRange, [&](std::size_t first, std::size_t last) {
      std::vector<std::uint32_t>& sum = before[first / kRange];
      sum.assign(blocks_.size(), 0);
      for (std::size_t t = first; t < last; ++t) {
        const auto triangle = static_cast<std::uint32_t>(t);
        if (tree)
          label_[t] = whole_.is_hole(triangle) ? kNone : tree->part_at(middle_of(whole_, triangle));
        if (label_[t] != kNone) number_[t] = sum[label_[t]]++;
      }
    });
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      std::uint32_t sum = 0;
      for (std::vector<std::uint32_t>& range : before) sum += std::exchange(range[k], sum);
      blocks_[k].block.index = k;
      blocks_[k].block.triangles.resize(sum);
    }
    team_.each_range(count, kRange, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        if (label_[t] == kNone) continue;
        number_[t] += before[first / kRange][label_[t]];
        blocks_[label_[t]].block.triangles[number_[t]] = static_cast<std::uint32_t>(t);
      }
    });
  }

  void cut(std::size_t index) {
    Part& part = blocks_[index];
    Block& block = part.block;
    const auto is_inside = [&](std::uint32_t n) { return !is_side(n) && label_[n] == index; };
    // Vertices that are fixed or on the border come first.
    NumberTable numbers(block.triangles.size());
    std::vector<std::uint32_t>& vertices = block.vertices;
    const auto number = [&](std::uint32_t v) {
      const auto next = static_cast<std::uint32_t>(vertices.size());
      if (numbers.number(v, next) == next) vertices.push_back(v);
    };
    for (const std::uint32_t t : block.triangles) {
      const auto& [v, n] = whole_.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) {
        if (!is_inside(n[i])) number(v[(i + 1) % 3]), number(v[(i + 2) % 3]);
        if (whole_.is_fixed(v[i])) number(v[i]);
      }
    }
    const auto fixed = static_cast<std::uint32_t>(vertices.size());
    for (const std::uint32_t t : block.triangles) {
      for (const std::uint32_t v : whole_.triangles[t].v) number(v);
    }
    part.own_vertices = static_cast<std::uint32_t>(vertices.size());

    Triangulation triangles;
    triangles.points.reserve(vertices.size());
    for (const std::uint32_t v : vertices) triangles.points.push_back(whole_.points[v]);
    triangles.triangles.resize(block.triangles.size());
    std::vector<EdgeRef> side_at, border_at;
    std::vector<SideLimit> limits, border_limits;
    for (std::uint32_t k = 0; k < block.triangles.size(); ++k) {
      const std::uint32_t t = block.triangles[k];
      const auto& [v, n] = whole_.triangles[t];
      Triangle& triangle = triangles.triangles[k];
      for (std::uint32_t i = 0; i < 3; ++i) {
        triangle.v[i] = numbers[v[i]];
        if (is_inside(n[i])) {
          triangle.n[i] = number_[n[i]];
        } else if (is_side(n[i])) {
          side_at.push_back({k, static_cast<std::uint8_t>(i)});
          limits.push_back(whole_.sides[side_index(n[i])]);
          part.whole_side.push_back(n[i]);
        } else {
          border_at.push_back({k, static_cast<std::uint8_t>(i)});
          border_limits.push_back(limit_across(t, i));
          const auto j =
              static_cast<std::uint32_t>(whole_.triangles[n[i]].edge_from(v[(i + 2) % 3]));
          part.border.push_back({3 * t + i, 3 * n[i] + j, 0, 0});
        }
      }
    }
    block.first_border = static_cast<std::uint32_t>(side_at.size());
    side_at.insert(side_at.end(), border_at.begin(), border_at.end());
    limits.insert(limits.end(), border_limits.begin(), border_limits.end());
    block.mesh = MutableMesh(triangles, fixed, side_at, std::move(limits));
    block.mesh.set_goal(whole_.goal());
  }

  /// What may become of the coupling of edge i of `t`, of which another part may use as much: the
  /// sum is above zero if it was, or no less than before.
  [[nodiscard]] SideLimit limit_across(std::uint32_t t, std::uint32_t i) const {
    SideLimit limit = kNoLimit;
    if (!whole_.goal().coupling.inside) return limit;
    const auto& [v, n] = whole_.triangles[t];
    const double own = whole_.cot_opposite(t, v[(i + 1) % 3]);
    const double sum = own + whole_.cot_opposite(n[i], v[(i + 2) % 3]);
    limit.least_cot = own - std::max(sum / 2 - kLeastCoupling, 0.0);
    limit.is_inner = true;
    return limit;
  }

  /// Gives every part places of its own for what it has more than before, and takes those of which
  /// it has fewer.
  void make_room() {
    for (Part& part : blocks_) {
      const MutableMesh& mesh = part.block.mesh;
      std::vector<std::uint32_t>& place = part.block.triangles;
      std::vector<std::uint32_t> spare =
          std::exchange(place, std::vector<std::uint32_t>(mesh.triangles.size(), kNone));
      std::size_t used = 0;
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.is_hole(t)) continue;
        place[t] = used < spare.size() ? spare[used] : whole_.add_triangle();
        ++used;
      }
      for (std::size_t k = used; k < spare.size(); ++k) whole_.drop_triangle(spare[k]);
      spare.clear();
      for (std::uint32_t v = mesh.fixed_vertices(); v < part.own_vertices; ++v) {
        if (mesh.home[v] == kNone) spare.push_back(std::exchange(part.block.vertices[v], kNone));
      }
      used = 0;
      part.block.vertices.resize(mesh.points.size(), kNone);
      for (std::uint32_t v = part.own_vertices; v < mesh.points.size(); ++v) {
        if (mesh.home[v] == kNone) continue;
        part.block.vertices[v] = used < spare.size() ? spare[used] : whole_.add_vertex({});
        ++used;
      }
      for (std::size_t k = used; k < spare.size(); ++k) whole_.drop_vertex(spare[k]);
    }
  }

  void put_back(Part& part) {
    const MutableMesh& mesh = part.block.mesh;
    const std::vector<std::uint32_t>& vertex = part.block.vertices;
    const std::vector<std::uint32_t>& place = part.block.triangles;
    for (std::uint32_t v = mesh.fixed_vertices(); v < mesh.points.size(); ++v) {
      if (vertex[v] == kNone) continue;
      whole_.points[vertex[v]] = mesh.points[v];
      whole_.home[vertex[v]] = place[mesh.home[v]];
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.is_hole(t)) continue;
      MeshTriangle& triangle = whole_.triangles[place[t]];
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t n = mesh.triangles[t].n[i];
        triangle.v[i] = vertex[mesh.triangles[t].v[i]];
        if (!is_side(n)) {
          triangle.n[i] = place[n];
        } else if (side_index(n) < part.block.first_border) {
          triangle.n[i] = part.whole_side[side_index(n)];
        } else {
          BorderEdge& edge = part.border[side_index(n) - part.block.first_border];
          edge.triangle = place[t];
          edge.edge = static_cast<std::uint8_t>(i);
        }
      }
      whole_.excess[place[t]] = mesh.excess[t];
    }
  }

  void join(const Part& part) {
    for (const BorderEdge& edge : part.border) {
      const std::vector<BorderEdge>& others = blocks_[label_[edge.across / 3]].border;
      const auto other = std::lower_bound(
          others.begin(), others.end(), edge.across,
          [](const BorderEdge& e, std::uint32_t half_edge) { return e.half_edge < half_edge; });
      whole_.triangles[edge.triangle].n[edge.edge] = other->triangle;
    }
  }

  /// The excesses that are others in the whole: couplings across borders, and those between
  /// vertices that were fixed in the part alone.
  void measure_again(const Part& part) {
    const MutableMesh& mesh = part.block.mesh;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.is_hole(t)) continue;
      const auto& [v, n] = mesh.triangles[t];
      const bool is_fixed =
          std::all_of(v.begin(), v.end(), [&](std::uint32_t u) { return mesh.is_fixed(u); });
      const bool is_beside = std::any_of(n.begin(), n.end(), [&](std::uint32_t s) {
        return is_side(s) && side_index(s) >= part.block.first_border;
      });
      if (is_fixed || is_beside) whole_.measure(part.block.triangles[t]);
    }
  }

  /// Vertices on borders, and fixed ones, may be those of several parts: the last one has its way.
  void set_homes(const Part& part) {
    const MutableMesh& mesh = part.block.mesh;
    for (std::uint32_t v = 0; v < mesh.fixed_vertices(); ++v) {
      whole_.home[part.block.vertices[v]] = part.block.triangles[mesh.home[v]];
    }
  }

  Borders borders_now() {
    Borders borders;
    for (const Part& part : blocks_) {
      for (const BorderEdge& edge : part.border) {
        borders.triangles.push_back(edge.triangle);
        const auto& v = whole_.triangles[edge.triangle].v;
        borders.vertices.push_back(v[(edge.edge + 1U) % 3]);
      }
    }
    std::sort(borders.triangles.begin(), borders.triangles.end());
    borders.triangles.erase(std::unique(borders.triangles.begin(), borders.triangles.end()),
                            borders.triangles.end());
    std::sort(borders.vertices.begin(), borders.vertices.end());
    borders.vertices.erase(std::unique(borders.vertices.begin(), borders.vertices.end()),
                           borders.vertices.end());
    return borders;
  }

  MutableMesh& whole_;
  const Team& team_;
  std::vector<Part> blocks_;
  std::vector<std::uint32_t> label_;   ///< by triangle: its part
  std::vector<std::uint32_t> number_;  ///< by triangle: in its part
};

}  // namespace

std::vector<std::uint32_t> Borders::triangles_near(const MutableMesh& whole) const {
  std::vector<std::uint8_t> is_marked(whole.points.size(), 0);
  for (const std::uint32_t v : vertices) is_marked[v] = 1;
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < whole.triangles.size(); ++t) {
    if (whole.is_hole(t)) continue;
    const auto& [v, n] = whole.triangles[t];
    if ((is_marked[v[0]] | is_marked[v[1]] | is_marked[v[2]]) == 0) continue;
    near.push_back(t);
    std::copy_if(n.begin(), n.end(), std::back_inserter(near),
                 [](std::uint32_t other) { return !is_side(other); });
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

std::size_t block_count(const MutableMesh& whole, const Sharing& sharing) {
  return std::max<std::size_t>(1, (whole.triangle_count() + sharing.block / 2) / sharing.block);
}

Borders work_in_blocks(MutableMesh& whole, const Sharing& sharing,
                       const std::function<void(Block&)>& work,
                       const std::function<void(const Block&)>& done) {
  return BlockWork(whole, sharing).run(work, done);
}

}  // namespace cover
