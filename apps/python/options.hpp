// Keyword arguments as Options.
#pragma once

#include <pybind11/pybind11.h>

#include <cover/options.hpp>

namespace cover::python {

/// Raises: TypeError for a keyword that is none, ValueError for a value that is not allowed.
Options options_from(const pybind11::dict& keywords);

}  // namespace cover::python
