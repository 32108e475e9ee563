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
  Table table({{title, 8, Align::right, 0}});
  for (const SigmaStep& column : steps) table.add({std::to_string(column.crossing), 3});
  text += "\n" + table.head();
  for (const SigmaStep& row : steps) {
    std::vector<std::string> cells{std::to_string(row.crossing)};
    for (const SigmaStep& column : steps) cells.emplace_back(row.*next == column.crossing ? "1" : "0");
    text += table.row(cells);
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
  const Table table({{"crossing", 8, Align::right, 0},
                     {"rho", 4},
                     {names.first, 6},
                     {names.second, 6},
                     {"sigma", 6},
                     {"class", 6},
                     {"S", 24}});
  text += table.head();
  const std::size_t rows = std::min(max_table_crossings, steps.size());
  for (const SigmaStep& step : std::span(steps).first(rows)) {
    text += table.row({std::to_string(step.crossing), fmt::format("{:+}", step.rho), std::to_string(step.along1),
                       std::to_string(step.along2), std::to_string(step.sigma), std::to_string(step.class_number),
                       fmt::format("{:.16g}", step.s)});
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
