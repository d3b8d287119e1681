// What the class Mesh of Python holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <cover/output.hpp>
#include <cover/verify.hpp>

namespace cover::python {

/// A mesh with everything that is known of it.
struct PyMesh {
  Output output;
  TriangleSoup soup;
  std::string report;  ///< of a mesh that was pickled, as JSON; else empty
  /// What it promises for Output::pslg and table; none where these were made of the mesh itself.
  std::optional<VerifyOptions> promises;
  std::vector<std::string> remarks;  ///< on how it was saved, for its notes
};

}  // namespace cover::python
