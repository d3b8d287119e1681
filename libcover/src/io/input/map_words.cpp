// Tested by tests/unit/io/input/drawings/read_geojson_test.cpp, tests/unit/gdal/read_gdal_test.cpp.
#include "io/input/map_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/errors.hpp"
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

void AskedNames::note(const std::string& option, const std::string& name, bool is_there,
                      const std::string& missing) {
  auto asked = std::find_if(names_.begin(), names_.end(), [&](const AskedName& known) {
    return known.option == option && known.name == name;
  });
  if (asked == names_.end()) asked = names_.insert(asked, {option, name, false, ""});
  asked->is_there |= is_there;
  if (!is_there) asked->missing += (asked->missing.empty() ? "" : "; ") + missing;
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

void tell_renamed(const std::vector<Attribute>& attributes, std::vector<std::string>& warnings) {
  std::vector<std::string> names;
  for (const Attribute& attribute : attributes) names.push_back(attribute.name);
  const std::vector<std::string> arrays = array_names(names);
  for (std::size_t k = 0; k < names.size(); ++k)
    if (is_own_array(names[k]))
      warnings.push_back(
          fmt::format("the attribute '{}' is the array '{}' of mesh files: every mesh has an array "
                      "of its name",
                      names[k], arrays[k]));
}

std::optional<double> number_in_words(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
  if (begin == std::string_view::npos) return std::nullopt;
  const std::optional<double> number = parse_double(text.substr(begin, end + 1 - begin));
  return number && std::isfinite(*number) ? number : std::nullopt;
}

}  // namespace cover
