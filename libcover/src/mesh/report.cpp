// Tested by tests/unit/io/report/write_report_json_test.cpp.
#include <cover/report.hpp>

#include <algorithm>
#include <numbers>

namespace cover {

BoxMethod& BoxMethod::operator+=(const BoxMethod& other) {
  obtuse_sides += other.obtuse_sides;
  non_delaunay_edges += other.non_delaunay_edges;
  negative_couplings += other.negative_couplings;
  negative_inside += other.negative_inside;
  negative_encroached += other.negative_encroached;
  negative_forced += other.negative_forced;
  negative_given_up += other.negative_given_up;
  box_area += other.box_area;
  return *this;
}

double RegionReport::rho() const {
  return quality.largest_nu.in_radians() / std::min(nu_opt.in_radians(), std::numbers::pi / 2);
}

}  // namespace cover
