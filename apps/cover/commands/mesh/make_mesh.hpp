// How `cover mesh` makes its mesh: in memory or on the disk, all of it or some regions again.
#pragma once

#include <string>
#include <vector>

#include <spdlog/logger.h>

#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>
#include <cover/stream_mesh.hpp>

#include "files/output_files.hpp"

namespace cover::app {

/// What the command line says of it, apart from the library's options.
struct MeshPlan {
  std::vector<std::string> only;  ///< regions to mesh again
  std::string onto;               ///< the mesh in which they are replaced; empty: all is meshed
  std::string stream = "auto";    ///< whether the mesh stays on the disk: auto, on, off
};

/// What needs the whole mesh in memory, a part of a sentence; empty if nothing does.
std::string what_needs_all_in_memory(const MeshPlan& plan, const OutputFiles& files,
                                     const Input& input, const Options& options);

/// Whether a mesh of about so many triangles stays on the disk until it is written to `files`.
bool stays_on_disk(const MeshPlan& plan, const OutputFiles& files, const Input& input,
                   const Options& options, double triangles);

/// Makes the mesh that is to be written to `files`. The log tells why it cannot stay on the disk.
///
/// Errors: those of cover_mesh(), stream_mesh(), remesh() and read_triangles(); bad_option where it
///         is to stay on the disk and cannot
Result<StreamedOutput> make_mesh(const MeshPlan& plan, const OutputFiles& files, Input input,
                                 const Options& options, const Callbacks& callbacks,
                                 spdlog::logger& log);

}  // namespace cover::app
