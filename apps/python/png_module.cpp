// Pictures as .png, apart: they are all that needs VTK, and who has another VTK loaded, as
// ParaView, must not get this one.
#include <pybind11/pybind11.h>

#include <cover/mesh.hpp>
#include <cover/picture.hpp>

#include "py_mesh.hpp"
#include "raise.hpp"

PYBIND11_MODULE(_png, module) {
  module.def("write_png",
             [](const cover::python::PyMesh& mesh, const std::string& path, int order) {
               const cover::Status status = [&] {
                 const pybind11::gil_scoped_release release;
                 return cover::write_png(cover::picture_of(mesh.output, order), {}, path);
               }();
               if (!status) cover::python::raise(status.error());
             });
}
