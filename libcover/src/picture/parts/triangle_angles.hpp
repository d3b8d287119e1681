// Angles of the triangles of a soup, in degrees, as files of a mesh have them.
#pragma once

#include <cstddef>
#include <vector>

#include <cover/triangle_soup.hpp>

namespace cover {

double largest_angle(const TriangleSoup& soup, std::size_t triangle);
double smallest_angle(const TriangleSoup& soup, std::size_t triangle);

/// By triangle.
std::vector<double> largest_angles(const TriangleSoup& soup);
std::vector<double> smallest_angles(const TriangleSoup& soup);

}  // namespace cover
