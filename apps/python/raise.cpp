#include "raise.hpp"

#include <pybind11/pybind11.h>

namespace py = pybind11;

namespace cover::python {
namespace {

const char* type_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::cancelled:
      return "Cancelled";
    case ErrorCode::bad_option:
      return "OptionError";
    case ErrorCode::out_of_memory:
      return "OutOfMemory";
    case ErrorCode::requirement_not_met:
      return "RequirementNotMet";
    default:
      return "Error";
  }
}

}  // namespace

void raise(const Error& error) { raise(error, py::none()); }

void raise(const Error& error, const py::object& mesh) {
  const py::object type = py::module_::import("cover").attr(type_of(error.code));
  const py::object raised = type(error.message);
  raised.attr("code") = static_cast<int>(error.code);
  py::list where;
  for (const Point& p : error.where) where.append(py::make_tuple(p.x, p.y));
  raised.attr("where") = where;
  if (!mesh.is_none()) raised.attr("mesh") = mesh;
  PyErr_SetObject(type.ptr(), raised.ptr());
  throw py::error_already_set();
}

}  // namespace cover::python
