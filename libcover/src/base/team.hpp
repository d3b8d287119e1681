// Several threads for one piece of work.
//
// Layers below `tasks` do not know threads: they are given a team, and say which parts of their
// work need nothing of each other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace cover {

/// Whoever has threads to give: base/run_all.
class Crew {
 public:
  Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  virtual ~Crew() = default;

  [[nodiscard]] virtual unsigned workers() const = 0;
  /// As Team::each().
  virtual void each(std::size_t count, const std::function<void(std::size_t)>& run) = 0;
};

/// The threads that may work on something; by default the caller's alone.
class Team {
 public:
  Team() = default;
  /// REQUIRES: `crew` outlives the team
  explicit Team(Crew& crew) : crew_(crew.workers() > 1 ? &crew : nullptr) {}

  [[nodiscard]] unsigned workers() const { return crew_ != nullptr ? crew_->workers() : 1; }

  /// Calls `run` with 0, 1, ..., count - 1, which begin in this order. The caller works, too, so
  /// that a part may divide its own work in turn.
  ///
  /// ENSURES: all calls that began have returned
  /// Throws:  what the first call that threw (by number) has thrown; later ones may not begin then
  template <class Run>
  void each(std::size_t count, const Run& run) const {
    if (crew_ == nullptr || count < 2) {
      for (std::size_t k = 0; k < count; ++k) run(k);
    } else {
      crew_->each(count, run);
    }
  }

  /// Calls `run` with ranges [first, last) of `size` each, which are all numbers below `count`.
  /// What they are does not depend on the team.
  template <class Run>
  void each_range(std::size_t count, std::size_t size, const Run& run) const {
    each(ranges(count, size),
         [&](std::size_t k) { run(k * size, std::min(count, (k + 1) * size)); });
  }
  [[nodiscard]] static std::size_t ranges(std::size_t count, std::size_t size) {
    return (count + size - 1) / size;
  }

 private:
  Crew* crew_ = nullptr;
};

/// How much a thread takes at a time of what is looked through for each item alone: points,
/// triangles, sides. A range takes some tenths of a millisecond, so that handing it out costs
/// nothing to speak of. The same for any team: what ranges add up is added in the same order.
inline constexpr std::size_t kItemsAtATime = 1 << 15;
/// The same of items that take longer.
inline constexpr std::size_t kFewAtATime = 1 << 14;
/// The same of items that take less.
inline constexpr std::size_t kManyAtATime = 1 << 16;

}  // namespace cover
