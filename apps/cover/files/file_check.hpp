// What a command reads and writes, looked at together before it does anything.
#pragma once

#include <string>
#include <vector>

#include <cover/result.hpp>

namespace cover::app {

/// A file that the command line names.
struct NamedFile {
  std::string option;    ///< what names it: "-o"; empty: an argument without a name
  std::string path;      ///< `-` is standard input or output; empty: no file
  bool is_mesh = false;  ///< a mesh may be written over that of --onto, which it was made from
};

/// Makes sure that no file that is written takes the place of one that is read or written too,
/// companions (.node beside .ele and .poly, the pieces of a .vtm) included, and that the folders of
/// those that are written are there and can be written to. Devices and pipes are not looked at.
///
/// Errors: bad_option; cannot_write, with the reason that the system gives
Status check_files(const std::vector<NamedFile>& read, const std::vector<NamedFile>& written);

}  // namespace cover::app
