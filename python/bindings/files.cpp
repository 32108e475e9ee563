#include "lober/curve/files.hpp"

#include <pybind11/stl.h>

#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

// Format, SHA-256, and of each zone its title and points.
py::tuple read_zones(const std::string& path, bool hash, const std::string& columns) {
  CurveFile file = long_call(0, [&] { return read_curve_file(path, {.hash = hash, .columns = columns}); });
  py::list zones;
  for (Zone& zone : file.zones) zones.append(py::make_tuple(py::bytes(zone.title), array_of(std::move(zone.points))));
  return py::make_tuple(name(file.format), file.sha256, zones);
}

py::array read_one(const std::string& spec, bool closed) {
  NamedCurve found = long_call(0, [&] { return read_curve(spec, closed, {.hash = false}); });
  return array_of(std::move(found.curve.points));
}

void write_zones(const std::string& path, const std::vector<std::pair<std::string, Array>>& zones) {
  std::vector<Zone> copies;
  for (const auto& [title, array] : zones) {
    const std::span<const Point> points = points_of(array);
    copies.push_back({title, {points.begin(), points.end()}, 1});
  }
  const py::gil_scoped_release released;
  write_tecplot(path, copies);
}

// Writes one curve; `format` is npy, raw, csv or text.
void write_one(const std::string& path, const Array& curve, const std::string& format) {
  const std::span<const Point> points = points_of(curve);
  const py::gil_scoped_release released;
  if (format == "npy") return write_npy(path, points);
  if (format == "raw") return write_raw(path, points);
  write_text(path, points, format == "csv" ? ',' : ' ');
}

}  // namespace

void bind_files(py::module_& module) {
  module.def("read_zones", read_zones, py::arg("path"), py::arg("hash"), py::arg("columns"));
  module.def("read_one", read_one, py::arg("spec"), py::arg("closed"));
  module.def("write_zones", write_zones, py::arg("path"), py::arg("zones"));
  module.def("write_one", write_one, py::arg("path"), py::arg("curve").noconvert(), py::arg("format"));
}

}  // namespace lober::python
