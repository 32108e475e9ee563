#include <pybind11/stl.h>

#include "engine/base/parallel/parallel.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/system.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

// Points a thread takes at a time: enough for a map that is a Python function of arrays.
constexpr std::size_t grain = 4096;

py::tuple info_of(const SystemInfo& info) {
  py::list parameters;
  for (const Parameter& p : info.parameters) {
    parameters.append(py::make_tuple(p.name, p.value, p.meaning, p.min, p.max, p.min_excluded));
  }
  return py::make_tuple(info.name, info.summary, parameters);
}

py::list list() {
  py::list systems;
  for (const SystemInfo& info : list_systems()) systems.append(info_of(info));
  return systems;
}

SystemHandle make_system(const std::string& name, const ParameterValues& values, double tolerance) {
  IntegrationOptions options;
  options.tolerance = tolerance;
  return std::make_shared<System>(make_system(name, values, options));
}

py::array iterated(const System& system, const Array& points, int iterates, int threads) {
  const PlanarMap& map = map_of(system);
  const std::span<const Point> given = points_of(points);
  return array_of(long_call(threads, [&] {
    Buffer<Point> result(given.begin(), given.end());
    lober::detail::for_each_block(result.size(), grain, [&](std::size_t begin, std::size_t end) {
      map.iterate(std::span(result).subspan(begin, end - begin), iterates);
    });
    return result;
  }));
}

py::array derivatives(const System& system, const Array& points, int iterates, int threads) {
  const PlanarMap& map = map_of(system);
  const std::span<const Point> given = points_of(points);
  py::array_t<double> result({static_cast<py::ssize_t>(given.size()), py::ssize_t{2}, py::ssize_t{2}});
  static_assert(sizeof(Matrix2) == 4 * sizeof(double));
  const std::span<Matrix2> matrices(reinterpret_cast<Matrix2*>(result.mutable_data()), given.size());
  (void)long_call(threads, [&] {
    std::vector<Point> moved(given.begin(), given.end());
    lober::detail::for_each_block(moved.size(), grain, [&](std::size_t begin, std::size_t end) {
      map.iterate_with_derivatives(std::span(moved).subspan(begin, end - begin), iterates,
                                   matrices.subspan(begin, end - begin));
    });
    return true;
  });
  return result;
}

py::list saddles_of(const System& system) {
  const int dimension = system.flow ? system.flow->dimension() : 0;
  py::list saddles;
  for (const FlowState& state : system.saddles) {
    saddles.append(py::tuple(py::cast(std::vector<double>(state.begin(), state.begin() + dimension))));
  }
  return saddles;
}

// Not by a cast: one of complex numbers of NumPy leaves their imaginary parts out.
std::vector<double> numbers_from(const py::handle& given) {
  for (const py::handle entry : given) {
    if (PyComplex_Check(entry.ptr()) != 0 || py::module_::import("numpy").attr("iscomplexobj")(entry).cast<bool>()) {
      throw UsageError("a point or a box has real coordinates; give x and y instead of a complex number");
    }
  }
  return given.cast<std::vector<double>>();
}

}  // namespace

const PlanarMap& map_of(const System& system) {
  if (!system.map) throw UsageError("system " + system.info.name + " has no planar map, which this function needs");
  return *system.map;
}

Point point_from(const py::handle& pair) {
  const std::vector<double> numbers = numbers_from(pair);
  if (numbers.size() != 2) throw UsageError("a point has two coordinates");
  return {numbers[0], numbers[1]};
}

Rectangle rectangle_from(const py::handle& corners) {
  const std::vector<double> numbers = numbers_from(corners);
  if (numbers.size() != 4 || !(numbers[0] < numbers[2] && numbers[1] < numbers[3])) {
    throw UsageError("a box is given by its corners (x0, y0, x1, y1), with x0 < x1 and y0 < y1");
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

py::tuple corners_of(const Rectangle& rectangle) {
  return py::make_tuple(rectangle.min_x, rectangle.min_y, rectangle.max_x, rectangle.max_y);
}

void take_description(Keywords& given, System& system) {
  given.take("name", system.info.name)
      .take("summary", system.info.summary)
      .take_as<ParameterValues>("values",
                                [&](const ParameterValues& values) {
                                  for (const auto& [name, value] : values) {
                                    Parameter parameter{name, value, ""};
                                    parameter.perturbation = name == "eps";
                                    system.info.parameters.push_back(parameter);
                                  }
                                })
      .take_as<py::tuple>("window", [&](const py::tuple& corners) { system.window = rectangle_from(corners); })
      .take_as<py::tuple>("lattice", [&](const py::tuple& shift) { system.lattice = point_from(shift); });
}

Connection connection_from(const py::tuple& parts) {
  Connection connection{point_from(parts[0]), point_from(parts[1]), point_from(parts[2]), point_from(parts[3])};
  if (!parts[4].is_none()) connection.bip = point_from(parts[4]);
  for (const py::handle corner : parts[5]) connection.closure.push_back(point_from(corner));
  return connection;
}

py::tuple connection_parts(const Connection& connection) {
  py::object bip = py::none();
  if (connection.bip) bip = pair_of(*connection.bip);
  py::list corners;
  for (const Point corner : connection.closure) corners.append(pair_of(corner));
  return py::make_tuple(pair_of(connection.from), pair_of(connection.u_direction), pair_of(connection.to),
                        pair_of(connection.s_direction), bip, py::tuple(corners));
}

namespace {

// The same system with the tangle that the caller means in place of its own.
SystemHandle with_connection(const System& system, const py::tuple& parts) {
  auto made = std::make_shared<System>(system);
  made->connection = connection_from(parts);
  made->no_connection.clear();
  made->further.clear();
  made->further_needed = false;
  return made;
}

}  // namespace

void bind_systems(py::module_& module) {
  py::class_<System, SystemHandle>(module, "System")
      .def_property_readonly("info", [](const System& system) { return info_of(system.info); })
      .def_property_readonly("window", [](const System& system) { return corners_of(system.window); })
      .def_property_readonly("picture", [](const System& system) { return corners_of(system.picture); })
      .def_property_readonly("lattice", [](const System& system) { return pair_of(system.lattice); })
      .def_property_readonly("connection",
                             [](const System& system) -> py::object {
                               if (!system.connection) return py::none();
                               return connection_parts(*system.connection);
                             })
      .def_property_readonly("no_connection", [](const System& system) { return system.no_connection; })
      .def_property_readonly("further",
                             [](const System& system) {
                               py::list all;
                               for (const Connection& other : system.further) all.append(connection_parts(other));
                               return all;
                             })
      .def_property_readonly("further_needed", [](const System& system) { return system.further_needed; })
      .def_property_readonly("has_map", [](const System& system) { return system.map != nullptr; })
      .def_property_readonly("dimension",
                             [](const System& system) { return system.flow ? system.flow->dimension() : 0; })
      .def_property_readonly("period", [](const System& system) { return system.flow ? system.flow->period() : 0.0; })
      .def("connect",
           [](System& system, const py::tuple& connection) { system.connection = connection_from(connection); })
      .def_property_readonly("saddles", saddles_of);
  module.def("with_connection", with_connection, py::arg("system"), py::arg("connection"));
  module.def("systems", list);
  module.def("system", make_system, py::arg("name"), py::arg("values"), py::arg("tolerance"));
  module.def("images", iterated, py::arg("system"), py::arg("points").noconvert(), py::arg("iterates"),
             py::arg("threads"));
  module.def("derivatives", derivatives, py::arg("system"), py::arg("points").noconvert(), py::arg("iterates"),
             py::arg("threads"));
}

}  // namespace lober::python
