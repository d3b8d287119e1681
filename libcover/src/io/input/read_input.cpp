// Which reader a file wants is told by its extension.
// Tested by tests/unit/io/input/read_json_test.cpp and those beside it.
#include <cover/read_input.hpp>

#include <fmt/core.h>

#include <array>

#include "base/out_of_memory.hpp"
#include "io/input/formats.hpp"
#include "io/text/text.hpp"
#include "io/vtk_files/read_data_set.hpp"

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

}  // namespace

Result<Input> parse_input(std::string_view text, std::string_view extension,
                          const std::string& source) {
  return memory_as_value(source, [&]() -> Result<Input> {
    const std::string wanted = lower(extension);
    for (const Format& format : kFormats)
      if (format.extension == wanted) return format.parse(text, source);
    if (is_data_set(wanted)) return parse_vtk_input(text, wanted, source);
    if (wanted == ".geo") {
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
        fmt::format("{}: no reader for files named '*{}'; known: {}, .vtu, .vtp, .vti, .vtk",
                    source, extension, known),
        {},
        {}};
  });
}

Result<Input> read_input(const std::string& path) {
  return memory_as_value(path, [&]() -> Result<Input> {
    Result<std::string> text = read_file(path);
    if (!text) return std::move(text).error();
    return parse_input(*text, extension_of(path), path);
  });
}

}  // namespace cover
