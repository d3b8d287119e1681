// Tested by tests/unit/io/write_mesh/partition_test.cpp.
#include "io/write_mesh/partition.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "base/containers/buckets.hpp"
#include "base/containers/order.hpp"
#include "geom/spatial_order.hpp"

namespace cover {
namespace {

/// Indices of places along a Hilbert curve.
std::vector<std::uint32_t> along_curve(const std::vector<Point>& places) {
  const std::vector<std::uint32_t> order = sorted_numbers(
      places.size(), [&](std::uint32_t a, std::uint32_t b) { return places[a] < places[b]; });
  std::vector<std::uint32_t> curve = spatial_order(in_order(places, order));
  for (std::uint32_t& k : curve) k = order[k];
  return curve;
}

/// The regions that have triangles, as places on the curve.
std::vector<std::uint32_t> ordered_regions(const std::vector<Point>& centres,
                                           const Buckets& members) {
  std::vector<std::uint32_t> used;
  std::vector<Point> places;
  for (std::uint32_t r = 0; r < members.size(); ++r) {
    if (members[r].empty()) continue;
    used.push_back(r);
    Point sum;
    for (const std::size_t t : members[r]) {
      sum.x += centres[t].x / static_cast<double>(members[r].size());
      sum.y += centres[t].y / static_cast<double>(members[r].size());
    }
    places.push_back(sum);
  }
  std::vector<std::uint32_t> order = along_curve(places);
  for (std::uint32_t& k : order) k = used[k];
  return order;
}

/// Where each part ends in a sequence of regions with these sizes.
std::vector<std::size_t> ends_of_parts(const std::vector<std::size_t>& sizes, std::size_t all,
                                       std::uint32_t parts) {
  constexpr std::size_t kSmall = 8;  // of a part
  std::vector<std::size_t> ends;
  std::size_t region = 0, before = 0;  // triangles before that region
  for (std::uint32_t p = 1; p <= parts; ++p) {
    std::size_t end = all * p / parts;
    while (region < sizes.size() && before + sizes[region] <= end) before += sizes[region++];
    // The end is inside of that region, or where it begins.
    if (region < sizes.size() && end > before && kSmall * parts * sizes[region] <= all)
      end = 2 * (end - before) < sizes[region] ? before : before + sizes[region];
    ends.push_back(std::max(end, ends.empty() ? 0 : ends.back()));
  }
  return ends;
}

void add_ghosts(const MeshView& view, Partition& out) {
  const Cells& triangles = view.triangles;
  const Buckets around(view.points.size(), 3 * triangles.size(),
                       [&](std::size_t c) { return triangles[c / 3][c % 3]; });
  std::vector<std::uint32_t> seen(triangles.size(), static_cast<std::uint32_t>(out.parts.size()));
  for (std::uint32_t p = 0; p < out.parts.size(); ++p) {
    MeshPart& part = out.parts[p];
    for (const std::size_t t : part.own) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (const std::size_t corner : around[triangles[t][k]]) {
          const std::size_t other = corner / 3;
          if (out.owner[other] == p || seen[other] == p) continue;
          seen[other] = p;
          part.ghosts.push_back(other);
        }
      }
    }
    std::sort(part.ghosts.begin(), part.ghosts.end());
  }
}

}  // namespace

Partition partition_of(const MeshView& view, std::uint32_t parts) {
  const std::size_t count = view.triangles.size();
  std::vector<Point> centres;
  centres.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    const auto corners = view.triangles[t];
    const Point a = view.points[corners[0]], b = view.points[corners[1]],
                c = view.points[corners[2]];
    centres.push_back({a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3});
  }
  const Buckets members(view.region_group.size(), count,
                        [&](std::size_t t) { return place_of(view.region[t]); });
  const std::vector<std::uint32_t> regions = ordered_regions(centres, members);
  std::vector<std::size_t> sizes, sequence;
  sequence.reserve(count);
  for (const std::uint32_t r : regions) {
    sizes.push_back(members[r].size());
    std::vector<Point> places;
    for (const std::size_t t : members[r]) places.push_back(centres[t]);
    for (const std::uint32_t k : along_curve(places)) sequence.push_back(members[r][k]);
  }
  Partition out;
  out.owner.resize(count);
  out.vertex_owner.assign(view.points.size(), parts);
  out.parts.resize(parts);
  const std::vector<std::size_t> ends = ends_of_parts(sizes, count, parts);
  std::size_t at = 0;
  for (std::uint32_t p = 0; p < parts; ++p) {
    std::vector<std::size_t>& own = out.parts[p].own;
    for (; at < ends[p]; ++at) {
      own.push_back(sequence[at]);
      out.owner[sequence[at]] = p;
      for (const std::uint32_t v : view.triangles[sequence[at]])
        out.vertex_owner[v] = std::min(out.vertex_owner[v], p);
    }
    std::sort(own.begin(), own.end());
  }
  add_ghosts(view, out);
  return out;
}

Error periodic_in_parts(const std::string& path) {
  return {ErrorCode::bad_option,
          fmt::format("cannot write '{}' in parts: periodic sides have no place in them", path),
          {},
          {}};
}

}  // namespace cover
