// Errors of the library as exceptions of Python.
#pragma once

#include <cover/error.hpp>

namespace cover::python {

/// Raises cover.Error, or one of its kinds (Cancelled, OptionError, OutOfMemory), with the members
/// code and where.
[[noreturn]] void raise(const Error& error);

}  // namespace cover::python
