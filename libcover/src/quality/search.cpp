// A triangle that is left is often held by neighbours that meet the goal just so. Each attempt
// changes a copy of an excerpt: improvement with hardly any weight for small angles, or with all of
// it; holes of growing size filled anew with one vertex; kicks, then improvement; where one vertex
// at a time is stuck, several at once. A trial aims a little below the goal, or ties between large
// and small angles would end just above it. Tested by tests/unit/quality/search_test.cpp.
#include "quality/search.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "quality/cavity.hpp"
#include "quality/excerpt.hpp"
#include "quality/improve.hpp"
#include "quality/joint_placement.hpp"
#include "quality/kicks.hpp"
#include "quality/merit.hpp"
#include "quality/polygon.hpp"
#include "quality/polygon_with_vertex.hpp"

namespace cover {
namespace {

constexpr std::size_t kTriangles = 64;  ///< in an excerpt
constexpr std::uint64_t kCopied = 8;    ///< triangles copied in the time of one star evaluation
constexpr double kLightWeight = 1e-4;   ///< of small angles where large ones come first
constexpr double kStricter = 0.005;     ///< in cotangents: 0.3 degrees
constexpr double kGain = 0.01;          ///< of an excess, that is worth a change
constexpr double kSame = 1e-9;          ///< rounding, in cotangents
constexpr std::uint64_t kLeastShare = 1000;  ///< of the budget, for a triangle
constexpr std::uint64_t kLeastSpent = 20;    ///< for a triangle: its excerpt alone
constexpr int kLeastHole = 6;                ///< edges of a hole that is filled anew
constexpr int kJointly = 3;                  ///< times that several vertices are moved
constexpr std::size_t kTiny = 32;  ///< triangles of an excerpt, in which pairs of kicks are tried
constexpr std::size_t kFew = 3;    ///< triangles above the goal, for which they are in any

/// What an excerpt has reached.
struct Standing {
  double largest = 0;         ///< -cot of the largest angle, if that is obtuse
  double large = 0;           ///< the largest excess of a large angle, by what sides allow
  std::size_t above = 0;      ///< triangles where that is positive
  std::size_t far_above = 0;  ///< those of them above 120 degrees
  double small = 0;           ///< the largest excess of a small angle, by what sides allow
  std::size_t below = 0;      ///< triangles where that is positive
};

/// Measured by `goal`, whatever goal the excerpt has set.
Standing standing_of(const MutableMesh& mesh, const Goal& goal) {
  Standing standing;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    const auto& n = mesh.triangles[t].n;
    const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    std::array<Allowance, 3> side{};
    double allowed = 0, large = -kInverted, small = -kInverted;
    bool far = false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_side(n[i])) continue;
      side[i] = allowance_for(mesh.sides[side_index(n[i])], goal);
      allowed = std::max(allowed, side[i].small);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const double cot = k.dot[i] / k.cross;
      standing.largest = std::max(standing.largest, -cot);
      large = std::max(large, -cot - goal.large - side[i].large);
      far = far || -cot > std::max(kFarAbove, goal.large + side[i].large) + kSame;
      if (is_side(n[(i + 1) % 3]) && is_side(n[(i + 2) % 3])) continue;
      small = std::max(small, cot - goal.small - allowed);
    }
    standing.large = std::max(standing.large, large);
    standing.above += large > kSame ? 1 : 0;
    standing.far_above += far ? 1 : 0;
    if (goal.weight == 0) continue;
    standing.small = std::max(standing.small, small);
    standing.below += small > kSame * goal.small ? 1 : 0;
  }
  return standing;
}

/// Whether the change from `before` to `now` is one for the better, of large angles or, without
/// harm to these, of small ones.
bool is_gain(const Standing& now, const Standing& before) {
  if (now.largest > before.largest || now.large > before.large || now.above > before.above ||
      now.far_above > before.far_above) {
    return false;
  }
  if (now.above < before.above || now.far_above < before.far_above ||
      now.large < (1 - kGain) * before.large) {
    return true;
  }
  if (now.below > before.below || now.small > before.small) return false;
  return now.below < before.below || now.small < (1 - kGain) * before.small;
}

/// The triangle with the largest excess.
std::uint32_t worst_of(const MutableMesh& mesh) {
  return static_cast<std::uint32_t>(std::max_element(mesh.excess.begin(), mesh.excess.end()) -
                                    mesh.excess.begin());
}

/// Takes in the worst triangle beside the cavity that can be.
bool grow(const MutableMesh& mesh, Cavity& cavity) {
  std::array<bool, Cavity::kCapacity> tried{};
  for (;;) {
    int best = -1;
    for (int k = 0; k < cavity.size(); ++k) {
      if (tried[static_cast<std::size_t>(k)] || is_side(cavity.outer(k))) continue;
      if (best < 0 || mesh.excess[cavity.outer(k)] > mesh.excess[cavity.outer(best)]) best = k;
    }
    if (best < 0) return false;
    tried[static_cast<std::size_t>(best)] = true;
    if (cavity.grow(best)) return true;
  }
}

/// The attempts around one triangle.
class Attempts {
 public:
  Attempts(const MutableMesh& part, const Goal& goal, Budget& budget)
      : part_(part), goal_(goal), light_(goal), before_(standing_of(part, goal)), budget_(budget) {
    light_.weight *= kLightWeight;
    light_.large -= kStricter;
  }

  /// ENSURES: true if result() is better than the part
  bool run() {
    const bool only_small = before_.above == 0;
    const Goal& first = only_small ? goal_ : light_;
    const Goal& second = only_small ? light_ : goal_;
    if (as_it_is(first, false) || fill_holes(first) || kick(part_, 0, first, false, 0)) return true;
    if (as_it_is(second, false)) return true;
    if (before_.below > 0 && kick(part_, 0, second, false, 0)) return true;
    if (as_it_is(first, true)) return true;
    if (before_.above > 0 && kick(part_, 0, first, true, 0)) return true;
    const bool is_worth_pairs =
        part_.triangle_count() <= kTiny || (before_.above > 0 && before_.above <= kFew);
    return is_worth_pairs && kick(part_, 0, first, false, 1);
  }

  [[nodiscard]] const MutableMesh& result() const { return trial_; }

 private:
  [[nodiscard]] bool is_better() const { return is_gain(standing_of(trial_, goal_), before_); }

  /// Improves the trial for `aim`, a vertex at a time and then several at once. With `slack` for a
  /// much stricter goal before.
  bool improve_trial(const Goal& aim, bool slack) {
    trial_.set_goal(aim);
    if (slack) {
      improve_with_slack(trial_, budget_);
    } else {
      budget_.spend(improve(trial_, budget_.left).evaluations + trial_.triangles.size() / kCopied);
    }
    if (is_better()) return true;
    for (int k = 0; k < kJointly && !budget_.is_used_up(); ++k) {
      const std::uint32_t worst = worst_of(trial_);
      if (!(trial_.excess[worst] > kSame)) return false;
      std::uint64_t evaluations = 0;
      const bool moved = place_jointly(trial_, worst, evaluations);
      budget_.spend(evaluations);
      if (!moved) return false;
      if (is_better()) return true;
      budget_.spend(improve(trial_, budget_.left).evaluations);
      if (is_better()) return true;
    }
    return false;
  }

  bool as_it_is(const Goal& aim, bool slack) {
    trial_ = part_;
    return improve_trial(aim, slack);
  }

  /// Takes out triangles around the one in the middle, more and more, and fills the hole.
  bool fill_holes(const Goal& aim) {
    MutableMesh start = part_;
    start.set_goal(aim);
    Cavity cavity(start);
    cavity.start(0);
    for (bool grown = true; grown && !budget_.is_used_up();) {
      grown = cavity.size() < kPolygonLimit && grow(start, cavity);
      if (cavity.size() == 3 || (grown && cavity.size() < kLeastHole)) continue;
      std::uint64_t evaluations = 0;
      Patch patch;
      const double worst =
          min_max_polygon_with_vertex(start, cavity, cavity.worst(), patch, evaluations);
      budget_.spend(evaluations);
      if (!(worst < cavity.worst())) continue;
      trial_ = start;
      Installed installed;
      if (!install_patch(trial_, cavity, patch, installed)) continue;
      if (is_better() || improve_trial(aim, false)) return true;
    }
    return false;
  }

  /// Kicks triangle `t` of `from` in every way. What does not get better is kicked again, where it
  /// is worst then, `more` times.
  bool kick(const MutableMesh& from, std::uint32_t t, const Goal& aim, bool slack, int more) {
    for (int kind = 0; kind < kKinds && !budget_.is_used_up(); ++kind) {
      trial_ = from;
      if (!cover::kick(trial_, t, kind)) continue;
      if (improve_trial(aim, slack)) return true;
      if (more == 0) continue;
      const MutableMesh kicked = trial_;
      if (kick(kicked, worst_of(kicked), aim, slack, more - 1)) return true;
    }
    return false;
  }

  const MutableMesh& part_;
  MutableMesh trial_;
  const Goal& goal_;
  Goal light_;
  Standing before_;
  Budget& budget_;
};

/// The triangles that are left, in turn.
class Search {
 public:
  Search(MutableMesh& mesh, Budget& budget) : mesh_(mesh), budget_(budget) {}

  void run() {
    queued_.assign(mesh_.triangles.size(), 0);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) enqueue(t);
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const std::uint32_t t = queue_[head];
      queued_[t] = 0;
      if (!is_left(t)) continue;
      if (budget_.is_used_up()) {
        budget_.was_too_small = true;
        return;
      }
      try_around(t, queue_.size() - head);
    }
  }

 private:
  [[nodiscard]] bool is_left(std::uint32_t t) const { return mesh_.excess[t] > kSame; }

  void enqueue(std::uint32_t t) {
    if (queued_.size() <= t) queued_.resize(mesh_.triangles.size(), 0);
    if (!is_left(t) || queued_[t] != 0) return;
    queued_[t] = 1;
    queue_.push_back(t);
  }

  /// Spends on `t` one of `shares` equal shares of the budget at most.
  void try_around(std::uint32_t t, std::size_t shares) {
    Budget share = budget_;
    share.left = std::min(budget_.left, std::max(kLeastShare, budget_.left / shares));
    const std::uint64_t given = share.left;
    const Excerpt excerpt(mesh_, t, kTriangles);
    Attempts attempts(excerpt.mesh, mesh_.goal(), share);
    if (attempts.run()) {
      for (const std::uint32_t changed : excerpt.replace(mesh_, attempts.result())) {
        enqueue(changed);
      }
    } else if (share.is_used_up()) {
      budget_.was_too_small = true;
    }
    budget_.spend(std::max(kLeastSpent, given - share.left));
  }

  MutableMesh& mesh_;
  Budget& budget_;
  std::vector<std::uint32_t> queue_;
  std::vector<std::uint8_t> queued_;
};

}  // namespace

void search_excerpts(MutableMesh& mesh, const Goal& goal, Budget& budget) {
  mesh.set_goal(goal);
  Search(mesh, budget).run();
}

}  // namespace cover
