#include "png/draw_png.hpp"

#include <dlfcn.h>

#include <fmt/core.h>

#include "png/png_module.hpp"

namespace cover::app {
namespace {

struct Module {
  DrawPng* draw = nullptr;
  std::string failure;  ///< empty: open
};

/// It stays open: VTK keeps what it has made to the end of the program.
Module open_module() {
  Module out;
  // Where the program's RUNPATH says.
  void* const library = dlopen(kPngModule, RTLD_NOW | RTLD_LOCAL);
  if (library != nullptr) out.draw = reinterpret_cast<DrawPng*>(dlsym(library, kDrawPng));
  if (out.draw == nullptr) out.failure = dlerror();
  return out;
}

const Module& module() {
  static const Module opened = open_module();
  return opened;
}

}  // namespace

Status can_draw_png() {
  if (module().draw != nullptr) return ok();
  return Error{
      ErrorCode::unsupported_format,
      fmt::format("pictures in .png are drawn by {}, which is installed with the program and "
                  "cannot be opened ({}); .svg needs no module",
                  kPngModule, module().failure),
      {},
      {}};
}

Status draw_png(const PictureMesh& mesh, const PictureOptions& options, const std::string& path) {
  if (Status there = can_draw_png(); !there) return there;
  Status drawn = ok();
  module().draw(mesh, options, path, drawn);
  return drawn;
}

}  // namespace cover::app
