// Meshes too large for memory: made region by region into a file that nobody sees, and written
// from there.
#pragma once

#include <memory>
#include <string>

#include <cover/input.hpp>
#include <cover/mesh_counts.hpp>
#include <cover/mesh_view.hpp>
#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>
#include <cover/write_mesh.hpp>

namespace cover {

/// When a mesh is to stay on the disk.
struct StreamOptions {
  std::string beside;         ///< a file on the disk where there is room, as the one to be written
  double most_in_memory = 0;  ///< expected triangles from which on it does
  /// Whether meshes may stay in the processes of Callbacks::share_out, if all of them see the
  /// folder of `beside`. They must be there then when files are written, and of these
  /// can_write_from_elsewhere() must be true.
  bool may_stay = false;
};

/// A mesh on the disk.
struct SpooledParts;

/// What stream_mesh() returns. Copies share the file, which goes with the last of them.
struct StreamedOutput {
  Output output;                              ///< its mesh is empty where there are parts
  MeshCounts counts;                          ///< of the mesh, wherever it is
  std::shared_ptr<const SpooledParts> parts;  ///< empty: the mesh is in memory

  [[nodiscard]] bool is_streamed() const { return parts != nullptr; }
};

/// Why a run needs the whole mesh in memory: a part of a sentence. Empty: it does not.
std::string needs_whole_mesh(const Input& input, const Options& options);
/// The same of a file that is to be written.
std::string needs_whole_mesh(const std::string& path, const WriteOptions& options);

/// Whether a file can be written whose regions are in several processes: only .vtkhdf, and no
/// device.
bool can_write_from_elsewhere(const std::string& path, const WriteOptions& options);

/// Makes the mesh that cover_mesh() makes. Where it is expected to be large, each region goes to
/// the disk when it is done, and what it was made of is given back.
///
/// Errors:   those of cover_mesh(); bad_option unless needs_whole_mesh(input, options) is empty;
///           cannot_write, in the name of StreamOptions::beside, also where its disk has no room
///           for what is expected
/// Memory:   input and tables; 16 bytes and a RegionReport for each region, 32 for each segment;
///           the regions in work
Result<StreamedOutput> stream_mesh(Input&& input, const Options& options,
                                   const StreamOptions& stream, const Callbacks& callbacks = {});

/// Writes the file that write_mesh() writes of the same mesh in memory, byte for byte.
///
/// Errors: those of can_write(); bad_option unless output.is_streamed() and
///         needs_whole_mesh(path, options) is empty, and where regions are elsewhere and cannot be
///         written from there; cannot_write, also where the disk has no room for the file;
///         cancelled
Status write_streamed_mesh(const StreamedOutput& output, const std::string& path,
                           const WriteOptions& options = {});

/// Groups and lines of a mesh on the disk, as a view of it in memory would have them; no points and
/// no triangles.
///
/// REQUIRES: output.is_streamed()
MeshView view_of_lines(const StreamedOutput& output, const WriteOptions& options);

/// The report, as of an Output.
std::string report_json(const StreamedOutput& output);
Status write_report_json(const StreamedOutput& output, const std::string& path);

}  // namespace cover
