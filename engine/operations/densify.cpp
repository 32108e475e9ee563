// More points on a curve, or fewer.
#include "lober/curve/densify.hpp"

#include <algorithm>
#include <cmath>

#include "engine/operations/curve_of.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/table.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

// A point that comes out and, while it is made, its criteria.
constexpr std::size_t bytes_per_new_point = 2 * sizeof(Point);

struct DensifyHow {
  bool closed = true, closed_against = true, hobson = false, crossings = false;
  std::optional<double> simplify{}, max_length{}, angle{}, distance_angle{}, min_length{};
  int passes = 0, points = 0;
  std::optional<Interpolation> interpolation{};
  std::size_t max_points = DensifyOptions{}.max_points;

  [[nodiscard]] bool has_angles() const { return hobson || angle || distance_angle; }
  [[nodiscard]] bool is_near() const { return passes > 0 || crossings; }
};

const OptionList<DensifyHow>& densify_options() {
  using How = DensifyHow;
  static const OptionList<How> options = [] {
    OptionList<How> list;
    list.option("closed", &How::closed, "whether to join the last vertex of the curve to the first")
        .option("closed_against", &How::closed_against,
                "whether to join the last vertex of the other curve to the first")
        .option(
            "simplify", &How::simplify,
            "maximum distance of a removed vertex from the curve that remains, in units of the coordinates; vertices "
            "are removed before all other steps",
            {.min = 0, .otherwise = "no vertex is removed", .value = "LENGTH"})
        .option(
            "max_length", &How::max_length,
            "maximum length of a segment (tau), in units of the coordinates; longer segments are split, and none is "
            "made by the removal of vertices",
            {.min = 0, .above_min = true, .otherwise = "no maximum", .value = "LENGTH"})
        .option("hobson", &How::hobson,
                "whether to use the angle criteria of Hobson and of Mancho et al., with limits relative to the size of "
                "the curve, which is the longer side of its bounding box")
        .option("angle", &How::angle, "maximum angle between consecutive segments, in radians",
                {.min = 0, .above_min = true, .otherwise = "no maximum; with hobson 0.3", .value = "ANGLE"})
        .option(
            "distance_angle", &How::distance_angle,
            "maximum product of the length of a segment and the angles at its ends, in units of the coordinates",
            {.min = 0, .above_min = true, .otherwise = "no maximum; with hobson 1e-3 of the size", .value = "LENGTH"})
        .option(
            "min_length", &How::min_length,
            "minimum length of a segment (delta), in units of the coordinates; no segment is split into shorter ones",
            {.min = 0, .otherwise = "0; with angle criteria 1e-6 of the size", .value = "LENGTH"})
        .option("passes", &How::passes, "number of passes that refine the curve where it meets the other one",
                {.min = 0, .max = 64, .value = "P"})
        .option("points", &How::points,
                "number of points that each pass inserts into a segment that meets the other curve",
                {.min = 0, .max = 1'000'000, .value = "N"})
        .option("crossings", &How::crossings, "whether to insert a vertex wherever the curves meet")
        .choice("interpolation", &How::interpolation, all_interpolations, "interpolation between the vertices",
                "linear; with angle criteria dritschel")
        .option("max_points", &How::max_points, "maximum number of points of the result",
                {.min = 1, .max = 2'147'483'647, .value = "N"});
    return list;
  }();
  return options;
}

struct SimplifyHow : SimplifyOptions {
  bool closed = true;
  std::optional<double> tolerance_given{}, max_length_given{};
};

const OptionList<SimplifyHow>& simplify_options() {
  static const OptionList<SimplifyHow> options = [] {
    OptionList<SimplifyHow> list;
    list.option("tolerance", &SimplifyHow::tolerance_given,
                "maximum distance of a removed vertex from the curve that remains, in units of the coordinates",
                {.min = 0, .value = "LENGTH"})
        .option("max_length", &SimplifyHow::max_length_given,
                "maximum length of new segments, in units of the coordinates",
                {.min = 0, .above_min = true, .otherwise = "no maximum", .value = "LENGTH"})
        .option("closed", &SimplifyHow::closed, "whether to join the last vertex of the curve to the first");
    return list;
  }();
  return options;
}

// ---------------------------------------------------------------------------------------------------------- result

template <typename Curve>
Schema<Curve> size_schema() {
  Schema<Curve> made;
  made.field("points", "", "number of points", [](const Curve& c) { return c.points.size(); })
      .field("closed", "", "whether the last point is joined to the first one", &Curve::closed);
  return made;
}

Schema<RefinedCurve> diagnostics() {
  Schema<RefinedCurve> counts;
  for (const DiagnosticCause cause : all_diagnostic_causes) {
    counts.field(std::string(name(cause)), "", "number of places", [cause](const RefinedCurve& c) {
      const std::size_t places = c.places[static_cast<std::size_t>(cause)];
      return places > 0 ? std::optional(places) : std::nullopt;
    });
  }
  Schema<Diagnostic> one;
  one.field("segment", "", "number of the first segment, from 0", &Diagnostic::first)
      .field("count", "", "number of segments, at least one of which breaks a criterion", &Diagnostic::count)
      .field("cause", "", "min_length, corner, max_points or max_rounds",
             [](const Diagnostic& d) { return std::string(name(d.cause)); });
  Schema<RefinedCurve> made;
  made.object("counts", "number of places by cause, for each cause that occurs", counts,
              [](const RefinedCurve& c) { return &c; })
      .field("segments", "", "number of segments in all places", &RefinedCurve::segments_with_diagnostics)
      .list("list", "places in order along the result; empty where a later step has changed the numbers of segments",
            one, [](const RefinedCurve& c) -> const std::vector<Diagnostic>& { return c.diagnostics; });
  return made;
}

std::vector<Point> copied(const Buffer<Point>& points) {
  return {points.begin(), points.end()};
}

Schema<RefinedCurve> result_schema() {
  Schema<RefinedCurve> made;
  made.field("given", "", "number of points of the curve given", &RefinedCurve::given)
      .object("result", "the resulting curve", size_schema<RefinedCurve>(), [](const RefinedCurve& c) { return &c; })
      .field("signed_area", "area",
             "signed area, positive for a counter-clockwise curve; for an open one that of the "
             "polygon that its ends close",
             [](const RefinedCurve& c) {
               return signed_area(CurveView{c.points, true});
             })
      .field("points", "length", "points of the result", [](const RefinedCurve& c) { return copied(c.points); });
  return made;
}

std::vector<Field> densify_fields() {
  using Step = RefinedCurve::Step;
  Schema<Step> step;
  step.field("step", "", "simplify, criteria, passes or crossings", &Step::name)
      .field("points", "", "number of points after the step", &Step::points)
      .field("rounds", "", "number of rounds in which points were inserted or removed", &Step::rounds);
  Schema<RefinedCurve> made;
  made.list("steps", "the steps in order", step, &RefinedCurve::steps)
      .field("rounds", "", "number of rounds of all steps",
             [](const RefinedCurve& c) {
               std::size_t sum = 0;
               for (const Step& one : c.steps) sum += one.rounds;
               return sum;
             })
      .parts(result_schema(), [](const RefinedCurve& c) { return &c; })
      .object("against", "the other curve with the crossings inserted", size_schema<DensifiedCurve>(),
              [](const RefinedCurve& c) { return c.against ? &*c.against : nullptr; })
      .if_asked_for()
      .field("against_points", "length", "points of the other curve; none where no crossings were inserted",
             [](const RefinedCurve& c) { return c.against ? copied(c.against->points) : std::vector<Point>(); })
      .object("diagnostics", "segments that do not meet the criteria", diagnostics(),
              [](const RefinedCurve& c) { return &c; });
  return made.fields();
}

// ------------------------------------------------------------------------------------------------------------- run

// The criteria, missing ones taken from the size of the curve.
std::optional<Criteria> criteria_for(const DensifyHow& how, CurveView curve) {
  if (!how.has_angles() && !how.max_length) return std::nullopt;
  const Criteria usual = hobson_criteria(curve);
  Criteria criteria{how.max_length.value_or(Criteria::off),
                    how.angle.value_or(how.hobson ? usual.angle : Criteria::off),
                    how.distance_angle.value_or(how.hobson ? usual.distance_angle : Criteria::off),
                    how.min_length.value_or(how.has_angles() ? usual.min_length : 0)};
  return criteria;
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

// The largest number of points that there may be, by the option and by the memory.
class PointLimit {
 public:
  PointLimit(const DensifyHow& how, const Context& context)
      : context_(context),
        by_memory_(std::min<std::size_t>(context.memory / bytes_per_new_point, 1'000'000'000)),
        most_(std::min(how.max_points, by_memory_)) {}

  [[nodiscard]] std::size_t most() const { return most_; }
  void require(double points) const {
    if (most_ < by_memory_ || points <= static_cast<double>(by_memory_)) return;
    throw DataError("the criteria ask for more than " + std::to_string(by_memory_) +
                    " points, the number that there is memory for; give larger criteria");
  }
  void holds(double points) const {
    if (context_.holds) context_.holds(bytes_per_new_point * static_cast<std::size_t>(points));
  }

 private:
  const Context& context_;
  std::size_t by_memory_, most_;
};

// Else the curve would come back as it was given.
void require_step(const DensifyHow& how) {
  const bool is_step = how.is_near() || how.has_angles() || how.max_length || how.simplify;
  if (is_step || how.min_length) return;  // which is refused for its own reason
  throw UsageError(
      "no step is given; give option \"simplify\", option \"max_length\", option \"hobson\", option \"angle\", option "
      "\"distance_angle\", option \"passes\" or option \"crossings\"");
}

void check(const DensifyHow& how, bool has_other) {
  if (how.is_near() && !has_other) {
    throw UsageError("option \"passes\" and option \"crossings\" need a second curve");
  }
  if (how.passes > 0 && how.points == 0) throw UsageError("option \"passes\" needs option \"points\"");
  if (how.min_length && !how.has_angles() && !how.max_length) {
    throw UsageError("option \"min_length\" needs option \"max_length\", \"hobson\", \"angle\" or \"distance_angle\"");
  }
}

// Why criteria are not met that a limit could have left unmet; those of the shortest length and of corners are what the
// caller asked for.
std::string unmet(const RefinedCurve& found) {
  const auto has = [&](DiagnosticCause cause) { return found.places[static_cast<std::size_t>(cause)] > 0; };
  const std::string count =
      "the curve has " + std::to_string(found.points.size()) + " points and does not meet the criteria";
  if (has(DiagnosticCause::max_points)) {
    return count + ", since max_points allows no more; give a larger max_points";
  }
  if (has(DiagnosticCause::max_rounds)) return count + " after all rounds; give a larger min_length";
  return {};
}

Outcome run_densify(std::span<const Input> inputs, const Options& options, const Context& context) {
  const Operation& operation = named("densify");
  const DensifyHow how = densify_options().how(options);
  check(how, inputs.size() > 1);
  const CurveView given = curve_at(operation, inputs, 0, how.closed);
  const CurveView other = how.is_near() ? curve_at(operation, inputs, 1, how.closed_against) : CurveView{};
  RefinedCurve found;
  found.given = given.points.size();
  found.points.assign(given.points.begin(), given.points.end());
  found.closed = given.closed;
  const int steps = (how.simplify ? 1 : 0) + (how.passes > 0 ? 1 : 0) + (how.crossings ? 1 : 0) + 1;
  const auto done = [&](const char* step, DensifiedCurve&& curve) {
    static_cast<DensifiedCurve&>(found) = std::move(curve);
    found.steps.push_back({step, found.points.size(), found.rounds});
    const double fraction = std::min(1.0, static_cast<double>(found.steps.size()) / steps);
    if (!context.progress(fraction, {})) throw Cancelled();
  };
  if (how.simplify) done("simplify", simplify(found, {*how.simplify, how.max_length.value_or(Criteria::off)}));
  const PointLimit limit(how, context);
  const Interpolation interpolation =
      how.interpolation.value_or(how.has_angles() ? Interpolation::dritschel : Interpolation::linear);
  std::vector<OptionSetting> chosen{{"interpolation", std::string(name(interpolation))}};
  if (const auto criteria = criteria_for(how, found)) {
    const double expected = expected_points(found, *criteria);
    limit.require(expected);
    limit.holds(std::min(expected, static_cast<double>(limit.most())));
    done("criteria", densify(found, *criteria, {interpolation, limit.most()}));
    limit.holds(static_cast<double>(found.points.size()));
    for (const Diagnostic& diagnostic : found.diagnostics) {
      if (diagnostic.cause == DiagnosticCause::max_points) limit.require(Criteria::off);
      ++found.places[static_cast<std::size_t>(diagnostic.cause)];
      found.segments_with_diagnostics += diagnostic.count;
    }
    if (std::isfinite(criteria->angle)) chosen.push_back({"angle", criteria->angle});
    if (std::isfinite(criteria->distance_angle)) chosen.push_back({"distance_angle", criteria->distance_angle});
    chosen.push_back({"min_length", criteria->min_length});
  }
  if (how.passes > 0) {
    done("passes", densify_near(found, other, {how.passes, how.points, interpolation, limit.most()}));
  }
  if (how.crossings) {
    auto [curve, against] = insert_crossings(found, other);
    done("crossings", std::move(curve));
    found.against = std::move(against);
  }
  std::string incomplete = unmet(found);
  Outcome outcome = outcome_of(std::move(found), options);
  outcome.incomplete = std::move(incomplete);
  outcome.chosen = std::move(chosen);
  return outcome;
}

Outcome run_simplify(std::span<const Input> inputs, const Options& options, const Context&) {
  const Operation& operation = named("simplify");
  SimplifyHow how = simplify_options().how(options);
  how.tolerance = *how.tolerance_given;
  if (how.max_length_given) how.max_length = *how.max_length_given;
  const CurveView given = curve_at(operation, inputs, 0, how.closed);
  RefinedCurve found{simplify(given, how)};
  found.given = given.points.size();
  return outcome_of(std::move(found), options);
}

double result_bytes(const Input& first, const Options& options) {
  const DensifyHow how = densify_options().how(options);
  const std::array<Input, 1> one{first};
  const CurveView curve = curve_at(named("densify"), one, 0, how.closed);
  const auto criteria = criteria_for(how, curve);
  return criteria ? static_cast<double>(bytes_per_new_point) * expected_points(curve, *criteria) : 0;
}

}  // namespace

Operation densify_operation() {
  Operation operation;
  operation.name = "densify";
  operation.title = "insertion of points into a curve, or removal";
  operation.summary =
      "Inserts points into a curve, or removes them: first simplify, then the criteria (max_length, hobson, angle, "
      "distance_angle), then passes, then crossings.";
  operation.compares = false;
  operation.inputs = {{"curve", InputKind::curve, "a curve"},
                      {"against", InputKind::curve, "another curve, for passes and crossings", true}};
  operation.options = densify_options().specs();
  operation.result = densify_fields();
  operation.examples = {{{"examples/resonance.dat"}, {{"max_length", 0.01}}, "no segment is longer than 0.01"},
                        {{"examples/resonance.dat", "examples/resonance_image.dat"},
                         {{"crossings", true}},
                         "with a vertex wherever the other curve meets it"}};
  operation.check = [](const Options& options, std::size_t) { require_step(densify_options().how(options)); };
  operation.result_bytes = result_bytes;
  operation.run = run_densify;
  return operation;
}

Operation simplify_operation() {
  Operation operation;
  operation.name = "simplify";
  operation.title = "removal of points from a curve";
  operation.summary = "Removes vertices of a curve, so that it stays within a tolerance of the given one.";
  operation.compares = false;
  operation.inputs = {{"curve", InputKind::curve, "a curve"}};
  operation.options = simplify_options().specs();
  operation.result = result_schema().fields();
  operation.examples = {{{"examples/resonance.dat"}, {{"tolerance", 1e-6}}, "nothing moves by more than 1e-6"},
                        {{"examples/manifolds.dat#0"}, {{"tolerance", 1e-4}, {"closed", false}}, "an open curve"}};
  operation.run = run_simplify;
  return operation;
}

}  // namespace lober::detail::table
