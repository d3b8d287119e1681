// Which reader a file wants is told by its extension. Tested by tests/unit/io/read_poly_test.cpp.
#include <cover/read_input.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace cover {

Result<Input> read_input(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".poly") return read_poly(path);
  return Error{ErrorCode::unsupported_format,
               fmt::format("{}: no reader for files named '*{}'; known: .poly", path, extension),
               {},
               {}};
}

}  // namespace cover
