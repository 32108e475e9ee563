// Winding numbers of a curve about points.
#include <cmath>
#include <map>
#include <numbers>

#include "engine/base/text.hpp"
#include "engine/operations/curve_of.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/table.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

constexpr std::size_t block_points = std::size_t{1} << 18;  // between two reports of progress

// One of the points.
struct PointWinding {
  const CurveWinding* all;
  std::size_t k;
};
struct PointWindings {
  const CurveWinding* all;
  [[nodiscard]] std::size_t size() const { return all->points.size(); }
  PointWinding operator[](std::size_t k) const { return {all, k}; }
};

std::vector<Field> winding_fields() {
  Schema<CurveWinding::Count> count;
  count.field("winding", "", "a winding number", &CurveWinding::Count::winding)
      .field("points", "", "number of points that have this winding number", &CurveWinding::Count::points);
  Schema<PointWinding> point;
  point.field("x", "length", "x of the point", [](const PointWinding& p) { return p.all->points[p.k].x; })
      .field("y", "length", "y of the point", [](const PointWinding& p) { return p.all->points[p.k].y; })
      .field("winding", "", "number of turns of the curve round the point, counter-clockwise positive; 0 on the curve",
             [](const PointWinding& p) { return p.all->windings[p.k].number; })
      .field("on", "", "whether the point lies on the curve",
             [](const PointWinding& p) { return p.all->windings[p.k].on; })
      .field("j", "", "J, 2 pi times the winding number; on the curve the principal value",
             [](const PointWinding& p) { return p.all->values[p.k].j; });
  Schema<CurveWinding> error;
  error
      .field("consistency", "", "largest |J / 2 pi - winding number| of the points that are not on the curve",
             &CurveWinding::difference)
      .field("bar", "", "bound on the part that rounding of J explains", &CurveWinding::bar);
  Schema<CurveWinding> made;
  made.list("counts", "winding numbers of points that are not on the curve, ascending", count, &CurveWinding::counts)
      .field("on", "", "number of points on the curve", &CurveWinding::on)
      .list("points", "points in the given order", point, [](const CurveWinding& w) { return PointWindings{&w}; })
      .object("error", "error of J", error, [](const CurveWinding& w) { return &w; });
  return made.fields();
}

void count(CurveWinding& found) {
  std::map<int, std::size_t> counts;
  for (const Winding& one : found.windings) {
    if (one.on) {
      ++found.on;
    } else {
      ++counts[one.number];
    }
  }
  for (const auto& [winding, points] : counts) found.counts.push_back({winding, points});
}

// J comes from angles and the winding number from crossings of a ray: two routes. A curve has at most as many angles as
// segments, each right to 2^-51 of a turn (lober/interior.hpp).
void compare_with_turns(CurveWinding& found, std::size_t vertices) {
  found.bar = std::ldexp(static_cast<double>(vertices + 8), -51);
  for (std::size_t k = 0; k < found.points.size(); ++k) {
    if (found.windings[k].on) continue;
    const double turns = found.values[k].j / (2 * std::numbers::pi), number = found.windings[k].number;
    const double difference = std::fabs(turns - number);
    found.difference = std::max(found.difference, difference);
    if (difference <= found.bar) continue;
    const Point at = found.points[k];
    found.agreement.compare(
        {"the winding number about (" + format_rounded(at.x, 6) + ", " + format_rounded(at.y, 6) + ")",
         "crossings of a ray", "J", number, turns, found.bar});
  }
}

Outcome run_winding(std::span<const Input> inputs, const Options& options, const Context& context) {
  const Operation& operation = named("winding");
  const IndexedCurve curve = indexed_curve(operation, inputs, 0);
  CurveWinding found;
  found.points = points_at(operation, inputs, 1);
  const std::size_t size = found.points.size();
  found.windings.reserve(size);
  found.values.reserve(size);
  for (std::size_t begin = 0; begin < size; begin += block_points) {
    const auto block = found.points.subspan(begin, std::min(block_points, size - begin));
    const std::vector<Winding> numbers = windings(curve, block);
    const std::vector<InteriorValue> values = interior_function(curve, block);
    found.windings.insert(found.windings.end(), numbers.begin(), numbers.end());
    found.values.insert(found.values.end(), values.begin(), values.end());
    if (!context.progress(static_cast<double>(found.values.size()) / static_cast<double>(size), {})) throw Cancelled();
  }
  count(found);
  compare_with_turns(found, curve.view().points.size());
  return outcome_of(std::move(found), options);
}

}  // namespace

Operation winding_operation() {
  Operation operation;
  operation.name = "winding";
  operation.title = "winding numbers and J of a closed curve about points";
  operation.summary =
      "Computes how often a closed curve, which may cross itself, winds round points, and the interior function J.";
  operation.inputs = {{"curve", InputKind::closed_curve, "a closed curve, which may cross itself"},
                      {"points", InputKind::points, "the points"}};
  operation.result = winding_fields();
  operation.examples = {{{"examples/resonance.dat", "0,0"}, {}, "about the origin"}};
  operation.run = run_winding;
  return operation;
}

}  // namespace lober::detail::table
