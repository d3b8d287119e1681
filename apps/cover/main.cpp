// The program: finds the subcommand and runs it.
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <cover/text.hpp>
#include <cover/version.hpp>

#include "commands/commands.hpp"
#include "commands/exit_code.hpp"
#include "commands/guarded.hpp"
#include "terminal/console.hpp"

namespace {

using cover::app::Arguments;

struct Command {
  std::string_view name;
  int (*run)(Arguments);
};

int mesh_here(Arguments arguments) { return cover::app::run_mesh(std::move(arguments)); }

constexpr std::array kCommands{
    Command{"mesh", mesh_here},
    Command{"info", cover::app::run_info},
    Command{"check", cover::app::run_check},
    Command{"render", cover::app::run_render},
    Command{"convert", cover::app::run_convert},
};

constexpr const char* kHelp =
    R"(cover: triangle meshes over many materials, every interface segment kept whole, and a
proven bound on the largest angle of each region.

Usage: cover COMMAND [OPTIONS] ...

Commands:
  mesh    triangulate a geometry file             cover mesh device.poly -o device.vtu
  info    regions, interfaces, bounds on angles   cover info device.poly
  check   does a mesh keep every promise?         cover check device.poly device.vtm
  render  picture of a mesh                       cover render device.vtm -o device.svg
  convert another format for a mesh               cover convert device.vtm -o device.msh

  cover COMMAND --help   options of a command
  cover --version        version and licence
)";

int usage_error(const std::string& message) {
  cover::app::print_on_stderr(
      fmt::format("cover: error: {}\nSee 'cover --help'.\n", cover::printable(message)));
  return cover::app::exit_usage;
}

int run(const std::string& name, Arguments arguments) {
  if (name == "help" && !arguments.empty()) return run(arguments.front(), {"--help"});
  if (name == "-h" || name == "--help" || name == "help") {
    std::fputs(kHelp, stdout);
    return cover::app::exit_ok;
  }
  if (name == "--version") {
    fmt::print("cover {}\nLicence: GPL-3.0-or-later\n", COVER_VERSION);
    return cover::app::exit_ok;
  }
  std::vector<std::string> names;
  for (const Command& command : kCommands) {
    if (command.name == name) return command.run(std::move(arguments));
    names.emplace_back(command.name);
  }
  return usage_error(fmt::format("unknown command '{}'{}", name, cover::did_you_mean(name, names)));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) {
    std::fputs(kHelp, stderr);
    return cover::app::exit_usage;
  }
  return cover::app::guarded("cover", [&] {
    return run(words.front(), {words.begin() + 1, words.end()});
  });
}
