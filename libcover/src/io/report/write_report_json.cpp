// The report as JSON. Angles are in degrees unless the name says radians; lengths and areas are in
// units of the input; ids are those of the library (regions and interfaces count from 1).
//
//   { "format": "cover report", "version": 1,
//     "cover": version, "options": { name: value } as in the manifest,
//     "input":  { "source", "unit", "scale", "points", "segments": before any of them was cut,
//                 "void_points": [ids], "void_segments": n,
//                 "named_points": [ { "name", "id", "at": [x, y] } ] where there are any },
//     "mesh":   { "vertices", "edges", "triangles", "steiner_vertices": new ones inside regions,
//                 "cut_vertices": new ones on segments },
//     "overall": LIMITS + QUALITY + { "bound_held": regions, "bound_missed": [region ids],
//                "methods": {method: regions}, "fallbacks", "rho_smallest", "box": BOX,
//                "limits": { "largest": {standing: regions}, "smallest": {standing: regions} } },
//     "regions": [ { "id", "name", "material", "material_name", "area": with straight edges,
//                    "sides", "method",
//                    "input_vertices", "steiner_vertices", "bound_held", "seconds", "notes": NOTES,
//                    "box": BOX, "limits": PROVEN, "layers": [ LAYERS ] where
//                    it has some } + LIMITS + QUALITY ],
//     "replaced": [ { "region": id, "triangles", "steiner_vertices": before } ], only where regions
//                 were meshed again inside a mesh; the method of the others is "kept",
//     "interfaces": [ { "id", "name", "kind", "left", "right", "length", "segments" } ],
//     "periodic": [ { "from", "to", "map", ... as in the manifest, "vertices": pairs, "edges":
//                 pairs } ] where there are any,
//     "arcs": { "edges": on arcs, "straight": those of them that --order 2 cannot curve, "moved":
//              nodes of other edges that give way to arcs, "where":
//                 [[x, y]], "areas": with curved edges, by region } where there are any,
//     "notes": NOTES, "changes": [ { "kind", "message", "where", "inputs" } ],
//     "box_cuts": [ { "at": [x, y], "reason", "by": [x, y] } ], only with --box-method,
//     "threads", "times": [ { "stage", "seconds" } ] }
//
// Of an input that was not meshed: "format": "cover input report", "version", "cover", "options",
// "input", "regions": [ { "id", "name", "material", "material_name", "area", "sides", "size" where
// it has one, "gamma_opt", "bound", "forced_above_120", "forced_above_150" } ], "interfaces",
// "notes", "changes"; of a dry run also "estimate": { "triangles", "bytes" of memory,
// "available_bytes" where that is known, "by_disks": then it is none, but what lines far from each
// other take }.
//
// LIMITS gamma_opt (at least 60: no triangulation is below), nu_opt_radians (pi - gamma_opt,
//   uncut), bound (the largest angle that promise 3 allows), nu_bound_radians, rho,
//   forced_above_120, forced_above_150
// PROVEN largest, smallest: how the angles reached stand: "met" (the target), "optimal", "near"
//   (within a degree of the limit), "coupled" (the same, but only among meshes whose negative
//   couplings are among those of this one), "open", "unknown"; where a target is missed also
//   largest_angle and smallest_angle, the limits, under (no mesh whose largest angle is at most
//   this has a larger smallest one), largest_gap and smallest_gap
// QUALITY triangles, largest_angle, largest_nu_radians (pi - largest angle, which keeps the
//   digits of flat triangles), smallest_angle, obtuse, obtuse_by_rounding, above_120, above_150,
//   histogram (all angles in 18 bins of 10 degrees), meshed_area
// BOX obtuse_sides, non_delaunay_edges (both by more than rounding), negative_couplings (exact
//   signs), those of them inside, on encroached sides and on sides given up for the angle:
//   negative_inside, negative_encroached, negative_forced, negative_given_up; box_area; of
//   regions also "negative": [ { "kind", "edge": [[x, y], [x, y]], "apex": [x, y] } ]
// LAYERS line, first, growth, count (as asked for; 0: until isotropic), segments and length of
//   the line in this region, complete (segments with all), fewest and most layers over a
//   segment, thickness (of the most), cut_short: [ { "why": "end", "room", "turned",
//   "withdrawn" (for the bound), "couplings", "segments", "at": [x, y] } ]
// NOTES [ { "kind", "message", "where": [[x, y], ...] } ]
//
// Tested by tests/unit/io/report/write_report_json_test.cpp.
#include <cmath>

#include <nlohmann/json.hpp>

#include <cover/curved_mesh.hpp>
#include <cover/estimate.hpp>
#include <cover/mesh.hpp>
#include <cover/text.hpp>
#include <cover/write_mesh.hpp>

#include "base/faults/out_of_memory.hpp"
#include "io/files/atomic_file.hpp"
#include "io/report/object_text.hpp"
#include "io/report/periodic_json.hpp"
#include "io/report/provenance_json.hpp"
#include "io/report/region_json.hpp"
#include "io/report/remarks_json.hpp"
#include "io/report/report_text.hpp"

namespace cover {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(BoxCut::Reason reason) {
  switch (reason) {
    case BoxCut::Reason::encroached:
      return "encroached";
    case BoxCut::Reason::encroached_by_cut:
      return "encroached_by_cut";
    case BoxCut::Reason::given_up:
      break;
  }
  return "given_up";
}

Json to_json(const std::vector<BoxCut>& cuts) {
  Json list = Json::array();
  for (const BoxCut& cut : cuts) {
    list.push_back({{"at", {cut.at.x, cut.at.y}},
                    {"reason", name_of(cut.reason)},
                    {"by", {cut.by.x, cut.by.y}}});
  }
  return list;
}

Json to_json(const Interface& line) {
  return {{"id", line.id.value()},           {"name", line.name},
          {"kind", describe(line.kind)},     {"left", line.left.value()},
          {"right", line.right.value()},     {"length", line.length},
          {"segments", line.segments.size()}};
}

Json input_json(const Pslg& pslg, const RegionTable& table, const Report& report) {
  Json void_points = Json::array();
  for (const VertexId v : table.void_points) void_points.push_back(pslg.point_ids[v.index()]);
  Json json{{"source", report.provenance.source},
            {"unit", report.unit},
            {"scale", report.scale},
            {"points", report.input_points},
            {"segments", report.input_segments},
            {"void_points", void_points},
            {"void_segments", table.void_segments.size()}};
  for (const NamedPoint& point : pslg.named_points) {
    const std::size_t v = point.vertex.index();
    json["named_points"].push_back({{"name", point.name},
                                    {"id", pslg.point_ids[v]},
                                    {"at", {pslg.points[v].x, pslg.points[v].y}}});
  }
  return json;
}

Json mesh_json(const Output& output, const MeshCounts& mesh) {
  return {{"vertices", mesh.vertices},
          {"edges", mesh.edges},
          {"triangles", mesh.triangles},
          {"steiner_vertices", output.report.steiner_vertices},
          {"cut_vertices", output.pslg.points.size() - output.report.input_points}};
}

Json to_json(const Output& output, const CurvedMesh& curved) {
  Json where = Json::array();
  for (const CurvedEdge& edge : curved.edges) {
    if (edge.is_straight) where.push_back({edge.middle.x, edge.middle.y});
  }
  const std::size_t straight = where.size();
  Json areas = Json::array();
  for (std::size_t r = 0; r < curved.areas.size(); ++r)
    areas.push_back({{"region", output.table.regions[r].id.value()}, {"area", curved.areas[r]}});
  return {{"edges", curved.edges.size()},
          {"straight", straight},
          {"moved", curved.moved.size()},
          {"where", std::move(where)},
          {"areas", std::move(areas)}};
}

void add_origin(const char* format, const Report& report, ObjectText& out) {
  out.add("format", format);
  out.add("version", 1);
  out.add("cover", report.provenance.version);
  out.add("options", options_json(report.provenance));
}

void add_lines_and_remarks(const RegionTable& table, const Report& report, ObjectText& out) {
  out.add_list("interfaces", table.interfaces.size(),
               [&](std::size_t k) { return to_json(table.interfaces[k]); });
  out.add("notes", notes_json(report.notes));
  out.add_list("changes", report.changes.size(),
               [&](std::size_t k) { return change_json(report.changes[k]); });
}

Json to_json(const Estimate& estimate) {
  Json json{{"triangles", std::round(estimate.triangles)},
            {"bytes", std::round(estimate.bytes)},
            {"by_disks", estimate.by_disks}};
  if (std::isfinite(estimate.available)) json["available_bytes"] = estimate.available;
  return json;
}

void add_prepared(const Prepared& prepared, ObjectText& out) {
  const Report& report = prepared.report;
  add_origin("cover input report", report, out);
  out.add("input", input_json(prepared.pslg, prepared.table, report));
  out.add_list("regions", report.regions.size(), [&](std::size_t k) {
    const Region& region = prepared.table.region(report.regions[k].id);
    Json json{{"id", region.id.value()},     {"name", region.name},
              {"material", region.material}, {"material_name", region.material_name},
              {"area", region.area},         {"sides", region.sides}};
    if (region.size) json["size"] = *region.size;
    const RegionReport& limits = report.regions[k];
    json["gamma_opt"] = limits.lowest_nu().supplement().in_degrees();
    json["bound"] = limits.nu_bound.supplement().in_degrees();
    json["forced_above_120"] = limits.forced_above_120;
    json["forced_above_150"] = limits.forced_above_150;
    return json;
  });
  add_lines_and_remarks(prepared.table, report, out);
}

}  // namespace

std::string report_json(const Output& output) { return report_json(output, count_of(output.mesh)); }

std::string report_json(const Output& output, const MeshCounts& counts) {
  const Report& report = output.report;
  ObjectText out;
  add_origin("cover report", report, out);
  out.add("input", input_json(output.pslg, output.table, report));
  out.add("mesh", mesh_json(output, counts));
  out.add("overall", overall_json(report));
  out.add_list("regions", report.regions.size(), [&](std::size_t k) {
    return region_json(output.table.region(report.regions[k].id), report.regions[k]);
  });
  if (!report.replaced.empty()) {
    out.add_list("replaced", report.replaced.size(), [&](std::size_t k) {
      const Replaced& before = report.replaced[k];
      return Json{{"region", before.region.value()},
                  {"triangles", before.triangles},
                  {"steiner_vertices", before.steiner_vertices}};
    });
  }
  if (!output.periodic.empty()) {
    out.add_list("periodic", output.periodic.size(), [&](std::size_t k) {
      Json json = periodic_json(output.periodic[k]);
      json["vertices"] = output.periodic[k].vertices.size();
      json["edges"] = output.periodic[k].edges.size();
      return json;
    });
  }
  if (!output.pslg.circles.empty()) out.add("arcs", to_json(output, curved_mesh(output)));
  add_lines_and_remarks(output.table, report, out);
  if (!report.box_cuts.empty()) out.add("box_cuts", to_json(report.box_cuts));
  out.add("threads", report.threads);
  out.add_list("times", report.times.size(), [&](std::size_t k) {
    return Json{{"stage", report.times[k].stage}, {"seconds", report.times[k].seconds}};
  });
  return out.finish();
}

std::string report_json(const Prepared& prepared) {
  ObjectText out;
  add_prepared(prepared, out);
  return out.finish();
}

std::string report_json(const Prepared& prepared, const Estimate& estimate) {
  ObjectText out;
  add_prepared(prepared, out);
  out.add("estimate", to_json(estimate));
  return out.finish();
}

Status write_report_json(const Output& output, const std::string& path) {
  return write_report_json(output, count_of(output.mesh), path);
}

Status write_report_json(const Output& output, const MeshCounts& counts, const std::string& path) {
  return memory_as_value(path, [&]() -> Status {
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file) return std::move(file).error();
    file->write(report_json(output, counts));
    file->write("\n");
    return file->commit();
  });
}

}  // namespace cover
