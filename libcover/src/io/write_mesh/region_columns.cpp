// Regions that follow each other are neighbours in every array, so that a stretch of them is one
// piece of each. Tested by tests/unit/stream/kept_regions_test.cpp.
#include "io/write_mesh/region_columns.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <utility>

#include "io/write_mesh/placed_file.hpp"

namespace cover {
namespace {

constexpr std::size_t kCornersEach = 3;
constexpr std::uint8_t kTriangle = 5;  // as VTK has it
/// Of a stretch: some ten megabytes of the file.
constexpr std::size_t kTrianglesOfStretch = 1 << 17;
/// What is read at a time.
constexpr std::size_t kAtATime = 1 << 14;

/// Regions [first, last) that are here.
struct Stretch {
  std::size_t first = 0, last = 0;
};

/// Gathers the bytes of one array from a place on.
class ColumnWriter {
 public:
  ColumnWriter(PlacedFile& file, std::uint64_t at) : file_(file), at_(at) {}
  ~ColumnWriter() { file_.write(at_, bytes_); }
  ColumnWriter(const ColumnWriter&) = delete;
  ColumnWriter& operator=(const ColumnWriter&) = delete;

  template <class T>
  void put(T value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    if (bytes_.size() < kFull) return;
    file_.write(at_, bytes_);
    at_ += bytes_.size();
    bytes_.clear();
  }

 private:
  static constexpr std::size_t kFull = 1 << 20;

  PlacedFile& file_;
  std::uint64_t at_;
  std::string bytes_;
};

class Columns {
 public:
  Columns(const MeshSpool& spool, const ColumnPlan& plan, PlacedFile& file)
      : spool_(spool), plan_(plan), file_(file) {
    first_steiner_.reserve(plan.regions.size());
    first_triangle_.reserve(plan.regions.size());
    std::uint64_t vertices = plan.input_vertices, triangles = 0;
    for (const RegionCounts& region : plan.regions) {
      first_steiner_.push_back(vertices);
      first_triangle_.push_back(triangles);
      vertices += region.steiner;
      triangles += region.triangles;
    }
  }

  Status write(const Team& team) {
    if (spool_.has_input()) write_input();
    const std::vector<Stretch> stretches = find_stretches();
    const std::size_t columns = plan_.columns.size();
    team.each(stretches.size() * columns, [&](std::size_t k) {
      if (file_.is_good()) write(stretches[k / columns], plan_.columns[k % columns]);
    });
    const std::lock_guard lock(mutex_);
    return std::move(status_);
  }

 private:
  [[nodiscard]] std::vector<Stretch> find_stretches() const {
    std::vector<Stretch> stretches;
    std::size_t triangles = 0;
    for (std::size_t r = 0; r < plan_.regions.size(); ++r) {
      if (!spool_.has(r)) continue;
      if (stretches.empty() || stretches.back().last != r || triangles >= kTrianglesOfStretch) {
        stretches.push_back({r, r});
        triangles = 0;
      }
      stretches.back().last = r + 1;
      triangles += plan_.regions[r].triangles;
    }
    return stretches;
  }

  static void put_place(Point place, ColumnWriter& out) {
    out.put(std::array<double, 3>{place.x, place.y, 0});
  }

  void write_input() {
    for (const ColumnPlace& column : plan_.columns) {
      if (column.column == Column::ends) {
        ColumnWriter(file_, column.at).put(std::int64_t{0});
      } else if (column.column == Column::places) {
        ColumnWriter out(file_, column.at);
        keep(spool_.each_input_vertex([&](std::span<const Point> places) {
          for (const Point& place : places) put_place(place, out);
        }));
      }
    }
  }

  void write(const Stretch& stretch, const ColumnPlace& column) {
    switch (column.column) {
      case Column::places:
        return write_places(stretch, column.at);
      case Column::corners:
        return write_corners(stretch, column.at);
      case Column::ends:
        return of_triangles<std::int64_t>(
            stretch, column.at + sizeof(std::int64_t), [](std::size_t, std::uint64_t t) {
              return static_cast<std::int64_t>(kCornersEach * (t + 1));
            });
      case Column::types:
        return of_triangles<std::uint8_t>(stretch, column.at,
                                          [](std::size_t, std::uint64_t) { return kTriangle; });
      case Column::material:
        return of_triangles<std::int32_t>(stretch, column.at, [this](std::size_t r, std::uint64_t) {
          return plan_.regions[r].material;
        });
      case Column::region:
        return of_triangles<std::int32_t>(stretch, column.at, [](std::size_t r, std::uint64_t) {
          return static_cast<std::int32_t>(r + 1);
        });
      case Column::largest:
      case Column::smallest:
        return write_angles(stretch, column.at, column.column == Column::largest);
    }
  }

  /// Numbers of the triangles that need nothing of the spool.
  template <class T, class Value>
  void of_triangles(const Stretch& stretch, std::uint64_t at, Value value) {
    std::uint64_t t = first_triangle_[stretch.first];
    ColumnWriter out(file_, at + t * sizeof(T));
    for (std::size_t r = stretch.first; r < stretch.last; ++r) {
      const std::uint64_t end = t + plan_.regions[r].triangles;
      for (; t < end; ++t) out.put(value(r, t));
    }
  }

  /// What regions have in the spool, some at a time.
  template <class T, class Read, class Put>
  void of_spool(const Stretch& stretch, std::uint32_t RegionCounts::*count, Read read, Put put) {
    std::vector<T> room;
    for (std::size_t r = stretch.first; r < stretch.last; ++r) {
      const std::size_t all = plan_.regions[r].*count;
      for (std::size_t done = 0; done < all && file_.is_good(); done += room.size()) {
        room.resize(std::min(kAtATime, all - done));
        if (Status status = read(r, done, std::span(room)); !status) return keep(std::move(status));
        for (const T& item : room) put(item);
      }
    }
  }

  void write_places(const Stretch& stretch, std::uint64_t at) {
    ColumnWriter out(file_, at + first_steiner_[stretch.first] * 3 * sizeof(double));
    of_spool<Point>(
        stretch, &RegionCounts::steiner,
        [&](std::size_t r, std::size_t first, std::span<Point> room) {
          return spool_.read_steiner(r, first, room);
        },
        [&](const Point& place) { put_place(place, out); });
  }

  void write_corners(const Stretch& stretch, std::uint64_t at) {
    ColumnWriter out(file_,
                     at + first_triangle_[stretch.first] * kCornersEach * sizeof(std::int64_t));
    of_spool<IndexTriple>(
        stretch, &RegionCounts::triangles,
        [&](std::size_t r, std::size_t first, std::span<IndexTriple> room) {
          return spool_.read_corners(r, static_cast<std::uint32_t>(first_steiner_[r]), first, room);
        },
        [&](const IndexTriple& t) {
          out.put(std::array<std::int64_t, 3>{t[0], t[1], t[2]});
        });
  }

  void write_angles(const Stretch& stretch, std::uint64_t at, bool largest) {
    ColumnWriter out(file_, at + first_triangle_[stretch.first] * sizeof(double));
    of_spool<double>(
        stretch, &RegionCounts::triangles,
        [&](std::size_t r, std::size_t first, std::span<double> room) {
          return spool_.read_angles(r, largest, first, room);
        },
        [&](double angle) { out.put(angle); });
  }

  void keep(Status status) {
    const std::lock_guard lock(mutex_);
    if (status_ && !status) status_ = std::move(status);
  }

  const MeshSpool& spool_;
  const ColumnPlan& plan_;
  PlacedFile& file_;
  std::vector<std::uint64_t> first_steiner_, first_triangle_;  ///< by region
  std::mutex mutex_;
  Status status_ = ok();
};

}  // namespace

Status write_columns(const MeshSpool& spool, const ColumnPlan& plan, const std::stop_token& stop,
                     const Team& team) {
  Result<PlacedFile> file = PlacedFile::open(plan.path, plan.shown, stop);
  if (!file) return std::move(file).error();
  Status read = Columns(spool, plan, *file).write(team);
  Status written = file->finish();
  return read ? written : read;
}

}  // namespace cover
