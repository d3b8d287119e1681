// Meshing some regions again inside an existing mesh.
#pragma once

#include <span>
#include <string>

#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>
#include <cover/triangle_soup.hpp>

namespace cover {

/// Triangulates the regions of `input` called `only` again, with `options`, inside `onto`, a mesh
/// of the same input: since no vertex is put on a segment, nothing outside of them notices.
///
/// A name is that of a region or of a material, the number of a material, or "region:" and a
/// RegionId. Where segments of `onto` were cut (Options::split_interfaces, Method::nonobtuse),
/// their pieces are the segments now; nothing is cut again, and a note says so if it was asked for.
/// Materials, markers and names are those of `input`.
/// ENSURES: (1) triangles of all other regions have the same corners, bit for bit and in the same
///              order, and stand in the same order; so do vertices, less Steiner vertices of the
///              regions meshed again, whose new ones take their place;
///          (2) the regions meshed again are what cover_mesh() makes of them with these options:
///              with those of `onto`, the result is `onto`;
///          (3) Report::replaced says what was there before; the method of all other regions is
///              "kept", and their figures are measured.
/// Errors:  those of cover_mesh(); other_mesh, with places, where `onto` is no mesh of `input`;
///          bad_option for a name that nothing has, and for Method::nonobtuse, which cuts segments.
/// Threads: as cover_mesh().
/// Cost:    O(n log n), and what meshing the named regions costs.
Result<Output> remesh(const Input& input, const TriangleSoup& onto,
                      std::span<const std::string> only, const Options& options = {},
                      const Callbacks& callbacks = {});

/// What `before`, which was meshed again, has from the input of its run and `output` does not have
/// from this one's: attributes of regions stay; values at points have none in new vertices, which a
/// note tells, with `name` for that mesh.
///
/// REQUIRES: `output` is remesh() of it
void keep_attributes(const Output& before, const std::string& name, Output& output);

}  // namespace cover
