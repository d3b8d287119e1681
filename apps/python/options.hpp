// Keyword arguments as Options.
#pragma once

#include <pybind11/pybind11.h>

#include <cover/options.hpp>
#include <cover/write_mesh.hpp>

namespace cover::python {

/// Raises: TypeError for a keyword that is none, ValueError for a value that is not allowed.
Options options_from(const pybind11::dict& keywords);

/// What a file should hold. Raises: as options_from
WriteOptions write_options_from(const pybind11::dict& keywords);

}  // namespace cover::python
