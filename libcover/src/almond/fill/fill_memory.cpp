// Tested by tests/unit/almond/fill/fill_memory_test.cpp.
#include "almond/fill/fill_memory.hpp"

#include <utility>

namespace cover {
namespace {

constexpr std::size_t kMostKept = 4'000'000;  ///< numbers, or 32 MB

std::vector<double> key_of(std::size_t which, const FillTask& task) {
  std::vector<double> key{static_cast<double>(which), static_cast<double>(task.points.size())};
  key.reserve(2 + 2 * task.points.size() + 4 * task.chords.size());
  for (const Point p : task.points) key.insert(key.end(), {p.x, p.y});
  for (const Chord& c : task.chords)
    key.insert(key.end(),
               {static_cast<double>(c.a), static_cast<double>(c.b), c.locked ? 1.0 : 0.0, c.nu});
  return key;
}

}  // namespace

Filling FillMemory::filling(const Filler& filler, std::size_t which, const FillTask& task,
                            const std::stop_token& stop) {
  std::vector<double> key = key_of(which, task);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  Filling made = filler.fill(task, stop);
  const std::size_t numbers = key.size() + 2 * made.added.size() + 2 * made.triangles.size();
  if (numbers_ + numbers <= kMostKept) {
    numbers_ += numbers;
    known_.emplace(std::move(key), made);
  }
  return made;
}

}  // namespace cover
