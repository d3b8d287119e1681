// Rows of the table whose values have a form of their own: sizes, layers, periodic sides and such.
// They are made as those in option_kinds.hpp are, and read, write and check their values.
// Tested by tests/unit/options/option_table_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <cover/option_table.hpp>
#include <cover/text.hpp>

#include "base/expression.hpp"
#include "base/words/quoted_names.hpp"
#include "options/option_kinds.hpp"
#include "options/periodic_rule.hpp"

namespace cover::option_kinds {

using Texts = std::vector<std::string>;

inline const std::array<std::string, 2> kPlace{"x", "y"};

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

/// What stands before the values of a rule: LINE or LINE@REGION. Names with '@' or '=' are in
/// quotation marks.
struct LineSide {
  std::string line, region;
  std::string_view values;  ///< after the '='
};

inline std::optional<LineSide> line_side(std::string_view text) {
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
inline Status check_layers(const LayerRule& rule) {
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
inline bool take_map(std::string_view text, PeriodicRule& rule) {
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
      if (rule.map == PeriodicRule::Map::glide) text += "@glide";
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

inline constexpr std::array kRequirements{&Requirements::bound, &Requirements::max_angle,
                                          &Requirements::delaunay, &Requirements::non_obtuse,
                                          &Requirements::box_method};

/// Members of Requirements, in the order of the words.
constexpr OptionEntry requirements(OptionEntry row) {
  row.kind = OptionKind::words;
  row.repeats = true;
  row.set = [](const OptionEntry& self, std::string_view text, Options& options) -> Status {
    const Result<std::size_t> found = word_of(self, text);
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

}  // namespace cover::option_kinds
