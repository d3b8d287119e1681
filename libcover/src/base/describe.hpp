// How points and numbers are written in messages.
#pragma once

#include <string>
#include <string_view>

#include <cover/point.hpp>
#include <cover/regions.hpp>

namespace cover {

/// The shortest text that reads back as the same number.
std::string describe(double x);

/// Three digits, for distances that are only told.
std::string describe_roughly(double x);

/// "(x, y)", each in the shortest form that reads back as the same number.
std::string describe(Point p);

/// "interface", "outline", "slit", "contact".
std::string describe(InterfaceKind kind);

/// "1 segment", "3 segments".
std::string counted(std::size_t n, std::string_view singular);

}  // namespace cover
