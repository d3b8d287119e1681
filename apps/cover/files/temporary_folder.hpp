// A folder for files that only pass through, where the system keeps such.
#pragma once

#include <string_view>

#include <cover/files.hpp>
#include <cover/result.hpp>

namespace cover::app {

/// A folder in $TMPDIR, or in /tmp; `name` begins with "cover-", by which an interrupt finds it.
///
/// Errors: cannot_write, also where $TMPDIR is no folder.
Result<ScratchFolder> temporary_folder(std::string_view name);

}  // namespace cover::app
