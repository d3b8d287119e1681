// Tested by tests/unit/io/input/drawings/read_geojson_test.cpp, tests/unit/gdal/read_gdal_test.cpp.
#include "io/input/map_words.hpp"

#include <cmath>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "io/text/array_names.hpp"
#include "io/text/text.hpp"

namespace cover {

void LeftOut::add_size(long feature) {
  if (sizes_++ == 0) first_size_ = feature;
}

void LeftOut::tell(std::string_view what, std::vector<std::string>& warnings) const {
  const auto are = [](std::size_t n, const char* one, const char* several) {
    return fmt::format("{} {}", n, n == 1 ? one : several);
  };
  if (points_ > 0)
    warnings.push_back(are(points_, "geometry is a point", "geometries are points") + ": left out");
  if (surfaces_ > 0)
    warnings.push_back(
        are(surfaces_, "geometry is a surface in space", "geometries are surfaces in space") +
        ": left out");
  if (sizes_ > 0)
    warnings.push_back(fmt::format(
        "the {} 'size' of {} is no length above 0: left out{}{}", what, counted(sizes_, "feature"),
        sizes_ == 1 ? ", feature " : ", the first of feature ", first_size_));
  if (sizes_of_lines_ > 0)
    warnings.push_back(
        fmt::format("the {} 'size' of {} is left out: it is one of areas; along a line, "
                    "--size-at NAME=... asks for sizes",
                    what, counted(sizes_of_lines_, "line")));
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
