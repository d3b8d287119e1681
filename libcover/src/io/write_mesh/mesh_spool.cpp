// Tested by tests/unit/stream/stream_mesh_test.cpp.
#include "io/write_mesh/mesh_spool.hpp"

#include <algorithm>

namespace cover {
namespace {

constexpr std::size_t kVerticesAtATime = 1 << 16;

template <class T>
std::span<const std::byte> bytes_of(std::span<const T> items) {
  return std::as_bytes(items);
}

template <class T>
void put(std::span<const T> items, std::vector<std::byte>& out) {
  const auto bytes = bytes_of(items);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

template <class T>
std::span<std::byte> room_of(std::vector<T>& items) {
  return std::as_writable_bytes(std::span(items));
}

}  // namespace

Result<MeshSpool> MeshSpool::beside(const std::string& target, std::span<const Point> input,
                                    std::size_t regions) {
  Result<SpoolFile> file = SpoolFile::beside(target);
  if (!file) return std::move(file).error();
  MeshSpool spool(*std::move(file), input.size(), regions);
  spool.file_.append(bytes_of(input));
  return spool;
}

Result<MeshSpool> MeshSpool::without_input(const std::string& target, std::size_t input_vertices,
                                           std::size_t regions) {
  Result<SpoolFile> file = SpoolFile::beside(target);
  if (!file) return std::move(file).error();
  MeshSpool spool(*std::move(file), input_vertices, regions);
  spool.has_input_ = false;
  return spool;
}

void MeshSpool::add(std::size_t region, std::span<const Point> steiner,
                    std::span<const IndexTriple> triangles,
                    std::span<const std::array<double, 2>> angles) {
  std::vector<std::byte> bytes;
  bytes.reserve(steiner.size_bytes() + triangles.size_bytes() + angles.size_bytes());
  put(steiner, bytes);
  put(triangles, bytes);
  std::vector<double> column(angles.size());
  for (const std::size_t k : {0U, 1U}) {
    std::transform(angles.begin(), angles.end(), column.begin(),
                   [k](const std::array<double, 2>& both) { return both[k]; });
    put(std::span<const double>(column), bytes);
  }
  places_[region] = {file_.append(bytes), static_cast<std::uint32_t>(steiner.size()),
                     static_cast<std::uint32_t>(triangles.size())};
}

Status MeshSpool::finish() {
  first_steiner_.resize(places_.size());
  vertices_ = input_vertices_;
  triangles_ = 0;
  for (std::size_t r = 0; r < places_.size(); ++r) {
    first_steiner_[r] = static_cast<std::uint32_t>(vertices_);
    vertices_ += places_[r].steiner;
    triangles_ += places_[r].triangles;
  }
  return file_.status();
}

bool MeshSpool::has_all() const {
  return has_input_ && std::all_of(places_.begin(), places_.end(),
                                   [](const Place& place) { return place.at != kElsewhere; });
}

std::vector<std::uint64_t> MeshSpool::first_triangles() const {
  std::vector<std::uint64_t> first{0};
  first.reserve(places_.size() + 1);
  for (const Place& place : places_) first.push_back(first.back() + place.triangles);
  return first;
}

Status MeshSpool::each_input_vertex(const Points& use) const {
  std::vector<Point> room;
  for (std::size_t done = 0; done < input_vertices_; done += room.size()) {
    room.resize(std::min(kVerticesAtATime, input_vertices_ - done));
    if (Status status = file_.read(done * sizeof(Point), room_of(room)); !status) return status;
    use(room);
  }
  return ok();
}

Status MeshSpool::each_vertex(const Points& use) const {
  if (Status status = each_input_vertex(use); !status) return status;
  std::vector<Point> room;
  for (std::size_t r = 0; r < places_.size(); ++r) {
    if (places_[r].steiner == 0) continue;
    room.resize(places_[r].steiner);
    if (Status status = read_steiner(r, 0, room); !status) return status;
    use(room);
  }
  return ok();
}

Status MeshSpool::corners_of(std::size_t region, std::uint32_t first_steiner,
                             std::vector<IndexTriple>& room) const {
  room.resize(places_[region].triangles);
  return read_corners(region, first_steiner, 0, room);
}

Status MeshSpool::read_steiner(std::size_t region, std::size_t first, std::span<Point> out) const {
  return file_.read(places_[region].at + first * sizeof(Point), std::as_writable_bytes(out));
}

Status MeshSpool::read_corners(std::size_t region, std::uint32_t first_steiner, std::size_t first,
                               std::span<IndexTriple> out) const {
  const Place& place = places_[region];
  Status status = file_.read(place.at + place.steiner * sizeof(Point) + first * sizeof(IndexTriple),
                             std::as_writable_bytes(out));
  if (!status) return status;
  const auto inputs = static_cast<std::uint32_t>(input_vertices_);
  for (IndexTriple& t : out) {
    for (std::uint32_t& v : t) {
      if (v >= inputs) v = first_steiner + (v - inputs);
    }
  }
  return ok();
}

Status MeshSpool::read_angles(std::size_t region, bool largest, std::size_t first,
                              std::span<double> out) const {
  const Place& place = places_[region];
  const std::size_t column = largest ? 0 : place.triangles;
  const std::uint64_t at = place.at + place.steiner * sizeof(Point) +
                           place.triangles * sizeof(IndexTriple) +
                           (column + first) * sizeof(double);
  return file_.read(at, std::as_writable_bytes(out));
}

Status MeshSpool::each_triangle(const Corners& use) const {
  std::vector<IndexTriple> room;
  for (std::size_t r = 0; r < places_.size(); ++r) {
    if (Status status = corners_of(r, first_steiner_[r], room); !status) return status;
    use(r, room);
  }
  return ok();
}

Status MeshSpool::triangles_of(std::span<const std::uint32_t> regions, const Corners& use) const {
  std::vector<IndexTriple> room;
  for (const std::uint32_t r : regions) {
    if (Status status = corners_of(r, first_steiner_[r], room); !status) return status;
    use(r, room);
  }
  return ok();
}

Status MeshSpool::each_angle(bool largest, const Angles& use) const {
  std::vector<double> room;
  for (std::size_t r = 0; r < places_.size(); ++r) {
    room.resize(places_[r].triangles);
    if (Status status = read_angles(r, largest, 0, room); !status) return status;
    use(room);
  }
  return ok();
}

Result<std::vector<Point>> MeshSpool::input_points() const {
  std::vector<Point> points(input_vertices_);
  if (Status status = file_.read(0, room_of(points)); !status) return std::move(status).error();
  return points;
}

}  // namespace cover
