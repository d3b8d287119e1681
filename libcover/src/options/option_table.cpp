// The table. How values are read and written is in option_kinds.hpp and option_forms.hpp.
#include <cover/option_table.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "options/option_forms.hpp"
#include "options/option_kinds.hpp"

namespace cover {
namespace {

using option_kinds::angle;
using option_kinds::flag;
using option_kinds::layers;
using option_kinds::number;
using option_kinds::periodic;
using option_kinds::requirements;
using option_kinds::size_field;
using option_kinds::size_of;
using option_kinds::sizes;
using option_kinds::weld;
using option_kinds::whole;
using option_kinds::word;

bool is_quality(const Options& options) { return options.method == Method::quality; }

bool has_size_functions(const Options& options) {
  const auto is_expression = [](const SizeRule& rule) { return !rule.expression.empty(); };
  return options.size_field || !options.size_field_name.empty() ||
         std::any_of(options.sizes.begin(), options.sizes.end(), is_expression);
}

// clang-format off
constexpr OptionEntry kTable[] = {
    word<&Options::method>({
        .name = "method", .placeholder = "NAME",
        .word_list = {"quality", "almond", "nonobtuse"},
        .help = "quality: good angles, never below the proven bound; almond: the bound alone, the "
                "fastest; nonobtuse: no angle above 90 degrees, or by rounding 90.1, but segments "
                "are split",
        .more = "The report says how many triangles are above 90 degrees; --require non-obtuse "
                "allows none."}),
    word<&Options::fill>({
        .name = "fill", .placeholder = "NAME",
        .word_list = {"refine", "disks"},
        .implies = "almond",
        .help = "What fills the space between the almonds, refine or disks; implies --method "
                "almond",
        .counts_with = "--method almond",
        .counts = [](const Options& o) { return o.method == Method::almond; }}),
    flag<&Options::paper>({
        .name = "paper",
        .implies = "almond",
        .help = "The publication as printed, for comparison: none of our improvements; implies "
                "--method almond"}),
    whole<&Options::pieces>({
        .name = "pieces", .placeholder = "N",
        .range = ranges::kPieces,
        .needs = "paper",
        .help = "With --paper: pieces of an arc are at most 1/N of it; the bound is proven for 6 "
                "and more"}),
    flag<&Options::hull>({
        .name = "hull",
        .help = "Mesh the convex hull; for input that need not enclose anything"}),
    angle<&Options::max_angle>({
        .name = "max-angle",
        .range = ranges::kMaxAngle,
        .help = "Largest angle that --method quality aims at, and --require max-angle asks for",
        .counts_with = "--method quality and --require max-angle",
        .counts = [](const Options& o) { return is_quality(o) || o.require.max_angle; }}),
    angle<&Options::min_angle>({
        .name = "min-angle",
        .range = ranges::kMinAngle,
        .help = "Smallest angle that --method quality aims at, where the largest allows it",
        .counts_with = "--method quality",
        .counts = is_quality}),
    word<&Options::prefer>({
        .name = "prefer", .placeholder = "NAME",
        .word_list = {"balanced", "largest"},
        .help = "balanced: large and small angles weigh alike; largest: the smaller largest angle, "
                "whatever the smallest pays",
        .more = "Below --max-angle 95, largest holds in any case.",
        .counts_with = "--method quality",
        .counts = is_quality}),
    word<&Options::effort>({
        .name = "effort", .placeholder = "NAME",
        .word_list = {"fast", "normal", "thorough"},
        .help = "How much the quality method tries: fast refines and improves once, normal does "
                "what pays for its time, thorough all there is",
        .counts_with = "--method quality",
        .counts = is_quality}),
    word<&Options::couplings>({
        .name = "couplings", .placeholder = "WHICH",
        .word_list = {"auto", "first", "last"},
        .help = "first: no negative coupling of the box method that the input does not force; "
                "targets give way, the bound never does. last: angles alone decide. auto: first; "
                "with --split-interfaces targets before couplings",
        .more = "With --split-interfaces and auto that is so in regions without layers, unless "
                "there is --box-method, too; with first, segments are cut before meshing alone. "
                "Layers give way to couplings inside but with last.",
        .counts_with = "--method quality and --layers",
        .counts = [](const Options& o) { return is_quality(o) || !o.layers.empty(); }}),
    flag<&Options::box_method>({
        .name = "box-method",
        .help = "Cut segments until no coupling of the box method (finite volumes on Voronoi "
                "boxes) is negative; both sides get the same points"}),
    sizes<false>({
        .name = "size", .placeholder = "[NAME=]h",
        .help = "Edge length inside: everywhere (h), or in a region or material (NAME=h), by name, "
                "number of the material, or region:ID; a number or an expression of x and y",
        .more = "The ID is the number that reports give a region. Expressions, as 0.1+0.3*abs(y), "
                "have + - * / ^, pi, min, max, hypot(x,y), atan2(y,x), abs, sqrt, exp, log, sin, "
                "cos, asinh, tanh; where they are no number above zero they ask for nothing; where "
                "they fall to zero, --min-size must say what counts. Where several sizes hold, the "
                "smallest counts."}),
    sizes<true>({
        .name = "size-at", .placeholder = "NAME=h",
        .help = "Edge length at an interface, a contact or a point (NAME=h)",
        .more = "An interface is called by both of its regions, in either order, a point by its "
                "name, as in maps, or its number in the input; a boundary marker too (\"marker 7\", "
                "\"7\" where no point is). Beside segments that are longer than asked, triangles are "
                "larger."}),
    flag<&Options::input_sizes, false>({
        .name = "no-input-sizes",
        .help = "Leave out the sizes that regions have in the input (.poly: largest areas)",
        .more = "Those are \"size\" in JSON; in .poly the largest area A of a region line, where "
                "it is above zero, which means the edge length sqrt(4A/sqrt 3). They count without "
                "being asked (Triangle needs -a), and triangles have the area A on average."}),
    size_field({
        .name = "size-field", .placeholder = "FILE",
        .help = "Background edge lengths: point array (size, h or the only one) of a plane mesh in "
                ".vtu, .vtp, .vti or .vtk, or points x,y,h in .csv; linear between points",
        .more = "In the unit of the coordinates. Outside, what holds at the nearest place. Lengths "
                "are lowered where they differ faster than --growth allows. Points of a .csv are "
                "joined by their Delaunay triangulation."}),
    size_of({
        .name = "size-of", .placeholder = "F",
        .needs = "size-field",
        .help = "Take the values of --size-field for what is to be resolved, not for lengths: a "
                "function (asinh) of the only array, or an expression of arrays, as asinh(doping)",
        .more = "Edges are as long as this changes by --size-step along them. The functions are "
                "those of --size; names of arrays with other characters stand in single quotes."}),
    number<&Options::size_step>({
        .name = "size-step", .placeholder = "S",
        .range = ranges::kSize,
        .needs = "size-of",
        .help = "The largest change of what --size-of names along an edge"}),
    number<&Options::min_size>({
        .name = "min-size", .placeholder = "H",
        .range = ranges::kSize,
        .help = "The shortest edge length that --size-field and expressions of --size ask for",
        .more = "Where they ask for less, they ask for H. Sizes that are plain numbers count as "
                "they are.",
        .counts_with = "--size-field or an expression in --size",
        .counts = has_size_functions}),
    number<&Options::growth>({
        .name = "growth", .placeholder = "G",
        .range = ranges::kGrowth,
        .help = "Ratio of neighbouring edges where sizes differ; above 1 (1.3 unless given). "
                "Without sizes, triangles grow by it from the boundary's own edges",
        .more = "Without this option and without sizes, they grow as fast as their angles allow.",
        .counts_with = "--method quality and --split-interfaces",
        .counts = [](const Options& o) { return is_quality(o) || o.split_interfaces; }}),
    angle<&Options::split_interfaces>({
        .name = "split-interfaces",
        .range = ranges::kSplitInterfaces,
        .alone = "90",
        .help = "Cut segments until none forces an angle above DEG (default: 90), and to the "
                "lengths that sizes ask for; both sides get the same points"}),
    layers({
        .name = "layers", .placeholder = "LINE=first,growth[,count]",
        .help = "Layers of thin triangles along an interface, contact, outline, inner line or "
                "boundary marker, on both sides or on one (LINE@REGION=...): the first so thick, each growth times the "
                "one before, count of them, or until triangles are about isotropic",
        .more = "Their vertices stand above those of the line; --split-interfaces cuts lines to "
                "the lengths that --size-at asks for. Layers are fewer at ends of lines, where room "
                "is short, and where the bound would break; the report tells. Names with @ or = are "
                "put in quotation marks."}),
    word<&Options::overlap>({
        .name = "overlap", .placeholder = "WHICH",
        .word_list = {"last", "first", "error"},
        .help = "Which of several painted polygons wins: last, first, or error",
        .more = "Polygons of different priority overlap without an error: the higher wins.",
        .group = OptionGroup::cleaning}),
    weld({
        .name = "weld", .placeholder = "REL", .unit = "part of the drawing's size",
        .range = ranges::kWeld,
        .help = "Unite ends closer than this part of the drawing's size, at most 1/8 of the "
                "shortest line there: auto, off or a number (default: auto for polygons, off for "
                "segments)",
        .group = OptionGroup::cleaning}),
    periodic({
        .name = "periodic", .placeholder = "A=B",
        .help = "Make the lines A and B images of each other, and whatever cuts one of them cut "
                "both: by translation (A=B), rotation (A=B@x,y:degrees) or reflection (A=B@mirror)",
        .more = "Names are those of contacts, interfaces and outlines that info shows, or boundary "
                "markers; a name with = or @ stands in quotation marks. Points that only one of "
                "the lines has are put on the other. Pairs of nodes stand in .msh, in the array "
                "PeriodicNode of VTK's files and in the manifest. Not with --method nonobtuse.",
        .group = OptionGroup::cleaning}),
    flag<&Options::strict>({
        .name = "strict",
        .help = "Any change to the input is an error",
        .more = "That a corner of one polygon splits the side of another is no change: it is what "
                "painting is for.",
        .group = OptionGroup::cleaning}),
    flag<&Options::merge_materials>({
        .name = "merge-materials",
        .help = "Unite touching faces of equal material; borders with a name stay",
        .group = OptionGroup::cleaning}),
    requirements({
        .name = "require", .placeholder = "WHAT",
        .word_list = {"bound", "max-angle", "delaunay", "non-obtuse", "box-method"},
        .shapes_mesh = false,
        .help = "Exit with 6 unless this holds: bound, max-angle, delaunay, non-obtuse, box-method"}),
    whole<&Options::threads>({
        .name = "threads", .letter = 'j', .placeholder = "N",
        .range = ranges::kThreads,
        .shapes_mesh = false,
        .help = "Threads; 0: all cores",
        .more = "The mesh does not depend on it."}),
};
// clang-format on

}  // namespace

std::span<const OptionEntry> option_table() { return kTable; }

const OptionEntry* find_option(std::string_view name) {
  return option_kinds::find_in<Options>(kTable, name);
}

std::string default_text(const OptionEntry& entry) { return option_kinds::default_of(entry); }

std::vector<Provenance::Setting> describe_options(const Options& options) {
  std::vector<Provenance::Setting> settings;
  for (const OptionEntry& entry : kTable) {
    if (!entry.shapes_mesh) continue;
    std::vector<std::string> values = entry.get(entry, options);
    if (entry.name != "method" && values == entry.get(entry, Options())) continue;
    for (std::string& value : values) settings.push_back({std::string(entry.name), value});
  }
  return settings;
}

Status check_options(const Options& options) {
  if (options.paper && options.method != Method::almond) {
    return bad_option("the publication describes the almond method: paper needs method almond");
  }
  if (options.box_method && options.method == Method::almond)
    return bad_option("the box method needs method quality: the almond method minds no couplings");
  if (options.box_method && options.method == Method::nonobtuse)
    return bad_option(
        "the box method needs method quality: method nonobtuse cuts segments by itself");
  if (!options.periodic.empty() && options.method == Method::nonobtuse)
    return bad_option(
        "periodic sides need another method: method nonobtuse cuts segments by itself");
  if (options.box_method && options.hull)
    return bad_option("the box method cuts segments, and sides of a hull are none: not with hull");
  if (!options.layers.empty() && options.method == Method::nonobtuse)
    return bad_option("layers need method quality or almond: method nonobtuse cuts their lines");
  if (!options.layers.empty() && options.hull)
    return bad_option(
        "layers lie along lines of the input, and sides of a hull are none: not with hull");
  if (!options.size_of.empty() && options.size_field_name.empty())
    return bad_option("size-of is of the values of a file, and size-field names none");
  if (!ranges::kScale.holds(options.size_field_scale))
    return bad_option(fmt::format("size_field_scale is {}, but must be {}",
                                  describe(options.size_field_scale), describe(ranges::kScale)));
  return option_kinds::check_all<Options>(kTable, options);
}

std::string describe(const Range& range) {
  std::string text = fmt::format("{} {}", range.has_low ? "at least" : "above", range.low);
  if (range.high < ranges::kNoLimit)
    text += fmt::format(" and {} {}", range.has_high ? "at most" : "below", range.high);
  return text;
}

}  // namespace cover
