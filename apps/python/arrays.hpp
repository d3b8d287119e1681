// numpy arrays to geometry and back.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cover/input.hpp>

#include "raise.hpp"

namespace cover::python {

namespace py = pybind11;

/// Anything that numpy makes an array of doubles, or of indices, of.
using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::int64_t, py::array::c_style>;

/// A PSLG; a region is (x, y, material) or (x, y, material, name); `lines` has the indices of
/// segments by the name of a contact or interface.
///
/// Raises: TypeError, ValueError, IndexError where kinds, shapes or indices do not fit.
Input pslg_from(const py::object& points, const py::object& segments, const py::list& regions,
                const py::object& holes, const py::dict& lines);

/// Painted polygons; each is (material, rings) or (material, rings, region name).
Input soup_from(const py::list& polygons);

/// Raises ValueError where a value of an array of numpy, or of one in a list, is masked: there is
/// a number behind it, which is not meant.
void refuse_masked(const py::handle& value, const std::string& what);

/// As an array of `Array`'s kind; `words`, because of what numpy says, where there is none.
template <class Array>
Array converted(const py::handle& value, const std::string& words) {
  try {
    return Array(py::reinterpret_borrow<py::object>(value));
  } catch (py::error_already_set& raised) {
    raise_because(raised, PyExc_TypeError, words);
  }
}

/// What nobody can write to: it is a copy, so that nothing would come of it.
template <class Array>
Array read_only(Array array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

// Copies of what a mesh has, for reading only.

/// n x 2.
py::array_t<double> array_of(const std::vector<Point>& points);
/// n x N.
template <std::size_t N>
py::array_t<std::uint32_t> array_of(const std::vector<std::array<std::uint32_t, N>>& rows) {
  py::array_t<std::uint32_t> array({rows.size(), N});
  auto view = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < view.shape(0); ++i)
    for (py::ssize_t j = 0; j < view.shape(1); ++j)
      view(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return read_only(std::move(array));
}
py::array_t<std::int64_t> array_of(const std::vector<std::int64_t>& values);
py::array_t<double> array_of(const std::vector<double>& values);

}  // namespace cover::python
