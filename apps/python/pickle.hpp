// A mesh as numbers, texts and arrays, for Python's pickle.
#pragma once

#include <pybind11/pybind11.h>

#include <cover/output.hpp>
#include <cover/verify.hpp>

namespace cover::python {

/// What the state of a mesh begins with; other versions are refused.
inline constexpr int kPickleVersion = 2;

/// Everything that saving, drawing and asking a mesh needs. `report`: its report as JSON.
pybind11::tuple pickled(const Output& output, const TriangleSoup& soup, const std::string& report);

/// A mesh and its report again. Raises cover.Error or ValueError for what is no such state.
std::pair<Output, std::string> unpickled(const pybind11::tuple& state);

}  // namespace cover::python
