// What program and module agree on. They are built together: the name bears the version, so that a
// module of another one is not taken.
#pragma once

#include <string>

#include <cover/picture.hpp>
#include <cover/result.hpp>

namespace cover::app {

inline constexpr const char* kPngModule = COVER_PNG_MODULE;
inline constexpr const char* kDrawPng = "cover_draw_png";

using DrawPng = void(const PictureMesh& mesh, const PictureOptions& options,
                     const std::string& path, Status& drawn);

}  // namespace cover::app
