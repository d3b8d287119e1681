// A mesh as numbers, texts and arrays, for Python's pickle.
#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include <cover/output.hpp>
#include <cover/verify.hpp>

namespace cover::python {

/// What the state of a mesh begins with; other versions are refused.
inline constexpr int kPickleVersion = 5;

/// A mesh, its report as JSON, and remarks on how it was saved.
struct Unpickled {
  Output output;
  std::string report;
  std::vector<std::string> remarks;
};

/// Everything that saving, drawing and asking a mesh needs. `report`: its report as JSON; of the
/// report in Output, what a manifest tells is there, too.
pybind11::tuple pickled(const Output& output, const TriangleSoup& soup, const std::string& report,
                        const std::vector<std::string>& remarks);

/// The same again. Raises cover.Error or ValueError for what is no such state.
Unpickled unpickled(const pybind11::tuple& state);

}  // namespace cover::python
