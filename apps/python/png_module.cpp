// Pictures as .png, apart: they are all that needs VTK, and who has another VTK loaded, as
// ParaView, must not get this one.
#include <pybind11/pybind11.h>

#include <cover/mesh.hpp>
#include <cover/picture.hpp>

#include "py_mesh.hpp"
#include "run.hpp"

PYBIND11_MODULE(_png, module) {
  cover::python::stop_runs_at_exit();
  module.def("write_png", [](const cover::python::PyMesh& mesh, const std::string& path, int order,
                             const std::string& title, int width, const std::string& color) {
    cover::python::Callables callables;
    cover::PictureOptions options;
    options.title = title;
    options.width = width;
    options.color = color;
    options.stop = callables.token();
    cover::python::run(callables, [&] {
      return cover::write_png(cover::picture_of(mesh.output, order), options, path);
    });
  });
}
