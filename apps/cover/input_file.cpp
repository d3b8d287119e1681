#include "input_file.hpp"

#include <cover/read_input.hpp>

namespace cover::app {

Result<Input> read_geometry(const std::string& path) {
  return path == "-" ? read_poly("/dev/stdin") : read_input(path);
}

}  // namespace cover::app
