// The options that say what some formats leave open, shared by all commands that write meshes.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include <cover/write_mesh.hpp>

namespace cover::app {

/// --order, --msh, --xdmf, --parts, --no-inner-lines, --lines, --ids, --inp-element. Their values
/// are checked, with the file they are meant for, by can_write().
class FormatOptions {
 public:
  void add(CLI::App& command, const std::string& group);
  [[nodiscard]] WriteOptions make() const;

 private:
  WriteOptions options_;
  bool no_inner_lines_ = false;
};

}  // namespace cover::app
