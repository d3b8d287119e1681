#include "words/text_report.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

#include <fmt/core.h>

#include <cover/curved_mesh.hpp>
#include <cover/text.hpp>

#include "terminal/console.hpp"
#include "words/angle_text.hpp"
#include "words/limits_text.hpp"
#include "words/text_table.hpp"
#include "words/verdict.hpp"

namespace cover::app {
namespace {

constexpr std::size_t kRows = 20;
using Align = TextTable::Align;

/// The first rows of a table: all, or those with the smallest key.
template <class Key>
std::vector<std::size_t> rows(std::size_t count, bool all, Key key) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (all || count <= kRows) return order;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  order.resize(kRows);
  return order;
}

std::string more(std::size_t count, std::size_t shown, std::string_view which) {
  return shown == count
             ? std::string()
             : fmt::format("  the {} of {} {}; -v shows all\n", shown, grouped(count), which);
}

std::string above(std::size_t count, std::size_t forced) {
  return forced == 0 ? grouped(count) : fmt::format("{} ({})", grouped(count), grouped(forced));
}

std::string histogram(const Quality& quality) {
  constexpr std::size_t kBar = 24;
  const std::size_t most = *std::max_element(quality.histogram.begin(), quality.histogram.end());
  const auto bin = [&](std::size_t i) {
    const std::size_t n = quality.histogram[i];
    // Every angle is seen: a bin that is not empty has at least one mark.
    const std::size_t bar = most == 0 ? 0 : (n * kBar + most - 1) / most;
    return fmt::format("{:>3}-{:<3} {:>11} {:<24}", 10 * i, 10 * (i + 1), grouped(n),
                       std::string(bar, '#'));
  };
  std::string out = "Angles in degrees\n";
  for (std::size_t i = 0; i < 9; ++i) {
    std::string line = "  " + bin(i) + "  " + bin(i + 9);
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  return out;
}

/// "; lengths in nm"; empty where the input does not say.
std::string unit_text(const Report& report) {
  return report.unit.empty() ? "" : fmt::format("; lengths in {}", printable(report.unit));
}

std::string arcs_text(const Output& output) {
  if (output.pslg.circles.empty()) return {};
  const CurvedMesh curved = curved_mesh(output);
  if (curved.edges.empty()) return {};
  const std::size_t straight = curved.straight_edges();
  const double area = std::accumulate(curved.areas.begin(), curved.areas.end(), 0.0);
  std::string out =
      fmt::format("On arcs         {:>7}  edges; with --order 2 the area is {:.10g}\n",
                  grouped(curved.edges.size()), area);
  if (!curved.moved.empty())
    out += fmt::format("  {} of edges beside them with --order 2 give way to arcs\n",
                       counted(curved.moved.size(), "node"));
  if (straight > 0)
    out += fmt::format(
        "  {} of them stay straight, or triangles beside them would not be valid;\n"
        "  --split-interfaces with sizes along them cuts arcs finer\n",
        grouped(straight));
  return out;
}

/// In how many regions promise 3 is `held`, and whether doubles could hold it in the others.
std::string bound_text(const Report& report, std::size_t held) {
  const std::size_t all = report.regions.size();
  if (held == all) return "held in every region";
  const bool is_below_resolution =
      std::all_of(report.regions.begin(), report.regions.end(), [](const RegionReport& r) {
        return r.bound_held || std::any_of(r.notes.begin(), r.notes.end(), [](const Note& note) {
                 return note.kind == Note::Kind::below_resolution;
               });
      });
  if (!is_below_resolution) return fmt::format("MISSED in {} of {} regions", all - held, all);
  return fmt::format("held in {} of {} regions; the others lie below the resolution of doubles",
                     held, all);
}

/// Whether --box-method is not among the options yet, and goes with them.
bool may_be_asked_for_boxes(const Report& report) {
  const auto& settings = report.provenance.settings;
  return std::none_of(settings.begin(), settings.end(), [](const Provenance::Setting& setting) {
    return setting.name == "box-method" || (setting.name == "method" && setting.value != "quality");
  });
}

/// The negative couplings of the box method, and the sides given up or forced.
std::string couplings_row(const Report& report) {
  constexpr std::size_t kGivenUp = 3;
  BoxMethod sum;
  std::size_t forced = 0, given_up = 0;
  std::string places;
  bool has_layers = false;
  for (const RegionReport& region : report.regions) {
    sum += region.box;
    has_layers = has_layers || !region.layers.empty();
    for (const NegativeCoupling& c : region.couplings) {
      const bool is_forced = c.kind == NegativeCoupling::Kind::forced;
      if (!is_forced && c.kind != NegativeCoupling::Kind::given_up) continue;
      if (++(is_forced ? forced : given_up) > kGivenUp) continue;
      places += fmt::format("\n                         {}: from {} to {}, region {}",
                            is_forced ? "forced" : "given up", cover::describe(c.a),
                            cover::describe(c.b), region.id.value());
    }
  }
  std::string out =
      fmt::format("Box method      {:>7}  {}", grouped(sum.negative_couplings),
                  sum.negative_couplings == 1 ? "negative coupling" : "negative couplings");
  if (sum.negative_couplings > 0)
    out +=
        fmt::format(": {} inside, {} on sides that the input {}, {}{} given up for angles{}",
                    grouped(sum.negative_inside), grouped(sum.negative_encroached),
                    has_layers ? "or layers encroach" : "encroaches",
                    sum.negative_forced == 0
                        ? ""
                        : fmt::format("{} that the bound forces, ", grouped(sum.negative_forced)),
                    grouped(sum.negative_given_up),
                    !may_be_asked_for_boxes(report) || sum.negative_couplings == sum.negative_inside
                        ? ""
                        : "; --box-method cuts these sides");
  const long excess = excess_of_unsigned_boxes(report);
  if (report.quality.obtuse > 0 && excess > 0)
    places += "\n                         solvers that add up unsigned boxes find " +
              excess_text(excess) + " too much area";
  return out + places + '\n';
}

/// What the mesh consists of, what was cut for it, and which sides are periodic.
std::string size_rows(const Output& output, const MeshCounts& counts) {
  const Report& report = output.report;
  const std::size_t cuts = output.pslg.points.size() - report.input_points;
  std::string out =
      fmt::format("{}, {} ({} new{}), {}{}\n", plural(report.quality.triangles, "triangle"),
                  grouped(counts.vertices) + " vertices", grouped(report.steiner_vertices + cuts),
                  cuts > 0 ? fmt::format(", {} of them on segments", grouped(cuts)) : "",
                  plural(report.regions.size(), "region"), unit_text(report));
  for (const Note& note : report.notes) {
    if (note.kind == Note::Kind::cut || note.kind == Note::Kind::box_cut)
      out += printable(note.message) + '\n';
  }
  for (const PeriodicNodes& nodes : output.periodic) {
    out += fmt::format("Periodic        {:>7}  pairs of vertices on '{}' and '{}'\n",
                       grouped(nodes.vertices.size()), nodes.rule.from, nodes.rule.to);
  }
  return out + arcs_text(output);
}

/// The angles of all regions; there is one at least.
std::string angle_rows(const Output& output) {
  const Report& report = output.report;
  const Quality& q = report.quality;
  std::size_t forced_120 = 0, forced_150 = 0, worst = 0;
  for (std::size_t r = 0; r < report.regions.size(); ++r) {
    const RegionReport& region = report.regions[r];
    forced_120 += region.forced_above_120;
    forced_150 += region.forced_above_150;
    if (region.quality.largest_nu < report.regions[worst].quality.largest_nu) worst = r;
  }
  const RegionReport& region = report.regions[worst];
  std::string out =
      fmt::format("Largest angle   {:>7}  in region {} '{}'; no mesh is below {} there\n",
                  angle_text(q.largest_nu), region.id.value(),
                  printable(output.table.region(region.id).name), angle_text(region.lowest_nu()));
  out += fmt::format("Smallest angle  {:>7}\n", small_angle_text(q.smallest));
  out += fmt::format("Above 90        {:>7}  obtuse triangles{}\n", grouped(q.obtuse),
                     q.obtuse_by_rounding == 0
                         ? ""
                         : fmt::format("; {} more by no more than rounding of coordinates",
                                       grouped(q.obtuse_by_rounding)));
  out += fmt::format("Above 120       {:>7}  forced by the input: {}\n", grouped(q.above_120),
                     grouped(forced_120));
  out += fmt::format("Above 150       {:>7}  forced by the input: {}\n", grouped(q.above_150),
                     grouped(forced_150));
  return out;
}

/// In how many regions a target is missed, and what is proven of these; empty if in none.
std::string target_rows(const Report& report) {
  const auto missed =
      std::count_if(report.regions.begin(), report.regions.end(), [](const RegionReport& r) {
        return std::any_of(r.notes.begin(), r.notes.end(),
                           [](const Note& note) { return note.kind == Note::Kind::target_missed; });
      });
  if (missed == 0) return {};
  const bool for_couplings = std::any_of(report.regions.begin(), report.regions.end(),
                                         [](const RegionReport& r) { return r.has_no_room; });
  std::string out = fmt::format("Targets         missed in {} of {}; -v tells where and why{}\n",
                                grouped(static_cast<std::size_t>(missed)),
                                counted(report.regions.size(), "region"),
                                for_couplings ? ", --couplings last may reach more of them" : "");
  LimitCounts limits;
  for (const RegionReport& region : report.regions) limits.add(region.limits);
  if (const std::string text = limits_text(limits); !text.empty())
    out += fmt::format("Proven limits   {}\n", text);
  return out;
}

std::string totals(const Output& output, const MeshCounts& counts) {
  const Report& report = output.report;
  std::string out = size_rows(output, counts);
  if (report.regions.empty()) return out;
  const auto held = std::count_if(report.regions.begin(), report.regions.end(),
                                  [](const RegionReport& r) { return r.bound_held; });
  out += angle_rows(output);
  out += couplings_row(report);
  out += fmt::format("Proven bound    {}\n", bound_text(report, static_cast<std::size_t>(held)));
  return out + target_rows(report);
}

/// What was meshed again, and what was there before; empty if the whole was meshed.
std::string replaced_rows(const Output& output) {
  constexpr std::size_t kNamed = 10;
  const auto& replaced = output.report.replaced;
  if (replaced.empty()) return {};
  std::string out = fmt::format("Meshed again, the other {} kept:\n",
                                plural(output.table.regions.size() - replaced.size(), "region"));
  for (std::size_t k = 0; k < std::min(kNamed, replaced.size()); ++k) {
    const RegionReport& now = output.report.regions[place_of(replaced[k].region)];
    out += fmt::format("  region {} '{}': {}, {} new; before: {}, {} new\n", now.id.value(),
                       printable(output.table.region(now.id).name),
                       plural(now.quality.triangles, "triangle"), grouped(now.steiner_vertices),
                       plural(replaced[k].triangles, "triangle"),
                       grouped(replaced[k].steiner_vertices));
  }
  if (replaced.size() > kNamed) out += fmt::format("  and {} more\n", replaced.size() - kNamed);
  return out + '\n';
}

/// "8 of 8 layers", "5 to 8 layers", "no layers".
std::string layer_count(const LayerReport& layers) {
  if (layers.most == 0) return "no layers";
  const std::string range = layers.fewest == layers.most
                                ? fmt::format("{}", layers.most)
                                : fmt::format("{} to {}", layers.fewest, layers.most);
  return layers.asked.count > 0 ? fmt::format("{} of {} layers", range, layers.asked.count)
                                : range + (layers.most == 1 ? " layer" : " layers");
}

/// What became of the layers that were asked for, line by line.
std::string layer_rows(const Output& output) {
  std::string out;
  for (const RegionReport& region : output.report.regions) {
    for (const LayerReport& layers : region.layers) {
      out += fmt::format("  {} in {}: {}, {:.6g} thick; {} of {} complete", layers.asked.line,
                         output.table.region(region.id).name, layer_count(layers), layers.thickness,
                         grouped(layers.complete), plural(layers.segments, "segment"));
      for (const LayerReport::Short& part : layers.cut_short)
        out += fmt::format("; on {} {}, the first at {}", grouped(part.segments),
                           describe(part.why), describe(part.at));
      out += '\n';
    }
  }
  return out.empty() ? out : "\nLayers\n" + out;
}

std::string region_rows(const Output& output, bool every_region) {
  const auto& regions = output.report.regions;
  TextTable table({{"region"},
                   {"name", Align::left},
                   {"material", Align::left},
                   {"triangles"},
                   {"new"},
                   {"lowest"},
                   {"proven"},
                   {"reached"},
                   {"smallest"},
                   {"rho"},
                   {">120 (forced)"},
                   {">150 (forced)"},
                   {"method", Align::left}});
  const auto order =
      rows(regions.size(), every_region, [&](std::size_t i) { return regions[i].rho(); });
  for (const std::size_t i : order) {
    const RegionReport& r = regions[i];
    const Region& region = output.table.region(r.id);
    table.add({fmt::format("{}", r.id.value()), region.name, region.material_name,
               grouped(r.quality.triangles), grouped(r.steiner_vertices), angle_text(r.lowest_nu()),
               angle_text(r.nu_bound), angle_text(r.quality.largest_nu),
               small_angle_text(r.quality.smallest), fmt::format("{:.2f}", r.rho()),
               above(r.quality.above_120, r.forced_above_120),
               above(r.quality.above_150, r.forced_above_150),
               r.method + (r.bound_held ? "" : " (bound missed)")});
  }
  return "Largest angle per region, in degrees: lowest (no mesh is below), proven, reached\n" +
         table.text() + more(regions.size(), order.size(), "regions, lowest rho first");
}

std::string times(const Report& report) {
  std::string out = "Time";
  double total = 0;
  for (const StageTime& stage : report.times) {
    out += fmt::format("  {} {:.3f} s", stage.stage, stage.seconds);
    total += stage.seconds;
  }
  return out + fmt::format("  total {:.3f} s, {}\n", total, plural(report.threads, "thread"));
}

/// The boundary markers on a line, without 0: "11, 12".
std::string markers(const Pslg& pslg, const Interface& line) {
  std::set<int> seen;
  for (const SegmentId id : line.segments) seen.insert(pslg.segments[id.index()].marker);
  seen.erase(0);
  std::vector<std::string> texts;
  for (const int marker : seen) texts.push_back(fmt::format("{}", marker));
  return listed(texts);
}

std::string region_name(const RegionTable& table, RegionId id) {
  return id == kVoid ? "void" : table.region(id).name;
}

/// What `cover info` says of regions: all of them, or those of the largest angles.
std::string bounds_of_regions(const Prepared& prepared, bool every_region) {
  const RegionTable& table = prepared.table;
  std::vector<TextTable::Column> columns{{"region"},
                                         {"name", Align::left},
                                         {"material", Align::left},
                                         {"id"},
                                         {"area"},
                                         {"sides"},
                                         {"gamma_opt"},
                                         {"lowest"},
                                         {"proven"}};
  const bool sized = std::any_of(table.regions.begin(), table.regions.end(),
                                 [](const Region& region) { return region.size.has_value(); });
  if (sized) columns.push_back({"size"});
  TextTable regions(std::move(columns));
  const auto& reports = prepared.report.regions;
  const auto order =
      rows(table.regions.size(), every_region, [&](std::size_t i) { return reports[i].nu_opt; });
  for (const std::size_t i : order) {
    const Region& region = table.regions[i];
    const RegionReport& report = reports[i];
    std::vector<std::string> cells{fmt::format("{}", region.id.value()),
                                   region.name,
                                   region.material_name,
                                   fmt::format("{}", region.material),
                                   fmt::format("{:.6g}", region.area),
                                   grouped(region.sides),
                                   angle_text(report.nu_opt),
                                   angle_text(report.lowest_nu()),
                                   angle_text(report.nu_bound)};
    if (sized) cells.push_back(region.size ? fmt::format("{:.6g}", *region.size) : "");
    regions.add(std::move(cells));
  }
  return "Regions; bounds on the largest angle, in degrees: lowest (no mesh is below), proven\n" +
         regions.text() + more(table.regions.size(), order.size(), "regions, largest angle first");
}

/// What it says of their borders: all of them, or the longest.
std::string lines_between(const Prepared& prepared, bool every_line) {
  const RegionTable& table = prepared.table;
  TextTable interfaces({{"line"},
                        {"name", Align::left},
                        {"kind", Align::left},
                        {"left", Align::left},
                        {"right", Align::left},
                        {"segments"},
                        {"length"},
                        {"markers", Align::left}});
  const auto longest = rows(table.interfaces.size(), every_line,
                            [&](std::size_t i) { return -table.interfaces[i].length; });
  for (const std::size_t i : longest) {
    const Interface& line = table.interfaces[i];
    interfaces.add({fmt::format("{}", line.id.value()), line.name, describe(line.kind),
                    region_name(table, line.left), region_name(table, line.right),
                    grouped(line.segments.size()), fmt::format("{:.6g}", line.length),
                    markers(prepared.pslg, line)});
  }
  return "\nInterfaces, outlines and contacts\n" + interfaces.text() +
         more(table.interfaces.size(), longest.size(), "lines, longest first");
}

/// Points that the input calls by a name.
std::string named_points(const Pslg& pslg) {
  if (pslg.named_points.empty()) return {};
  TextTable points({{"point"}, {"name", Align::left}, {"at", Align::left}});
  for (const NamedPoint& point : pslg.named_points) {
    const std::size_t v = point.vertex.index();
    points.add({fmt::format("{}", pslg.point_ids[v]), point.name, cover::describe(pslg.points[v])});
  }
  return "\nNamed points\n" + points.text();
}

}  // namespace

std::string mesh_text(const StreamedOutput& streamed, bool every_region) {
  const Output& output = streamed.output;
  std::string out = replaced_rows(output) + totals(output, streamed.counts);
  if (output.report.regions.size() > 1) out += '\n' + region_rows(output, every_region);
  out += layer_rows(output);
  return out + '\n' + histogram(output.report.quality) + '\n' + times(output.report);
}

std::string info_text(const Prepared& prepared, bool every_region) {
  const RegionTable& table = prepared.table;
  std::string out = fmt::format(
      "{}, {}, {}, {}{}\n\n", plural(prepared.pslg.points.size(), "point"),
      plural(prepared.pslg.segments.size(), "segment"), plural(table.regions.size(), "region"),
      plural(table.interfaces.size(), "interface"), unit_text(prepared.report));
  out += bounds_of_regions(prepared, every_region) + lines_between(prepared, every_region);
  if (every_region) out += named_points(prepared.pslg);
  if (!table.void_points.empty() || !table.void_segments.empty()) {
    out += fmt::format("\nWholly in the void, left out of a mesh: {}, {}\n",
                       plural(table.void_points.size(), "point"),
                       plural(table.void_segments.size(), "segment"));
  }
  return out;
}

std::string box_costs_text(const BoxCosts& costs, bool every_side) {
  const auto counted = [](std::optional<std::size_t> cuts) {
    return cuts ? grouped(*cuts) : std::string("many");
  };
  std::string out = fmt::format(
      "\nBox method: {} of {} {} a vertex in the open diametral disk, which forces a negative "
      "coupling\n",
      grouped(costs.encroached_sides), plural(costs.sides, "side"),
      costs.encroached_sides == 1 ? "has" : "have");
  out += fmt::format(
      "  segments whole                        {:>7} negative couplings are forced\n"
      "  none negative (--box-method)          {:>7} cuts before meshing; proven to be needed: {}\n"
      "  no obtuse angle (--split-interfaces)  {:>7} cuts before meshing\n",
      grouped(costs.encroached_sides), counted(costs.cuts), grouped(costs.least_cuts),
      counted(costs.cuts_for_right_angles));
  if (!costs.cuts || !costs.cuts_for_right_angles)
    out += "  many: not counted, as cuts of one segment make the next ones need cuts, and so on\n";
  if (costs.uncut > 0)
    out += fmt::format("  {} cannot be cut often enough in double coordinates\n",
                       plural(costs.uncut, "segment"));
  const std::size_t shown =
      every_side ? costs.encroached.size() : std::min(kRows, costs.encroached.size());
  for (std::size_t k = 0; k < shown; ++k) {
    const NegativeCoupling& c = costs.encroached[k];
    out += fmt::format("  region {}: the side from {} to {} by {}\n", c.region.value(),
                       cover::describe(c.a), cover::describe(c.b), cover::describe(c.apex));
  }
  return out + more(costs.encroached.size(), shown, "sides");
}

}  // namespace cover::app
