// A mesh as numbers, texts and arrays, for Python's pickle.
#pragma once

#include <pybind11/pybind11.h>

#include <cover/output.hpp>
#include <cover/verify.hpp>

namespace cover::python {

/// What the state of a mesh begins with; other versions are refused.
inline constexpr int kPickleVersion = 3;

/// Everything that saving, drawing and asking a mesh needs, but for what a manifest tells of the
/// quality of each region. `report`: its report as JSON, which has that, too.
pybind11::tuple pickled(const Output& output, const TriangleSoup& soup, const std::string& report);

/// A mesh and its report again. Raises cover.Error or ValueError for what is no such state.
std::pair<Output, std::string> unpickled(const pybind11::tuple& state);

}  // namespace cover::python
