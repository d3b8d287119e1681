// Tested by tests/unit/cuts/periodic/mirror_cuts_test.cpp.
#include "cuts/periodic/mirror_cuts.hpp"

#include <algorithm>
#include <tuple>

#include "base/containers/order.hpp"
#include "geom/isometry.hpp"

namespace cover {
namespace {

std::vector<Point> mapped(const Isometry& map, bool turned, std::vector<Point> points) {
  for (Point& p : points) p = image_of(map, p);
  if (turned) std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace

PeriodicClasses::PeriodicClasses(const Pslg& pslg) : maps_(pslg.isometries) {
  if (pslg.periodic.empty()) return;
  for (const Isometry& map : maps_) inverses_.push_back(inverse_of(map));
  number_.assign(pslg.segments.size(), 0);
  std::vector<Members> links(pslg.segments.size());
  for (const SegmentPair& pair : pslg.periodic) {
    links[pair.from.index()].push_back({pair.to, 0, pair.rule, false, pair.turned});
    links[pair.to.index()].push_back({pair.from, 0, pair.rule, true, pair.turned});
  }
  // From segments that are no images first, in the order of their places: it does not depend on the
  // order of the input.
  std::vector<std::size_t> order;
  for (std::size_t s = 0; s < links.size(); ++s) {
    if (!links[s].empty()) order.push_back(s);
  }
  const auto key = [&](std::size_t s) {
    const bool is_image = std::any_of(links[s].begin(), links[s].end(),
                                      [](const Member& link) { return link.is_back; });
    const Point a = pslg.points[pslg.segments[s].a.index()],
                b = pslg.points[pslg.segments[s].b.index()];
    return std::tuple(is_image, std::min(a, b), std::max(a, b));
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t s, std::size_t t) { return key(s) < key(t); });
  for (const std::size_t s : order) {
    if (number_[s] == 0) add_class(SegmentId{s}, links);
  }
}

void PeriodicClasses::add_class(SegmentId root, const std::vector<Members>& links) {
  Members members{{root, 0, 0, false, false}};
  number_[root.index()] = classes_.size() + 1;
  for (std::size_t head = 0; head < members.size(); ++head) {
    for (Member link : links[members[head].segment.index()]) {
      if (number_[link.segment.index()] != 0) continue;
      number_[link.segment.index()] = classes_.size() + 1;
      link.from = head;
      members.push_back(link);
    }
  }
  classes_.push_back(std::move(members));
}

std::vector<Point> PeriodicClasses::to_first(const Members& members, std::size_t at,
                                             std::vector<Point> points) const {
  for (; at != 0; at = members[at].from) {
    const Member& m = members[at];
    points = mapped((m.is_back ? maps_ : inverses_)[m.rule], m.turned, std::move(points));
  }
  return points;
}

std::vector<SegmentCut> PeriodicClasses::images(const SegmentCut& cut) const {
  if (!is_periodic(cut.segment)) return {cut};
  const Members& members = classes_[number_[cut.segment.index()] - 1];
  const auto at = std::find_if(members.begin(), members.end(),
                               [&](const Member& m) { return m.segment == cut.segment; });
  std::vector<SegmentCut> all{
      {members[0].segment,
       to_first(members, static_cast<std::size_t>(at - members.begin()), cut.points)}};
  for (std::size_t k = 1; k < members.size(); ++k) {
    const Member& m = members[k];
    all.push_back(
        {m.segment, mapped((m.is_back ? inverses_ : maps_)[m.rule], m.turned, all[m.from].points)});
  }
  return all;
}

std::vector<SegmentId> PeriodicClasses::with_classes(std::vector<SegmentId> segments) const {
  const std::size_t given = segments.size();
  for (std::size_t k = 0; k < given; ++k) {
    if (!is_periodic(segments[k])) continue;
    for (const Member& m : classes_[number_[segments[k].index()] - 1])
      segments.push_back(m.segment);
  }
  sort_unique(segments);
  return segments;
}

std::vector<SegmentCut> PeriodicClasses::with_images(std::vector<SegmentCut> cuts) const {
  if (classes_.empty()) return cuts;
  std::vector<SegmentCut> all;
  std::vector<const SegmentCut*> chosen(classes_.size(), nullptr);
  std::vector<std::size_t> place(number_.size(), 0);  // of a segment in its class
  for (const Members& members : classes_) {
    for (std::size_t k = 0; k < members.size(); ++k) place[members[k].segment.index()] = k;
  }
  for (const SegmentCut& cut : cuts) {
    if (!is_periodic(cut.segment)) {
      all.push_back(cut);
      continue;
    }
    const SegmentCut*& best = chosen[number_[cut.segment.index()] - 1];
    if (best == nullptr || cut.points.size() > best->points.size() ||
        (cut.points.size() == best->points.size() &&
         place[cut.segment.index()] < place[best->segment.index()]))
      best = &cut;
  }
  for (const SegmentCut* cut : chosen) {
    if (cut == nullptr) continue;
    for (SegmentCut& image : images(*cut)) all.push_back(std::move(image));
  }
  std::sort(all.begin(), all.end(),
            [](const SegmentCut& x, const SegmentCut& y) { return x.segment < y.segment; });
  return all;
}

}  // namespace cover
