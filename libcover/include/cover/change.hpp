// What a reader or cleaning did to the geometry of a user.
#pragma once

#include <string>
#include <vector>

#include <cover/error.hpp>
#include <cover/point.hpp>

namespace cover {

/// Something that was done to the input to make a clean PSLG of it.
struct Change {
  enum class Kind {
    split,    ///< a segment was cut, where another one crosses or touches it
    welded,   ///< a point or a segment was moved onto another one
    dropped,  ///< an element that adds nothing was left out
    merged,   ///< two elements became one
  };
  Kind kind = Kind::split;
  std::string message;  ///< a sentence with coordinates and ids
  std::vector<Point> where;
  std::vector<InputRef> inputs;  ///< the elements concerned
};

}  // namespace cover
