// Pictures of a mesh, without a display: SVG, and PNG through VTK's image writer (cover::vtk).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <cover/output.hpp>
#include <cover/point.hpp>
#include <cover/read_mesh.hpp>
#include <cover/result.hpp>
#include <cover/window.hpp>

namespace cover {

/// A named line of a picture: an interface, an outline or a contact.
struct PictureLine {
  std::string name;
  bool contact = false;  ///< drawn in colour and labelled
  std::vector<std::array<std::uint32_t, 2>> edges;
};

/// What is drawn.
struct PictureMesh {
  MeshFile mesh;  ///< with middle nodes, edges are drawn as they curve
  std::map<std::int64_t, std::string> region_names;    ///< by RegionId; missing: "region 7"
  std::map<std::int64_t, std::string> material_names;  ///< by material; missing: "material 3"
  std::vector<PictureLine> lines;                      ///< empty: found from the regions
  std::string unit;                                    ///< of the coordinates; empty: not said
  std::vector<std::vector<std::uint32_t>> periodic{};  ///< by rule: vertices with partners, marked
  RegionValues region_values{};  ///< of arrays at points, as Output::region_values
};

/// How it is drawn.
struct PictureOptions {
  int width = 1200;   ///< pixels, >= 200, from 400 on with a key; the height follows from the shape
  std::string title;  ///< first line, empty: none
  /// Shown by colour: an array, or an expression of arrays as Options::size_of has them; empty: the
  /// regions.
  std::string color;
  std::optional<std::array<double, 2>> range;  ///< values at both ends of the colours; none: found
  std::optional<Window> window;                ///< part of the mesh shown; none: all of it
  int worst = 3;                               ///< so many of the largest angles are marked
  std::string id = "plot";                     ///< a name in XML; the SVGs of one page differ in it
  bool edges = true;                           ///< draw all edges, thin
  bool y_down = false;                         ///< y grows downwards, as in devices of TCAD
  std::stop_token stop = {};                   ///< ends the writing of a file with `cancelled`
};

/// The mesh of a run, with its names; of second order with the middle nodes that files have.
PictureMesh picture_of(const Output& output, int order = 1);

/// Draws as SVG.
///
/// Errors: bad_option (unknown array, empty window, an id that is no name in XML); id_out_of_range
///         for triangles, lines and vertices without their points, and for arrays that are not as
///         long as the triangles or points; non_finite_coordinate for points and middle nodes;
///         cannot_write, cancelled
Status write_svg(const PictureMesh& mesh, const PictureOptions& options, const std::string& path);

/// The SVG document as text, to be put into a page.
/// Errors: as write_svg
Result<std::string> svg_text(const PictureMesh& mesh, const PictureOptions& options);

/// Draws as PNG (target cover::vtk).
/// Errors: as write_svg, but for the id
Status write_png(const PictureMesh& mesh, const PictureOptions& options, const std::string& path);

}  // namespace cover
