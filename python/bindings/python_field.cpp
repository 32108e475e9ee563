// Vector fields whose values are computed by Python functions of many points at a time, or by functions at an address
// (lober/_own_field.py), and systems made of them.
#include <pybind11/stl.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/periodic_orbit.hpp"
#include "lober/dynamics/vector_field.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/system.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The common part of both kinds: the attributes dimension, period, pairs and extent of an object, which is kept.
class KeptField : public VectorField {
 public:
  explicit KeptField(py::object object)
      : object_(std::move(object)),
        dimension_(object_.attr("dimension").cast<int>()),
        period_(object_.attr("period").cast<double>()),
        extent_(object_.attr("extent").cast<double>()) {
    for (const py::handle pair : object_.attr("pairs")) {
      const auto [q, p] = pair.cast<std::pair<int, int>>();
      pairs_.push_back({q, p, 1});
    }
  }
  ~KeptField() override {
    const py::gil_scoped_acquire acquired;
    object_ = py::object();
  }

  [[nodiscard]] int dimension() const override { return dimension_; }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] std::span<const ConjugatePair> conjugate_pairs() const override { return pairs_; }
  [[nodiscard]] double extent() const override { return extent_; }

 protected:
  [[nodiscard]] const py::object& object() const { return object_; }
  [[nodiscard]] std::size_t coordinates() const { return static_cast<std::size_t>(dimension_); }

 private:
  py::object object_;
  int dimension_;
  double period_, extent_;
  std::vector<ConjugatePair> pairs_;
};

/// A field of the methods velocities(x, t), jacobians(x, t) and hamiltonians(x, t) of an object: x of dimension x N,
/// results of dimension x N, dimension x dimension x N and N. They are called with the GIL, by one thread at a time.
class PythonField final : public KeptField {
 public:
  explicit PythonField(const py::object& field)
      : KeptField(field), has_jacobian_(field.attr("has_jacobian").cast<bool>()) {}

  void velocities(std::size_t count, const double* x, const double* t, double* dxdt) const override {
    call("velocities", count, x, t, coordinates(), dxdt);
  }
  void jacobians(std::size_t count, const double* x, const double* t, double* jacobian) const override {
    if (!has_jacobian_) {
      VectorField::jacobians(count, x, t, jacobian);
    } else {
      call("jacobians", count, x, t, coordinates() * coordinates(), jacobian);
    }
  }
  [[nodiscard]] bool has_jacobian() const override { return has_jacobian_; }
  void hamiltonians(std::size_t count, const double* x, const double* t, double* h) const override {
    call("hamiltonians", count, x, t, 1, h);
  }
  /// From now on exceptions of the functions go on. Until then, while the system is made and checked, they stand for
  /// points without values: a function that raises does so again where it is used.
  void made() { checking_ = false; }
  /// Throws the first of those exceptions, if there was one.
  void raise_first_fault() const {
    if (first_fault_) std::rethrow_exception(first_fault_);
  }
  /// A call costs as much as thousands of points.
  [[nodiscard]] std::size_t batch() const override { return 6144; }

 private:
  void call(const char* name, std::size_t count, const double* x, const double* t, std::size_t numbers,
            double* to) const {
    throw_if_cancelled();
    const py::gil_scoped_acquire acquired;
    if (!checking_) {
      ask(name, count, x, t, numbers, to);
      return;
    }
    try {
      ask(name, count, x, t, numbers, to);
    } catch (const std::exception&) {
      if (!first_fault_) first_fault_ = std::current_exception();
      std::fill_n(to, numbers * count, std::numeric_limits<double>::quiet_NaN());
    }
  }
  void ask(const char* name, std::size_t count, const double* x, const double* t, std::size_t numbers,
           double* to) const {
    const auto points = static_cast<py::ssize_t>(count);
    // Copies: a function may keep what it is given.
    const py::array_t<double> at({static_cast<py::ssize_t>(dimension()), points}, x);
    const py::array_t<double> times(points, t);
    const auto found = object().attr(name)(at, times).cast<Numbers>();
    if (found.size() != static_cast<py::ssize_t>(numbers * count)) throw UsageError("a field gives too few numbers");
    std::copy_n(found.data(), numbers * count, to);
  }

  bool has_jacobian_;
  bool checking_ = true;
  mutable std::exception_ptr first_fault_;
};

/// A field of functions at addresses, which have the form of those of lober_flow (lober_system.h).
class AddressField final : public KeptField {
 public:
  AddressField(const py::object& field, std::vector<double> parameters)
      : KeptField(field),
        parameters_(std::move(parameters)),
        velocity_(reinterpret_cast<Function>(field.attr("velocity").cast<std::uintptr_t>())),
        jacobian_(reinterpret_cast<Function>(field.attr("jacobian").cast<std::uintptr_t>())),
        hamiltonian_(reinterpret_cast<Energy>(field.attr("hamiltonian").cast<std::uintptr_t>())) {}

  void velocities(std::size_t count, const double* x, const double* t, double* dxdt) const override {
    each(velocity_, count, x, t, coordinates(), dxdt);
  }
  void jacobians(std::size_t count, const double* x, const double* t, double* jacobian) const override {
    if (jacobian_ == nullptr) {
      VectorField::jacobians(count, x, t, jacobian);
    } else {
      each(jacobian_, count, x, t, coordinates() * coordinates(), jacobian);
    }
  }
  [[nodiscard]] bool has_jacobian() const override { return jacobian_ != nullptr; }
  void hamiltonians(std::size_t count, const double* x, const double* t, double* h) const override {
    double at[max_flow_dimension] = {};
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t i = 0; i < coordinates(); ++i) at[i] = x[i * count + k];
      h[k] = hamiltonian_(parameters_.data(), at, t[k]);
    }
  }

 private:
  using Function = int (*)(const double*, const double*, double, double*);
  using Energy = double (*)(const double*, const double*, double);

  void each(Function function, std::size_t count, const double* x, const double* t, std::size_t numbers,
            double* to) const {
    double at[max_flow_dimension] = {}, found[max_flow_dimension * max_flow_dimension] = {};
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t i = 0; i < coordinates(); ++i) at[i] = x[i * count + k];
      const bool lost = function(parameters_.data(), at, t[k], found) != 0;
      for (std::size_t i = 0; i < numbers; ++i) {
        to[i * count + k] = lost ? std::numeric_limits<double>::quiet_NaN() : found[i];
      }
    }
  }

  std::vector<double> parameters_;
  Function velocity_, jacobian_;
  Energy hamiltonian_;
};

Section section_from(const py::dict& given) {
  Section section;
  Keywords(given)
      .take("coordinate", section.coordinate)
      .take("value", section.value)
      .take("direction", section.direction)
      .take("chart_x", section.chart_x)
      .take("chart_y", section.chart_y)
      .take("solved", section.solved)
      .take("bound_coordinate", section.bound_coordinate)
      .take("bound", section.bound)
      .take("bound_side", section.bound_side)
      .take("period", section.period)
      .end();
  return section;
}

std::vector<FlowState> states_from(const py::list& given) {
  std::vector<FlowState> states;
  for (const py::handle one : given) {
    const auto numbers = one.cast<std::vector<double>>();
    FlowState state{};
    if (numbers.size() > state.size()) throw UsageError("a state has more than 6 coordinates");
    std::copy(numbers.begin(), numbers.end(), state.begin());
    states.push_back(state);
  }
  return states;
}

SystemHandle make_field_system(const py::object& field, const py::kwargs& given) {
  System described;
  FieldMap map;
  IntegrationOptions options;
  Keywords keywords(given);
  take_description(keywords, described);
  keywords.take_as<py::dict>("section", [&](const py::dict& of) { described.section = section_from(of); })
      .take("phase", map.phase)
      .take("energy", map.energy)
      .take("tolerance", options.tolerance)
      .end();
  std::vector<double> numbers;
  for (const Parameter& parameter : described.info.parameters) numbers.push_back(parameter.value);
  if (!py::hasattr(field, "velocities")) {
    auto at_address = std::make_shared<const AddressField>(field, std::move(numbers));
    return std::make_shared<System>(make_system(std::move(at_address), std::move(described), map, options));
  }
  const auto of_python = std::make_shared<PythonField>(field);
  try {
    auto made = std::make_shared<System>(make_system(of_python, std::move(described), map, options));
    of_python->made();
    return made;
  } catch (const DataError&) {
    of_python->raise_first_fault();
    throw;
  }
}

// The saddles of a flow by their states, and the names of its coordinates.
void set_saddles(System& system, const py::list& given, std::vector<std::string> names) {
  system.coordinates = std::move(names);
  system.saddles.clear();
  for (const FlowState& state : states_from(given)) system.saddles.push_back(state);
}

std::vector<double> at_rest(const System& system, const py::object& position) {
  const FlowState state = state_at_rest(*system.flow, point_from(position));
  return {state.begin(), state.begin() + system.flow->dimension()};
}

}  // namespace

void bind_python_field(py::module_& module) {
  module.def("field_system", make_field_system, py::arg("field"));
  module.def("set_saddles", set_saddles, py::arg("system"), py::arg("states"), py::arg("names"));
  module.def("at_rest", at_rest, py::arg("system"), py::arg("position"));
}

}  // namespace lober::python
