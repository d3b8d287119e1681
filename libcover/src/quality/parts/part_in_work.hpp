// A part of a large mesh, and what is known of it: for work_in_parts and put_back alone.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/containers/unset_vector.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "quality/parts/work_in_parts.hpp"

namespace cover {

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

/// Whose a vertex is: nobody's, that of a part, or that of several. Then its number in its part.
class VertexOwners {
 public:
  VertexOwners(std::size_t vertices, const Team& team) {
    state_.resize(vertices);
    set_all(state_, kNone, team);
  }

  /// Threads: any, with any vertices
  void claim(std::uint32_t v, std::uint32_t part) {
    const std::uint32_t mine = kOwnerBit | part;
    std::atomic_ref<std::uint32_t> state(state_[v]);
    std::uint32_t now = state.load(std::memory_order_relaxed);
    if (now == mine || now == kShared) return;
    if (now == kNone && state.compare_exchange_strong(now, mine, std::memory_order_relaxed)) return;
    if (now != mine) state.store(kShared, std::memory_order_relaxed);
  }
  [[nodiscard]] bool is_shared(std::uint32_t v) const { return state_[v] == kShared; }
  /// The rest is for the part that a vertex belongs to, once all are claimed.
  [[nodiscard]] bool is_numbered(std::uint32_t v) const { return (state_[v] & kOwnerBit) == 0; }
  void number(std::uint32_t v, std::uint32_t number) { state_[v] = number; }
  std::uint32_t operator[](std::uint32_t v) const { return state_[v]; }

 private:
  static constexpr std::uint32_t kOwnerBit = 0x80000000U, kShared = kNone - 1;
  UnsetVector<std::uint32_t> state_;
};

/// Gives the places that a part had to what it has now. What is more is numbered from `extra` on.
struct ReusedPlaces {
  std::vector<std::uint32_t> spare;  ///< first those that it had, then those that are left
  std::uint32_t extra = 0;           ///< how many have none

  std::uint32_t next(std::uint32_t first_extra) {
    return used_ < spare.size() ? spare[used_++] : first_extra + extra++;
  }
  void leave_rest() { spare.erase(spare.begin(), spare.begin() + static_cast<long>(used_)); }

 private:
  std::size_t used_ = 0;
};

/// An edge to another part, seen from this one.
struct BorderEdge {
  std::uint32_t half_edge = 0;  ///< 3 t + i, in the whole before
  std::uint32_t part = 0;       ///< the part beyond,
  std::uint32_t across = 0;     ///< and the half-edge there
  std::uint32_t triangle = 0;   ///< the place in the whole now
  Corner edge;
  double least_cot = -kInverted;  ///< of the angle opposite to it
};
/// What a part has more than before, in places that are not known yet.
struct Extras {
  std::vector<MeshTriangle> triangles;
  std::vector<double> excess;
  std::vector<Point> points;
  std::vector<std::uint32_t> home;
};
struct PartInWork {
  Part given;
  std::vector<BorderEdge> border;         ///< by side from first_border on: by half_edge
  std::vector<std::uint32_t> whole_side;  ///< by side below: that of the whole
  std::uint32_t own_vertices = 0;         ///< that it had at first
  ReusedPlaces triangles, vertices;
  Extras extras;
  std::vector<std::uint32_t> triangle_ids, vertex_ids;  ///< of the extras, in the whole
  std::vector<std::uint32_t> beside_extras;   ///< triangles in places that tell of extras,
  std::vector<std::uint32_t> home_of_extras;  ///< and vertices
  /// Triangles whose excess is another in the whole: by couplings across borders, or those between
  /// vertices that were fixed in the part alone.
  std::vector<std::uint32_t> to_measure;
  /// Vertices that may be those of several parts: the last one has its way.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> homes;
};

/// Whether the excess of triangle `t` is another in the whole: by couplings across borders, or
/// between vertices that are fixed in the part alone.
bool is_other_in_whole(const PartInWork& part, std::uint32_t t);

}  // namespace cover
