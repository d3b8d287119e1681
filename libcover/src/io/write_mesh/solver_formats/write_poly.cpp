// Triangle's .poly with everything in one file. Each region gets a seed with its material and each
// enclosed void face a hole, so that a reader needs no rule about unseeded faces; named lines get
// numbers as markers; names, for which the format has no place, stand in comments.
// Tested by tests/unit/io/write_mesh/solver_formats/write_poly_test.cpp.
#include <cover/write_mesh.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "base/faults/out_of_memory.hpp"
#include "io/files/atomic_file.hpp"

namespace cover {
namespace {

void write_points(std::string& text, const Pslg& pslg) {
  const auto& markers = pslg.point_markers;
  const bool marked = std::any_of(markers.begin(), markers.end(), [](int m) { return m != 0; });
  text += fmt::format("{} 2 0 {}\n", pslg.points.size(), marked ? 1 : 0);
  for (std::size_t k = 0; k < pslg.points.size(); ++k) {
    const Point p = pslg.points[k];
    text += fmt::format("{} {:.17g} {:.17g}", k + 1, p.x, p.y);
    if (marked) text += fmt::format(" {}", markers[k]);
    text.push_back('\n');
  }
}

/// A name that does not end its comment line.
std::string on_one_line(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return name;
}

/// By SegmentId: the input's marker; else, of a named line, a number that is no marker.
std::vector<int> markers_of(const Pslg& pslg) {
  std::set<int> taken{0};
  for (const Segment& segment : pslg.segments) taken.insert(segment.marker);
  std::map<std::uint32_t, int> of_name;  // in the order of names, whatever that of segments is
  for (const Segment& segment : pslg.segments)
    if (segment.marker == 0 && !pslg.names[segment.name].empty()) of_name[segment.name] = 0;
  int next = 0;
  for (auto& [name, marker] : of_name) {
    while (taken.contains(next)) ++next;
    marker = next++;
  }
  std::vector<int> markers;
  markers.reserve(pslg.segments.size());
  for (const Segment& segment : pslg.segments) {
    const auto named = of_name.find(segment.name);
    markers.push_back(segment.marker != 0 || named == of_name.end() ? segment.marker
                                                                    : named->second);
  }
  return markers;
}

void write_segments(std::string& text, const Pslg& pslg) {
  const std::vector<int> markers = markers_of(pslg);
  std::set<std::pair<int, std::uint32_t>> named;
  for (std::size_t s = 0; s < markers.size(); ++s)
    if (!pslg.names[pslg.segments[s].name].empty())
      named.emplace(markers[s], pslg.segments[s].name);
  for (const auto& [marker, name] : named)
    text += fmt::format("# marker {}: {}\n", marker, on_one_line(pslg.names[name]));
  const bool marked = std::any_of(markers.begin(), markers.end(), [](int m) { return m != 0; });
  text += fmt::format("{} {}\n", pslg.segments.size(), marked ? 1 : 0);
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment& segment = pslg.segments[s];
    text += fmt::format("{} {} {}", s + 1, segment.a.value() + 1, segment.b.value() + 1);
    if (marked) text += fmt::format(" {}", markers[s]);
    text.push_back('\n');
  }
}

constexpr std::string_view kUnnamed = "unnamed";

/// Whether a region that no seed can name is unnamed anyway. A reader gives faces without a seed
/// the material above the largest, so the others of that material must have no seed either.
bool must_omit_unnamed(const RegionTable& table) {
  int largest = 0;
  bool omit = false;
  for (const Region& r : table.regions) {
    if (r.material_name != kUnnamed) largest = std::max(largest, r.material);
    omit |= r.material_name == kUnnamed && !r.inside;
  }
  return omit && std::all_of(table.regions.begin(), table.regions.end(), [&](const Region& r) {
           return r.material_name != kUnnamed || r.material == largest + 1;
         });
}

void write_seeds(std::string& text, const RegionTable& table) {
  text += fmt::format("{}\n", table.void_seeds.size());
  for (std::size_t k = 0; k < table.void_seeds.size(); ++k) {
    const Point p = table.void_seeds[k];
    text += fmt::format("{} {:.17g} {:.17g}\n", k + 1, p.x, p.y);
  }
  const bool omit = must_omit_unnamed(table);
  const auto has_seed = [&](const Region& r) {
    return r.inside && !(omit && r.material_name == kUnnamed);
  };
  text += fmt::format("{}\n", std::count_if(table.regions.begin(), table.regions.end(), has_seed));
  for (const Region& r : table.regions) {
    if (!has_seed(r)) {
      if (!r.inside) {
        text += fmt::format("# region {}, {}, {}, holds no double: no seed\n", r.id.value(),
                            on_one_line(r.name), on_one_line(r.material_name));
      }
      continue;
    }
    // The largest area as the reader understands it: of an equilateral triangle of that edge.
    const double area = r.size ? *r.size * *r.size * std::numbers::sqrt3 / 4 : -1;
    text += fmt::format("{} {:.17g} {:.17g} {} {:.17g}  # {}, {}\n", r.id.value(), r.inside->x,
                        r.inside->y, r.material, area, on_one_line(r.name),
                        on_one_line(r.material_name));
  }
}

}  // namespace

Status write_poly(const Pslg& pslg, const RegionTable& table, const std::string& path,
                  const WriteOptions& options) {
  return memory_as_value(path, [&]() -> Status {
    std::string text;
    text += fmt::format("# points\n");
    write_points(text, pslg);
    text += fmt::format("# segments\n");
    write_segments(text, pslg);
    text += fmt::format("# holes, then regions: material, area, name\n");
    write_seeds(text, table);
    Result<AtomicFile> file = AtomicFile::create(path, options.stop);
    if (!file) return file.error();
    file->write({text.data(), text.size()});
    return file->commit();
  });
}

}  // namespace cover
