// Which writer belongs to which extension, and `-` for stdout.
#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include <cover/output.hpp>
#include <cover/result.hpp>
#include <cover/write_mesh.hpp>

namespace cover::app {

/// Writes one kind of file; a requested stop ends that with `cancelled`.
using Writer =
    std::function<Status(const Output&, const std::string& path, const std::stop_token& stop)>;

/// The writer for what `path` ends in.
/// Errors: unsupported_format, naming what is possible, and as can_draw_png(); bad_option where the
///         format cannot do what `options` ask for.
Result<Writer> mesh_writer(const std::string& path, const WriteOptions& options);

/// The same for standard output, in the format of the extension `format`, which has no dot.
/// Errors: also bad_option for formats of several files.
Result<Writer> stdout_writer(const std::string& format, const WriteOptions& options);

/// The writer of a --report file, for a mesh of first or second order.
/// Errors: unsupported_format
Result<Writer> report_writer(const std::string& path, int order = 1);

/// The extensions that mesh_writer knows, for help texts.
std::string mesh_extensions();

/// The extension that tells the format of an output, with its dot; `format`: of standard output,
/// without.
std::string extension_of_output(const std::string& path, const std::string& format);

/// Writes to `path`; `-` is stdout, where `extension`, with its dot, tells the format.
Status write_to(const std::string& path, const std::string& extension,
                const std::function<Status(const std::string&)>& write);
Status write_to(const Writer& writer, const Output& output, const std::string& path,
                const std::string& extension, const std::stop_token& stop = {});

}  // namespace cover::app
