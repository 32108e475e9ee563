// `lober transport --melnikov`: Melnikov's function and its lobes, beside the exact ones.

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/transport/transport_report.hpp"
#include "lober/error.hpp"

namespace lober::cli {

const Parameter& perturbation_of(const System& system) {
  const Parameter* const perturbation = system.info.perturbation();
  if (system.flow && perturbation != nullptr) return *perturbation;
  throw UsageError("--melnikov needs a flow with a parameter that is the size of a perturbation, such as eps of ovp; " +
                   system.info.name + " has none");
}

Melnikov melnikov_of(const SystemRequest& request, const ParameterValues& values, const System& system,
                     const Connection& connection) {
  const std::string& name = perturbation_of(system).name;
  const auto member = [&](double eps) {
    ParameterValues changed = values;
    std::erase_if(changed, [&](const auto& value) { return value.first == name; });
    changed.emplace_back(name, eps);
    return system_of(request, changed).flow;
  };
  return melnikov(member, connection, request.integration);
}

std::string melnikov_text(const MelnikovReport& report) {
  const Melnikov& m = report.function;
  std::string text = fmt::format("Melnikov   M(t0) has {} in a period of {:.10g}, |M| is {:.10g} at most, +- {:.0e}\n",
                                 counted(m.zeros.size(), "zero", "zeros"), m.period, m.largest, m.error);
  const auto side = [&](const char* name, double estimate, double exact) {
    text += fmt::format("{:<11}lobes on the {} of U: first order {:.10g}, exact {:.10g}", "", name, estimate, exact);
    if (exact > 0)
      text += fmt::format(", difference {:.3g} ({:.2g} %)", estimate - exact, 100 * (estimate / exact - 1));
    text += "\n";
  };
  side("left", report.estimate.left, report.exact.left);
  side("right", report.estimate.right, report.exact.right);
  return text;
}

Json melnikov_json(const MelnikovReport& report) {
  const Melnikov& m = report.function;
  Json zeros = Json::array(), lobes = Json::array();
  for (const MelnikovZero& zero : m.zeros) zeros.push_back({{"t0", zero.t0}, {"slope", zero.slope}});
  for (const MelnikovLobe& lobe : m.lobes) {
    lobes.push_back({{"begin", lobe.begin}, {"end", lobe.end}, {"area", -report.eps * lobe.integral}});
  }
  const auto sides = [](const Melnikov::Sides& areas) { return Json{{"left", areas.left}, {"right", areas.right}}; };
  return {{"parameter", report.parameter},
          {"eps", report.eps},
          {"period", m.period},
          {"saddles", {point_json(m.from), point_json(m.to)}},
          {"cosines", m.cosines},
          {"sines", m.sines},
          {"largest", m.largest},
          {"error", m.error},
          {"zeros", zeros},
          {"lobes", lobes},
          {"first_order", sides(report.estimate)},
          {"exact", sides(report.exact)}};
}

}  // namespace lober::cli
