// The class Mesh of Python.
#pragma once

#include <string>

#include <pybind11/pybind11.h>

namespace cover::python {

/// Adds the class to the module.
void define_mesh(pybind11::module_& module);

/// A path that the system would take as far as its first zero is another one.
/// Raises: ValueError
void check_path(const std::string& path);

}  // namespace cover::python
