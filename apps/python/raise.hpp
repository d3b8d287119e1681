// Errors of the library as exceptions of Python.
#pragma once

#include <string>

#include <pybind11/pybind11.h>

#include <cover/error.hpp>

namespace cover::python {

/// Words for people: bytes that are no UTF-8, as in the names of some files, stand there as \xfc.
pybind11::str words(const std::string& text);

// Names as Python has those of files, see os.fsdecode(): what is no UTF-8 comes back the same.
pybind11::str name_of(const std::string& bytes);
std::string bytes_of(const pybind11::handle& name);

/// Raises `type` with `message`, because of what is raised just now; that itself where it is no
/// fault of the value: no memory, no numpy, Ctrl-C.
///
/// REQUIRES: called in the handler of `raised`
[[noreturn]] void raise_because(pybind11::error_already_set& raised, PyObject* type,
                                const std::string& message);

/// Raises cover.Error, or one of its kinds (Cancelled, OptionError, OutOfMemory,
/// RequirementNotMet), with the members code, where and inputs.
[[noreturn]] void raise(const Error& error);
/// The same with the mesh that there is nevertheless, as the member `mesh`.
[[noreturn]] void raise(const Error& error, const pybind11::object& mesh);

}  // namespace cover::python
