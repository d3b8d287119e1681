// Tested by tests/unit/io/report/write_report_json_test.cpp.
#include <cover/report.hpp>

#include <algorithm>
#include <numbers>

namespace cover {

double RegionReport::rho() const {
  return quality.largest_nu.in_radians() / std::min(nu_opt.in_radians(), std::numbers::pi / 2);
}

}  // namespace cover
