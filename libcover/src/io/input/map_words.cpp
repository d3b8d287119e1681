// Tested by tests/unit/io/input/drawings/read_geojson_test.cpp, tests/unit/gdal/read_gdal_test.cpp.
#include "io/input/map_words.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include <cover/files.hpp>
#include <cover/text.hpp>

#include "base/faults/errors.hpp"
#include "base/words/characters.hpp"
#include "io/input/coordinate_systems.hpp"
#include "io/text/array_names.hpp"
#include "io/text/text.hpp"

namespace cover {

void LeftOut::add_size(long feature) {
  if (sizes_++ == 0) first_size_ = feature;
}

void LeftOut::tell(std::string_view what, Input& input) const {
  std::vector<std::string>& warnings = input.warnings;
  if (surfaces_ > 0)
    input.changes.push_back(
        {Change::Kind::dropped,
         surfaces_ == 1 ? std::string("1 geometry is a surface in space: left out")
                        : fmt::format("{} geometries are surfaces in space: left out", surfaces_),
         {},
         {}});
  if (empty_ > 0)
    warnings.push_back(empty_ == 1
                           ? std::string("1 geometry is null or empty: left out")
                           : fmt::format("{} geometries are null or empty: left out", empty_));
  if (heights_ > 0)
    warnings.push_back(fmt::format("{} not in the plane: z is dropped",
                                   counted(heights_, "point") + (heights_ == 1 ? " is" : " are")));
  if (voids_ > 0)
    warnings.push_back(fmt::format(
        "in a map 'void' is a material like others, here of {}: what is to be left out has to be "
        "an inner ring of what is around it",
        counted(voids_, "polygon")));
  if (sizes_ > 0)
    warnings.push_back(fmt::format(
        "the {} 'size' of {} is no length above 0: left out{}{}", what, counted(sizes_, "feature"),
        sizes_ == 1 ? ", feature " : ", the first of feature ", first_size_));
  if (sizes_of_lines_ > 0)
    warnings.push_back(
        fmt::format("the {} 'size' of {} is left out: it is one of areas; along a line, "
                    "--size-at NAME=... asks for sizes",
                    what, counted(sizes_of_lines_, "line")));
  if (sizes_of_points_ > 0)
    warnings.push_back(fmt::format("the {} 'size' of {} is left out: it is one of areas", what,
                                   counted(sizes_of_points_, "point")));
}

void tell_degrees(Input& input) {
  const Box box = box_of_input(input);
  if (box.is_empty() || (is_on_globe(box.low) && is_on_globe(box.high))) {
    input.warnings.emplace_back(kInDegrees);
    return;
  }
  input.warnings.push_back(fmt::format(
      "coordinates should be longitudes and latitudes, as the file says, but they reach from {} to "
      "{}: if they are those of a plane already, 'ogr2ogr -a_srs EPSG:... OUT{} {}' makes a file "
      "that says of which system",
      describe(box.low), describe(box.high), extension_of(input.source), input.source));
}

void note_field(Input& input, const std::string& name) {
  std::vector<std::string>& fields = input.fields;
  if (std::find(fields.begin(), fields.end(), name) == fields.end()) fields.push_back(name);
}

bool is_word_for_void(std::string_view material) { return lower(material) == "void"; }

void AskedNames::note(const std::string& option, const std::string& name, bool is_there,
                      const std::string& missing) {
  auto asked = std::find_if(names_.begin(), names_.end(), [&](const AskedName& known) {
    return known.option == option && known.name == name;
  });
  if (asked == names_.end()) asked = names_.insert(asked, {option, name, false, ""});
  asked->is_there |= is_there;
  if (!is_there) asked->missing += (asked->missing.empty() ? "" : "; ") + missing;
}

void AskedNames::deny(const std::string& option, const std::string& name,
                      const std::string& missing) {
  for (AskedName& asked : names_)
    if (asked.option == option && asked.name == name) asked = {option, name, false, missing};
}

std::optional<Error> AskedNames::settle(const ReadOptions& options, Input& input) const {
  if (options.is_one_of_several) {
    input.asked = names_;
    return std::nullopt;
  }
  const auto missing = std::find_if(names_.begin(), names_.end(),
                                    [](const AskedName& asked) { return !asked.is_there; });
  if (missing == names_.end()) return std::nullopt;
  return bad_option(fmt::format("{}: {}: {}", input.source, missing->option, missing->missing));
}

std::string no_text_on(std::string_view layer, std::vector<std::string> layers) {
  constexpr std::size_t kMostNamed = 12;
  if (layers.size() > kMostNamed) {
    layers.resize(kMostNamed);
    layers.emplace_back("...");
  }
  return fmt::format(
      "no text is on the layer '{}'{}", legible(layer),
      layers.empty() ? ": there are no texts in it" : "; texts are on " + listed(layers));
}

void tell_renamed(const std::vector<Attribute>& attributes, std::vector<std::string>& warnings) {
  std::vector<std::string> names;
  for (const Attribute& attribute : attributes) names.push_back(attribute.name);
  const std::vector<std::string> arrays = array_names(names);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == arrays[k]) continue;
    warnings.push_back(
        fmt::format("the attribute '{}' is the array '{}' of mesh files: {}", names[k], arrays[k],
                    is_own_array(names[k]) ? "every mesh has an array of its name"
                                           : "not every name can be that of an array"));
  }
}

std::optional<double> number_in_words(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
  if (begin == std::string_view::npos) return std::nullopt;
  const std::optional<double> number = parse_double(text.substr(begin, end + 1 - begin));
  return number && std::isfinite(*number) ? number : std::nullopt;
}

bool double_holds(std::int64_t whole) {
  const auto bits = static_cast<std::uint64_t>(whole);
  const std::uint64_t size = whole < 0 ? 0 - bits : bits;
  return size == 0 ||
         std::bit_width(size) - std::countr_zero(size) <= std::numeric_limits<double>::digits;
}

std::optional<double> number_in_column(std::string_view text) {
  const std::optional<double> number = number_in_words(text);
  const bool is_whole = text.find_first_not_of(" +-0123456789") == std::string_view::npos;
  const bool is_short =
      number && std::abs(*number) < std::ldexp(1, std::numeric_limits<double>::digits);
  if (!is_whole || is_short) return number;
  const std::optional<long> whole = parse_integer(text);
  return whole && double_holds(*whole) ? number : std::nullopt;
}

void tell_spelled_numbers(const std::vector<Attribute>& attributes,
                          std::vector<std::string>& warnings) {
  const auto spells_number = [](const std::string& word) {
    const bool is_code = word.size() > 1 && word[0] == '0' && is_digit(word[1]);
    return !is_code && number_in_column(word);
  };
  for (const Attribute& attribute : attributes) {
    const std::vector<std::string>& words = attribute.words;
    if (!words.empty() && std::all_of(words.begin(), words.end(), spells_number))
      warnings.push_back(
          fmt::format("the attribute '{}' is text wherever it is, as '{}', though it spells "
                      "numbers: its array numbers the different texts 1, 2, ...",
                      attribute.name, words.front()));
  }
}

}  // namespace cover
