// Almonds by themselves.
#pragma once

#include "almond/almond.hpp"

namespace cover::testing {

inline Almond almond_of(Point from, Point to, double nu) {
  Almond a;
  a.u = 0, a.v = 1;
  a.from = from, a.to = to;
  a.length = length(a.chord());
  a.set_nu(nu);
  return a;
}

}  // namespace cover::testing
