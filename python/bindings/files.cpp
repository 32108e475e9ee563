#include "lober/curve/files.hpp"

#include "lober/base/error.hpp"
#include "lober/base/version.hpp"
#include "lober/curve/formats.hpp"
#include "lober/curve/periods.hpp"

#include <pybind11/stl.h>

#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

// Format, SHA-256, and of each zone its title and points.
py::tuple read_zones(const std::string& path, bool hash, const std::string& columns) {
  CurveFile file = long_call(0, [&] { return read_curves(path, {.hash = hash, .columns = columns}); });
  py::list zones;
  for (Zone& zone : file.zones) zones.append(py::make_tuple(py::bytes(zone.title), array_of(std::move(zone.points))));
  return py::make_tuple(name(file.format), file.sha256, zones);
}

// The points, and a warning, which is nearly always empty.
py::tuple read_one(const std::string& spec, bool closed, double period_x, double period_y,
                   const std::optional<Array>& near) {
  const Periods periods{period_x, period_y};
  const std::span<const Point> others = near ? points_of(*near) : std::span<const Point>();
  NamedCurve found = long_call(0, [&] {
    NamedCurve one = read_curve(spec, closed, {.hash = false, .periods = periods});
    if (!others.empty()) move_near(one.curve.points, others, periods);
    return one;
  });
  std::string warning = std::move(found.warning);
  if (!warning.empty()) {
    warning += found.curve.latitude_first.value_or(false) ? "; give periods=(None, 360)" : "; give periods=360";
  }
  return py::make_tuple(array_of(std::move(found.curve.points)), warning);
}

Format format_named(const std::string& format) {
  std::string known;
  for (const FormatInfo& info : formats()) {
    if (info.name == format) return info.format;
    if (info.writes) known += (known.empty() ? "" : ", ") + std::string(info.name);
  }
  throw UsageError("no format is called " + format + "; those that are written are " + known);
}

using Notes = std::vector<std::pair<std::string, std::string>>;

// `format`: by its name, or empty for that of the ending.
void write_zones(const std::string& path, const std::vector<std::pair<std::string, Array>>& zones,
                 const std::string& format, bool closed, const Notes& notes) {
  std::vector<Zone> copies;
  for (const auto& [title, array] : zones) {
    const std::span<const Point> points = points_of(array);
    copies.push_back({title, {points.begin(), points.end()}, 1});
  }
  WriteOptions options{.closed = closed};
  if (!format.empty()) options.format = format_named(format);
  // Tables of text have no comments unless they are asked for: not every reader expects them.
  const std::optional<Format> known = options.format ? options.format : format_of_name(path);
  if (!notes.empty() || (known != Format::csv && known != Format::text)) {
    options.provenance.emplace_back("lober", std::string(version()));
  }
  options.provenance.insert(options.provenance.end(), notes.begin(), notes.end());
  const py::gil_scoped_release released;
  write_curves(path, copies, options);
}

// Name, meaning, endings, whether it is read, written, and takes several curves, the library, and why that is missing.
py::list list_formats() {
  py::list all;
  for (const FormatInfo& info : formats()) {
    all.append(py::make_tuple(info.name, info.meaning, info.suffixes, info.reads, info.writes, info.takes_several,
                              info.library, info.missing));
  }
  return all;
}

}  // namespace

void bind_files(py::module_& module) {
  module.def("read_zones", read_zones, py::arg("path"), py::arg("hash"), py::arg("columns"));
  module.def("read_one", read_one, py::arg("spec"), py::arg("closed"), py::arg("period_x"), py::arg("period_y"),
             py::arg("near"));
  module.def("write_zones", write_zones, py::arg("path"), py::arg("zones"), py::arg("format"), py::arg("closed"),
             py::arg("notes"));
  module.def("list_formats", list_formats);
}

}  // namespace lober::python
