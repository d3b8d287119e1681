#include "input_file.hpp"

#include <iostream>
#include <iterator>
#include <string_view>

#include <cover/read_input.hpp>

namespace cover::app {
namespace {

std::string_view format_of(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const char first = start == std::string_view::npos ? ' ' : text[start];
  if (first == '$') return ".msh";
  if (first != '{') return ".poly";
  return text.find("\"Feature") != std::string_view::npos ? ".geojson" : ".json";
}

}  // namespace

Result<Input> read_geometry(const std::string& path) {
  if (path != "-") return read_input(path);
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  return parse_input(text, format_of(text), "standard input");
}

}  // namespace cover::app
