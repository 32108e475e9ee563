// `densify`: more points on a curve, or fewer, in the steps and with the options of `lober densify`.
#include "lober/densify.hpp"
#include "lober/files.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/batch/operations/output_folder.hpp"
#include "engine/batch/operations/output_name.hpp"
#include "engine/batch/operations/table.hpp"

namespace lober::detail {
namespace {

// 0 stands for "not given" where the command line has no option.
double or_off(double value) {
  return value > 0 ? value : Criteria::off;
}

bool has_angles(const Options& options) {
  return options.flag("hobson") || options.real("alpha") > 0 || options.real("distance_angle") > 0;
}

std::optional<Criteria> criteria_for(const Options& options, CurveView curve) {
  if (!has_angles(options) && options.real("max_length") == 0) return std::nullopt;
  Criteria criteria{or_off(options.real("max_length")), or_off(options.real("alpha")),
                    or_off(options.real("distance_angle")), std::max(options.real("min_length"), 0.0)};
  const Criteria usual = hobson_criteria(curve);
  if (options.flag("hobson") && options.real("alpha") == 0) criteria.angle = usual.angle;
  if (options.flag("hobson") && options.real("distance_angle") == 0) criteria.distance_angle = usual.distance_angle;
  if (has_angles(options) && options.real("min_length") < 0) criteria.min_length = usual.min_length;
  return criteria;
}

Interpolation interpolation_of(const Options& options) {
  for (const Interpolation kind : {Interpolation::linear, Interpolation::dritschel, Interpolation::spline}) {
    if (name(kind) == options.text("interpolation")) return kind;
  }
  return has_angles(options) ? Interpolation::dritschel : Interpolation::linear;
}

// How many points the distance criterion alone asks for.
double expected_points(CurveView curve, const Criteria& criteria) {
  double points = static_cast<double>(curve.points.size());
  for (std::size_t k = 0; k < curve.segments(); ++k) {
    const Point a = curve.points[k], b = curve.points[k + 1 < curve.points.size() ? k + 1 : 0];
    points += std::hypot(b.x - a.x, b.y - a.y) / criteria.max_length;
  }
  return points;
}

void require_memory(double points, std::size_t most) {
  if (points <= static_cast<double>(most)) return;
  throw DataError("the criteria ask for more than " + std::to_string(most) + " points, as many as there is memory for");
}

// A point that comes out and, while it is made, its criteria.
constexpr std::size_t bytes_per_new_point = 2 * sizeof(Point);

double result_bytes(const Curve& curve, const Options& options) {
  const auto criteria = criteria_for(options, curve);
  return criteria ? static_cast<double>(bytes_per_new_point) * expected_points(curve, *criteria) : 0;
}

Result run_densify(JobCurves curves, const Options& options) {
  const PreparedCurve& first = *curves[0];
  const PreparedCurve* const second = curves.size() > 1 ? curves[1] : nullptr;
  const bool near = options.whole("passes") > 0 || options.flag("crossings");
  if (near && second == nullptr) throw UsageError("passes and crossings need a second curve, see pairs");
  if (options.whole("passes") > 0 && options.whole("points") == 0) throw UsageError("passes needs points");
  const Interpolation interpolation = interpolation_of(options);
  DensifiedCurve result;
  std::size_t with_diagnostic = 0, rounds = 0;
  result.points.assign(first.curve().points.begin(), first.curve().points.end());
  result.closed = first.curve().closed;
  const auto done = [&](DensifiedCurve&& curve) {
    result = std::move(curve);
    rounds += result.rounds;
    for (const Diagnostic& diagnostic : result.diagnostics) with_diagnostic += diagnostic.count;
  };
  if (options.real("simplify") > 0) {
    done(simplify(result, {options.real("simplify"), or_off(options.real("max_length"))}));
  }
  const Allowance& allowance = curves.allowance();
  const std::size_t most = std::min<std::size_t>(allowance.most() / bytes_per_new_point, 1'000'000'000);
  if (const auto criteria = criteria_for(options, result)) {
    require_memory(expected_points(result, *criteria), most);
    allowance.book(bytes_per_new_point * static_cast<std::size_t>(expected_points(result, *criteria)));
    done(densify(result, *criteria, {interpolation, most}));
    allowance.book(bytes_per_new_point * result.points.size());
    for (const Diagnostic& diagnostic : result.diagnostics) {
      if (diagnostic.cause == DiagnosticCause::max_points) require_memory(INFINITY, most);
    }
  }
  if (options.whole("passes") > 0) {
    done(densify_near(
        result, second->curve(),
        {static_cast<int>(options.whole("passes")), static_cast<int>(options.whole("points")), interpolation, most}));
  }
  if (options.flag("crossings")) done(std::move(insert_crossings(result, second->curve())[0]));
  if (const std::string& pattern = options.text("output"); !pattern.empty()) {
    const std::string name =
        output_name(pattern, options, first.curve().name, second != nullptr ? second->curve().name : "");
    write_npy(curves.outputs() != nullptr ? curves.outputs()->accept(name) : name, result.points);
  }
  const auto number = [](std::size_t count) { return static_cast<double>(count); };
  return {{signed_area(result), number(first.curve().points.size()), number(result.points.size()), number(rounds),
           number(with_diagnostic)},
          {}};
}

}  // namespace

Operation densify_operation() {
  Operation operation;
  operation.name = "densify";
  operation.view = "densified";
  operation.arity = Arity::one_or_two;
  operation.summary =
      "insertion of points into a curve, or removal, in the steps and with the options of lober densify";
  operation.options = {
      {"simplify",
       0.0,
       "largest distance between the curve given and the one without the points removed; 0 removes none",
       {},
       0},
      {"max_length", 0.0, "largest length of a segment; 0 for no limit", {}, 0},
      {"hobson", false, "alpha and distance_angle of Hobson's criteria"},
      {"alpha", 0.0, "largest angle between segments, in radians; 0 for no limit", {}, 0},
      {"distance_angle", 0.0, "largest product of that angle and the length of a segment; 0 for no limit", {}, 0},
      {"min_length", -1.0,
       "no shorter segments; negative: 0, or with criteria on angles 1e-6 of the size of the curve"},
      {"passes", std::int64_t{0}, "number of passes that refine the first curve where it meets the second", {}, 0, 64},
      {"points",
       std::int64_t{0},
       "number of points that a pass inserts into a segment that meets the other curve",
       {},
       0,
       1'000'000},
      {"crossings", false, "insert a vertex wherever the curves meet"},
      {"interpolation",
       "auto",
       "the curve through the points; auto: dritschel with criteria on angles, else linear",
       {"auto", "linear", "dritschel", "spline"}},
      {"output", "",
       "file for the curve, in NPY, below the folder of the manifest; {name} and {second} stand for the names of the "
       "curves given, {max_length} and the like for options; empty: no file"}};
  operation.columns = {{"signed_area", Column::Kind::real},
                       {"points_in", Column::Kind::count},
                       {"points", Column::Kind::count},
                       {"rounds", Column::Kind::count},
                       {"segments_with_diagnostics", Column::Kind::count}};
  operation.requirements = [](const Options&) { return Requirements{}; };
  operation.run = run_densify;
  operation.result_bytes = result_bytes;
  operation.output = [](const Options& options, std::string_view first, std::string_view second) {
    return output_name(options.text("output"), options, first, second);
  };
  operation.cost = [](std::size_t points) { return 10 + 0.1 * static_cast<double>(points); };
  return operation;
}

}  // namespace lober::detail
