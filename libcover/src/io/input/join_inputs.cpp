// Tested by tests/unit/io/input/join_inputs_test.cpp.
#include <cover/join_inputs.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>
#include <cover/units.hpp>

#include "base/faults/errors.hpp"
#include "base/numbers.hpp"
#include "base/words/and_more.hpp"
#include "base/words/characters.hpp"
#include "io/input/attribute_table.hpp"
#include "io/input/coordinate_systems.hpp"
#include "io/input/map_words.hpp"

namespace cover {
namespace {

template <class T>
void append(std::vector<T>& to, std::vector<T> from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// Something that there is for each point or not at all; `missing(k)` where it was not there.
template <class T, class Missing>
void append_by_point(std::vector<T>& to, std::vector<T> from, std::size_t before, std::size_t more,
                     Missing missing) {
  if (to.empty() && from.empty()) return;
  for (std::size_t k = to.size(); k < before; ++k) to.push_back(missing(k));
  for (std::size_t k = from.size(); k < more; ++k) from.push_back(missing(k));
  append(to, std::move(from));
}

/// Whether a name is feature_ and a number.
bool is_made_up(std::string_view material) {
  constexpr std::string_view kHead = "feature_";
  if (!material.starts_with(kHead) || material.size() == kHead.size()) return false;
  material.remove_prefix(kHead.size());
  return std::all_of(material.begin(), material.end(), is_digit);
}

Error differ(const Input& one, const Input& other, std::string_view what) {
  return {ErrorCode::bad_option,
          fmt::format("{} and {} cannot be taken together: {}", one.source, other.source, what),
          {},
          {}};
}

std::string unit_in_words(const Input& input) {
  if (!input.unit.empty()) return input.unit;
  return input.other_unit.empty() ? std::string("none") : input.other_unit;
}

/// What to do about units that are not the same.
std::string unit_advice(const Input& one, const Input& other) {
  const bool other_is_scaled = is_length_unit(one.unit);
  const Input& scaled = other_is_scaled ? other : one;
  const std::string& unit = other_is_scaled ? one.unit : other.unit;
  const std::optional<double> factor = factor_between(unit_in_words(scaled), unit);
  if (!factor) {
    // A shapefile without its .prj, say.
    const bool one_knows = !one.system.empty(), other_knows = !other.system.empty();
    const std::string lacking =
        one_knows == other_knows
            ? ""
            : fmt::format("{} says no coordinate system, as a .prj or 'crs' does; ",
                          one_knows ? other.source : one.source);
    return lacking + fmt::format("the option unit (--unit {}) gives all of them one",
                                 is_length_unit(unit) ? unit : "mm");
  }
  return fmt::format(
      "multiply the coordinates of {} by {:.10g} first, which makes them {}; the option unit takes "
      "all numbers as they are",
      scaled.source, *factor, unit);
}

/// Circles are numbered from 1.
void shift(std::vector<std::uint32_t>& circles, std::uint32_t by) {
  for (std::uint32_t& circle : circles) circle = circle == 0 ? 0 : circle + by;
}

double nothing_of(const Attribute& attribute) { return attribute.is_text ? 0 : kNoNumber; }

/// The number of a word, which `attribute` and its `known` words get if it is new.
double number_of(const std::string& word, Attribute& attribute,
                 std::unordered_map<std::string, std::size_t>& known) {
  const auto [entry, is_new] = known.emplace(word, known.size() + 1);
  if (is_new) attribute.words.push_back(word);
  return static_cast<double>(entry->second);
}

/// A column of numbers as the words that a reader would write for them in a column of text.
Attribute as_text(Attribute numbers) {
  if (numbers.is_text) return numbers;
  numbers.is_text = true;
  std::unordered_map<std::string, std::size_t> known;
  for (double& value : numbers.values)
    value = std::isnan(value) ? 0 : number_of(fmt::format("{}", value), numbers, known);
  return numbers;
}

bool is_all_nothing(const Attribute& numbers) {
  return std::all_of(numbers.values.begin(), numbers.values.end(),
                     [](double value) { return std::isnan(value); });
}

/// Turns a column of text that spells numbers into them; false where a word spells none.
bool make_numbers(Attribute& text) {
  std::vector<double> numbers{kNoNumber};
  for (const std::string& word : text.words) {
    const std::optional<double> number = number_in_column(word);
    if (!number) return false;
    numbers.push_back(*number);
  }
  for (double& value : text.values) value = numbers[static_cast<std::size_t>(value)];
  text.words.clear();
  text.is_text = false;
  return true;
}

/// What stands in a column of text that does not spell numbers throughout.
std::string words_in(const Attribute& text) {
  const auto word = std::find_if_not(text.words.begin(), text.words.end(), number_in_words);
  if (word != text.words.end()) return "words";
  const auto whole = std::find_if_not(text.words.begin(), text.words.end(), number_in_column);
  return fmt::format("whole numbers that no double holds, as {}", *whole);
}

/// What AttributeTable makes of texts and numbers in one file.
void make_alike(Attribute& all, Attribute& more, const std::string& source,
                std::vector<std::string>& warnings) {
  Attribute& text = all.is_text ? all : more;
  if (const Attribute& numbers = all.is_text ? more : all; !is_all_nothing(numbers)) {
    if (make_numbers(text)) return;
    warnings.push_back(
        fmt::format("the attribute '{}' of {} has {}, and that of files before it {}: its array "
                    "numbers the different values 1, 2, ...",
                    all.name, source, more.is_text ? words_in(text) : "numbers",
                    more.is_text ? "numbers" : words_in(text)));
  }
  all = as_text(std::move(all));
  more = as_text(std::move(more));
}

/// The rows of `more` behind those of `all`.
void append_rows(Attribute& all, Attribute more, const std::string& source,
                 std::vector<std::string>& warnings) {
  if (all.is_text != more.is_text) make_alike(all, more, source, warnings);
  if (all.is_text) {
    std::unordered_map<std::string, std::size_t> known;
    for (const std::string& word : all.words) known.emplace(word, known.size() + 1);
    std::vector<double> numbers{0};
    for (const std::string& word : more.words) numbers.push_back(number_of(word, all, known));
    for (double& value : more.values) value = numbers[static_cast<std::size_t>(value)];
  }
  append(all.values, std::move(more.values));
}

/// One table: columns of one name are one.
void join_attributes(Input& all, Input& more) {
  if (more.attributes.empty()) return;
  const std::size_t before = all.attributes.empty() ? 0 : all.attributes.front().values.size();
  const std::size_t rows = before + more.attributes.front().values.size();
  for (InputPolygon& polygon : more.polygons)
    if (polygon.feature != 0) polygon.feature += static_cast<std::uint32_t>(before);
  for (Attribute& attribute : more.attributes) {
    const auto same = std::find_if(all.attributes.begin(), all.attributes.end(),
                                   [&](const Attribute& a) { return a.name == attribute.name; });
    if (same != all.attributes.end()) {
      append_rows(*same, std::move(attribute), more.source, all.warnings);
    } else {
      attribute.values.insert(attribute.values.begin(), before, nothing_of(attribute));
      all.attributes.push_back(std::move(attribute));
    }
  }
  for (Attribute& attribute : all.attributes) attribute.values.resize(rows, nothing_of(attribute));
}

/// Tells where features of several files have one number.
void tell_equal_ids(const std::vector<Input>& inputs, std::vector<std::string>& warnings) {
  std::unordered_set<double> known;
  for (const Input& input : inputs) {
    const auto ids = std::find_if(input.attributes.begin(), input.attributes.end(),
                                  [](const Attribute& a) { return a.name == kFeatureId; });
    if (ids == input.attributes.end() || ids->is_text) continue;
    const auto twice = std::find_if(ids->values.begin(), ids->values.end(),
                                    [&](double id) { return known.contains(id); });
    if (twice != ids->values.end()) {
      warnings.push_back(fmt::format(
          "'{}' is {} in {} and in a file before it: each file numbers its features anew",
          kFeatureId, *twice, input.source));
      return;
    }
    std::copy_if(ids->values.begin(), ids->values.end(), std::inserter(known, known.end()),
                 [](double id) { return !std::isnan(id); });  // they would be all in one bucket
  }
}

/// All maps of one system have one unit, which not every format says.
void share_units(std::vector<Input>& inputs) {
  std::map<std::pair<std::string, double>, std::string> units;
  for (const Input& input : inputs)
    if (!input.system.empty() && !input.unit.empty())
      units.emplace(std::pair(input.system, input.scale), input.unit);
  for (Input& input : inputs) {
    const auto unit = units.find({input.system, input.scale});
    if (input.unit.empty() && unit != units.end()) input.unit = unit->second;
  }
}

/// Whether a warning says the same of one map as of another, and once is enough.
bool is_of_all_maps(const std::string& warning) {
  return warning == kInDegrees || warning == kMayBeDegrees;
}
bool is_told(const Input& input, const std::string& warning) {
  return std::any_of(input.warnings.begin(), input.warnings.end(),
                     [&](const std::string& told) { return told.ends_with(warning); });
}

Status join(Input& all, Input more, std::size_t file) {
  if (all.unit != more.unit || all.other_unit != more.other_unit || all.scale != more.scale)
    return differ(all, more,
                  fmt::format("their units of length are not the same, {} and {}: {}",
                              unit_in_words(all), unit_in_words(more), unit_advice(all, more)));
  if (all.void_rule != more.void_rule && !all.segments.empty() && !more.segments.empty())
    return differ(all, more, "faces without a seed are void in one of them alone");
  if (all.field && more.field) return differ(all, more, "both have values beside their geometry");
  if (all.system.empty()) all.system = more.system;
  if (!more.segments.empty()) all.void_rule = more.void_rule;
  if (more.field) all.field = more.field;
  all.seeds_may_miss |= more.seeds_may_miss;
  all.is_picture &= more.is_picture;
  for (const std::string& field : more.fields) note_field(all, field);
  const std::size_t before = all.points.size(), count = more.points.size();
  const auto circles = static_cast<std::uint32_t>(all.circles.size());
  append_by_point(all.point_ids, std::move(more.point_ids), before, count,
                  [](std::size_t k) { return static_cast<long>(k); });
  append_by_point(all.point_lines, std::move(more.point_lines), before, count,
                  [](std::size_t) { return 0; });
  append_by_point(all.point_markers, std::move(more.point_markers), before, count,
                  [](std::size_t) { return 0; });
  append(all.points, std::move(more.points));
  for (PointName& name : more.point_names) name.point += static_cast<std::uint32_t>(before);
  append(all.point_names, std::move(more.point_names));
  for (InputSegment& segment : more.segments) {
    segment.a += static_cast<std::uint32_t>(before);
    segment.b += static_cast<std::uint32_t>(before);
    if (segment.circle != 0) segment.circle += circles;
  }
  for (InputPolygon& polygon : more.polygons) {
    for (std::vector<std::uint32_t>& ring : polygon.circles) shift(ring, circles);
    if (polygon.region.empty() && is_made_up(polygon.material))
      polygon.material = fmt::format("{}:{}", file, polygon.material);
  }
  for (InputLine& line : more.lines) shift(line.circles, circles);
  join_attributes(all, more);
  append(all.circles, std::move(more.circles));
  append(all.segments, std::move(more.segments));
  append(all.holes, std::move(more.holes));
  append(all.seeds, std::move(more.seeds));
  append(all.polygons, std::move(more.polygons));
  append(all.lines, std::move(more.lines));
  append(all.periodic, std::move(more.periodic));
  append(all.layers, std::move(more.layers));
  append(all.changes, std::move(more.changes));
  for (const std::string& warning : more.warnings) {
    if (is_of_all_maps(warning) && is_told(all, warning)) continue;
    all.warnings.push_back(fmt::format("{}: {}", more.source, warning));
  }
  return ok();
}

/// Says of all elements from which file they are, before they get among others.
void note_files(std::vector<Input>& inputs) {
  std::vector<std::string> files;
  for (Input& input : inputs) {
    const auto before = static_cast<std::uint32_t>(files.size());
    for (InputSegment& segment : input.segments) segment.file += before;
    for (InputPolygon& polygon : input.polygons) polygon.file += before;
    for (InputLine& line : input.lines) line.file += before;
    for (Change& change : input.changes)
      if (input.files.empty()) change.message = fmt::format("{}: {}", input.source, change.message);
    if (input.files.empty()) input.files = {input.source};
    append(files, std::move(input.files));
  }
  inputs.front().files = std::move(files);
}

bool is_empty(const Input& input) {
  return input.points.empty() && input.segments.empty() && input.polygons.empty() &&
         input.lines.empty() && input.seeds.empty() && input.holes.empty() &&
         input.circles.empty() && input.periodic.empty() && input.layers.empty() && !input.field;
}

/// Leaves out what holds nothing, as some tiles of a map do: it would not even have a coordinate
/// system. Appends a sentence on each to `warnings`.
///
/// Errors: syntax, where none is left
Status drop_empty(std::vector<Input>& inputs, std::vector<std::string>& warnings) {
  constexpr const char* kEmpty = "no polygon, line or point in it";
  for (const Input& input : inputs)
    if (is_empty(input)) warnings.push_back(fmt::format("{}: {}", input.source, kEmpty));
  if (warnings.size() == inputs.size())
    return Error{ErrorCode::syntax, listed(warnings, "; "), {}, {}};
  std::erase_if(inputs, is_empty);
  return ok();
}

/// The error where no input has a field or a layer that was asked of all.
std::optional<Error> find_missing(const std::vector<Input>& inputs) {
  constexpr std::size_t kTold = 3;
  struct Missing {
    bool is_there = false;
    std::vector<std::string> sentences;
  };
  std::map<std::pair<std::string, std::string>, Missing> names;
  for (const Input& input : inputs) {
    for (const AskedName& asked : input.asked) {
      Missing& missing = names[{asked.option, asked.name}];
      missing.is_there |= asked.is_there;
      if (!asked.is_there) missing.sentences.push_back(input.source + ": " + asked.missing);
    }
  }
  for (auto& [name, missing] : names) {
    if (missing.is_there) continue;
    const std::size_t all = missing.sentences.size();
    missing.sentences.resize(std::min(all, kTold));
    return bad_option(name.first + ": " + listed(missing.sentences, "; ") +
                      and_more(all, kTold, ";"));
  }
  return std::nullopt;
}

}  // namespace

Result<Input> join_inputs(std::vector<Input> inputs) {
  constexpr std::size_t kNamed = 3;
  if (inputs.empty()) return bad_option("there is no input to join");
  for (std::size_t k = 0; k < inputs.size() && inputs.size() > 1; ++k)  // sentences name both
    if (inputs[k].source.empty()) inputs[k].source = fmt::format("input {}", k + 1);
  std::vector<std::string> warnings;
  const bool is_joined = inputs.size() > 1;
  if (is_joined)
    if (Status status = drop_empty(inputs, warnings); !status) return std::move(status).error();
  if (Status status = check_systems(inputs, warnings); !status) return std::move(status).error();
  if (std::optional<Error> missing = find_missing(inputs)) return *std::move(missing);
  if (inputs.size() > 1) note_files(inputs);
  share_units(inputs);
  tell_equal_ids(inputs, warnings);
  std::string source = inputs.front().source;
  for (std::size_t k = 1; k < inputs.size() && k < kNamed; ++k) source += ", " + inputs[k].source;
  source += and_more(inputs.size(), kNamed);
  Input all = std::move(inputs.front());
  for (std::size_t k = 1; k < inputs.size(); ++k) {
    if (Status status = join(all, std::move(inputs[k]), k + 1); !status)
      return std::move(status).error();
    inputs[k] = {};
  }
  all.source = std::move(source);
  append(all.warnings, std::move(warnings));
  if (is_joined) tell_spelled_numbers(all.attributes, all.warnings);
  return all;
}

}  // namespace cover
