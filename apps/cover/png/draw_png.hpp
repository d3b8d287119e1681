// Pictures as .png, by VTK. It stands in a module that is opened when a picture is wanted: with VTK
// come forty libraries, which take longer to load than most meshes take to be made.
#pragma once

#include <string>

#include <cover/picture.hpp>
#include <cover/result.hpp>

namespace cover::app {

/// Whether draw_png() has what it needs, for who wants to know before a long run.
///
/// Errors: unsupported_format, where the module is not there
Status can_draw_png();

/// write_png() of the library.
///
/// Errors: as write_png(), can_draw_png()
Status draw_png(const PictureMesh& mesh, const PictureOptions& options, const std::string& path);

}  // namespace cover::app
