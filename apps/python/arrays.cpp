#include "arrays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace cover::python {
namespace {

constexpr double kAllWhole = 9007199254740992;  ///< 2^53: up to there, doubles have every integer

/// Raises ValueError where a whole number is not a double: to round it would move a point.
void refuse_rounded(const py::handle& number, const std::string& what) {
  if (!PyLong_Check(number.ptr())) return;
  const double rounded = PyLong_AsDouble(number.ptr());
  const bool overflows = rounded == -1 && PyErr_Occurred() != nullptr;
  if (overflows) PyErr_Clear();
  if (overflows || (std::abs(rounded) >= kAllWhole && !py::float_(rounded).equal(number)))
    throw py::value_error(what + ": no double is " + std::string(py::str(number)) +
                          "; numbers above 2^53 are rounded, give a float if that is meant");
}

bool has_large(const py::array& array, const std::string& what) {
  const auto doubles = converted<Points>(array, what);
  const double* const all = doubles.data();
  return std::any_of(all, all + doubles.size(), [](double x) { return std::abs(x) >= kAllWhole; });
}

/// The same of all numbers of an array; `given` is what it was made of: of a list in which a float
/// stands, numpy makes floats.
void refuse_rounded(const py::array& array, const py::handle& given, const std::string& what) {
  const char kind = array.dtype().kind();
  const bool was_list = kind == 'f' && !py::hasattr(given, "dtype");
  const bool is_whole = kind == 'i' || kind == 'u';
  if (kind != 'O' && !((was_list || is_whole) && has_large(array, what))) return;
  const py::object numbers = py::module_::import("numpy").attr("array")(
      was_list ? given : py::handle(array), py::arg("dtype") = "object");
  for (const py::handle& number : numbers.attr("ravel")()) refuse_rounded(number, what);
}

std::vector<Point> points_from(const py::handle& value, const std::string& what) {
  const std::string words = what + " must be numbers of the shape (n, 2)";
  refuse_masked(value, what);
  const auto given = converted<py::array>(value, words);
  // Casting leaves out an imaginary part, and makes numbers of dates.
  const char kind = given.dtype().kind();
  if (kind == 'c' || kind == 'M' || kind == 'm') throw py::type_error(words);
  refuse_rounded(given, value, what);
  const auto array = converted<Points>(given, words);
  if (array.size() == 0) return {};
  if (array.ndim() != 2 || array.shape(1) != 2)
    throw py::value_error(what + " must have the shape (n, 2)");
  const auto view = array.unchecked<2>();
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(view.shape(0)));
  for (py::ssize_t i = 0; i < view.shape(0); ++i) points.push_back({view(i, 0), view(i, 1)});
  return points;
}

/// Whole numbers: those that are written as 1.0 count, 1.5 does not.
Indices indices_from(const py::handle& value, const std::string& what) {
  refuse_masked(value, what);
  auto array = converted<py::array>(value, what + " must be indices");
  // What is in it says which numbers these are.
  if (array.dtype().kind() == 'O')
    array = converted<py::array>(array.attr("tolist")(), what + " must be indices");
  if (array.size() == 0) return Indices(py::ssize_t{0});  // numpy takes an empty list for floats
  const char kind = array.dtype().kind();
  // Those would wrap around to other numbers.
  if (kind == 'u' && array.itemsize() == sizeof(std::uint64_t)) {
    const auto largest = array.attr("max")().cast<std::uint64_t>();
    if (largest > std::uint64_t{std::numeric_limits<std::int64_t>::max()})
      throw py::index_error(what + ": there is no index " + std::to_string(largest));
  }
  if (kind == 'i' || kind == 'u')
    return Indices(py::object(array.attr("astype")("int64", py::arg("copy") = false)));
  if (kind != 'f') throw py::type_error(what + " must be indices: whole numbers");
  refuse_rounded(array, value, what);
  Indices indices(py::object(array.attr("astype")("int64")));
  if (!py::bool_(array.attr("__eq__")(indices).attr("all")()))
    throw py::value_error(what + " must be indices: whole numbers, of 0 and more");
  return indices;
}

std::uint32_t index_from(std::int64_t value, std::size_t count) {
  if (value < 0 || static_cast<std::size_t>(value) >= count)
    throw py::index_error("segments: there is no point " + std::to_string(value) + ": there are " +
                          std::to_string(count) + " points");
  return static_cast<std::uint32_t>(value);
}

void name_segments(const py::dict& lines, Input& input) {
  std::vector<InputSegment>& segments = input.segments;
  for (const auto& [name, value] : lines) {
    const std::string own = py::str(name);
    const Indices indices = indices_from(value, "lines");
    if (indices.ndim() != 1) throw py::value_error("lines: a name needs a list of segments");
    if (indices.size() == 0)
      input.warnings.push_back(
          std::string("the line '").append(own).append("' has no segments: it is left out"));
    for (py::ssize_t i = 0; i < indices.shape(0); ++i) {
      const std::int64_t s = indices.at(i);
      if (s < 0 || static_cast<std::size_t>(s) >= segments.size())
        throw py::index_error("lines: there is no segment " + std::to_string(s));
      std::string& known = segments[static_cast<std::size_t>(s)].name;
      if (!known.empty() && known != own)
        throw py::value_error(std::string("lines: segment ")
                                  .append(std::to_string(s))
                                  .append(" is in '")
                                  .append(known)
                                  .append("' and in '")
                                  .append(own)
                                  .append("'; a segment has one name"));
      known = own;
    }
  }
}

/// A name, or a whole number as it is written.
std::string name_from(const py::handle& value, const char* what) {
  const bool is_number = PyIndex_Check(value.ptr()) != 0 && !py::isinstance<py::bool_>(value) &&
                         !py::hasattr(value, "__len__");
  if (!py::isinstance<py::str>(value) && !is_number)
    throw py::type_error(std::string(what) + " must be a name or a whole number, not " +
                         std::string(py::repr(value)));
  return py::str(value);
}

/// A coordinate of a region.
double coordinate_from(const py::handle& value) {
  refuse_masked(value, "a region");
  refuse_rounded(value, "a region");
  try {
    return py::float_(py::reinterpret_borrow<py::object>(value));
  } catch (py::error_already_set& raised) {
    raise_because(raised, PyExc_TypeError,
                  "a region is (x, y, material) or (x, y, material, name), and " +
                      std::string(py::repr(value)) + " is no coordinate");
  }
}

/// What has no mask.
bool is_plain_number(const py::handle& value) {
  return PyFloat_CheckExact(value.ptr()) != 0 || PyLong_CheckExact(value.ptr()) != 0;
}

void refuse_masked_array(const py::handle& value, const std::string& what) {
  if (is_plain_number(value) || !py::hasattr(value, "dtype") || !py::hasattr(value, "mask")) return;
  if (py::bool_(py::module_::import("numpy").attr("ma").attr("is_masked")(value)))
    throw py::value_error(what + ": a value is masked, so there is no number to take");
}

}  // namespace

void refuse_masked(const py::handle& value, const std::string& what) {
  if (is_plain_number(value) || py::isinstance<py::str>(value)) return;
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    for (const py::handle& item : value) {
      if (!py::isinstance<py::list>(item) && !py::isinstance<py::tuple>(item))
        refuse_masked(item, what);
      else
        for (const py::handle& number : item) refuse_masked_array(number, what);
    }
  } else {
    refuse_masked_array(value, what);
  }
}

Input pslg_from(const py::object& points, const py::object& ends, const py::list& regions,
                const py::object& holes, const py::dict& lines) {
  Input input;
  input.source = "arrays";
  input.void_rule = VoidRule::unseeded_faces;
  input.seeds_may_miss = true;
  input.points = points_from(points, "points");
  const Indices segments = indices_from(ends, "segments");
  if (segments.size() > 0 && (segments.ndim() != 2 || segments.shape(1) != 2))
    throw py::value_error("segments must have the shape (m, 2)");
  const py::ssize_t count = segments.size() / 2;
  for (py::ssize_t i = 0; i < count; ++i) {
    InputSegment segment;
    segment.a = index_from(segments.at(i, 0), input.points.size());
    segment.b = index_from(segments.at(i, 1), input.points.size());
    segment.id = static_cast<long>(i);
    input.segments.push_back(segment);
  }
  name_segments(lines, input);
  for (const py::handle& item : regions) {
    if (!py::isinstance<py::sequence>(item))
      throw py::type_error("a region is (x, y, material) or (x, y, material, name)");
    const auto fields = py::reinterpret_borrow<py::sequence>(item);
    if (fields.size() < 3 || fields.size() > 4)
      throw py::value_error("a region is (x, y, material) or (x, y, material, name)");
    RegionSeed seed;
    seed.at = {coordinate_from(fields[0]), coordinate_from(fields[1])};
    seed.material = name_from(fields[2], "a material");
    if (fields.size() == 4) seed.region = name_from(fields[3], "a region");
    seed.id = static_cast<long>(input.seeds.size());
    input.seeds.push_back(std::move(seed));
  }
  for (const Point p : points_from(holes, "holes"))
    input.holes.push_back({p, static_cast<long>(input.holes.size()), 0});
  return input;
}

Input soup_from(const py::list& polygons) {
  Input input;
  input.source = "polygons";
  for (const py::handle& item : polygons) {
    const auto fields = py::reinterpret_borrow<py::sequence>(item);
    if (fields.size() < 2 || fields.size() > 3)
      throw py::value_error("a polygon is (material, rings) or (material, rings, name)");
    InputPolygon polygon;
    polygon.material = name_from(fields[0], "a material");
    const std::string which = "polygon " + std::to_string(input.polygons.size()) + ": ring ";
    for (const py::handle& ring : fields[1])
      polygon.rings.push_back(points_from(ring, which + std::to_string(polygon.rings.size())));
    if (fields.size() == 3) polygon.region = name_from(fields[2], "a region");
    polygon.id = static_cast<long>(input.polygons.size());
    input.polygons.push_back(std::move(polygon));
  }
  return input;
}

py::array_t<double> array_of(const std::vector<Point>& points) {
  py::array_t<double> array({points.size(), std::size_t{2}});
  auto view = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < view.shape(0); ++i) {
    view(i, 0) = points[static_cast<std::size_t>(i)].x;
    view(i, 1) = points[static_cast<std::size_t>(i)].y;
  }
  return read_only(std::move(array));
}

py::array_t<std::int64_t> array_of(const std::vector<std::int64_t>& values) {
  return read_only(
      py::array_t<std::int64_t>(static_cast<py::ssize_t>(values.size()), values.data()));
}

py::array_t<double> array_of(const std::vector<double>& values) {
  return read_only(py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data()));
}

}  // namespace cover::python
