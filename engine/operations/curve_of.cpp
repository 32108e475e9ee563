#include "engine/operations/curve_of.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "lober/base/error.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

bool is_curve(InputKind kind) {
  return kind == InputKind::closed_curve || kind == InputKind::open_curve || kind == InputKind::curve;
}

const CurveInput* given_curve(const Input& input) {
  return std::get_if<CurveInput>(&input);
}

bool is_of_kind(const Input& input, InputKind kind) {
  const auto* const system = std::get_if<SystemInput>(&input);
  if (kind == InputKind::system) return system != nullptr && system->system;
  return system == nullptr && (is_curve(kind) || given_curve(input) == nullptr);
}

std::string takes(const Operation& operation) {
  std::string text = operation.name + " takes ";
  for (const InputSpec& spec : operation.inputs) {
    text += (&spec == operation.inputs.data() ? "" : ", ") + spec.name;
    if (spec.optional) text += ", which may be left out";
  }
  return text + ", and nothing else";
}

CurveView view_of(const Operation& operation, std::span<const Input> inputs, std::size_t k, bool closed) {
  const CurveInput* const given = given_curve(inputs[k]);
  CurveView curve = given != nullptr ? given->curve : CurveView{std::get<std::span<const Point>>(inputs[k])};
  if (operation.inputs[k].kind != InputKind::curve || !closed) curve.closed = closed;
  return curve;
}

std::string_view name_of(const Operation& operation, std::span<const Input> inputs, std::size_t k) {
  const CurveInput* const given = given_curve(inputs[k]);
  return given != nullptr && !given->name.empty() ? given->name : operation.inputs[k].name;
}

}  // namespace

void require_inputs(const Operation& operation, std::span<const Input> inputs) {
  const std::vector<InputSpec>& specs = operation.inputs;
  const auto needed = static_cast<std::size_t>(
      std::count_if(specs.begin(), specs.end(), [](const InputSpec& spec) { return !spec.optional; }));
  if (inputs.size() < needed || inputs.size() > specs.size()) {
    throw UsageError(operation.name + " takes " + (needed < specs.size() ? std::to_string(needed) + " to " : "") +
                     std::to_string(specs.size()) + " inputs, not " + std::to_string(inputs.size()));
  }
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    if (!is_of_kind(inputs[k], specs[k].kind)) throw UsageError(takes(operation));
  }
}

CurveView curve_at(const Operation& operation, std::span<const Input> inputs, std::size_t k, bool closed) {
  const CurveView curve = view_of(operation, inputs, k, closed);
  validate(curve, name_of(operation, inputs, k));
  return curve;
}

// The pass that builds the index sees a coordinate that is not finite; only then is it worth another to say which.
IndexedCurve indexed_curve(const Operation& operation, std::span<const Input> inputs, std::size_t k) {
  if (is_indexed(inputs, k)) return *given_curve(inputs[k])->index;
  const CurveView curve = view_of(operation, inputs, k, operation.inputs[k].kind == InputKind::closed_curve);
  require_enough_vertices(curve, name_of(operation, inputs, k));
  IndexedCurve indexed(curve);
  if (!indexed.finite()) validate(curve, name_of(operation, inputs, k));
  return indexed;
}

bool is_indexed(std::span<const Input> inputs, std::size_t k) {
  const CurveInput* const curve = given_curve(inputs[k]);
  return curve != nullptr && curve->index != nullptr;
}

bool known_simple(std::span<const Input> inputs, std::size_t k) {
  const CurveInput* const curve = given_curve(inputs[k]);
  return curve != nullptr && curve->simple;
}

const DiscretisationSums* known_sums(std::span<const Input> inputs, std::size_t k) {
  const CurveInput* const curve = given_curve(inputs[k]);
  return curve != nullptr ? curve->sums : nullptr;
}

std::span<const Point> points_at(const Operation& operation, std::span<const Input> inputs, std::size_t k) {
  const std::span<const Point> points = std::get<std::span<const Point>>(inputs[k]);
  for (std::size_t at = 0; at < points.size(); ++at) {
    if (std::isfinite(points[at].x) && std::isfinite(points[at].y)) continue;
    throw DataError(operation.inputs[k].name + ": point " + std::to_string(at) + " is not finite");
  }
  return points;
}

}  // namespace lober::detail::table
