#include "python/bindings/areas.hpp"

#include "lober/base/error.hpp"
#include "lober/overlay/areas.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/keywords.hpp"

namespace py = pybind11;

namespace lober::python {

void bind_areas(py::module_& module) {
  py::class_<Areas>(module, "Areas", "The areas that two closed curves make, in squared units of the coordinates.")
      .def_readonly("c1", &Areas::c1)
      .def_readonly("c2", &Areas::c2)
      .def_readonly("intersection", &Areas::intersection)
      .def_readonly("union", &Areas::union_)
      .def_readonly("c1_minus_c2", &Areas::c1_minus_c2)
      .def_readonly("c2_minus_c1", &Areas::c2_minus_c1)
      .def_readonly("symmetric_difference", &Areas::symmetric_difference);
  module.def("areas_of", [](const py::kwargs& given) {
    Areas areas;
    Keywords(given)
        .take("c1", areas.c1)
        .take("c2", areas.c2)
        .take("intersection", areas.intersection)
        .take("union", areas.union_)
        .take("c1_minus_c2", areas.c1_minus_c2)
        .take("c2_minus_c1", areas.c2_minus_c1)
        .take("symmetric_difference", areas.symmetric_difference)
        .end();
    return areas;
  });
  module.def(
      "signed_area",
      [](const Array& curve) {
        const CurveView view{points_of(curve), true};
        return long_call(0, [&] {
          validate(view, "curve");
          return signed_area(view);
        });
      },
      py::arg("curve").noconvert());
}

Pairing pairing_of(const std::string& name) {
  std::string known;
  for (const Pairing pairing : all_pairings) {
    if (name == lober::name(pairing)) return pairing;
    known += (known.empty() ? "" : ", ") + std::string(lober::name(pairing));
  }
  throw UsageError("\"" + name + "\" is not a pairing; there are " + known);
}

}  // namespace lober::python
