// Tested by tests/unit/almond/almond_region_test.cpp.
#include "almond/fill/fill_remainder.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "almond/fill/fill_refine.hpp"
#include "base/team.hpp"
#include "geom/vector.hpp"
#include "target/refine_budget.hpp"
#include "target/report/holds_bound.hpp"
#include "target/report/measure_angles.hpp"

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

}  // namespace

RemainderFill::RemainderFill(Remainder remainder, const FillPlan& plan, FillMemory& memory,
                             double nu, std::stop_token stop, const Team& team)
    : r_(std::move(remainder)),
      plan_(plan),
      memory_(memory),
      nu_(nu),
      stop_(std::move(stop)),
      team_(team),
      known_(r_.cdt.points.size()) {}

std::vector<std::uint32_t> RemainderFill::refine() {
  if (!plan_.refine_first) return {};
  Refinement refinement = refine_large_angles(
      r_.cdt, r_.edges, r_.chords, {kRefineTarget, nu_, refine_budget(known_)}, stop_, team_);
  refined_ = std::move(refinement.splits);
  held_ = all_hold();
  return held_ ? std::vector<std::uint32_t>{} : std::move(refinement.blocking);
}

FilledRemainder RemainderFill::finish() {
  if (held_) {
    Triangulation cdt = std::move(std::exchange(r_, {}).cdt);  // the rest is given back
    out_.triangles.reserve(cdt.triangles.size());
    for (const Triangle& f : cdt.triangles) out_.triangles.push_back(f.v);
    out_.points = std::move(cdt.points);
    out_.splits = std::move(refined_);
    return std::move(out_);
  }
  out_.points = r_.cdt.points;
  for (const auto& members : members_of_parts(r_.cdt)) fill_part(members);
  std::sort(out_.splits.begin(), out_.splits.end(),
            [](const ChordSplit& a, const ChordSplit& b) { return a.chord < b.chord; });
  return std::move(out_);
}

bool RemainderFill::all_hold() const {
  const auto& p = r_.cdt.points;
  const double tan_nu = std::tan(nu_);
  const auto& triangles = r_.cdt.triangles;
  std::atomic<bool> all = true;
  team_.each_range(triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    if (all &&
        std::any_of(triangles.begin() + static_cast<std::ptrdiff_t>(first),
                    triangles.begin() + static_cast<std::ptrdiff_t>(last), [&](const Triangle& f) {
                      return is_flatter(p[f.v[0]], p[f.v[1]], p[f.v[2]], tan_nu);
                    }))
      all = false;
  });
  return all;
}

bool RemainderFill::holds(const std::vector<Point>& points, const Triangles& triangles) const {
  return !triangles.empty() && holds_bound(points, triangles, Angle::radians(nu_));
}

/// Keeps the refined part if that holds, else the first fill that does, else the best.
void RemainderFill::fill_part(std::span<const std::uint32_t> members) {
  const RemainderPart part = part_of(r_, members, known_);
  Triangles refined;
  double best_nu = -1;
  if (plan_.refine_first) {
    for (const std::uint32_t t : members) refined.push_back(r_.cdt.triangles[t].v);
    if (holds(r_.cdt.points, refined)) {
      keep_refined(part, refined);
      return;
    }
    best_nu = measure_angles(r_.cdt.points, refined).largest_nu.in_radians();
  }
  Filling best;
  std::size_t which = plan_.fillers.size();
  bool held = false;
  for (std::size_t i = 0; i < plan_.fillers.size() && !held; ++i) {
    Filling filling = memory_.filling(*plan_.fillers[i], i, part.task, stop_);
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
    keep_refined(part, refined);
  }
}

void RemainderFill::keep_refined(const RemainderPart& part, const Triangles& triangles) {
  out_.triangles.insert(out_.triangles.end(), triangles.begin(), triangles.end());
  for (const ChordSplit& split : refined_) {
    if (std::binary_search(part.chord.begin(), part.chord.end(), split.chord)) {
      out_.splits.push_back(split);
    }
  }
}

void RemainderFill::keep_filling(const RemainderPart& part, const Filling& filling) {
  const auto base = static_cast<std::uint32_t>(out_.points.size());
  const auto own = static_cast<std::uint32_t>(part.vertex.size());
  const auto global = [&](std::uint32_t v) { return v < own ? part.vertex[v] : base + (v - own); };
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

}  // namespace cover
