// Errors of the library as exceptions of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <cover/error.hpp>

namespace cover::python {

/// Raises cover.Error, or one of its kinds (Cancelled, OptionError, OutOfMemory,
/// RequirementNotMet), with the members code and where.
[[noreturn]] void raise(const Error& error);
/// The same with the mesh that there is nevertheless, as the member `mesh`.
[[noreturn]] void raise(const Error& error, const pybind11::object& mesh);

}  // namespace cover::python
