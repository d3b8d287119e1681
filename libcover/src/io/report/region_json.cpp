// See region_json.hpp. Tested by tests/unit/io/report/write_report_json_test.cpp.
#include "io/report/region_json.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "io/report/remarks_json.hpp"

namespace cover {
namespace {

using Json = nlohmann::ordered_json;

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
      return "withdrawn";
    case LayerStop::couplings:
      break;
  }
  return "couplings";
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
    sum.box += region.box;
  }
  return sum;
}

}  // namespace

nlohmann::ordered_json region_json(const Region& region, const RegionReport& report) {
  nlohmann::ordered_json out{{"id", region.id.value()},
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
    out["layers"] = nlohmann::ordered_json::array();
    for (const LayerReport& layers : report.layers) out["layers"].push_back(to_json(layers));
  }
  out["notes"] = notes_json(report.notes);
  out["seconds"] = report.seconds;
  return out;
}

nlohmann::ordered_json overall_json(const Report& report) {
  const RegionReport sum = sum_of(report);
  auto out = nlohmann::ordered_json::object();
  add_limits(sum, out);
  add_quality(sum.quality, out);
  out["box"] = to_json(sum.box);
  auto missed = nlohmann::ordered_json::array();
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

}  // namespace cover
