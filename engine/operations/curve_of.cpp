#include "engine/operations/curve_of.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lober/error.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

bool is_curve(InputKind kind) {
  return kind == InputKind::closed_curve || kind == InputKind::open_curve;
}

CurveInput curve_at(const Operation& operation, std::span<const Input> inputs, std::size_t k) {
  const auto* const curve = std::get_if<CurveInput>(&inputs[k]);
  CurveInput given = curve != nullptr ? *curve : CurveInput{{std::get<std::span<const Point>>(inputs[k])}};
  given.curve.closed = operation.inputs[k].kind == InputKind::closed_curve;
  if (given.name.empty()) given.name = operation.inputs[k].name;
  return given;
}

}  // namespace

void require_inputs(const Operation& operation, std::span<const Input> inputs) {
  const auto needed = static_cast<std::size_t>(std::count_if(operation.inputs.begin(), operation.inputs.end(),
                                                             [](const InputSpec& one) { return !one.optional; }));
  bool right = inputs.size() >= needed && inputs.size() <= operation.inputs.size();
  std::string wanted;
  for (std::size_t k = 0; k < operation.inputs.size(); ++k) {
    const InputSpec& spec = operation.inputs[k];
    wanted += (k == 0 ? "" : ", ") + spec.name + (spec.optional ? ", which may be left out" : "");
    if (!right || k >= inputs.size()) continue;
    const bool system = std::holds_alternative<SystemInput>(inputs[k]);
    right = spec.kind == InputKind::system ? system && std::get<SystemInput>(inputs[k]).system
                                           : !system && (is_curve(spec.kind) || inputs[k].index() == 2);
  }
  if (!right) throw UsageError(operation.name + " takes " + wanted + ", and nothing else");
}

IndexedCurve indexed_curve(const Operation& operation, std::span<const Input> inputs, std::size_t k) {
  const CurveInput given = curve_at(operation, inputs, k);
  if (given.index != nullptr) return *given.index;
  validate(given.curve, given.name);
  return IndexedCurve(given.curve);
}

bool known_simple(std::span<const Input> inputs, std::size_t k) {
  const auto* const curve = std::get_if<CurveInput>(&inputs[k]);
  return curve != nullptr && curve->simple;
}

std::span<const Point> points_at(const Operation& operation, std::span<const Input> inputs, std::size_t k) {
  const std::span<const Point> points = std::get<std::span<const Point>>(inputs[k]);
  for (std::size_t at = 0; at < points.size(); ++at) {
    if (std::isfinite(points[at].x) && std::isfinite(points[at].y)) continue;
    throw DataError(operation.inputs[k].name + ": point " + std::to_string(at) + " is not finite");
  }
  return points;
}

std::function<bool(double)> fraction_to(const Context& context) {
  if (!context.progress) return {};
  return [&context](double fraction) { return context.progress(fraction, {}); };
}

}  // namespace lober::detail::table
