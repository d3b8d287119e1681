// Cutting: a part has its vertices by their numbers in the whole; those that several parts share
// are in a hash table of its own. What a part reads of the whole is its own, or never changes, so
// that it can be put back (put_back.hpp) as soon as it is done, while others are still to be cut.
// Tested by tests/unit/quality/parts/work_in_parts_test.cpp.
#include "quality/parts/work_in_parts.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/containers/give_back.hpp"
#include "base/containers/order.hpp"
#include "quality/parts/part_in_work.hpp"
#include "quality/parts/part_labels.hpp"
#include "quality/parts/put_back.hpp"

namespace cover {
namespace {

constexpr std::size_t kSpare = 16;  ///< one in so many may be added before a part moves

class WorkInParts {
 public:
  WorkInParts(MutableMesh& whole, const Sharing& sharing)
      : whole_(whole),
        team_(sharing.team),
        stop_(sharing.stop),
        labels_(label_parts(whole, part_count(whole, sharing), team_)),
        parts_(labels_.count),
        owners_(whole.points.size(), team_) {}

  Borders run(const std::function<void(Part&)>& work,
              const std::function<void(const Part&)>& done) {
    number();
    PutBack put_back(whole_, owners_);
    team_.each(parts_.size(), [&](std::size_t k) { find_border(k); });
    team_.each(parts_.size(), [&](std::size_t k) {
      cut(k);
      if (!stop_.stop_requested()) work(parts_[k].given);
      put_back.put(parts_[k]);
    });
    labels_ = {};
    give_back(number_);
    put_back.make_room(parts_, team_);
    team_.each(parts_.size(), [&](std::size_t k) { put_back.put_extras(parts_[k]); });
    team_.each(parts_.size(), [&](std::size_t k) { join(k); });
    team_.each(parts_.size(), [&](std::size_t k) {
      for (const std::uint32_t t : parts_[k].to_measure) whole_.measure(t);
    });
    for (const PartInWork& part : parts_) {
      for (const auto& [v, t] : part.homes) whole_.home[v] = t;
    }
    if (done) {
      for (const PartInWork& part : parts_) {
        if (part.given.tells_places) done(part.given);
      }
    }
    return borders_now();
  }

 private:
  /// Tells every part its triangles, and every triangle its number there.
  void number() {
    const UnsetVector<std::uint32_t>& label = labels_.of_triangle;
    number_.resize(label.size());
    std::vector<std::vector<std::uint32_t>> before(Team::ranges(label.size(), kItemsAtATime));
    team_.each_range(label.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      std::vector<std::uint32_t>& sum = before[first / kItemsAtATime];  // by part
      sum.assign(parts_.size(), 0);
      for (std::size_t t = first; t < last; ++t) {
        if (label[t] != kNone) number_[t] = sum[label[t]]++;
      }
    });
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      std::uint32_t sum = 0;
      for (std::vector<std::uint32_t>& range : before) sum += std::exchange(range[k], sum);
      parts_[k].given.index = k;
      parts_[k].given.triangles.resize(sum);
    }
    team_.each_range(label.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        if (label[t] == kNone) continue;
        number_[t] += before[first / kItemsAtATime][label[t]];
        parts_[label[t]].given.triangles[number_[t]] = static_cast<std::uint32_t>(t);
      }
    });
  }

  /// All that a part has to know of others.
  void find_border(std::size_t index) {
    PartInWork& part = parts_[index];
    for (const std::uint32_t t : part.given.triangles) {
      const auto& [v, n] = whole_.triangles[t];
      for (const Corner i : kCorners) {
        owners_.claim(v[i], static_cast<std::uint32_t>(index));
        if (is_side(n[i])) {
          ++part.given.first_border;
        } else if (const std::uint32_t beyond = labels_.of_triangle[n[i]]; beyond != index) {
          const Corner j = whole_.triangles[n[i]].edge_from(v[i.previous()]);
          part.border.push_back({3 * t + i, beyond, 3 * n[i] + j, 0, 0, least_cot_across(t, i)});
        }
      }
    }
  }

  /// What may become of the coupling of edge i of `t`, of which another part may use as much: the
  /// sum is above zero if it was, or no less than before.
  [[nodiscard]] double least_cot_across(std::uint32_t t, Corner i) const {
    if (!whole_.goal().coupling.inside) return -kInverted;
    const auto& [v, n] = whole_.triangles[t];
    const double own = whole_.cot_opposite(t, v[i.next()]);
    const double sum = own + whole_.cot_opposite(n[i], v[i.previous()]);
    return own - std::max(sum / 2 - kLeastCoupling, 0.0);
  }

  void cut(std::size_t index) {
    PartInWork& part = parts_[index];
    NumberTable shared(2 * part.border.size());
    const std::uint32_t fixed = number_vertices(index, shared);
    Part& given = part.given;
    given.mesh = MutableMesh::part_of(whole_, fixed);
    MutableMesh& mesh = given.mesh;
    const std::size_t count = given.triangles.size(), vertices = given.vertices.size();
    mesh.triangles.reserve(count + count / kSpare);
    mesh.excess.reserve(count + count / kSpare);
    mesh.points.reserve(vertices + vertices / kSpare);
    mesh.home.reserve(vertices + vertices / kSpare);
    mesh.triangles.resize(count);
    mesh.excess.resize(count);
    mesh.home.resize(vertices, kNone);
    for (const std::uint32_t v : given.vertices) mesh.points.push_back(whole_.points[v]);
    part.whole_side.reserve(given.first_border);
    mesh.allowances.reserve(given.first_border + part.border.size());
    cut_triangles(index, shared);
    for (const BorderEdge& edge : part.border) {
      SideLimit limit = kNoLimit;
      limit.least_cot = edge.least_cot;
      limit.is_inner = whole_.goal().coupling.inside;
      mesh.allowances.push_back(allowance_for(limit, whole_.goal()));
    }
    measure_cut(part);
  }

  /// Those that are fixed or on the border come first: returns how many they are.
  std::uint32_t number_vertices(std::size_t index, NumberTable& shared) {
    PartInWork& part = parts_[index];
    std::vector<std::uint32_t>& vertices = part.given.vertices;
    vertices.reserve(part.given.triangles.size());
    const auto number = [&](std::uint32_t v) {
      const auto next = static_cast<std::uint32_t>(vertices.size());
      if (!owners_.is_shared(v)) {
        if (owners_.is_numbered(v)) return;
        owners_.number(v, next);
      } else if (shared.number(v, next) != next) {
        return;
      }
      vertices.push_back(v);
    };
    const auto is_border = [&](std::uint32_t n) {
      return !is_side(n) && labels_.of_triangle[n] != index;
    };
    for (const std::uint32_t t : part.given.triangles) {
      const auto& [v, n] = whole_.triangles[t];
      for (const Corner i : kCorners) {
        if (is_side(n[i]) || is_border(n[i])) number(v[i.next()]), number(v[i.previous()]);
        if (whole_.is_fixed(v[i])) number(v[i]);
      }
    }
    const auto fixed = static_cast<std::uint32_t>(vertices.size());
    for (const std::uint32_t t : part.given.triangles) {
      for (const std::uint32_t v : whole_.triangles[t].v) number(v);
    }
    part.own_vertices = static_cast<std::uint32_t>(vertices.size());
    return fixed;
  }

  void cut_triangles(std::size_t index, NumberTable& shared) {
    PartInWork& part = parts_[index];
    Part& given = part.given;
    MutableMesh& mesh = given.mesh;
    std::uint32_t border = given.first_border;
    for (std::uint32_t k = 0; k < given.triangles.size(); ++k) {
      const std::uint32_t t = given.triangles[k];
      const auto& [v, n] = whole_.triangles[t];
      MeshTriangle& triangle = mesh.triangles[k];
      for (const Corner i : kCorners) {
        triangle.v[i] = owners_.is_shared(v[i]) ? shared[v[i]] : owners_[v[i]];
        mesh.home[triangle.v[i]] = k;
        if (is_side(n[i])) {
          triangle.n[i] = kSideBit | static_cast<std::uint32_t>(part.whole_side.size());
          mesh.allowances.push_back(whole_.allowances[side_index(n[i])]);
          part.whole_side.push_back(n[i]);
        } else {
          triangle.n[i] = labels_.of_triangle[n[i]] == index ? number_[n[i]] : kSideBit | border++;
        }
      }
      mesh.excess[k] = whole_.excess[t];
    }
  }

  static void measure_cut(PartInWork& part) {
    MutableMesh& mesh = part.given.mesh;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (is_other_in_whole(part, t)) mesh.measure(t);
    }
  }

  void join(std::size_t index) {
    for (const BorderEdge& edge : parts_[index].border) {
      const std::vector<BorderEdge>& others = parts_[edge.part].border;
      const auto other = std::lower_bound(
          others.begin(), others.end(), edge.across,
          [](const BorderEdge& e, std::uint32_t half_edge) { return e.half_edge < half_edge; });
      whole_.triangles[edge.triangle].n[edge.edge] = other->triangle;
    }
  }

  Borders borders_now() const {
    Borders borders;
    for (const PartInWork& part : parts_) {
      for (const BorderEdge& edge : part.border) {
        borders.triangles.push_back(edge.triangle);
        const auto& v = whole_.triangles[edge.triangle].v;
        borders.vertices.push_back(v[edge.edge.next()]);
      }
    }
    sort_unique(borders.triangles);
    sort_unique(borders.vertices);
    return borders;
  }

  MutableMesh& whole_;
  const Team& team_;
  const std::stop_token& stop_;
  PartLabels labels_;
  std::vector<PartInWork> parts_;
  VertexOwners owners_;
  UnsetVector<std::uint32_t> number_;  ///< by triangle: in its part
};

}  // namespace

std::vector<std::uint32_t> Borders::triangles_near(const MutableMesh& whole,
                                                   const Team& team) const {
  std::vector<std::uint8_t> is_marked(whole.points.size(), 0);
  for (const std::uint32_t v : vertices) is_marked[v] = 1;
  std::vector<std::vector<std::uint32_t>> found(
      Team::ranges(whole.triangles.size(), kItemsAtATime));
  team.each_range(whole.triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t>& own = found[first / kItemsAtATime];
    for (std::size_t k = first; k < last; ++k) {
      const auto t = static_cast<std::uint32_t>(k);
      if (whole.is_hole(t)) continue;
      const auto& [v, n] = whole.triangles[t];
      if ((is_marked[v[0]] | is_marked[v[1]] | is_marked[v[2]]) == 0) continue;
      own.push_back(t);
      std::copy_if(n.begin(), n.end(), std::back_inserter(own),
                   [](std::uint32_t other) { return !is_side(other); });
    }
  });
  std::vector<std::uint32_t> near;
  for (const std::vector<std::uint32_t>& own : found)
    near.insert(near.end(), own.begin(), own.end());
  sort_unique(near);
  return near;
}

std::size_t part_count(const MutableMesh& whole, const Sharing& sharing) {
  return std::max<std::size_t>(
      1, (whole.triangle_count() + sharing.part_size / 2) / sharing.part_size);
}

Borders work_in_parts(MutableMesh& whole, const Sharing& sharing,
                      const std::function<void(Part&)>& work,
                      const std::function<void(const Part&)>& done) {
  return WorkInParts(whole, sharing).run(work, done);
}

}  // namespace cover
