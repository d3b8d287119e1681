// What the run that made a mesh says about how to check it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <cover/read_origin.hpp>

#include "words/check_text.hpp"

namespace cover::app {

/// Whether an option stands on the command line.
bool has_option(const CLI::App& app, const std::string& name);

/// The options of the run that made the mesh which say how the input is understood, but those that
/// stand on this command line too; as words of a shell.
std::vector<std::string> options_to_repeat(const CLI::App& app, const MeshOrigin& origin);

/// `usual`, the targets of the command line and the defaults, with those of the run that made the
/// mesh where the command line has none.
AngleTargets targets_with_run(const CLI::App& app, const MeshOrigin& origin,
                              const AngleTargets& usual);

}  // namespace cover::app
