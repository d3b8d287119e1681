// cover render: a picture of a mesh.
#include "commands.hpp"

#include <fmt/format.h>

#include "exit_code.hpp"

namespace cover::app {

int run_render(Arguments) {
  fmt::print(stderr, "cover: error: render is not part of this version\n");
  return exit_usage;
}

}  // namespace cover::app
