#include "input_file.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#ifdef COVER_WITH_GMSH
#include <cover/read_geo.hpp>
#endif
#include <cover/read_input.hpp>
#include <cover/units.hpp>

#include "options.hpp"

namespace cover::app {
namespace {

#ifdef COVER_WITH_GMSH
constexpr const char* kGmshFormats = ".msh and .geo";
#else
constexpr const char* kGmshFormats = ".msh";
#endif

std::string_view format_of(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const char first = start == std::string_view::npos ? ' ' : text[start];
  if (text.starts_with("# vtk DataFile")) return ".vtk";
  if (first == '<') return ".vtu";  // and VTK's other data sets in XML: their root tells
  if (first == '$') return ".msh";
  if (first != '{') return ".poly";
  return text.find("\"Feature") != std::string_view::npos ? ".geojson" : ".json";
}

Result<Input> read_geometry(const std::string& path) {
#ifdef COVER_WITH_GMSH
  if (path.ends_with(".geo")) return read_geo(path);
#endif
  if (path == "-") {
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    return parse_input(text, format_of(text), "standard input");
  }
  const std::filesystem::path file(path);
  std::error_code ignored;
  // A pipe, as a shell's <(...), has no extension that would tell.
  if (file.has_extension() || !std::filesystem::is_fifo(file, ignored)) return read_input(path);
  std::ifstream pipe(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(pipe), {}};
  return parse_input(text, format_of(text), path);
}

}  // namespace

CLI::Option* GeometryFile::add(CLI::App& command) {
  const char* group = "Input";
  command.add_option("--unit", unit_, "What the coordinates mean, for reports: nm, um, mm, cm, m")
      ->check(one_of({"nm", "um", "mm", "cm", "m"}))
      ->type_name("UNIT")
      ->group(group);
  command
      .add_option("--scale", scale_,
                  "Multiply all lengths by this power of 10 or 2 first, say 1e-9")
      ->type_name("F")
      ->group(group);
  return command
      .add_option(
          "input", path_,
          fmt::format("Geometry: Triangle's .poly, our .json, .geojson, gmsh's {}, VTK's .vtu, "
                      ".vtp, .vti, .vtk; '-' is standard input, known by how it begins",
                      kGmshFormats))
      ->type_name("");
}

Result<Input> GeometryFile::read() const {
  Result<Input> input = read_geometry(path_);
  if (!input) return input;
  if (!unit_.empty()) input->unit = unit_;
  if (scale_ != 1)
    if (Status status = scale_input(*input, scale_); !status) return std::move(status).error();
  return input;
}

}  // namespace cover::app
