// Maps whose steps are computed by Python functions of many points at a time (lober/_own_maps.py).
#include <pybind11/stl.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/planar_map.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/system.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

/// The map of an object with
///   once(points, forward) -> (images, evaluations of the field, 0 for none)
///   iterate_with_derivatives(points, iterates) -> (images, derivatives)
///   action(from, to) -> number or None, action_accuracy, has_inverse, finer() -> such an object or None,
/// which are called with the GIL, by one thread at a time.
class PythonMap final : public PlanarMap {
 public:
  explicit PythonMap(py::object object)
      : object_(std::move(object)),
        unit_(unit_within(object_.attr("extent").cast<double>())),
        has_inverse_(object_.attr("has_inverse").cast<bool>()) {}
  ~PythonMap() override {
    const py::gil_scoped_acquire acquired;
    object_ = py::object();
  }

  void iterate(std::span<Point> points, int iterates) const override {
    for (int k = 0; k < std::abs(iterates); ++k) {
      throw_if_cancelled();
      const py::gil_scoped_acquire acquired;
      const py::tuple answer = object_.attr("once")(copied(points), iterates > 0);
      take(answer[0], points);
      add_tenths_of_work(10 * answer[1].cast<std::uint64_t>());
    }
  }

  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    iterate_with_derivatives({&point, 1}, iterates, {&derivative, 1});
    return point;
  }

  void iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const override {
    const py::gil_scoped_acquire acquired;
    const py::tuple answer = object_.attr("iterate_with_derivatives")(copied(points), iterates);
    take(answer[0], points);
    const auto matrices = answer[1].cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
    if (matrices.size() != static_cast<py::ssize_t>(4 * points.size())) throw UsageError("derivatives are N x 2 x 2");
    const double* number = matrices.data();
    for (Matrix2& d : derivatives) {
      d = {number[0], number[1], number[2], number[3]};
      number += 4;
    }
  }

  [[nodiscard]] std::optional<long double> action(Point from, Point to) const override {
    const py::gil_scoped_acquire acquired;
    const py::object answer = object_.attr("action")(pair_of(from), pair_of(to));
    if (answer.is_none()) return std::nullopt;
    return answer.cast<double>();
  }
  [[nodiscard]] double action_accuracy() const override {
    const py::gil_scoped_acquire acquired;
    return object_.attr("action_accuracy").cast<double>();
  }

  [[nodiscard]] double unit() const override { return unit_; }
  [[nodiscard]] bool takes_all_iterates() const override { return has_inverse_; }
  /// A call costs as much as hundreds of points.
  [[nodiscard]] std::size_t batch() const override { return 4096; }

  [[nodiscard]] std::unique_ptr<PlanarMap> finer() const override {
    const py::gil_scoped_acquire acquired;
    py::object answer = object_.attr("finer")();
    if (answer.is_none()) return nullptr;
    return std::make_unique<PythonMap>(std::move(answer));
  }

 private:
  static py::array_t<double> copied(std::span<const Point> points) {
    return array_of(std::vector<Point>(points.begin(), points.end()));
  }
  static void take(const py::object& answer, std::span<Point> points) {
    const auto images = answer.cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
    const std::span<const Point> given = points_of(images);
    if (given.size() != points.size()) throw UsageError("a map has to give as many images as it gets points");
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const bool finite = std::isfinite(given[k].x) && std::isfinite(given[k].y);
      points[k] = finite ? given[k] : Point{nan, nan};
    }
  }

  py::object object_;
  double unit_;
  bool has_inverse_;
};

SystemHandle make_own_system(py::object map, const py::kwargs& given) {
  auto system = std::make_shared<System>();
  Keywords keywords(given);
  take_description(keywords, *system);
  keywords.take_as<py::tuple>("connection",
                              [&](const py::tuple& parts) { system->connection = connection_from(parts); });
  keywords.end();
  system->picture = system->window;
  system->map = std::make_shared<PythonMap>(std::move(map));
  return system;
}

}  // namespace

void bind_python_map(py::module_& module) {
  module.def("check_cancelled", [] { throw_if_cancelled(); });
  module.def("own_system", make_own_system, py::arg("map"));
}

}  // namespace lober::python
