// Why parts are enough: verify_cover() shows of a part that its triangles cover its regions once
// and nothing else, with the segments around them as whole edges. Two regions of different parts
// have at most points and segments of the input in common. Where all parts have the same vertex at
// each of these points, an edge along a common segment has a triangle of either region on its
// sides; and no vertex of the inside of a region lies anywhere else.
//
// Tested by tests/unit/stream/check_in_parts_test.cpp.
#include <cover/check_in_parts.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <iterator>
#include <mutex>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

#include "base/containers/give_back.hpp"
#include "base/containers/order.hpp"
#include "base/faults/out_of_memory.hpp"
#include "base/run_all.hpp"
#include "base/sort_by_team.hpp"
#include "cdt/triangulation.hpp"
#include "io/vtk_files/mapped_triangles.hpp"
#include "layers/layer_rules.hpp"
#include "pipeline/prepare_regions.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/for_each_region.hpp"
#include "verify/verify_by_team.hpp"

namespace cover {
namespace {

/// Regions [first, last) by RegionId - 1, and their triangles in the file.
struct Part {
  std::uint32_t first = 0, last = 0;
  std::size_t first_triangle = 0, last_triangle = 0;
};

/// By region, where its triangles begin, and one more; nothing where regions do not come in order.
std::optional<std::vector<std::size_t>> first_triangles(const MappedTriangles& mesh,
                                                        std::size_t regions) {
  constexpr std::size_t kAtATime = std::size_t{1} << 22;
  std::vector<std::size_t> first{0};
  first.reserve(regions + 1);
  for (std::size_t t = 0; t < mesh.triangles; ++t) {
    const std::int32_t id = mesh.region[t];
    if (id < 1 || static_cast<std::size_t>(id) > regions ||
        static_cast<std::size_t>(id) < first.size())
      return std::nullopt;
    while (first.size() < static_cast<std::size_t>(id)) first.push_back(t);
    if (t % kAtATime == 0) mesh.file.forget();
  }
  first.resize(regions + 1, mesh.triangles);
  return first;
}

std::vector<Part> make_parts(std::span<const std::size_t> first, std::size_t triangles_each) {
  std::vector<Part> parts;
  for (std::uint32_t r = 0; r + 1 < first.size(); ++r) {
    if (parts.empty() || parts.back().last_triangle - parts.back().first_triangle >= triangles_each)
      parts.push_back({r, r, first[r], first[r]});
    parts.back().last = r + 1;
    parts.back().last_triangle = first[r + 1];
  }
  return parts;
}

/// Numbers by part, each part's in their order.
class ByPart {
 public:
  /// each(add) calls add(part, number) for all of them, twice the same.
  template <class Each>
  ByPart(std::size_t parts, Each each) : first_(parts + 1) {
    each([&](std::size_t part, std::uint32_t) { ++first_[part + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    numbers_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    each([&](std::size_t part, std::uint32_t number) { numbers_[next[part]++] = number; });
  }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t part) const {
    return std::span(numbers_).subspan(first_[part], first_[part + 1] - first_[part]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> numbers_;
};

/// A set of numbers, each with its place in the set: a bit for each number that there may be.
class NumbersInUse {
 public:
  explicit NumbersInUse(std::size_t numbers) : words_(numbers / 64 + 1, 0) {}

  /// May be called by several threads at a time.
  void add(std::uint32_t number) {
    const std::uint64_t bit = std::uint64_t{1} << number % 64;
    const std::atomic_ref word(words_[number / 64]);
    if ((word.load(std::memory_order_relaxed) & bit) == 0)
      word.fetch_or(bit, std::memory_order_relaxed);
  }

  /// The numbers, ascending. Nothing is added after that.
  std::vector<std::uint32_t> listed() {
    std::vector<std::uint32_t> numbers;
    before_.reserve(words_.size());
    for (std::uint32_t k = 0; k < words_.size(); ++k) {
      before_.push_back(static_cast<std::uint32_t>(numbers.size()));
      for (std::uint64_t word = words_[k]; word != 0; word &= word - 1)
        numbers.push_back(64 * k + static_cast<std::uint32_t>(std::countr_zero(word)));
    }
    return numbers;
  }

  /// The place of a number in that list.
  [[nodiscard]] std::uint32_t rank(std::uint32_t number) const {
    const std::uint64_t lower = words_[number / 64] & ((std::uint64_t{1} << number % 64) - 1);
    return before_[number / 64] + static_cast<std::uint32_t>(std::popcount(lower));
  }

 private:
  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> before_;  ///< by word: how many numbers there are in those before it
};

/// The input of a part, with all else as the void.
struct PartInput {
  Pslg pslg;
  RegionTable table;
  std::vector<std::uint32_t> point_of;  ///< VertexId of the whole, by VertexId of the part
};

class Checker {
 public:
  Checker(const Prepared& prepared, const MappedTriangles& mesh, const VerifyOptions& verify,
          std::vector<Part> parts)
      : pslg_(prepared.pslg),
        table_(prepared.table),
        mesh_(mesh),
        verify_(verify),
        parts_(std::move(parts)),
        part_of_(parts_of_regions(parts_, table_.regions.size())),
        segments_(parts_.size(), [this](auto add) { each_segment(add); }),
        isolated_(parts_.size(), [this](auto add) { each_isolated(add); }),
        vertex_of_(pslg_.points.size(), kNone),
        found_(parts_.size()) {}

  std::optional<CheckInParts> run(unsigned workers) {
    std::atomic<bool> holds = true;
    run_all(parts_.size(), workers, [&](std::size_t part, const Team& team) {
      if (!holds) return;
      const Status checked = errors_as_values("check", [&] { return check(part, team); });
      if (!checked) holds = false;
    });
    return holds ? std::optional(sum()) : std::nullopt;
  }

 private:
  static std::vector<std::uint32_t> parts_of_regions(std::span<const Part> parts,
                                                     std::size_t regions) {
    std::vector<std::uint32_t> part_of(regions);
    for (std::uint32_t p = 0; p < parts.size(); ++p)
      std::fill(part_of.begin() + parts[p].first, part_of.begin() + parts[p].last, p);
    return part_of;
  }

  template <class Add>
  void each_segment(Add add) const {
    for (std::uint32_t s = 0; s < table_.sides.size(); ++s) {
      const auto [left, right, interface] = table_.sides[s];
      const std::uint32_t one = left == kVoid ? kNone : part_of_[place_of(left)];
      const std::uint32_t other = right == kVoid ? kNone : part_of_[place_of(right)];
      if (one != kNone) add(one, s);
      if (other != kNone && other != one) add(other, s);
    }
  }
  template <class Add>
  void each_isolated(Add add) const {
    for (std::uint32_t k = 0; k < table_.isolated_points.size(); ++k)
      add(part_of_[place_of(table_.isolated_points[k].region)], k);
  }

  [[nodiscard]] PartInput input_of(std::size_t number) const {
    const Part& part = parts_[number];
    PartInput in;
    for (const std::uint32_t s : segments_[number]) {
      in.point_of.push_back(pslg_.segments[s].a.value());
      in.point_of.push_back(pslg_.segments[s].b.value());
    }
    for (const std::uint32_t k : isolated_[number])
      in.point_of.push_back(table_.isolated_points[k].vertex.value());
    sort_unique(in.point_of);
    const auto local = [&](VertexId v) {
      return VertexId{static_cast<std::size_t>(
          std::lower_bound(in.point_of.begin(), in.point_of.end(), v.value()) -
          in.point_of.begin())};
    };
    const auto region = [&](RegionId id) {
      return id == kVoid || place_of(id) < part.first || place_of(id) >= part.last
                 ? kVoid
                 : RegionId{id.index() - part.first};
    };
    for (const std::uint32_t v : in.point_of) {
      in.pslg.points.push_back(pslg_.points[v]);
      in.pslg.point_ids.push_back(static_cast<long>(v));
    }
    in.pslg.point_markers.resize(in.point_of.size());
    for (const std::uint32_t s : segments_[number]) {
      Segment segment = pslg_.segments[s];
      segment.a = local(segment.a);
      segment.b = local(segment.b);
      in.pslg.segments.push_back(segment);
      in.table.sides.push_back(
          {region(table_.sides[s].left), region(table_.sides[s].right), kNoInterface});
    }
    for (std::uint32_t r = part.first; r < part.last; ++r) {
      Region copy;
      copy.id = RegionId{static_cast<std::size_t>(r - part.first + 1)};
      copy.material = table_.regions[r].material;
      in.table.regions.push_back(std::move(copy));
    }
    for (const std::uint32_t k : isolated_[number]) {
      const IsolatedPoint& point = table_.isolated_points[k];
      in.table.isolated_points.push_back({local(point.vertex), region(point.region)});
    }
    return in;
  }

  /// The triangles of a part on points of their own; `vertices` are these points in the file.
  /// False where an index is none.
  bool read(const Part& part, TriangleSoup& soup, std::vector<std::uint32_t>& vertices,
            const Team& team) const {
    const std::size_t count = part.last_triangle - part.first_triangle;
    soup.triangles.resize(count);
    soup.region.resize(count);
    soup.material.resize(count);
    std::atomic<bool> is_right = true;
    NumbersInUse in_use(mesh_.points);
    team.each_range(count, kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last && is_right; ++t) {
        const std::size_t in_file = part.first_triangle + t;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto corner = as_index(mesh_.corners[3 * in_file + k], mesh_.points);
          if (!corner) {
            is_right = false;
            return;
          }
          soup.triangles[t][k] = static_cast<std::uint32_t>(*corner);
          in_use.add(soup.triangles[t][k]);
        }
        soup.region[t] = mesh_.region[in_file];
        soup.material[t] = mesh_.material[in_file];
      }
    });
    if (!is_right) return false;
    vertices = in_use.listed();
    team.each_range(count, kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        for (std::uint32_t& v : soup.triangles[t]) v = in_use.rank(v);
      }
    });
    soup.points.resize(vertices.size());
    team.each_range(vertices.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) soup.points[v] = mesh_.place(vertices[v]);
    });
    return true;
  }

  /// Whether other parts have the same vertices at the points of the input.
  bool agree_on_vertices(const PartInput& in, const TriangleSoup& soup,
                         std::span<const std::uint32_t> vertices, const Team& team) {
    const std::vector<Point>& points = in.pslg.points;
    std::vector<std::uint32_t> by_place(points.size());
    std::iota(by_place.begin(), by_place.end(), 0U);
    sort_by_team(
        by_place,
        [&](std::uint32_t p, std::uint32_t q) {
          return std::tie(points[p], p) < std::tie(points[q], q);
        },
        team);
    std::vector<std::uint32_t> input_point(vertices.size(), kNone);
    team.each_range(vertices.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        const auto at = std::lower_bound(
            by_place.begin(), by_place.end(), soup.points[v],
            [&](std::uint32_t p, const Point& place) { return points[p] < place; });
        if (at != by_place.end() && points[*at] == soup.points[v]) input_point[v] = *at;
      }
    });
    const std::lock_guard lock(mutex_);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (input_point[v] == kNone) continue;
      std::uint32_t& known = vertex_of_[in.point_of[input_point[v]]];
      if (known != kNone && known != vertices[v]) return false;
      known = vertices[v];
    }
    return true;
  }

  Status check(std::size_t number, const Team& team) {
    const Error broken{ErrorCode::other_mesh, "a promise is broken", {}, {}};
    const Part& part = parts_[number];
    TriangleSoup soup;
    std::vector<std::uint32_t> vertices;
    if (!read(part, soup, vertices, team)) return broken;
    mesh_.file.forget();
    const PartInput in = input_of(number);
    if (!agree_on_vertices(in, soup, vertices, team)) return broken;
    Verification found = verify_by_team(in.pslg, in.table, soup, verify_, team);
    if (found.violation_count > 0 || found.regions != part.last - part.first) return broken;
    give_back(found.triangle_regions);
    found_[number] = std::move(found);
    return ok();
  }

  CheckInParts sum() {
    CheckInParts all{{}, mesh_.triangles};
    for (Verification& found : found_) {
      all.found.regions += found.regions;
      all.found.within_rounding += found.within_rounding;
      std::move(found.limits.begin(), found.limits.end(), std::back_inserter(all.found.limits));
      all.found.unchecked = std::move(found.unchecked);
    }
    for (const SegmentSides& sides : table_.sides)
      all.found.segments_whole += sides.left != kVoid || sides.right != kVoid ? 1 : 0;
    return all;
  }

  const Pslg& pslg_;
  const RegionTable& table_;
  const MappedTriangles& mesh_;
  const VerifyOptions& verify_;
  std::vector<Part> parts_;
  std::vector<std::uint32_t> part_of_;  ///< by RegionId - 1
  ByPart segments_, isolated_;
  std::mutex mutex_;
  std::vector<std::uint32_t> vertex_of_;  ///< by VertexId: in the file, once it was met
  std::vector<Verification> found_;       ///< by part
};

}  // namespace

Result<Prepared> prepare_to_check(Input&& input, const Options& asked) {
  return memory_as_value("check", [&]() -> Result<Prepared> {
    StageClock clock;
    const Options options = with_layers_of(input, asked);
    Result<PreparedRegions> found =
        prepare_regions(std::move(input), options, {}, clock, Held::all);
    if (!found) return std::move(found).error();
    return std::move(found->prepared);
  });
}

std::optional<CheckInParts> check_in_parts(const Prepared& prepared, const std::string& path,
                                           const VerifyOptions& verify, const Options& options,
                                           std::size_t triangles_at_a_time) {
  const std::optional<MappedTriangles> mesh = map_triangles(path);
  if (!mesh || !verify.material_numbers) return std::nullopt;
  auto first = first_triangles(*mesh, prepared.table.regions.size());
  if (!first) return std::nullopt;
  std::vector<Part> parts = make_parts(*first, triangles_at_a_time);
  first = {};
  return Checker(prepared, *mesh, verify, std::move(parts)).run(worker_count(options));
}

}  // namespace cover
