// What cuts a periodic segment cuts its images alike.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <cover/pslg.hpp>

#include "cuts/cut_segments.hpp"

namespace cover {

/// The segments of a Pslg by classes of images: those that Pslg::periodic joins, directly or over
/// others.
class PeriodicClasses {
 public:
  /// Cost: O(n), or O(1) where nothing is periodic
  explicit PeriodicClasses(const Pslg& pslg);

  /// Whether `s` has images.
  [[nodiscard]] bool is_periodic(SegmentId s) const {
    return !number_.empty() && number_[s.index()] != 0;
  }

  /// `cut` itself and all its images. Where there are any, the points are first taken to the first
  /// segment of the class and then from there to all others, `cut.segment` too, so that they are
  /// rounded images of each other as given points are.
  [[nodiscard]] std::vector<SegmentCut> images(const SegmentCut& cut) const;

  /// Adds the segments that are images of `segments`; in order, without repeats.
  [[nodiscard]] std::vector<SegmentId> with_classes(std::vector<SegmentId> segments) const;

  /// `cuts` and their images, in the order of segments. Of several cuts of one class, the one with
  /// most points counts, and among these the one on the first segment of the class.
  ///
  /// REQUIRES: each segment at most once in `cuts`
  [[nodiscard]] std::vector<SegmentCut> with_images(std::vector<SegmentCut> cuts) const;

 private:
  /// A segment, and how it follows from another one of its class.
  struct Member {
    SegmentId segment;
    std::size_t from = 0;  ///< position in the class; itself: the first one
    std::size_t rule = 0;  ///< of the map that takes the points of `from` here
    bool is_back = false;  ///< by the inverse of that map
    bool turned = false;   ///< as SegmentPair::turned
  };
  using Members = std::vector<Member>;

  void add_class(SegmentId root, const std::vector<std::vector<Member>>& links);
  [[nodiscard]] std::vector<Point> to_first(const Members& members, std::size_t at,
                                            std::vector<Point> points) const;

  std::vector<Isometry> maps_, inverses_;
  std::vector<std::size_t> number_;  ///< by segment: of its class plus one; 0: none
  std::vector<Members> classes_;     ///< each from its first segment on
};

}  // namespace cover
