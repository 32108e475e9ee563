// `lober overlay --classes`: Tables 1 to 4 of Naik, Lekien & Ross (2017), for any two curves and both pairings.

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/overlay/overlay_report.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_table_crossings = 50;
constexpr std::size_t max_matrix_rows = 12;

struct PairingText {
  const char* title;
  const char* first;   // the function of C1 that gamma takes at rho = +1
  const char* second;  // the function of C2 that it takes at rho = -1
};
constexpr std::array<PairingText, 2> pairing_texts{{{"C1 \\ C2", "A+_C1", "A-_C2"}, {"C2 \\ C1", "A-_C1", "A+_C2"}}};

// A function of two crossings that is 1 where the second one is `next` of the first one, and 0 elsewhere.
void add_matrix(std::string& text, const char* title, const std::vector<SigmaStep>& steps,
                std::uint32_t SigmaStep::*next) {
  text += fmt::format("\n{:>8}", title);
  for (const SigmaStep& column : steps) text += fmt::format(" {:>3}", column.crossing);
  text += "\n";
  for (const SigmaStep& row : steps) {
    text += fmt::format("{:>8}", row.crossing);
    for (const SigmaStep& column : steps) text += fmt::format(" {:>3}", row.*next == column.crossing ? 1 : 0);
    text += "\n";
  }
}

double half_sum(const std::vector<SigmaStep>& steps) {
  double sum = 0;
  for (const SigmaStep& step : steps) sum += step.s;
  return sum / 2;
}

void add_pairing(std::string& text, const std::vector<SigmaStep>& steps, const PairingText& names) {
  text += fmt::format("\n{}: {}; half the sum of S is {:.16g}\n", names.title,
                      counted(class_count(steps), "class", "classes"), half_sum(steps));
  text += fmt::format("{:>8} {:>4} {:>6} {:>6} {:>6} {:>6} {:>24}\n", "crossing", "rho", names.first, names.second,
                      "sigma", "class", "S");
  const std::size_t rows = std::min(max_table_crossings, steps.size());
  for (const SigmaStep& step : std::span(steps).first(rows)) {
    text += fmt::format("{:>8} {:>+4} {:>6} {:>6} {:>6} {:>6} {:>24.16g}\n", step.crossing, step.rho, step.along1,
                        step.along2, step.sigma, step.class_number, step.s);
  }
  if (steps.size() > rows) text += fmt::format("{:>8} and {} more\n", "...", steps.size() - rows);
  if (steps.empty() || steps.size() > max_matrix_rows) return;
  add_matrix(text, names.first, steps, &SigmaStep::along1);
  add_matrix(text, names.second, steps, &SigmaStep::along2);
  add_matrix(text, "gamma", steps, &SigmaStep::sigma);
}

}  // namespace

const SigmaStep* step_of(const std::vector<SigmaStep>& steps, std::size_t node) {
  const auto found = std::lower_bound(steps.begin(), steps.end(), node,
                                      [](const SigmaStep& step, std::size_t wanted) { return step.crossing < wanted; });
  return found != steps.end() && found->crossing == node ? &*found : nullptr;
}

std::size_t class_count(const std::vector<SigmaStep>& steps) {
  std::size_t count = 0;
  for (const SigmaStep& step : steps) count = std::max(count, step.class_number + std::size_t{1});
  return count;
}

std::string classes_text(const CurveOverlay& found) {
  std::string text;
  if (!found.steps) return text;
  for (std::size_t k = 0; k < pairing_texts.size(); ++k) add_pairing(text, (*found.steps)[k], pairing_texts[k]);
  return text;
}

std::string sigma_columns() {
  std::string text;
  for (const char* pairing : {"12", "21"}) {
    for (const char* name : {"along1_", "along2_", "sigma_", "class_", "s_"}) append_all(text, ",", name, pairing);
  }
  return text;
}

void append_sigma(std::string& text, const CurveOverlay& found, std::size_t node) {
  for (const std::vector<SigmaStep>& steps : *found.steps) {
    if (const SigmaStep* step = step_of(steps, node)) {
      append_all(text, ",", step->along1, ",", step->along2, ",", step->sigma, ",", step->class_number, ",", step->s);
    } else {
      text += ",,,,,";
    }
  }
}

}  // namespace lober::cli
