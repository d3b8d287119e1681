// The input is prepared as always, except that segments get the cuts that the mesh has. Then the
// mesh is checked against it as any mesh is (verify_cover), which also tells in which region each
// triangle lies; the meshes of all other regions are taken out of it, and everything is stitched
// anew.
// Tested by tests/unit/pipeline/remesh_test.cpp and tests/property/remesh_property_test.cpp.
#include <cover/adopt_cuts.hpp>
#include <cover/periodic.hpp>
#include <cover/remesh.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/option_ranges.hpp>
#include <cover/regions.hpp>
#include <cover/text.hpp>
#include <cover/verify.hpp>

#include "base/containers/order.hpp"
#include "base/faults/errors.hpp"
#include "base/words/and_more.hpp"
#include "cdt/cdt.hpp"
#include "cuts/periodic/match_sides.hpp"
#include "layers/layer_rules.hpp"
#include "method/boundaries_with_wishes.hpp"
#include "pipeline/prepare_regions.hpp"
#include "pipeline/steps.hpp"
#include "sizes/expected_triangles.hpp"
#include "sizes/sizes.hpp"
#include "target/report/fill_report.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/followed_run.hpp"
#include "tasks/for_each_region.hpp"
#include "tasks/mesh_regions.hpp"

namespace cover {
namespace {

constexpr std::size_t kNamed = 5;  ///< in a message

/// The mesh that is there, by regions of the input.
class OldMesh {
 public:
  explicit OldMesh(const TriangleSoup& soup) : soup_(soup) {}

  /// Finds out in which region each triangle lies.
  ///
  /// Errors: other_mesh, if the mesh is not one of this input
  Status find_triangles(const Pslg& pslg, const RegionTable& table, bool hull) {
    VerifyOptions options;
    options.bound = false;
    options.hull = hull;
    options.materials = false;  // they may have got lost in a file: see other_materials()
    const Verification found = verify_cover(pslg, table, soup_, options);
    of_region_.assign(table.regions.size(), {});
    for (std::uint32_t t = 0; t < found.triangle_regions.size(); ++t) {
      const RegionId region = found.triangle_regions[t];
      if (region != kVoid) of_region_[place_of(region)].push_back(t);
    }
    if (found.violations.empty()) {
      find_vertices(pslg);
      return ok();
    }
    return misfit(pslg, table, found);
  }

  /// The mesh of one region over its boundary.
  [[nodiscard]] RegionMesh take(const RegionBoundary& boundary) const {
    RegionMesh mesh;
    const auto& own = of_region_[place_of(boundary.id)];
    const auto fixed = static_cast<std::uint32_t>(boundary.points.size());
    std::vector<std::uint32_t> vertices;  // of the old mesh, those of the boundary left out
    std::vector<std::pair<std::uint32_t, std::uint32_t>> local;
    for (std::uint32_t k = 0; k < fixed; ++k) {
      local.emplace_back(vertex_[boundary.vertices[k].index()], k);
    }
    std::sort(local.begin(), local.end());
    const auto on_boundary = [&](std::uint32_t v) {
      const auto at = std::lower_bound(local.begin(), local.end(), std::pair(v, 0U));
      return at != local.end() && at->first == v ? at->second : kNone;
    };
    for (const std::uint32_t t : own) {
      for (const std::uint32_t v : soup_.triangles[t]) {
        if (on_boundary(v) == kNone) vertices.push_back(v);
      }
    }
    sort_unique(vertices);
    for (const std::uint32_t v : vertices) mesh.steiner.push_back(soup_.points[v]);
    for (const std::uint32_t t : own) {
      IndexTriple triangle = soup_.triangles[t];
      for (std::uint32_t& v : triangle) {
        const std::uint32_t k = on_boundary(v);
        const auto at = std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin();
        v = k != kNone ? k : fixed + static_cast<std::uint32_t>(at);
      }
      mesh.triangles.push_back(triangle);
    }
    return mesh;
  }

  /// Regions that have another material in the mesh than in the input.
  [[nodiscard]] std::size_t other_materials(const RegionTable& table) const {
    if (soup_.material.empty()) return 0;
    return static_cast<std::size_t>(
        std::count_if(table.regions.begin(), table.regions.end(), [&](const Region& region) {
          const auto& own = of_region_[place_of(region.id)];
          return std::any_of(own.begin(), own.end(),
                             [&](std::uint32_t t) { return soup_.material[t] != region.material; });
        }));
  }

 private:
  /// The vertex of each point, by VertexId; kNone for those that are none.
  void find_vertices(const Pslg& pslg) {
    std::vector<std::pair<Point, std::uint32_t>> places;
    for (const auto& triangle : soup_.triangles) {
      for (const std::uint32_t v : triangle) places.emplace_back(soup_.points[v], v);
    }
    std::sort(places.begin(), places.end());
    for (const Point& p : pslg.points) {
      const auto at = std::lower_bound(places.begin(), places.end(), std::pair(p, 0U));
      vertex_.push_back(at != places.end() && at->first == p ? at->second : kNone);
    }
  }

  [[nodiscard]] Error misfit(const Pslg& pslg, const RegionTable& table,
                             const Verification& found) const {
    std::vector<std::string> missing;
    for (const Region& region : table.regions) {
      if (of_region_[place_of(region.id)].empty())
        missing.push_back(fmt::format("region {} '{}'", region.id.value(), region.name));
    }
    const Violation& first = found.violations.front();
    std::string message =
        fmt::format("the mesh is not one of {}: {}",
                    pslg.source.empty() ? "the input" : pslg.source, first.message);
    if (found.violation_count > 1)
      message += fmt::format("; {} in all", counted(found.violation_count, "fault"));
    if (!missing.empty() && missing.size() < table.regions.size()) {
      const std::string more = and_more(missing.size(), kNamed);
      missing.resize(std::min(missing.size(), kNamed));
      message += fmt::format("; no triangles in {}{} were found", listed(missing), more);
    }
    message +=
        "; since it was made, sizes, angles, methods, names and materials may have changed, but no "
        "point and no segment, in the regions to be meshed again neither, nor how they are cleaned";
    return {ErrorCode::other_mesh, std::move(message), first.where, {}};
  }

  const TriangleSoup& soup_;
  std::vector<std::vector<std::uint32_t>> of_region_;  ///< triangles, by RegionId - 1
  std::vector<std::uint32_t> vertex_;                  ///< by VertexId
};

/// Which regions are meant, by RegionId - 1.
Result<std::vector<bool>> choose(const RegionTable& table, std::span<const std::string> names) {
  std::vector<bool> chosen(table.regions.size(), false);
  for (const std::string& name : names) {
    const std::vector<RegionId> regions = named_regions(table, name);
    if (regions.empty()) return no_such_region(table, "only", name);
    for (const RegionId region : regions) chosen[place_of(region)] = true;
  }
  return chosen;
}

/// The options for finding regions: segments stay as the mesh has them.
Result<Options> options_without_cuts(Options options, std::span<const std::string> only) {
  if (only.empty()) return bad_option("only: no region to be meshed again is named");
  if (options.method == Method::nonobtuse) {
    return bad_option(
        "method nonobtuse cuts segments, so a region cannot be meshed with it inside a mesh");
  }
  if (options.box_method)
    return bad_option(
        "the box method cuts segments, and regions that are meshed again keep theirs: not with "
        "only");
  options.split_interfaces.reset();
  return options;
}

/// Meshes the chosen regions, `again`, and measures the others, whose meshes are there already.
Status fill_in(std::span<const RegionBoundary> again, const std::vector<bool>& chosen,
               const Options& options, const Callbacks& callbacks, Work& work) {
  Result<std::vector<RegionMesh>> made = mesh_regions(again, options, callbacks);
  if (!made) return std::move(made).error();
  for (std::size_t k = 0; k < again.size(); ++k)
    work.meshes[place_of(again[k].id)] = std::move((*made)[k]);
  return for_each_region(
      work.boundaries, worker_count(options), "measure", callbacks, [&](std::size_t r) {
        if (chosen[r]) return;
        const RegionBoundary& boundary = work.boundaries[r];
        const CdtResult cdt = triangulate_domain(boundary.points, boundary.sides);
        RegionReport& report = work.meshes[r].report;
        report.id = boundary.id;
        report.method = "kept";
        set_bound(angle_limit(cdt.triangulation, boundary.sides, boundary.segments), report);
        fill_report(boundary, work.meshes[r]);
      });
}

void tell(std::size_t cuts, std::size_t other_materials, const Options& asked, Report& report) {
  const auto warn = [&](std::string message) {
    report.notes.push_back({Note::Kind::warning, kVoid, std::move(message), {}});
  };
  if (cuts > 0) {
    warn(fmt::format("segments are cut as in the mesh, at {}", counted(cuts, "point")));
  }
  if (asked.split_interfaces) {
    warn("split-interfaces: segments stay as they are in the mesh, none is cut");
  }
  if (other_materials > 0) {
    warn(fmt::format("{} in the mesh has another material than in the input, whose material counts",
                     counted(other_materials, "region")));
  }
}

/// Cuts segments where the mesh has them cut, and finds its triangles.
///
/// Errors: other_mesh, if the mesh is not one of this input
Status adopt(const TriangleSoup& onto, const Options& options, const Options& asked, OldMesh& old,
             Work& work) {
  const std::size_t cuts = adopt_cuts(work.pslg, work.table, onto);
  for (const PeriodicRule& rule : work.rules) {
    const Result<SidesMatch> match = match_sides(work.pslg, work.table, rule, kAutoWeld);
    if (!match) return match.error();
    if (auto fault = unmatched(work.pslg, rule, *match))
      return Error{ErrorCode::other_mesh, std::move(fault->message), fault->where, {}};
  }
  if (Status status = old.find_triangles(work.pslg, work.table, options.hull); !status)
    return status;
  tell(cuts, old.other_materials(work.table), asked, work.report);
  return ok();
}

Result<Output> mesh_again(const Input& input, const TriangleSoup& onto,
                          std::span<const std::string> only, const Options& asked,
                          const Callbacks& callbacks) {
  if (!onto.material.empty() && onto.material.size() != onto.triangles.size())
    return Error{ErrorCode::other_mesh,
                 fmt::format("the mesh has {} triangles and materials of {}", onto.triangles.size(),
                             onto.material.size()),
                 {},
                 {}};
  StageClock clock;
  const Result<Options> options = options_without_cuts(with_layers_of(input, asked), only);
  if (!options) return options.error();
  Result<PreparedRegions> regions = prepare_regions(input, *options, callbacks, clock, Held::all);
  if (!regions) return std::move(regions).error();
  Work work{std::move(regions->prepared)};
  work.rules = periodic_rules(input, *options);
  work.field = input.field;
  const Result<std::vector<bool>> chosen = choose(work.table, only);
  if (!chosen) return chosen.error();
  for (const std::string& name : only) work.report.provenance.settings.push_back({"only", name});
  OldMesh old(onto);
  if (Status status = adopt(onto, *options, asked, old, work); !status)
    return std::move(status).error();
  Result<std::vector<RegionBoundary>> boundaries =
      boundaries_with_wishes(work.pslg, work.table, *options);
  if (!boundaries) return std::move(boundaries).error();
  work.boundaries = *std::move(boundaries);
  clock.note("split", work.report.times);

  std::vector<RegionBoundary> again;
  for (const RegionBoundary& boundary : work.boundaries) {
    work.meshes.push_back(old.take(boundary));
    if (!(*chosen)[work.meshes.size() - 1]) continue;
    again.push_back(boundary);
    const RegionMesh& before = work.meshes.back();
    work.report.replaced.push_back({boundary.id, before.triangles.size(), before.steiner.size()});
  }
  // Both ask size functions, which may throw.
  Status status = errors_as_values("sizes", [&] {
    Status expected = check_expected_triangles(work.table, again, *options);
    if (expected) warn_of_sizes(work.pslg, *options, again, false, work.report.notes);
    return expected;
  });
  if (status) status = fill_in(again, *chosen, *options, callbacks, work);
  if (!status) return std::move(status).error();
  clock.note("mesh", work.report.times);
  return stitch_regions(std::move(work), callbacks, clock);
}

}  // namespace

Result<Output> remesh(const Input& input, const TriangleSoup& onto,
                      std::span<const std::string> only, const Options& options,
                      const Callbacks& caller) {
  return followed("remesh", caller, [&](const Callbacks& callbacks) {
    return mesh_again(input, onto, only, options, callbacks);
  });
}

void keep_attributes(const Output& before, const std::string& name, Output& output) {
  if (before.table.regions.size() != output.table.regions.size()) return;
  const auto has = [](const auto& all, const std::string& called) {
    return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == called; });
  };
  for (const Attribute& attribute : before.table.attributes)
    if (!has(output.table.attributes, attribute.name)) output.table.attributes.push_back(attribute);
  for (const PlaneField::Array& field : before.fields) {
    if (has(output.fields, field.name)) continue;
    output.report.notes.push_back(
        {Note::Kind::warning,
         kVoid,
         fmt::format("the values '{}' of {} are left out: this input has none", field.name, name),
         {}});
  }
}

}  // namespace cover
