// Arrays of NumPy as spans, and memory of the library as arrays, without copies in either direction.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/point.hpp"

namespace lober::python {

/// A C-contiguous array of float64; lober/_arrays.py converts other arrays. Nothing is converted here.
using Array = pybind11::array_t<double, pybind11::array::c_style>;

/// The points of an N x 2 array, which has to stay alive. Throws UsageError for another shape.
[[nodiscard]] std::span<const Point> points_of(const Array& array);

/// A curve that keeps the array alive. Its last copy may be destroyed by any thread, with or without the GIL.
[[nodiscard]] ClosedCurve closed_curve(const Array& array);

/// A read-only array of memory that `base` keeps alive.
template <typename T>
pybind11::array_t<T> view_of(std::span<const T> values, pybind11::handle base) {
  pybind11::array_t<T> array({values.size()}, {sizeof(T)}, values.data(), base);
  array.attr("flags").attr("writeable") = false;
  return array;
}
/// N x 2.
[[nodiscard]] pybind11::array_t<double> view_of(std::span<const Point> points, pybind11::handle base);

namespace detail {

/// A capsule that owns the container.
template <typename Container>
std::pair<pybind11::capsule, const Container*> kept(Container&& container) {
  auto owned = std::make_unique<Container>(std::move(container));
  const Container* const memory = owned.get();
  pybind11::capsule capsule(memory, [](void* pointer) { delete static_cast<Container*>(pointer); });
  (void)owned.release();
  return {std::move(capsule), memory};
}

}  // namespace detail

/// A writable array that owns the numbers.
template <typename T, typename Allocator>
pybind11::array_t<T> array_of(std::vector<T, Allocator>&& values) {
  const auto [capsule, memory] = detail::kept(std::move(values));
  return pybind11::array_t<T>({memory->size()}, {sizeof(T)}, memory->data(), capsule);
}
/// N x 2, of a vector or Buffer of points.
template <typename Allocator>
pybind11::array_t<double> array_of(std::vector<Point, Allocator>&& points) {
  const auto [capsule, memory] = detail::kept(std::move(points));
  const auto rows = static_cast<pybind11::ssize_t>(memory->size());
  return pybind11::array_t<double>({rows, pybind11::ssize_t{2}}, {sizeof(Point), sizeof(double)},
                                   reinterpret_cast<const double*>(memory->data()), capsule);
}

[[nodiscard]] pybind11::list arrays_of(std::vector<std::vector<Point>>&& polygons);

[[nodiscard]] inline pybind11::tuple pair_of(Point point) {
  return pybind11::make_tuple(point.x, point.y);
}

/// An index as Python means it, negative from the end. Throws IndexError.
[[nodiscard]] std::size_t index_in(pybind11::ssize_t index, std::size_t size);

}  // namespace lober::python
