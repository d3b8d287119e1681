// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/parts/check_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/core.h>

namespace cover {
namespace {

Error out_of_range(std::string message) {
  return {ErrorCode::id_out_of_range, std::move(message), {}, {}};
}

/// Whether an array that may be left out has a value for each of `things`.
Status check_size(const std::string& what, std::size_t size, std::size_t things, const char* of) {
  if (size == 0 || size == things) return ok();
  return out_of_range(fmt::format("{} has {} values for {} {}", what, size, things, of));
}

Status check_indices(const PictureMesh& mesh) {
  const TriangleSoup& soup = mesh.mesh.soup;
  const std::size_t n = soup.points.size();
  const auto is_missing = [n](std::uint32_t v) { return v >= n; };
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (std::any_of(soup.triangles[t].begin(), soup.triangles[t].end(), is_missing))
      return out_of_range(fmt::format("triangle {} has a point that is not there", t));
  }
  for (const PictureLine& line : mesh.lines) {
    for (const auto& edge : line.edges) {
      if (std::any_of(edge.begin(), edge.end(), is_missing))
        return out_of_range(fmt::format("the line '{}' has a point that is not there", line.name));
    }
  }
  for (const std::vector<std::uint32_t>& vertices : mesh.periodic) {
    if (std::any_of(vertices.begin(), vertices.end(), is_missing))
      return out_of_range("a vertex on a periodic side is not there");
  }
  return ok();
}

/// Whether all places are in the plane.
Status check_places(const MeshFile& mesh) {
  const auto is_finite = [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  const auto refuse = [](std::string message, Point p) {
    return Error{ErrorCode::non_finite_coordinate, std::move(message), {p}, {}};
  };
  for (std::size_t v = 0; v < mesh.soup.points.size(); ++v) {
    if (const Point p = mesh.soup.points[v]; !is_finite(p))
      return refuse(fmt::format("point {} is not finite", v), p);
  }
  for (std::size_t t = 0; t < mesh.middles.size(); ++t) {
    for (const Point& p : mesh.middles[t])
      if (!is_finite(p)) return refuse(fmt::format("a node of triangle {} is not finite", t), p);
  }
  return ok();
}

}  // namespace

Status check_picture(const PictureMesh& mesh) {
  const TriangleSoup& soup = mesh.mesh.soup;
  const std::size_t triangles = soup.triangles.size();
  if (Status status = check_indices(mesh); !status) return status;
  if (Status status = check_places(mesh.mesh); !status) return status;
  Status status = check_size("the array of regions", soup.region.size(), triangles, "triangles");
  if (status)
    status = check_size("the array of materials", soup.material.size(), triangles, "triangles");
  if (status)
    status =
        check_size("the array of middle nodes", mesh.mesh.middles.size(), triangles, "triangles");
  return status;
}

}  // namespace cover
