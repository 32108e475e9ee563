#include "engine/operations/melnikov.hpp"

#include <cmath>
#include <utility>

#include "lober/base/error.hpp"

namespace lober::detail::table {
namespace {

using Comparison = MelnikovComparison;

Schema<MelnikovZero> melnikov_zero_schema() {
  Schema<MelnikovZero> made;
  made.field("t0", "time", "M(t0) = 0", &MelnikovZero::t0)
      .field("slope", "area per time", "dM/dt0 there", &MelnikovZero::slope);
  return made;
}

struct LobeOfEps {
  MelnikovLobe lobe;
  double eps;
};

std::vector<LobeOfEps> lobes_of(const Comparison& c) {
  std::vector<LobeOfEps> lobes;
  for (const MelnikovLobe& lobe : c.function.lobes) lobes.push_back({lobe, c.eps});
  return lobes;
}

Schema<LobeOfEps> melnikov_lobe_schema() {
  Schema<LobeOfEps> made;
  made.field("begin", "time", "t0 of the zero where the lobe begins", [](const LobeOfEps& l) { return l.lobe.begin; })
      .field("end", "time", "t0 of the next zero", [](const LobeOfEps& l) { return l.lobe.end; })
      .field("area", "area", "signed area to first order", [](const LobeOfEps& l) { return -l.eps * l.lobe.integral; });
  return made;
}

Schema<Melnikov::Sides> sides_schema() {
  Schema<Melnikov::Sides> made;
  made.field("left", "area", "sum of the lobes on the left of U", &Melnikov::Sides::left)
      .field("right", "area", "sum of the lobes on its right", &Melnikov::Sides::right);
  return made;
}

struct Saddle {
  Point at;
};
Schema<Saddle> saddle_schema() {
  Schema<Saddle> made;
  made.field("at", "length", "without the perturbation", &Saddle::at);
  return made;
}

}  // namespace

const Parameter& perturbation_of(const System& system) {
  const Parameter* const perturbation = system.info.perturbation();
  if (system.flow && perturbation != nullptr) return *perturbation;
  throw UsageError(
      "Melnikov's function needs a flow with a parameter that is the size of a perturbation, such as eps of "
      "ovp; " +
      system.info.name + " has none");
}

Melnikov melnikov_of(const SystemInput& input, const ParameterValues& values, const System& system,
                     const Connection& connection) {
  const std::string name = perturbation_of(system).name;
  if (!input.with) throw UsageError("Melnikov's function needs a system whose parameters can be changed");
  const auto member = [&](double eps) {
    ParameterValues changed = values;
    std::erase_if(changed, [&](const auto& value) { return value.first == name; });
    changed.emplace_back(name, eps);
    return input.with(changed).flow;
  };
  return melnikov(member, connection, input.integration);
}

MelnikovComparison melnikov_comparison(Melnikov function, const System& system, const ManifoldTangle& manifolds) {
  MelnikovComparison result;
  const Parameter& perturbation = perturbation_of(system);
  result.parameter = perturbation.name;
  result.eps = perturbation.value;
  result.estimate = function.lobe_areas(result.eps);
  result.function = std::move(function);
  std::vector<double> areas = manifolds.areas_by_action;
  if (areas.empty()) {
    const Images& images = manifolds.tangle.images;
    for (std::size_t k = images.turnstile_begin; k < images.turnstile_end; ++k)
      areas.push_back(manifolds.tangle.lobes[k].area);
  }
  for (const double area : areas) (area > 0 ? result.exact.left : result.exact.right) += std::fabs(area);
  return result;
}

const Schema<MelnikovComparison>& melnikov_schema() {
  static const Schema<Comparison> schema = [] {
    Schema<Comparison> made;
    made.field("parameter", "", "the size of the perturbation", &Comparison::parameter)
        .field("eps", "", "its value", &Comparison::eps)
        .field("period", "time", "period of M", [](const Comparison& c) { return c.function.period; })
        .list("saddles", "saddles of U and of S, without the perturbation", saddle_schema(),
              [](const Comparison& c) {
                return std::vector<Saddle>{{c.function.from}, {c.function.to}};
              })
        .field("cosines", "area per time", "coefficients of M(t0), from the constant on",
               [](const Comparison& c) { return c.function.cosines; })
        .field("sines", "area per time", "sine coefficients of M(t0); the first one is not used",
               [](const Comparison& c) { return c.function.sines; })
        .field("largest", "area per time", "|M|", [](const Comparison& c) { return c.function.largest; })
        .field("error", "area per time", "estimate of the error of M",
               [](const Comparison& c) { return c.function.error; })
        .list("zeros", "zeros of M in a period", melnikov_zero_schema(),
              [](const Comparison& c) { return c.function.zeros; })
        .list("lobes", "lobes, each from a zero to the next one", melnikov_lobe_schema(), lobes_of)
        .object("first_order", "areas of lobes to first order", sides_schema(), &Comparison::estimate)
        .object("exact", "areas of lobes by action, by geometry where the map has none", sides_schema(),
                &Comparison::exact);
    return made;
  }();
  return schema;
}

}  // namespace lober::detail::table
