// Tested by tests/cli/check_test.py.
#include "commands/check/rounded_points.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <cover/files.hpp>
#include <cover/write_mesh.hpp>

namespace cover::app {

RoundedPoints restore_digits(const std::string& path, const Pslg& pslg, TriangleSoup& mesh) {
  if (extension_of(path) != ".inp") return {};
  std::vector<Point> there = mesh.points;
  std::sort(there.begin(), there.end());
  const auto is_there = [&](Point p) { return std::binary_search(there.begin(), there.end(), p); };
  std::map<Point, std::vector<Point>> origins;  // of what the mesh has
  for (const Point& p : pslg.points) {
    if (const Point seen = rounded_by_inp(p); seen != p && !is_there(p) && is_there(seen))
      origins[seen].push_back(p);
  }
  RoundedPoints found;
  for (Point& p : mesh.points) {
    const auto origin = origins.find(p);
    if (origin == origins.end() || origin->second.size() > 1) continue;
    if (found.count == 0) found = {0, origin->second.front(), p};
    ++found.count;
    p = origin->second.front();
  }
  return found;
}

}  // namespace cover::app
