// The options that say what some formats leave open, shared by all commands that write meshes.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <cover/write_option_table.hpp>

#include "commands/options.hpp"

namespace cover::app {

/// Those of write_option_table(). Whether a file has what they ask for is told by can_write().
class FormatOptions {
 public:
  void add(CLI::App& command, const char* group);
  [[nodiscard]] WriteOptions make() const;
  /// A sentence for each option that was given and that no file of `outputs` asks for; `format`: of
  /// standard output, without its dot.
  [[nodiscard]] std::vector<std::string> ignored(const std::vector<std::string>& outputs,
                                                 const std::string& format) const;

 private:
  std::deque<WrittenOption<WriteOptions>> written_;  ///< which CLI11 points into
};

}  // namespace cover::app
