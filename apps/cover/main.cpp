// The program: finds the subcommand and runs it.
#include <array>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <fmt/core.h>
#include <spdlog/common.h>

#include <cover/version.hpp>

#include "base/suggest.hpp"
#include "commands.hpp"
#include "exit_code.hpp"

namespace {

using cover::app::Arguments;

struct Command {
  std::string_view name;
  int (*run)(Arguments);
};

constexpr std::array kCommands{
    Command{"mesh", cover::app::run_mesh},       Command{"info", cover::app::run_info},
    Command{"check", cover::app::run_check},     Command{"render", cover::app::run_render},
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
  fmt::print(stderr, "cover: error: {}\nSee 'cover --help'.\n", message);
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
  const auto meant = cover::closest(name, names);
  return usage_error(fmt::format("unknown command '{}'{}", name,
                                 meant ? fmt::format("; did you mean '{}'?", *meant) : ""));
}

/// Keeps large arrays apart from small ones, so that each goes back to the system when it is freed.
/// glibc does so too until the first of them is freed; then it puts ever larger ones among the
/// small ones, where what is freed stays. A fifth of the memory, and no time that could be
/// measured.
void give_back_large_arrays() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 512 * 1024);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  give_back_large_arrays();
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) {
    std::fputs(kHelp, stderr);
    return cover::app::exit_usage;
  }
  try {
    return run(words.front(), {words.begin() + 1, words.end()});
  } catch (const spdlog::spdlog_ex& error) {  // the file of --log
    fmt::print(stderr, "cover: error: {}\n", error.what());
    return cover::app::exit_files;
  } catch (const std::bad_alloc&) {  // fmt would need more
    std::fputs("cover: error: out of memory\n", stderr);
    return cover::app::exit_memory;
  } catch (const std::system_error& error) {  // no thread, for which there must be a stack
    fmt::print(stderr, "cover: error: the system has no more threads or memory: {}\n",
               error.what());
    return cover::app::exit_memory;
  } catch (const std::exception& error) {
    fmt::print(stderr, "cover: error: {}; this is an error in cover, please report it\n",
               error.what());
  }
  return cover::app::exit_internal;
}
