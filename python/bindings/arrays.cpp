#include "python/bindings/arrays.hpp"

#include <string>

#include "lober/base/error.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

std::shared_ptr<const void> keeper(const Array& array) {
  return {array.inc_ref().ptr(), [](PyObject* object) {
            const py::gil_scoped_acquire acquired;
            Py_DECREF(object);
          }};
}

}  // namespace

std::span<const Point> points_of(const Array& array) {
  if (array.ndim() != 2 || array.shape(1) != 2) throw UsageError("points are an array of N rows and 2 columns");
  return {reinterpret_cast<const Point*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

ClosedCurve closed_curve(const Array& array) {
  const std::span<const Point> points = points_of(array);
  return {keeper(array), points};
}

py::array_t<double> view_of(std::span<const Point> points, py::handle base) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}}, {sizeof(Point), sizeof(double)},
                            reinterpret_cast<const double*>(points.data()), base);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::list arrays_of(std::vector<std::vector<Point>>&& polygons) {
  py::list list;
  for (std::vector<Point>& polygon : polygons) list.append(array_of(std::move(polygon)));
  return list;
}

std::size_t index_in(py::ssize_t index, std::size_t size) {
  const auto count = static_cast<py::ssize_t>(size);
  if (index < -count || index >= count) {
    throw py::index_error("index " + std::to_string(index) + " is out of range for " + std::to_string(size) +
                          (size == 1 ? " element" : " elements"));
  }
  return static_cast<std::size_t>(index < 0 ? index + count : index);
}

}  // namespace lober::python
