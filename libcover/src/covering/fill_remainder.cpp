// Tested by tests/unit/covering/cover_region_test.cpp.
#include "covering/fill_remainder.hpp"

#include <algorithm>

#include "covering/fill_refine.hpp"
#include "covering/measure.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// Members of each connected part, parts in order of their first triangle.
std::vector<std::vector<std::uint32_t>> members_of_parts(const Triangulation& cdt) {
  const std::vector<std::uint32_t> part = connected_parts(cdt);
  std::vector<std::vector<std::uint32_t>> members;
  for (std::uint32_t t = 0; t < part.size(); ++t) {
    if (part[t] >= members.size()) members.resize(part[t] + 1);
    members[part[t]].push_back(t);
  }
  return members;
}

class Work {
 public:
  Work(Remainder remainder, const FillPlan& plan, double nu, const std::stop_token& stop)
      : r_(std::move(remainder)), plan_(plan), nu_(nu), stop_(stop), known_(r_.cdt.points.size()) {}

  FilledRemainder run() {
    std::vector<ChordSplit> refined;
    if (plan_.refine_first) {
      refined = refine_large_angles(r_.cdt, r_.edges, r_.chords, kRefineTarget,
                                    refine_budget(known_), stop_)
                    .splits;
      if (all_hold()) {
        out_.points = std::move(r_.cdt.points);
        for (const Triangle& f : r_.cdt.triangles) out_.triangles.push_back(f.v);
        out_.splits = std::move(refined);
        return std::move(out_);
      }
    }
    out_.points = r_.cdt.points;
    for (const auto& members : members_of_parts(r_.cdt)) fill_part(members, refined);
    std::sort(out_.splits.begin(), out_.splits.end(),
              [](const ChordSplit& a, const ChordSplit& b) { return a.chord < b.chord; });
    return std::move(out_);
  }

 private:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  [[nodiscard]] bool keeps(const Triangle& f) const {
    const auto& p = r_.cdt.points;
    return std::min({nu_at(p[f.v[1]], p[f.v[0]], p[f.v[2]]), nu_at(p[f.v[2]], p[f.v[1]], p[f.v[0]]),
                     nu_at(p[f.v[0]], p[f.v[2]], p[f.v[1]])}) >= nu_;
  }

  [[nodiscard]] bool all_hold() const {
    return std::all_of(r_.cdt.triangles.begin(), r_.cdt.triangles.end(),
                       [&](const Triangle& f) { return keeps(f); });
  }

  [[nodiscard]] bool holds(const std::vector<Point>& points, const Triangles& triangles) const {
    return !triangles.empty() && holds_bound(points, triangles, Angle::radians(nu_));
  }

  /// Keeps the refined part if that holds, else the first fill that does, else the best.
  void fill_part(const std::vector<std::uint32_t>& members,
                 const std::vector<ChordSplit>& refined) {
    const RemainderPart part = part_of(r_, members, known_);
    double best_nu = -1;
    if (plan_.refine_first) {
      Triangles triangles;
      for (const std::uint32_t t : members) triangles.push_back(r_.cdt.triangles[t].v);
      if (holds(out_.points, triangles)) {
        keep_refined(part, std::move(triangles), refined);
        return;
      }
      best_nu = measure_angles(out_.points, triangles).largest_nu.in_radians();
    }
    Filling best;
    std::size_t which = plan_.fillers.size();
    bool held = false;
    for (std::size_t i = 0; i < plan_.fillers.size() && !held; ++i) {
      Filling filling = plan_.fillers[i]->fill(part.task, stop_);
      if (filling.triangles.empty()) continue;
      std::vector<Point> points = part.task.points;
      points.insert(points.end(), filling.added.begin(), filling.added.end());
      held = holds(points, filling.triangles);
      const double reached = measure_angles(points, filling.triangles).largest_nu.in_radians();
      if (held || reached > best_nu) {
        best_nu = reached;
        best = std::move(filling);
        which = i;
      }
    }
    const bool found = which < plan_.fillers.size();
    if (plan_.refine_first || which != 0 || !held) {
      out_.fallbacks.push_back({found ? plan_.names[which] : "refine", held, part.task.points[0]});
    }
    if (found) {
      keep_filling(part, best);
    } else {
      Triangles triangles;
      for (const std::uint32_t t : members) triangles.push_back(r_.cdt.triangles[t].v);
      keep_refined(part, std::move(triangles), refined);
    }
  }

  void keep_refined(const RemainderPart& part, Triangles triangles,
                    const std::vector<ChordSplit>& refined) {
    out_.triangles.insert(out_.triangles.end(), triangles.begin(), triangles.end());
    for (const ChordSplit& split : refined) {
      if (std::binary_search(part.chord.begin(), part.chord.end(), split.chord)) {
        out_.splits.push_back(split);
      }
    }
  }

  void keep_filling(const RemainderPart& part, const Filling& filling) {
    const auto base = static_cast<std::uint32_t>(out_.points.size());
    const auto own = static_cast<std::uint32_t>(part.vertex.size());
    const auto global = [&](std::uint32_t v) {
      return v < own ? part.vertex[v] : base + (v - own);
    };
    out_.points.insert(out_.points.end(), filling.added.begin(), filling.added.end());
    for (const auto& t : filling.triangles) {
      out_.triangles.push_back({global(t[0]), global(t[1]), global(t[2])});
    }
    for (const ChordSplit& split : filling.splits) {
      ChordSplit moved{part.chord[split.chord], {}};
      for (const std::uint32_t v : split.vertices) moved.vertices.push_back(global(v));
      out_.splits.push_back(std::move(moved));
    }
  }

  Remainder r_;
  const FillPlan& plan_;
  double nu_;
  const std::stop_token& stop_;
  std::size_t known_;
  FilledRemainder out_;
};

}  // namespace

FilledRemainder fill_remainder(Remainder remainder, const FillPlan& plan, double nu,
                               const std::stop_token& stop) {
  return Work(std::move(remainder), plan, nu, stop).run();
}

}  // namespace cover
