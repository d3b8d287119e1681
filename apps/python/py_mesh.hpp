// What the class Mesh of Python holds.
#pragma once

#include <string>

#include <cover/output.hpp>
#include <cover/verify.hpp>

namespace cover::python {

/// A mesh with everything that is known of it.
struct PyMesh {
  Output output;
  TriangleSoup soup;
  std::string report;  ///< of a mesh that was pickled, as JSON; else empty
};

}  // namespace cover::python
