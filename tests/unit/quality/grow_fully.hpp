// A cavity of all that can be taken in.
#pragma once

#include "quality/mutable/cavity.hpp"

namespace cover::testing {

/// Takes in all that can be reached.
inline void grow_fully(Cavity& cavity) {
  for (bool grown = true; grown;) {
    grown = false;
    for (int k = 0; k < cavity.size() && !grown; ++k) grown = cavity.grow(k);
  }
}

}  // namespace cover::testing
