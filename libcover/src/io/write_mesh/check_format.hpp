// What write_mesh() asks before it writes, for the writers of single formats too.
#pragma once

#include <string>
#include <string_view>

#include <cover/output.hpp>
#include <cover/result.hpp>
#include <cover/write_options.hpp>

namespace cover {

/// Whether there is a mesh, and the format of `extension`, which need not be that of `path`, has
/// what is asked for.
///
/// REQUIRES: write_formats() has it
/// Errors:   bad_option; those of check_mesh()
Status check_format(std::string_view extension, const Output& output, const std::string& path,
                    const WriteOptions& options);

/// Whether `output` has triangles: where it has none, a file would be as good as one of a mesh.
///
/// Errors: cannot_write
Status check_mesh(const Output& output, const std::string& path);

}  // namespace cover
