// What write_mesh() asks before it writes, for the writers of single formats too.
#pragma once

#include <string>
#include <string_view>

#include <cover/result.hpp>
#include <cover/write_options.hpp>

namespace cover {

/// Whether the format of `extension`, which need not be that of `path`, has what is asked for.
///
/// REQUIRES: write_formats() has it
/// Errors:   bad_option
Status check_format(std::string_view extension, const std::string& path,
                    const WriteOptions& options);

}  // namespace cover
