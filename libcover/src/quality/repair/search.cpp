// A triangle that is left is often held by neighbours that meet the goal just so. Each attempt
// changes a copy of an excerpt: improvement with hardly any weight for small angles, or with all of
// it; holes of growing size filled anew with one vertex; kicks, then improvement; where one vertex
// at a time is stuck, several at once. A trial with hardly any weight for small angles aims a
// little below the goal, or ties between large and small angles would end just above it.
// Tested by tests/unit/quality/repair/search_test.cpp.
#include "quality/repair/search.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "base/numbers_where.hpp"
#include "base/once_queue.hpp"
#include "quality/effort/effort.hpp"
#include "quality/fault/keep_rules.hpp"
#include "quality/fault/tally.hpp"
#include "quality/moves/kick.hpp"
#include "quality/mutable/cavity.hpp"
#include "quality/optimum/min_max_polygon.hpp"
#include "quality/optimum/min_max_polygon_with_vertex.hpp"
#include "quality/parts/excerpt.hpp"
#include "quality/repair/improve.hpp"
#include "quality/repair/improve_jointly.hpp"
#include "quality/repair/kicks.hpp"
#include "quality/starts/restart.hpp"

namespace cover {
namespace {

constexpr std::uint64_t kLeastShare = 1000;  ///< of the budget, for a triangle
constexpr std::uint64_t kLeastSpent = 20;    ///< for a triangle: its excerpt alone
constexpr std::size_t kTogether = 128;       ///< excerpts that are worked on at the same time
constexpr std::size_t kFew = 3;              ///< triangles with small angles, in an excerpt
constexpr int kLeastHole = 6;                ///< edges of a hole that is filled anew
constexpr std::array<std::size_t, 3> kRestarted{6, 10, 14};  ///< triangles that are, in turn
constexpr std::uint32_t kTimesAnew = 12;  ///< that the inside of an excerpt is triangulated

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
  Attempts(const MutableMesh& excerpt, const Goal& goal, Budget& budget, Restarts restarts)
      : excerpt_(excerpt),
        goal_(goal),
        light_(goal),
        before_(tally_of(excerpt, goal)),
        budget_(budget),
        restarts_(restarts) {
    light_.weight *= kLightWeight;
    light_.large -= kAimBelow;
  }

  /// ENSURES: true if result() is better than the excerpt
  bool run() {
    const bool only_small = before_.above == 0;
    const Goal& first = only_small ? goal_ : light_;
    const Goal& second = only_small ? light_ : goal_;
    if (as_it_is(first, false) || fill_holes(first) || try_kicks(first, false)) return true;
    if (as_it_is(second, false)) return true;
    if (before_.below > 0 && try_kicks(second, false)) return true;
    if (as_it_is(first, true)) return true;
    const bool is_alone = before_.above > 0 || before_.below <= kFew;
    if (is_alone && try_kicks(first, true)) return true;
    return restarts_ == Restarts::at_last && before_.above > 0 && start_again(first);
  }

  [[nodiscard]] const MutableMesh& result() const { return trial_; }

 private:
  [[nodiscard]] bool is_better() const { return is_gain(tally_of(trial_, goal_), before_); }

  /// Improves the trial for `aim`, a vertex at a time and then several at once. With `slack` for a
  /// much stricter goal before.
  bool improve_trial(const Goal& aim, bool slack) {
    trial_.set_goal(aim);
    if (slack) {
      improve_with_slack(trial_, budget_);
    } else {
      budget_.spend(improve(trial_, budget_.left).evaluations +
                    trial_.triangles.size() / effort::kCopiedPerEvaluation);
    }
    return improve_jointly(trial_, budget_, [this] { return is_better(); });
  }

  bool as_it_is(const Goal& aim, bool slack) {
    trial_ = excerpt_;
    return improve_trial(aim, slack);
  }

  /// Takes out triangles around the one in the middle, more and more, and fills the hole.
  bool fill_holes(const Goal& aim) {
    MutableMesh start = excerpt_;
    start.set_goal(aim);
    Cavity cavity(start);
    cavity.start(0);
    for (bool grown = true; grown && !budget_.is_used_up();) {
      grown = cavity.size() < kPolygonLimit && grow(start, cavity);
      if (cavity.size() == 3 || (grown && cavity.size() < kLeastHole)) continue;
      Patch patch;
      const PlacedVertex placed = min_max_polygon_with_vertex(start, cavity, cavity.worst(), patch);
      budget_.spend(placed.evaluations);
      if (!(placed.worst < cavity.worst())) continue;
      trial_ = start;
      Installed installed;
      if (!install_patch(trial_, cavity, patch, installed)) continue;
      if (is_better() || improve_trial(aim, false)) return true;
    }
    return false;
  }

  /// Kicks the triangle in the middle in every way.
  bool try_kicks(const Goal& aim, bool slack) {
    for (const Kick kick : kKicks) {
      if (budget_.is_used_up()) break;
      trial_ = excerpt_;
      if (do_kick(trial_, 0, kick) && improve_trial(aim, slack)) return true;
    }
    return false;
  }

  /// Triangulates the inside of the excerpt anew, from one vertex less up to one more at random
  /// places.
  bool start_again(const Goal& aim) {
    for (std::uint32_t k = 0; k < kTimesAnew && !budget_.is_used_up(); ++k) {
      const Excerpt inside(excerpt_, 0, kRestarted[k % kRestarted.size()]);
      const std::size_t count = inside.mesh.points.size() - inside.mesh.fixed_vertices();
      std::optional<MutableMesh> anew =
          restart(inside.mesh, std::max<std::size_t>(count + k / kRestarted.size() % 3, 2) - 1, k);
      budget_.spend(kRestartCost);
      if (!anew) continue;
      trial_ = excerpt_;
      trial_.set_goal(aim);
      anew->set_goal(aim);
      inside.replace(trial_, *anew);
      if (improve_trial(aim, false)) return true;
    }
    return false;
  }

  const MutableMesh& excerpt_;
  MutableMesh trial_;
  const Goal& goal_;
  Goal light_;
  Tally before_;
  Budget& budget_;
  Restarts restarts_;
};

/// The triangles that are left, in turn.
class ExcerptSearch {
 public:
  ExcerptSearch(MutableMesh& mesh, Budget& budget, Restarts restarts)
      : mesh_(mesh), budget_(budget), restarts_(restarts) {}

  void run() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) enqueue(t);
    work_off();
  }

  /// Works on several at a time whose excerpts do not touch, so that none changes what another one
  /// looks at. How many does not depend on the team.
  void run(const Team& team) {
    enqueue_all(team);
    while (!queue_.empty()) {
      if (budget_.is_used_up()) {
        note_whether_any_is_left();
        return;
      }
      const std::size_t shares = queue_.size();
      const std::vector<std::uint32_t> together = take_apart();
      std::vector<TriedExcerpt> excerpts(together.size());
      team.each(together.size(), [&](std::size_t k) { excerpts[k] = tried(together[k], shares); });
      for (const TriedExcerpt& excerpt : excerpts) keep(excerpt);
    }
  }

 private:
  /// What came of the attempts around a triangle.
  struct TriedExcerpt {
    std::optional<Excerpt> excerpt;
    std::optional<MutableMesh> found;
    std::uint64_t spent = 0;
  };

  void work_off() {
    while (!queue_.empty()) {
      const std::size_t shares = queue_.size();
      const std::uint32_t t = queue_.pop();
      if (!is_left(t)) continue;
      if (budget_.is_used_up()) {
        budget_.was_too_small = true;
        return;
      }
      keep(tried(t, shares));
    }
  }

  /// What waits may have been mended with others. To be called once.
  void note_whether_any_is_left() {
    while (!queue_.empty()) {
      if (is_left(queue_.pop())) budget_.was_too_small = true;
    }
  }

  [[nodiscard]] bool is_left(std::uint32_t t) const { return mesh_.excess[t] > kSameCot; }

  void enqueue(std::uint32_t t) {
    if (is_left(t)) queue_.push(t);
  }

  void enqueue_all(const Team& team) {
    const auto left = [&](std::uint32_t t) { return is_left(t); };
    for (const std::uint32_t t : numbers_where(mesh_.triangles.size(), left, team)) queue_.push(t);
  }

  /// Spends on `t` one of `shares` equal shares of the budget at most.
  [[nodiscard]] TriedExcerpt tried(std::uint32_t t, std::size_t shares) const {
    TriedExcerpt out;
    Budget own = budget_;  // others may be tried at the same time
    out.excerpt.emplace(mesh_, t, effort::kExcerpt);
    own.within(std::max(kLeastShare, budget_.left / shares), [&] {
      Attempts attempts(out.excerpt->mesh, mesh_.goal(), own, restarts_);
      if (attempts.run()) out.found = attempts.result();
    });
    out.spent = std::max(kLeastSpent, budget_.left - own.left);
    return out;
  }

  void keep(const TriedExcerpt& done) {
    if (done.found) {
      for (const std::uint32_t changed : done.excerpt->replace(mesh_, *done.found)) {
        enqueue(changed);
      }
    }
    budget_.spend(done.spent);
  }

  /// Takes triangles from the queue whose excerpts have no triangle in common, nor beside each
  /// other. The others wait again.
  std::vector<std::uint32_t> take_apart() {
    std::vector<std::uint32_t> taken, others;
    ++round_;
    taken_in_.resize(mesh_.triangles.size(), 0);
    while (!queue_.empty() && taken.size() < kTogether && others.size() < kTogether) {
      const std::uint32_t t = queue_.pop();
      if (!is_left(t)) continue;
      const std::vector<std::uint32_t> around = triangles_around(mesh_, t, effort::kExcerpt);
      const auto is_taken = [&](std::uint32_t n) { return taken_in_[n] == round_; };
      if (std::any_of(around.begin(), around.end(), is_taken)) {
        others.push_back(t);
        continue;
      }
      taken.push_back(t);
      for (const std::uint32_t u : around) {
        taken_in_[u] = round_;
        for (const std::uint32_t n : mesh_.triangles[u].n) {
          if (!is_side(n)) taken_in_[n] = round_;
        }
      }
    }
    for (const std::uint32_t t : others) queue_.push(t);
    return taken;
  }

  MutableMesh& mesh_;
  Budget& budget_;
  Restarts restarts_;
  OnceQueue queue_;
  std::vector<std::uint32_t> taken_in_;  ///< by triangle: the last round
  std::uint32_t round_ = 0;
};

}  // namespace

void search_excerpts(MutableMesh& mesh, const Goal& goal, Budget& budget, Restarts restarts,
                     const Sharing& sharing) {
  mesh.set_goal(goal, sharing.team);
  ExcerptSearch search(mesh, budget, restarts);
  if (sharing.divides(mesh)) {
    search.run(sharing.team);
  } else {
    search.run();
  }
}

}  // namespace cover
