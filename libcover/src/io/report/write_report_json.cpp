// The report as JSON. Angles are in degrees unless the name says radians; lengths and areas are in
// units of the input; ids are those of the library (regions and interfaces count from 1).
//
//   { "format": "cover report", "version": 1,
//     "cover": version, "options": { name: value } as in the manifest,
//     "input":  { "source", "unit", "scale", "points", "segments": before any of them was cut,
//                 "void_points": [ids], "void_segments": n },
//     "mesh":   { "vertices", "edges", "triangles", "steiner_vertices": new ones inside regions,
//                 "cut_vertices": new ones on segments },
//     "overall": LIMITS + QUALITY + { "bound_held": regions, "bound_missed": [region ids],
//                "methods": {method: regions}, "fallbacks", "rho_smallest", "box": BOX,
//                "limits": { "largest": {standing: regions}, "smallest": {standing: regions} } },
//     "regions": [ { "id", "name", "material", "material_name", "area", "sides", "method",
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
//   "withdrawn", "segments", "at": [x, y] } ]
// NOTES [ { "kind", "message", "where": [[x, y], ...] } ]
//
// Tested by tests/unit/io/report/write_report_json_test.cpp.
#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include <cover/curved_mesh.hpp>
#include <cover/estimate.hpp>
#include <cover/mesh.hpp>
#include <cover/text.hpp>
#include <cover/write_mesh.hpp>

#include "base/faults/out_of_memory.hpp"
#include "io/files/atomic_file.hpp"
#include "io/report/periodic_json.hpp"
#include "io/report/provenance_json.hpp"
#include "io/report/report_text.hpp"

namespace cover {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Note::Kind kind) {
  switch (kind) {
    case Note::Kind::fallback:
      return "fallback";
    case Note::Kind::repair:
      return "repair";
    case Note::Kind::below_resolution:
      return "below_resolution";
    case Note::Kind::target_missed:
      return "target_missed";
    case Note::Kind::bound_missed:
      return "bound_missed";
    case Note::Kind::warning:
      return "warning";
    case Note::Kind::change:
      return "change";
    case Note::Kind::cut:
      return "cut";
    case Note::Kind::box_cut:
      return "box_cut";
  }
  return "";
}

Json to_json(const std::vector<Note>& notes) {
  Json list = Json::array();
  for (const Note& note : notes) {
    Json where = Json::array();
    for (const Point& p : note.where) where.push_back({p.x, p.y});
    list.push_back({{"kind", name_of(note.kind)}, {"message", note.message}, {"where", where}});
  }
  return list;
}

const char* name_of(Change::Kind kind) {
  switch (kind) {
    case Change::Kind::split:
      return "split";
    case Change::Kind::welded:
      return "welded";
    case Change::Kind::dropped:
      return "dropped";
    case Change::Kind::merged:
      break;
  }
  return "merged";
}

const char* name_of(InputKind kind) {
  switch (kind) {
    case InputKind::point:
      return "point";
    case InputKind::segment:
      return "segment";
    case InputKind::polygon:
      return "polygon";
    case InputKind::hole:
      return "hole";
    case InputKind::region_seed:
      return "region_seed";
    case InputKind::line:
      break;
  }
  return "line";
}

Json to_json(const Change& change) {
  Json where = Json::array(), inputs = Json::array();
  for (const Point& p : change.where) where.push_back({p.x, p.y});
  for (const InputRef& ref : change.inputs)
    inputs.push_back({{"kind", name_of(ref.kind)}, {"id", ref.id}});
  return {{"kind", name_of(change.kind)},
          {"message", change.message},
          {"where", where},
          {"inputs", inputs}};
}

Json to_json(const BoxMethod& box) {
  return {{"obtuse_sides", box.obtuse_sides},
          {"non_delaunay_edges", box.non_delaunay_edges},
          {"negative_couplings", box.negative_couplings},
          {"negative_inside", box.negative_inside},
          {"negative_encroached", box.negative_encroached},
          {"negative_forced", box.negative_forced},
          {"negative_given_up", box.negative_given_up},
          {"box_area", box.box_area}};
}

const char* name_of(NegativeCoupling::Kind kind) {
  switch (kind) {
    case NegativeCoupling::Kind::inside:
      return "inside";
    case NegativeCoupling::Kind::encroached:
      return "encroached";
    case NegativeCoupling::Kind::forced:
      return "forced";
    case NegativeCoupling::Kind::given_up:
      break;
  }
  return "given_up";
}

Json to_json(const std::vector<NegativeCoupling>& couplings) {
  Json list = Json::array();
  for (const NegativeCoupling& c : couplings) {
    list.push_back({{"kind", name_of(c.kind)},
                    {"edge", {{c.a.x, c.a.y}, {c.b.x, c.b.y}}},
                    {"apex", {c.apex.x, c.apex.y}}});
  }
  return list;
}

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

void add_limits(const RegionReport& report, Json& out) {
  out["gamma_opt"] = report.lowest_nu().supplement().in_degrees();
  out["nu_opt_radians"] = report.nu_opt.in_radians();
  out["bound"] = report.nu_bound.supplement().in_degrees();
  out["nu_bound_radians"] = report.nu_bound.in_radians();
  out["rho"] = report.rho();
  out["forced_above_120"] = report.forced_above_120;
  out["forced_above_150"] = report.forced_above_150;
}

void add_quality(const Quality& quality, Json& out) {
  out["triangles"] = quality.triangles;
  out["largest_angle"] = quality.largest_nu.supplement().in_degrees();
  out["largest_nu_radians"] = quality.largest_nu.in_radians();
  out["smallest_angle"] = quality.smallest.in_degrees();
  out["obtuse"] = quality.obtuse;
  out["obtuse_by_rounding"] = quality.obtuse_by_rounding;
  out["above_120"] = quality.above_120;
  out["above_150"] = quality.above_150;
  out["histogram"] = quality.histogram;
  out["meshed_area"] = quality.area;
}

Json limits_json(const RegionReport& report) {
  const RegionLimits& limits = report.limits;
  Json out{{"largest", describe(limits.of_largest)}, {"smallest", describe(limits.of_smallest)}};
  const auto missed = [](Standing s) { return s != Standing::met && s != Standing::unknown; };
  if (missed(limits.of_largest)) {
    out["largest_angle"] = limits.largest_nu.supplement().in_degrees();
    out["largest_gap"] = limits.largest_nu.in_degrees() - report.quality.largest_nu.in_degrees();
  }
  if (missed(limits.of_smallest)) {
    out["smallest_angle"] = limits.smallest.in_degrees();
    out["under"] = limits.under.supplement().in_degrees();
    out["smallest_gap"] = limits.smallest.in_degrees() - report.quality.smallest.in_degrees();
  }
  return out;
}

const char* name_of(LayerStop stop) {
  switch (stop) {
    case LayerStop::none:
      return "none";
    case LayerStop::isotropic:
      return "isotropic";
    case LayerStop::corner:
      return "corner";
    case LayerStop::end:
      return "end";
    case LayerStop::room:
      return "room";
    case LayerStop::turned:
      return "turned";
    case LayerStop::withdrawn:
      break;
  }
  return "withdrawn";
}

Json to_json(const LayerReport& layers) {
  Json cut_short = Json::array();
  for (const LayerReport::Short& part : layers.cut_short) {
    cut_short.push_back(
        {{"why", name_of(part.why)}, {"segments", part.segments}, {"at", {part.at.x, part.at.y}}});
  }
  return {{"line", layers.asked.line},     {"first", layers.asked.first},
          {"growth", layers.asked.growth}, {"count", layers.asked.count},
          {"segments", layers.segments},   {"length", layers.length},
          {"complete", layers.complete},   {"fewest", layers.fewest},
          {"most", layers.most},           {"thickness", layers.thickness},
          {"cut_short", cut_short}};
}

Json counts_json(const std::array<std::size_t, kStandings>& counts) {
  Json out = Json::object();
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] > 0) out[describe(static_cast<Standing>(k))] = counts[k];
  }
  return out;
}

Json region_json(const Region& region, const RegionReport& report) {
  Json out{{"id", region.id.value()},
           {"name", region.name},
           {"material", region.material},
           {"material_name", region.material_name},
           {"area", region.area},
           {"sides", region.sides},
           {"method", report.method},
           {"input_vertices", report.input_vertices},
           {"steiner_vertices", report.steiner_vertices},
           {"bound_held", report.bound_held}};
  add_limits(report, out);
  add_quality(report.quality, out);
  out["box"] = to_json(report.box);
  out["box"]["negative"] = to_json(report.couplings);
  out["limits"] = limits_json(report);
  if (!report.layers.empty()) {
    out["layers"] = Json::array();
    for (const LayerReport& layers : report.layers) out["layers"].push_back(to_json(layers));
  }
  out["notes"] = to_json(report.notes);
  out["seconds"] = report.seconds;
  return out;
}

/// The run as if it were one region.
RegionReport sum_of(const Report& report) {
  RegionReport sum;
  sum.nu_opt = sum.nu_bound = Angle::degrees(180);
  sum.quality = report.quality;
  for (const RegionReport& region : report.regions) {
    sum.nu_opt = std::min(sum.nu_opt, region.nu_opt);
    sum.nu_bound = std::min(sum.nu_bound, region.nu_bound);
    sum.forced_above_120 += region.forced_above_120;
    sum.forced_above_150 += region.forced_above_150;
    sum.box.obtuse_sides += region.box.obtuse_sides;
    sum.box.non_delaunay_edges += region.box.non_delaunay_edges;
    sum.box.negative_couplings += region.box.negative_couplings;
    sum.box.negative_inside += region.box.negative_inside;
    sum.box.negative_encroached += region.box.negative_encroached;
    sum.box.negative_forced += region.box.negative_forced;
    sum.box.negative_given_up += region.box.negative_given_up;
    sum.box.box_area += region.box.box_area;
  }
  return sum;
}

Json overall_json(const Report& report) {
  const RegionReport sum = sum_of(report);
  Json out = Json::object();
  add_limits(sum, out);
  add_quality(sum.quality, out);
  out["box"] = to_json(sum.box);
  Json missed = Json::array();
  std::map<std::string, std::size_t> methods;
  std::size_t fallbacks = 0;
  LimitCounts limits;
  double smallest_rho = sum.rho();
  for (const RegionReport& region : report.regions) {
    if (!region.bound_held) missed.push_back(region.id.value());
    ++methods[region.method];
    limits.add(region.limits);
    smallest_rho = std::min(smallest_rho, region.rho());
    for (const Note& note : region.notes) fallbacks += note.kind == Note::Kind::fallback ? 1 : 0;
  }
  out["rho_smallest"] = smallest_rho;
  out["bound_held"] = report.regions.size() - missed.size();
  out["bound_missed"] = missed;
  out["methods"] = methods;
  out["fallbacks"] = fallbacks;
  out["limits"] = {{"largest", counts_json(limits.largest)},
                   {"smallest", counts_json(limits.smallest)}};
  return out;
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
  return {{"source", report.provenance.source},
          {"unit", report.unit},
          {"scale", report.scale},
          {"points", report.input_points},
          {"segments", report.input_segments},
          {"void_points", void_points},
          {"void_segments", table.void_segments.size()}};
}

Json mesh_json(const Output& output, const MeshCounts& mesh) {
  return {{"vertices", mesh.vertices},
          {"edges", mesh.edges},
          {"triangles", mesh.triangles},
          {"steiner_vertices", output.report.steiner_vertices},
          {"cut_vertices", output.pslg.points.size() - output.report.input_points}};
}

/// An object, member by member: all of a report at once takes ten times the memory of its text.
class ObjectText {
 public:
  void add(std::string_view name, const Json& value) {
    begin(name);
    text_ += dump(value, 1);
  }

  /// A list of what `item` makes of 0, 1, ..., count - 1.
  template <class Item>
  void add_list(std::string_view name, std::size_t count, Item item) {
    begin(name);
    text_ += '[';
    for (std::size_t k = 0; k < count; ++k) {
      text_ += k == 0 ? "\n  " : ",\n  ";
      text_ += dump(item(k), 2);
    }
    text_ += count == 0 ? "]" : "\n ]";
  }

  std::string finish() {
    text_ += "\n}";
    return std::move(text_);
  }

 private:
  void begin(std::string_view name) {
    text_ += text_.empty() ? "{\n " : ",\n ";
    text_ += Json(name).dump() + ": ";
  }

  /// Each line but the first goes in by `level` blanks. No other line begins in a text of JSON.
  static std::string dump(const Json& value, std::size_t level) {
    // Names that are no UTF-8 must not make the report fail.
    const std::string flush = value.dump(1, ' ', false, Json::error_handler_t::replace);
    std::string text;
    for (const char c : flush) {
      text += c;
      if (c == '\n') text.append(level, ' ');
    }
    return text;
  }

  std::string text_;
};

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
  out.add("notes", to_json(report.notes));
  out.add_list("changes", report.changes.size(),
               [&](std::size_t k) { return to_json(report.changes[k]); });
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
