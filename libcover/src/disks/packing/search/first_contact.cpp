// The disks touching sides i and j form a family that is ordered by how far back on side i they
// touch it (the progress). Start with a disk that is surely too far; while an obstacle enters the
// disk, replace it by the disk of the family that touches this obstacle: progress falls, and after
// about two rounds nothing enters any more. Where an obstacle has no such disk (it is reached only
// from behind, after others), bisect the progress instead.
// Tested by tests/unit/disks/packing/packing_test.cpp.
#include "disks/packing/search/first_contact.hpp"

#include <algorithm>
#include <cmath>

#include "disks/packing/search/apollonius.hpp"

namespace cover::disks {
namespace {

class Family {
 public:
  Family(const Packing& packing, Index i, Index j, Point from)
      : packing_(packing),
        i_(i),
        j_(j),
        ei_(packing.element_of(i)),
        ej_(packing.element_of(j)),
        from_(from) {
    const Side& s = packing.sides[i];
    if (ei_.is_disk() && s.start == s.end) {
      limit_ = kFullTurn;
      if (const double done = way_back(ei_, packing.point(s.end), from); done > 0) limit_ -= done;
    } else {
      limit_ = way_back(ei_, from, packing.point(s.start));
    }
    if (ei_.is_disk()) limit_ = std::min(limit_, ccw_angle(from - ei_.c, infinite_end()));
  }

  std::optional<MedialDisk> first() const {
    double low = 0;
    std::optional<Upper> high = start(low);
    for (int k = 0; k < kSteps && high; ++k) {
      const Index g = obstacle(high->circle);
      if (g == kNone) return finished(high->circle, high->element);
      if (const auto root = touching(g, low, high->progress)) {
        high = root;
        continue;
      }
      high = between(low, high->progress);
    }
    return std::nullopt;
  }

 private:
  static constexpr int kSteps = 100;
  static constexpr double kRelative = 1e-12;
  static constexpr double kEmpty = 1e-9;  ///< an obstacle may enter by this part of the radius
  static constexpr double kLargest = 1;   ///< the packing lies in the unit square

  /// A disk of the family that is too far or just far enough.
  struct Upper {
    double progress = 0;
    Circle circle;
    Index element = kNone;  ///< the third that it touches; kNone: something enters it
  };

  /// The normal of disk i where disks of the family become infinitely large, that is, half planes:
  /// beyond begins another branch, behind the two elements.
  [[nodiscard]] Vector infinite_end() const {
    if (ej_.is_line()) return left_normal(ej_.d);
    const Vector v = ej_.c - ei_.c;
    const double cosine = std::clamp((ei_.r - ej_.r) / norm(v), -1.0, 1.0);
    return cosine * v + std::sqrt(1 - cosine * cosine) * left_normal(v);
  }

  /// A disk to start from: one that touches a neighbour of i or j, or else any that is too far.
  [[nodiscard]] std::optional<Upper> start(double& low) const {
    std::optional<Upper> best;
    for (const Index side : {packing_.sides[i_].prev, packing_.sides[j_].next}) {
      const auto disk = touching(packing_.sides[side].element, low, limit_ * (1 + kRelative));
      if (disk && (!best || disk->progress < best->progress)) best = disk;
    }
    return best ? best : between(low, 2 * limit_);
  }

  /// A disk with progress between `low`, where nothing enters, and `high`, where the disk is
  /// too far or has no finite radius any more; `low` rises as far as is found free.
  [[nodiscard]] std::optional<Upper> between(double& low, double high) const {
    for (int k = 0; k < kSteps && high - low > kRelative * limit_; ++k) {
      const double middle = low + (high - low) / 2;
      const auto circle = at(middle);
      if (!circle) {
        high = middle;
      } else if (obstacle(*circle) == kNone) {
        low = middle;
      } else {
        return Upper{middle, *circle, kNone};
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] Index obstacle(Circle circle) const {
    return packing_.nearest_obstacle(circle.c, circle.r * (1 - kEmpty), packing_.sides[i_].cycle,
                                     packing_.sides[i_].element, packing_.sides[j_].element);
  }

  /// The disk of the family that touches element `e` with progress in (low, high).
  [[nodiscard]] std::optional<Upper> touching(Index e, double low, double high) const {
    if (e == packing_.sides[i_].element || e == packing_.sides[j_].element) return std::nullopt;
    const Element& third = packing_.elements[e];
    std::optional<Upper> best;
    const TangentCircles found = tangent_circles(ei_, ej_, third, from_);
    for (int k = 0; k < found.count; ++k) {
      const Circle circle = found.circle[static_cast<std::size_t>(k)];
      const double progress = way_back(ei_, from_, contact(ei_, circle.c));
      if (!(progress > low + kRelative * limit_ && progress < high)) continue;
      if (!(circle.r < kLargest)) continue;
      if (third.is_line() && std::isinf(obstacle_distance(third, circle.c))) continue;
      if (!best || progress < best->progress) best = Upper{progress, circle, e};
    }
    return best;
  }

  /// The disk of the family with the given progress; nothing where its radius is
  /// not finite or larger than the whole domain.
  [[nodiscard]] std::optional<Circle> at(double progress) const {
    const Vector v = from_ - ei_.c;
    const Point q = ei_.is_line()
                        ? from_ + (-progress) * ei_.d
                        : ei_.c + std::cos(progress) * v + std::sin(progress) * left_normal(v);
    const Vector u = outward(ei_, q);
    double numerator = 0, denominator = 0;
    if (ej_.is_disk()) {  // |q + r u - c|^2 = (r + r_j)^2
      const Vector w = q - ej_.c;
      const double l = norm(w);
      numerator = (l - ej_.r) * (l + ej_.r);
      denominator = 2 * (ej_.r - dot(u, w));
    } else {  // n . (q + r u - c) = r
      numerator = cross(ej_.d, q - ej_.c);
      denominator = 1 - dot(u, left_normal(ej_.d));
    }
    if (!(denominator > 0 && numerator > 0)) return std::nullopt;
    const double r = numerator / denominator;
    if (!(r < kLargest)) return std::nullopt;
    return Circle{q + r * u, r};
  }

  [[nodiscard]] std::optional<MedialDisk> finished(Circle circle, Index third) const {
    const Index cycle = packing_.sides[i_].cycle;
    MedialDisk disk{circle, {i_, contact(ei_, circle.c)}, {j_, contact(ej_, circle.c)}, {}};
    if (!packing_.is_on(i_, disk.i.at) || !packing_.is_on(j_, disk.j.at)) return std::nullopt;
    disk.third.at = contact(packing_.elements[third], circle.c);
    const auto side = packing_.side_at(third, disk.third.at, cycle);
    if (!side) return std::nullopt;
    disk.third.side = *side;
    return disk;
  }

  const Packing& packing_;
  Index i_, j_;
  const Element& ei_;
  const Element& ej_;
  Point from_;
  double limit_ = 0;
};

}  // namespace

std::optional<MedialDisk> first_contact(const Packing& packing, Index i, Index j, Point from) {
  return Family(packing, i, j, from).first();
}

}  // namespace cover::disks
