// The subcommands of the program. Each one parses its own arguments, calls the library, prints.
#pragma once

#include <string>
#include <vector>

#include <cover/read_elsewhere.hpp>
#include <cover/share_out.hpp>

namespace cover::app {

/// What follows the name of the subcommand.
using Arguments = std::vector<std::string>;

/// Processes that take a part in the work; none by default.
struct OtherProcesses {
  ShareOut share_out;
  WriteElsewhere write_elsewhere;
  ReadElsewhere read_elsewhere;
};

/// `cover mesh`: triangulates a geometry file.
int run_mesh(Arguments arguments, const OtherProcesses& others = {});
/// `cover info`: regions, interfaces and what can be reached; no mesh.
int run_info(Arguments arguments);
/// `cover check`: the promises, on any mesh.
int run_check(Arguments arguments);
/// `cover render`: a picture of a mesh.
int run_render(Arguments arguments);
/// `cover convert`: a mesh that cover wrote, in another format.
int run_convert(Arguments arguments);

}  // namespace cover::app
