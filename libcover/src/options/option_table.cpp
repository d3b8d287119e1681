// The table, and the few options whose values are of no common kind.
#include <cover/option_table.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/expression.hpp"
#include "options/option_kinds.hpp"
#include "options/periodic_rule.hpp"

namespace cover {
namespace {

using option_kinds::angle;
using option_kinds::bad_option;
using option_kinds::flag;
using option_kinds::number;
using option_kinds::parse;
using option_kinds::whole;
using option_kinds::word;

using Texts = std::vector<std::string>;

const std::array<std::string, 2> kPlace{"x", "y"};

/// auto, off or a number.
constexpr OptionEntry weld(OptionEntry row) {
  row.kind = OptionKind::text;
  row.set = [](const OptionEntry& self, std::string_view text, Options& options) -> Status {
    const std::optional<double> value = text == "off"    ? 0
                                        : text == "auto" ? kAutoWeld
                                                         : parse<double>(text);
    if (!value || !self.range.holds(*value)) {
      return bad_option(
          fmt::format("'{}' is not auto, off or a number, {}", text, describe(self.range)));
    }
    options.weld = value;
    return ok();
  };
  row.get = [](const OptionEntry&, const Options& options) {
    return options.weld ? Texts{describe(*options.weld)} : Texts();
  };
  row.check = number<&Options::weld>({}).check;
  return row;
}

/// Of `sizes`, those inside regions or those `At` lines and points.
template <bool At>
constexpr OptionEntry sizes(OptionEntry row) {
  row.kind = OptionKind::text;
  row.repeats = true;
  row.unit = "length";
  row.range = ranges::kSize;
  row.set = [](const OptionEntry& self, std::string_view text, Options& options) -> Status {
    const std::size_t equals = text.rfind('=');
    const bool named = equals != std::string_view::npos;
    SizeRule rule{std::string(named ? text.substr(0, equals) : ""), 0, At};
    const std::string_view value = named ? text.substr(equals + 1) : text;
    const std::optional<double> size = parse<double>(value);
    if ((size && !self.range.holds(*size)) || (At && (!size || rule.name.empty())) ||
        value.empty()) {
      return bad_option(
          fmt::format("'{}' is not {}=h with a length h above 0", text, At ? "NAME" : "h or NAME"));
    }
    if (!size) {
      if (const auto formula = Expression::parse(value, kPlace); !formula) return formula.error();
      rule.expression = value;
    }
    rule.size = size.value_or(0);
    options.sizes.push_back(std::move(rule));
    return ok();
  };
  row.get = [](const OptionEntry&, const Options& options) {
    Texts texts;
    for (const SizeRule& rule : options.sizes) {
      if (rule.at != At) continue;
      const std::string size = rule.expression.empty() ? describe(rule.size) : rule.expression;
      texts.push_back(rule.name.empty() ? size : fmt::format("{}={}", rule.name, size));
    }
    return texts;
  };
  row.check = [](const OptionEntry& self, const Options& options) -> Status {
    for (const SizeRule& rule : options.sizes) {
      if (rule.at != At) continue;
      if (!rule.expression.empty()) {
        if (At) return bad_option("sizes at lines and points are lengths, not expressions");
        const auto formula = Expression::parse(rule.expression, kPlace);
        if (!formula) return formula.error();
        continue;
      }
      if (self.range.holds(rule.size)) continue;
      return bad_option(fmt::format("the size for '{}' is {}, but must be {}", rule.name, rule.size,
                                    describe(self.range)));
    }
    return ok();
  };
  return row;
}

/// A name in quotation marks, where two stand for one, at the beginning of `text`; it is taken off.
std::optional<std::string> take_quoted(std::string_view& text) {
  std::string name;
  for (std::size_t k = 1; k < text.size(); ++k) {
    if (text[k] == '"') {
      if (!text.substr(k + 1).starts_with('"')) {
        text.remove_prefix(k + 1);
        return name;
      }
      ++k;
    }
    name += text[k];
  }
  return std::nullopt;
}

/// A name at the beginning of `text`, in quotation marks or up to one of `ends`; it is taken off.
std::optional<std::string> take_name(std::string_view& text, std::string_view ends) {
  std::optional<std::string> name;
  if (text.starts_with('"')) {
    name = take_quoted(text);
  } else {
    const std::size_t stop = std::min(text.find_first_of(ends), text.size());
    name = text.substr(0, stop);
    text.remove_prefix(stop);
  }
  if (name && name->empty()) return std::nullopt;
  return name;
}

/// As take_name() reads it.
std::string quoted(const std::string& name) {
  if (!name.starts_with('"') && name.find_first_of("=@") == name.npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string(2, c) : std::string(1, c);
  return text + '"';
}

/// What stands before the values of a rule: LINE or LINE@REGION. Names with '@' or '=' are in
/// quotation marks.
struct LineSide {
  std::string line, region;
  std::string_view values;  ///< after the '='
};

std::optional<LineSide> line_side(std::string_view text) {
  LineSide out;
  const auto line = take_name(text, "@=");
  if (!line) return std::nullopt;
  out.line = *line;
  if (text.starts_with('@')) {
    text.remove_prefix(1);
    const auto region = take_name(text, "=");
    if (!region) return std::nullopt;
    out.region = *region;
  }
  if (!text.starts_with('=')) return std::nullopt;
  out.values = text.substr(1);
  return out;
}

/// Why the numbers of a rule are none.
Status check_layers(const LayerRule& rule) {
  const std::string line = rule.line + (rule.region.empty() ? "" : "@" + rule.region);
  const auto bad = [&](std::string_view what, double value, const Range& range) {
    return bad_option(fmt::format("layers for '{}': the {} is {}, but must be {}", line, what,
                                  describe(value), describe(range)));
  };
  if (!ranges::kSize.holds(rule.first)) return bad("first layer", rule.first, ranges::kSize);
  if (!ranges::kLayerGrowth.holds(rule.growth))
    return bad("growth", rule.growth, ranges::kLayerGrowth);
  if (!ranges::kLayerCount.holds(rule.count))
    return bad("number of layers", rule.count, ranges::kLayerCount);
  if (rule.count == 0 && rule.growth == 1)
    return bad_option(fmt::format(
        "layers for '{}': without a number of layers the growth must be above 1", line));
  return ok();
}

constexpr OptionEntry layers(OptionEntry row) {
  row.kind = OptionKind::text;
  row.repeats = true;
  row.unit = "length";
  row.set = [](const OptionEntry&, std::string_view text, Options& options) -> Status {
    const std::optional<LineSide> side = line_side(text);
    std::vector<std::string_view> values;
    for (std::string_view rest = side ? side->values : std::string_view(); !rest.empty();) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      values.push_back(rest.substr(0, comma));
      rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    const auto first = values.empty() ? std::nullopt : parse<double>(values[0]);
    const auto growth = values.size() < 2 ? std::nullopt : parse<double>(values[1]);
    const auto count = values.size() < 3 ? std::optional(0) : parse<int>(values[2]);
    if (!first || !growth || !count || values.size() > 3) {
      return bad_option(
          fmt::format("'{}' is not LINE[@REGION]=first,growth[,count] with a length, "
                      "a number and a whole number",
                      text));
    }
    LayerRule rule{side->line, side->region, *first, *growth, *count};
    if (Status status = check_layers(rule); !status) return status;
    for (const LayerRule& other : options.layers) {
      if (other.line == rule.line && other.region == rule.region)
        return bad_option(fmt::format("'{}': layers for that line are asked for twice", text));
    }
    options.layers.push_back(std::move(rule));
    return ok();
  };
  row.get = [](const OptionEntry&, const Options& options) {
    Texts texts;
    for (const LayerRule& rule : options.layers) {
      const std::string region = rule.region.empty() ? "" : "@" + quoted(rule.region);
      texts.push_back(fmt::format("{}{}={},{},{}", quoted(rule.line), region, rule.first,
                                  rule.growth, rule.count));
    }
    return texts;
  };
  row.check = [](const OptionEntry&, const Options& options) -> Status {
    for (const LayerRule& rule : options.layers) {
      if (Status status = check_layers(rule); !status) return status;
    }
    return ok();
  };
  return row;
}

/// A file, which whoever can read it makes Options::size_field of.
constexpr OptionEntry size_field(OptionEntry row) {
  row.kind = OptionKind::text;
  row.unit = "length";
  row.set = [](const OptionEntry&, std::string_view text, Options& options) -> Status {
    if (text.empty()) return bad_option("a file is needed");
    options.size_field_name = text;
    return ok();
  };
  row.get = [](const OptionEntry&, const Options& options) {
    return options.size_field || !options.size_field_name.empty() ? Texts{options.size_field_name}
                                                                  : Texts();
  };
  row.check = [](const OptionEntry&, const Options& options) -> Status {
    if (options.size_field || options.size_field_name.empty()) return ok();
    return bad_option(fmt::format("size_field: {} has not been read", options.size_field_name));
  };
  return row;
}

/// What the sizes of the file shall follow: a function of its values.
constexpr OptionEntry size_of(OptionEntry row) {
  row.kind = OptionKind::text;
  row.set = [](const OptionEntry&, std::string_view text, Options& options) -> Status {
    if (text.empty()) return bad_option("a function or an expression is needed");
    options.size_of = text;
    return ok();
  };
  row.get = [](const OptionEntry&, const Options& options) {
    return options.size_of.empty() ? Texts() : Texts{options.size_of};
  };
  return row;
}

/// What stands behind the @ of a pair of sides.
bool take_map(std::string_view text, PeriodicRule& rule) {
  if (text == "mirror") {
    rule.map = PeriodicRule::Map::mirror;
    return true;
  }
  const std::size_t comma = text.find(','), colon = text.find(':');
  if (comma == text.npos || colon == text.npos || colon < comma) return false;
  const auto x = parse<double>(text.substr(0, comma));
  const auto y = parse<double>(text.substr(comma + 1, colon - comma - 1));
  const auto degrees = parse<double>(text.substr(colon + 1));
  if (!x || !y || !degrees) return false;
  rule.map = PeriodicRule::Map::rotation;
  rule.centre = {*x, *y};
  rule.angle = Angle::degrees(*degrees);
  return true;
}

/// A pair of sides and the map that takes the one to the other.
constexpr OptionEntry periodic(OptionEntry row) {
  row.kind = OptionKind::text;
  row.repeats = true;
  row.set = [](const OptionEntry&, std::string_view text, Options& options) -> Status {
    PeriodicRule rule;
    std::string_view rest = text;
    const auto from = take_name(rest, "=");
    bool good = from && rest.starts_with('=');
    if (good) rest.remove_prefix(1);
    const auto to = good ? take_name(rest, "@") : std::nullopt;
    good = to && (rest.empty() || (rest.starts_with('@') && take_map(rest.substr(1), rule)));
    if (!good)
      return bad_option(fmt::format(
          "'{}' is not A=B, A=B@x,y:degrees or A=B@mirror with the names of two lines", text));
    rule.from = *from;
    rule.to = *to;
    options.periodic.push_back(std::move(rule));
    return ok();
  };
  row.get = [](const OptionEntry&, const Options& options) {
    Texts texts;
    for (const PeriodicRule& rule : options.periodic) {
      std::string text = quoted(rule.from) + "=" + quoted(rule.to);
      if (rule.map == PeriodicRule::Map::mirror) text += "@mirror";
      if (rule.map == PeriodicRule::Map::rotation)
        text +=
            fmt::format("@{},{}:{:.12g}", rule.centre.x, rule.centre.y, rule.angle.in_degrees());
      texts.push_back(std::move(text));
    }
    return texts;
  };
  row.check = [](const OptionEntry&, const Options& options) -> Status {
    for (const PeriodicRule& rule : options.periodic) {
      if (Status status = check_rule(rule); !status) return status;
    }
    return ok();
  };
  return row;
}

constexpr std::array kRequirements{&Requirements::bound, &Requirements::max_angle,
                                   &Requirements::delaunay, &Requirements::non_obtuse,
                                   &Requirements::box_method};

/// Members of Requirements, in the order of the words.
constexpr OptionEntry requirements(OptionEntry row) {
  row.kind = OptionKind::words;
  row.repeats = true;
  row.set = [](const OptionEntry& self, std::string_view text, Options& options) -> Status {
    const Result<std::size_t> found = option_kinds::word_of(self, text);
    if (!found) return found.error();
    options.require.*kRequirements.at(*found) = true;
    return ok();
  };
  row.get = [](const OptionEntry& self, const Options& options) {
    Texts texts;
    for (std::size_t k = 0; k < kRequirements.size(); ++k)
      if (options.require.*kRequirements[k]) texts.emplace_back(self.words()[k]);
    return texts;
  };
  return row;
}

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
                "targets give way, the bound never does. last: angles alone decide. auto: first",
        .more = "But with --split-interfaces and auto targets come first, then couplings, in "
                "regions without layers, unless there is --box-method, too; with first, segments "
                "are cut before meshing alone.",
        .counts_with = "--method quality",
        .counts = is_quality}),
    flag<&Options::box_method>({
        .name = "box-method",
        .help = "Cut segments until no coupling of the box method (finite volumes on Voronoi "
                "boxes) is negative; both sides get the same points"}),
    sizes<false>({
        .name = "size", .placeholder = "[NAME=]h",
        .help = "Edge length inside: everywhere (h), or in a region or material (NAME=h), by name, "
                "number of the material, or region:ID; a number or an expression of x and y",
        .more = "The ID is the number that reports give a region. Expressions, as 0.1+0.3*abs(y), "
                "have + - * / ^, pi, min, max, abs, sqrt, exp, log, sin, cos, asinh, tanh; where "
                "they are no number above zero they ask for nothing; where they fall to zero, "
                "--min-size must say what counts. Where several sizes hold, the smallest counts."}),
    sizes<true>({
        .name = "size-at", .placeholder = "NAME=h",
        .help = "Edge length at an interface, a contact or a point (NAME=h)",
        .more = "A point is called by its number in the input, or a boundary marker (\"marker 7\", "
                "\"7\" where no point is). Beside segments that are longer "
                "than asked, triangles are larger."}),
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
        .group = OptionGroup::cleaning}),
    flag<&Options::merge_materials>({
        .name = "merge-materials",
        .help = "Unite touching faces of equal material",
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
    Texts values = entry.get(entry, options);
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
