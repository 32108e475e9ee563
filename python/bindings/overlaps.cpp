// Many curves against many.
#include <pybind11/stl.h>

#include "lober/overlay/overlap_matrix.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/keywords.hpp"
#include "python/bindings/module.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

using Offsets = py::array_t<std::int64_t, py::array::c_style>;

// Curve k are the points from offsets[k] to offsets[k + 1]; what follows relies on that, so it is looked at here.
std::vector<CurveView> curves_of(const Array& points, const Offsets& offsets, const char* name) {
  const std::span<const Point> all = points_of(points);
  if (offsets.ndim() != 1 || offsets.size() == 0) {
    throw UsageError(std::string(name) + ": offsets are a vector with a number more than there are curves");
  }
  const std::span<const std::int64_t> begin(offsets.data(), static_cast<std::size_t>(offsets.size()));
  if (begin.front() < 0 || begin.back() > std::ssize(all)) {
    throw UsageError(std::string(name) + ": offsets go from 0 to the number of points, " + std::to_string(all.size()));
  }
  std::vector<CurveView> curves;
  curves.reserve(begin.size() - 1);
  for (std::size_t k = 0; k + 1 < begin.size(); ++k) {
    if (begin[k] > begin[k + 1]) {
      throw UsageError(std::string(name) + ": offset " + std::to_string(k + 1) + " is less than the one before it");
    }
    curves.push_back(
        {all.subspan(static_cast<std::size_t>(begin[k]), static_cast<std::size_t>(begin[k + 1] - begin[k]))});
  }
  return curves;
}

py::array matrix_array(std::vector<double>&& values, std::size_t rows, std::size_t columns) {
  return array_of(std::move(values)).reshape({rows, columns});
}

// The values of each measure, and the bounds if asked for: matrices if `dense`, else a number for each entry.
py::dict numbers_of(OverlapMatrix& found, bool dense, bool bounds) {
  py::dict numbers;
  for (std::size_t m = 0; m < found.numbers.size(); ++m) {
    OverlapMatrix::Numbers& of = found.numbers[m];
    const std::string key(name(of.measure));
    py::object values, errors = py::none();
    if (dense) {
      values = matrix_array(found.dense(m), found.rows, found.columns);
      if (bounds) errors = matrix_array(found.dense_bounds(m), found.rows, found.columns);
    } else {
      values = array_of(std::move(of.values));
      if (bounds && !is_count(of.measure)) errors = array_of(std::move(of.bounds));
    }
    numbers[key.c_str()] = py::make_tuple(values, errors);
  }
  return numbers;
}

// (numbers, begin, column, number of pairs overlaid, messages of failures). Besides OverlapOptions: whether matrices
// are dense and have bounds, and threads.
py::tuple matrix(const Array& points1, const Offsets& offsets1, const std::optional<Array>& points2,
                 const std::optional<Offsets>& offsets2, const py::object& progress, const py::kwargs& given) {
  const ProgressCallback callback(progress);
  OverlapOptions options;
  bool dense = true, bounds = false;
  int threads = 0;
  Keywords(given)
      .take_as<std::vector<std::string>>("measures",
                                         [&](const auto& names) {
                                           options.measures.clear();
                                           for (const std::string& measure : names) {
                                             options.measures.push_back(overlap_measure(measure));
                                           }
                                         })
      .take("check_simple", options.check_simple)
      .take("keep_going", options.keep_going)
      .take("dense", dense)
      .take("bounds", bounds)
      .take("threads", threads)
      .end();
  if (callback.given()) options.progress = [&](double fraction) { return callback(fraction); };
  const std::vector<CurveView> first = curves_of(points1, offsets1, "curves_a");
  std::vector<CurveView> second;
  if (points2) second = curves_of(*points2, *offsets2, "curves_b");
  OverlapMatrix found = long_call(
      threads, [&] { return points2 ? overlap_matrix(first, second, options) : overlap_matrix(first, options); });
  std::vector<std::string> failures;
  for (const OverlapMatrix::Failure& failure : found.failures) failures.push_back(failure.message);
  const py::dict numbers = numbers_of(found, dense, bounds);
  std::vector<std::int64_t> begin(found.begin.begin(), found.begin.end());
  return py::make_tuple(numbers, array_of(std::move(begin)), array_of(std::move(found.column)), found.pairs, failures);
}

std::vector<std::string> measure_names() {
  std::vector<std::string> names;
  for (const OverlapMeasure measure : all_overlap_measures) names.emplace_back(name(measure));
  return names;
}

}  // namespace

void bind_overlaps(py::module_& module) {
  module.def("overlap_matrix", matrix, py::arg("points1").noconvert(), py::arg("offsets1").noconvert(),
             py::arg("points2").noconvert(), py::arg("offsets2").noconvert(), py::arg("progress"));
  module.def("overlap_measures", measure_names);
}

}  // namespace lober::python
