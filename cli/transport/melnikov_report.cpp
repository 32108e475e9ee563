// `lober transport --melnikov` for people: Melnikov's function and its lobes, beside the exact ones.

#include <spdlog/fmt/fmt.h>

#include "cli/transport/transport_report.hpp"

namespace lober::cli {

std::string melnikov_text(const operations::MelnikovComparison& report) {
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

}  // namespace lober::cli
