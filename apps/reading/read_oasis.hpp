// Layouts in OASIS, by way of KLayout.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>

namespace cover::reading {

/// Whether files with this extension, in lower case, are OASIS.
bool is_oasis(std::string_view extension);

/// Has KLayout make GDSII of a layout, in a folder for temporary files, and reads that: by strm2gds
/// of the PATH or of Debian's package, else by klayout, which takes two seconds to start. Debian
/// has no library that reads OASIS.
///
/// Errors: unsupported_format where neither is installed; syntax where KLayout refuses the file;
///         cannot_open, cannot_write; cancelled where a signal ends KLayout, or `stop` asks for its
///         end; those of read_input() for layouts
Result<Input> read_oasis(const std::string& path, const ReadOptions& options,
                         const std::stop_token& stop);

}  // namespace cover::reading
