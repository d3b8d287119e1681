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

const char* kind_of(InputKind kind) {
  switch (kind) {
    case InputKind::point:
      return "point";
    case InputKind::segment:
      return "segment";
    case InputKind::polygon:
      return "polygon";
    case InputKind::hole:
      return "hole";
    case InputKind::region_seed:
      return "region";
    case InputKind::line:
      return "line";
  }
  return "";
}

py::str decoded(const std::string& bytes, const char* errors) {
  auto text = py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), errors));
  if (!text) throw py::error_already_set();
  return text;
}

}  // namespace

py::str words(const std::string& text) { return decoded(text, "backslashreplace"); }

py::str name_of(const std::string& bytes) { return decoded(bytes, "surrogateescape"); }

std::string bytes_of(const py::handle& name) {
  const auto bytes = py::reinterpret_steal<py::bytes>(
      PyUnicode_AsEncodedString(name.ptr(), "utf-8", "surrogateescape"));
  if (!bytes) throw py::error_already_set();
  return bytes;
}

void raise_because(py::error_already_set& raised, PyObject* type, const std::string& message) {
  // Where numpy is not there, the value may be right.
  if (!raised.matches(PyExc_Exception) || raised.matches(PyExc_MemoryError) ||
      raised.matches(PyExc_ImportError))
    throw;
  py::raise_from(raised, type, message.c_str());
  throw py::error_already_set();
}

void raise(const Error& error) { raise(error, py::none()); }

void raise(const Error& error, const py::object& mesh) {
  const py::object type = py::module_::import("cover").attr(type_of(error.code));
  const py::object raised = type(words(error.message));
  raised.attr("code") = static_cast<int>(error.code);
  py::list where;
  for (const Point& p : error.where) where.append(py::make_tuple(p.x, p.y));
  raised.attr("where") = where;
  py::list inputs;
  for (const InputRef& input : error.inputs)
    inputs.append(py::make_tuple(kind_of(input.kind), input.id));
  raised.attr("inputs") = inputs;
  if (!mesh.is_none()) raised.attr("mesh") = mesh;
  PyErr_SetObject(type.ptr(), raised.ptr());
  throw py::error_already_set();
}

}  // namespace cover::python
