// In a simply connected part whose m sides touch in a ring, the medial axis is a tree with m
// leaves, the cusps, and its inner nodes are centres of empty disks with three or more contacts. A
// disk is useless if its contacts are three consecutive sides, for then it cuts off two cusps and
// leaves a cycle as long as before. For m >= 5 some node is useful, and it is found within two
// steps along the tree from any cusp: from a useless node on, past the side that it cuts off, to
// the next. A disk that touches sides a, b, c steps apart (a + b + c = m) leaves cycles of a + 2,
// b + 2, c + 2 sides, so that the sum of (sides - 4) falls by two or more: at most m - 4 disks.
//
// Symmetric input gives disks with four and more contacts as a rule. All are found by distance
// and split at once; a contact ignored would stop the next search at its start.
// Among several cusps the largest disk is taken: larger disks, fewer small gaps.
// Tested by tests/unit/disks/packing/packing_test.cpp.
#include "disks/packing/reduce_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "disks/packing/search/first_contact.hpp"

namespace cover::disks {
namespace {

constexpr Index kAllCusps = 16;  ///< cycles up to this length are searched all around
constexpr Index kSample = 8;     ///< of longer ones so many cusps are looked at

struct UsefulDisk {
  Circle circle;
  std::vector<Contact> contacts;
};

class Reduction {
 public:
  Reduction(Packing& packing, double tolerance) : packing_(packing), tolerance_(tolerance) {}

  bool run() {
    std::vector<Index> open;
    for (auto k = static_cast<Index>(packing_.cycles.size()); k-- > 0;) open.push_back(k);
    while (!open.empty()) {
      const Index cycle = open.back();
      open.pop_back();
      const Index size = packing_.cycles[cycle].size;
      if (size < 3) return false;  // rounding has left a disk apart, or two that touch twice
      if (size <= 4) continue;
      const auto disk = best_disk(cycle);
      if (!disk) return false;
      const std::vector<Index> arcs = packing_.insert_disk(disk->circle, disk->contacts);
      const std::vector<Index> parts = packing_.split_cycle(cycle, arcs);
      if (parts.empty()) return false;
      open.insert(open.end(), parts.begin(), parts.end());
    }
    return true;
  }

 private:
  [[nodiscard]] Index next(Index side) const { return packing_.sides[side].next; }
  [[nodiscard]] Index prev(Index side) const { return packing_.sides[side].prev; }

  [[nodiscard]] std::optional<UsefulDisk> best_disk(Index cycle) const {
    const Cycle c = packing_.cycles[cycle];
    const Index sample = c.size <= kAllCusps ? c.size : kSample;
    std::optional<UsefulDisk> best;
    Index i = c.side;
    for (Index k = 0; k < c.size && (k < sample || !best); ++k, i = next(i)) {
      auto disk = useful_disk(i);
      if (disk && (!best || disk->circle.r > best->circle.r)) best = std::move(disk);
    }
    return best;
  }

  /// The useful disk found from the cusp at the end of side `i`.
  [[nodiscard]] std::optional<UsefulDisk> useful_disk(Index i) const {
    const Index j = next(i);
    auto disk = first_contact(packing_, i, j, packing_.point(packing_.sides[i].end));
    if (!disk) return std::nullopt;
    UsefulDisk result = with_all_contacts(*disk);
    if (is_useful(result)) return result;
    if (disk->third.side == next(j)) {
      disk = first_contact(packing_, i, next(j), disk->i.at);
    } else {
      disk = first_contact(packing_, prev(i), j, disk->third.at);
    }
    if (!disk) return std::nullopt;
    result = with_all_contacts(*disk);
    return is_useful(result) ? std::optional(result) : std::nullopt;
  }

  [[nodiscard]] UsefulDisk with_all_contacts(const MedialDisk& disk) const {
    const std::array<Contact, 3> known{disk.i, disk.j, disk.third};
    return {disk.circle, touched_sides(packing_, disk.circle, known,
                                       packing_.sides[disk.i.side].cycle, tolerance_)};
  }

  /// Whether the disk does not just touch three consecutive sides.
  [[nodiscard]] bool is_useful(const UsefulDisk& disk) const {
    if (disk.contacts.size() > 3) return true;
    for (const Contact& c : disk.contacts) {
      int neighbours = 0;
      for (const Contact& d : disk.contacts) {
        if (d.side == next(c.side) || d.side == prev(c.side)) ++neighbours;
      }
      if (neighbours == 2) return false;
    }
    return disk.contacts.size() == 3;
  }

  Packing& packing_;
  double tolerance_;
};

}  // namespace

std::vector<Contact> touched_sides(const Packing& packing, Circle disk,
                                   std::span<const Contact> known, Index cycle, double tolerance) {
  std::vector<Contact> result(known.begin(), known.end());
  for (const Index e : packing.elements_within(disk.c, disk.r * (1 + tolerance), cycle)) {
    const Element& element = packing.elements[e];
    const bool taken = std::any_of(known.begin(), known.end(), [&](const Contact& c) {
      return packing.sides[c.side].element == e;
    });
    if (taken) continue;
    const double limit = tolerance * (element.is_disk() ? std::min(disk.r, element.r) : disk.r);
    if (std::abs(signed_distance(element, disk.c) - disk.r) > limit) continue;
    const Point at = contact(element, disk.c);
    if (const auto side = packing.side_at(e, at, cycle)) result.push_back({*side, at});
  }
  return result;
}

bool reduce_cycles(Packing& packing, double tolerance) {
  return Reduction(packing, tolerance).run();
}

}  // namespace cover::disks
