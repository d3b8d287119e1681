// What every program of cover does around its commands.
#pragma once

#include <functional>
#include <string_view>

namespace cover::app {

/// Runs `command` and returns its exit code; what it throws is told on stderr, after the name of
/// the program.
int guarded(std::string_view program, const std::function<int()>& command);

}  // namespace cover::app
