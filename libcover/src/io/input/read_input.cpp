// Which reader a file wants is told by its extension. Tested by tests/unit/io/read_*_test.cpp.
#include <cover/read_input.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "io/input/formats.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// A format that is read from one text.
struct Format {
  std::string_view extension;
  Result<Input> (*parse)(std::string_view text, const std::string& source);
};

constexpr std::array kFormats{
    Format{".poly", parse_poly},
    Format{".json", parse_json},
    Format{".geojson", parse_geojson},
    Format{".msh", parse_msh},
};

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::string extension_of(const std::string& path) {
  return lower(std::filesystem::path(path).extension().string());
}

}  // namespace

Result<Input> parse_input(std::string_view text, std::string_view extension,
                          const std::string& source) {
  for (const Format& format : kFormats)
    if (format.extension == lower(extension)) return format.parse(text, source);
  if (lower(extension) == ".geo") {
    return Error{ErrorCode::unsupported_format,
                 fmt::format("{}: .geo is read by gmsh's library, without which this was built; "
                             "'gmsh -2 FILE.geo -o FILE.msh' makes a file that can be read",
                             source),
                 {},
                 {}};
  }
  std::string known;
  for (const Format& format : kFormats) {
    known += fmt::format("{}{}", known.empty() ? "" : ", ", format.extension);
  }
  return Error{
      ErrorCode::unsupported_format,
      fmt::format(
          "{}: no reader for files named '*{}'; known: {}, and through VTK .vtu, .vtp, .vtk",
          source, extension, known),
      {},
      {}};
}

Result<Input> read_input(const std::string& path) {
  Result<std::string> text = read_file(path);
  if (!text) return std::move(text).error();
  return parse_input(*text, extension_of(path), path);
}

}  // namespace cover
