#include "png/png_module.hpp"

#include <type_traits>

extern "C" void cover_draw_png(const cover::PictureMesh& mesh, const cover::PictureOptions& options,
                               const std::string& path, cover::Status& drawn);

static_assert(std::is_same_v<decltype(cover_draw_png), cover::app::DrawPng>);

void cover_draw_png(const cover::PictureMesh& mesh, const cover::PictureOptions& options,
                    const std::string& path, cover::Status& drawn) {
  drawn = cover::write_png(mesh, options, path);
}
