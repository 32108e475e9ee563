#include "lober/densify.hpp"

#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

Interpolation interpolation_of(const std::string& name) {
  for (const Interpolation known : {Interpolation::linear, Interpolation::dritschel, Interpolation::spline}) {
    if (name == lober::name(known)) return known;
  }
  throw UsageError("\"" + name + "\" is not an interpolation; there are linear, dritschel, spline");
}

// Points, and a list of (first segment, number of segments, cause).
py::tuple result_of(DensifiedCurve&& curve) {
  py::list diagnostics;
  for (const Diagnostic& diagnostic : curve.diagnostics) {
    diagnostics.append(py::make_tuple(diagnostic.first, diagnostic.count, name(diagnostic.cause)));
  }
  return py::make_tuple(array_of(std::move(curve.points)), diagnostics);
}

py::tuple refine(const Array& curve, bool closed, double max_length, double angle, double distance_angle,
                 double min_length, const std::string& interpolation, std::size_t max_points, int threads) {
  const CurveView view{points_of(curve), closed};
  const Criteria criteria{
      .max_length = max_length, .angle = angle, .distance_angle = distance_angle, .min_length = min_length};
  DensifyOptions options;
  options.interpolation = interpolation_of(interpolation);
  options.max_points = max_points;
  return result_of(long_call(threads, [&] { return densify(view, criteria, options); }));
}

py::tuple refine_near(const Array& curve, bool closed, const Array& other, bool other_closed, int passes, int points,
                      const std::string& interpolation, std::size_t max_points, int threads) {
  const CurveView view{points_of(curve), closed}, beside{points_of(other), other_closed};
  NearOptions options;
  options.passes = passes;
  options.points = points;
  options.interpolation = interpolation_of(interpolation);
  options.max_points = max_points;
  return result_of(long_call(threads, [&] { return densify_near(view, beside, options); }));
}

py::tuple hobson(const Array& curve, bool closed) {
  const CurveView view{points_of(curve), closed};
  const Criteria criteria = long_call(0, [&] { return hobson_criteria(view); });
  return py::make_tuple(criteria.max_length, criteria.angle, criteria.distance_angle, criteria.min_length);
}

py::array coarsen(const Array& curve, bool closed, double tolerance, double max_length, int threads) {
  const CurveView view{points_of(curve), closed};
  const SimplifyOptions options{.tolerance = tolerance, .max_length = max_length};
  return array_of(long_call(threads, [&] { return simplify(view, options); }).points);
}

double area_of(const Array& curve) {
  const CurveView view{points_of(curve), true};
  return long_call(0, [&] {
    validate(view, "curve");
    return signed_area(view);
  });
}

}  // namespace

void bind_densify(py::module_& module) {
  module.def("densify", refine, py::arg("curve").noconvert(), py::arg("closed"), py::arg("max_length"),
             py::arg("angle"), py::arg("distance_angle"), py::arg("min_length"), py::arg("interpolation"),
             py::arg("max_points"), py::arg("threads"));
  module.def("densify_near", refine_near, py::arg("curve").noconvert(), py::arg("closed"), py::arg("other").noconvert(),
             py::arg("other_closed"), py::arg("passes"), py::arg("points"), py::arg("interpolation"),
             py::arg("max_points"), py::arg("threads"));
  module.def("hobson_criteria", hobson, py::arg("curve").noconvert(), py::arg("closed"));
  module.def("simplify", coarsen, py::arg("curve").noconvert(), py::arg("closed"), py::arg("tolerance"),
             py::arg("max_length"), py::arg("threads"));
  module.def("signed_area", area_of, py::arg("curve").noconvert());
}

}  // namespace lober::python
