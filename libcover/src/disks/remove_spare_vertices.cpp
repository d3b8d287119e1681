// A vertex's star is taken out and the polygon that it leaves is triangulated with the smallest
// possible largest angle; if that is small enough it stays so. Vertices come in order of their
// numbers, last first (the feet inside gaps are younger than centres and tangency points), and
// again where something changed around them, at most kPasses times.
// Tested by tests/unit/disks/fill_disks_test.cpp.
#include "disks/remove_spare_vertices.hpp"

#include <algorithm>

#include "disks/gaps/small_polygon.hpp"
#include "geom/topology/corner.hpp"

namespace cover::disks {
namespace {

constexpr int kPasses = 6;

class SpareVertices {
 public:
  SpareVertices(TriangleDraft& draft, Index first, double most)
      : draft_(draft), most_(most), first_(first), stars_(draft.points.size()) {
    for (Index t = 0; t < draft.triangles.size(); ++t) {
      for (const Index v : draft.triangles[t]) stars_[v].push_back(t);
    }
    chord_.assign(draft.points.size(), kNone);
    for (const auto& [chord, vertex] : draft.on_chord) chord_[vertex] = chord;
  }

  void run() {
    std::vector<bool> waiting(draft_.points.size(), true);
    for (int pass = 0; pass < kPasses; ++pass) {
      std::vector<bool> next(draft_.points.size(), false);
      for (auto v = static_cast<Index>(draft_.points.size()); v-- > first_;) {
        if (!waiting[v] || stars_[v].empty()) continue;
        const std::vector<Index> link = link_of(v);
        if (!remove(v, link)) continue;
        for (const Index u : link) next[u] = true;
      }
      waiting = std::move(next);
    }
    compact();
  }

 private:
  /// The neighbours, counter-clockwise; of a vertex on a chord from end to end.
  [[nodiscard]] std::vector<Index> link_of(Index v) const {
    std::vector<std::array<Index, 2>> edges;
    for (const Index t : stars_[v]) {
      const auto& f = draft_.triangles[t];
      const Corner i = corner_with(f, v);
      edges.push_back({f[i.next()], f[i.previous()]});
    }
    std::size_t start = 0;  // on a chord: the edge that no other leads to
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (std::none_of(edges.begin(), edges.end(),
                       [&](const auto& e) { return e[1] == edges[k][0]; })) {
        start = k;
      }
    }
    std::vector<Index> link{edges[start][0]};
    for (Index at = edges[start][1]; at != link[0];) {
      link.push_back(at);
      const auto it =
          std::find_if(edges.begin(), edges.end(), [&](const auto& e) { return e[0] == at; });
      if (it == edges.end()) break;
      at = (*it)[1];
    }
    return link;
  }

  bool remove(Index v, const std::vector<Index>& link) {
    const std::size_t expected = stars_[v].size() + (chord_[v] == kNone ? 0 : 1);
    if (link.size() != expected || link.size() < 3 || link.size() > SmallPolygon::kMostCorners) {
      return false;
    }
    std::array<Point, SmallPolygon::kMostCorners> corners;
    for (std::size_t k = 0; k < link.size(); ++k) corners[k] = draft_.points[link[k]];
    const SmallPolygon polygon({corners.data(), link.size()}, most_);
    if (!(polygon.largest_angle() <= most_)) return false;

    const std::vector<Index> old = std::move(stars_[v]);
    stars_[v].clear();
    for (const Index t : old) {
      for (const Index u : draft_.triangles[t]) std::erase(stars_[u], t);
      draft_.triangles[t] = {kNone, kNone, kNone};
    }
    std::size_t used = 0;
    for (const auto& [i, j, k] : polygon.triangles()) {
      const Index t = old[used++];
      draft_.triangles[t] = {link[i], link[j], link[k]};
      for (const Index u : draft_.triangles[t]) stars_[u].push_back(t);
    }
    return true;
  }

  void compact() {
    std::erase_if(draft_.triangles, [](const auto& t) { return t[0] == kNone; });
    std::vector<Index> to(draft_.points.size(), kNone);
    Index count = 0;
    for (Index v = 0; v < to.size(); ++v) {
      if (v >= first_ && stars_[v].empty()) continue;
      draft_.points[count] = draft_.points[v];
      to[v] = count++;
    }
    draft_.points.resize(count);
    for (auto& t : draft_.triangles) t = {to[t[0]], to[t[1]], to[t[2]]};
    std::erase_if(draft_.on_chord, [&](const auto& p) { return to[p.vertex] == kNone; });
    for (auto& p : draft_.on_chord) p.vertex = to[p.vertex];
  }

  TriangleDraft& draft_;
  double most_;
  Index first_;
  std::vector<std::vector<Index>> stars_;  ///< triangles by vertex
  std::vector<Index> chord_;               ///< by vertex; kNone: inside
};

}  // namespace

void remove_spare_vertices(TriangleDraft& draft, Index first, double most) {
  SpareVertices(draft, first, most).run();
}

}  // namespace cover::disks
