#include "bench/trackers/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace lober::bench {
namespace {

std::string few_digits(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

// The area that all sides sweep when they move by a unit in the last place of the largest coordinate: coordinates
// rounded to doubles, or to integers, explain an error of this size.
double rounding_of_coordinates(const trust::TrackerCase& given, double grid) {
  double length = 0, largest = 0;
  for (const trust::Shape* shape : {&given.a, &given.b}) {
    for (const trust::PolygonRings& polygon : *shape) {
      for (const trust::Ring& ring : polygon) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
          const Point p = ring[k], q = ring[(k + 1) % ring.size()];
          length += std::hypot(q.x - p.x, q.y - p.y);
          largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
        }
      }
    }
  }
  return length * (grid > 0 ? grid : largest * std::numeric_limits<double>::epsilon());
}

std::string format_name(std::string_view area_name) {
  if (area_name == "c1_minus_c2") return "A \\ B";
  if (area_name == "c2_minus_c1") return "B \\ A";
  return std::string(area_name);
}

struct Finding {
  Verdict verdict = Verdict::right;
  double size = 0;  ///< how bad, among findings of one verdict
  std::string text;
};

Finding judge_overlay(std::string_view name, double area, const std::string& validity, double exact, double slack,
                      bool on_grid) {
  const double error = std::fabs(area - exact);
  const std::string overlay = format_name(name);
  const std::string both = overlay + " " + few_digits(area) + ", not " + few_digits(exact);
  if (validity.starts_with("error")) return {Verdict::failed, exact, "exception: " + overlay};
  if (error > slack) {
    if (error > 1e-3 * exact) return {Verdict::wrong, error, "**wrong**: " + both};
    return {Verdict::imprecise, error, "imprecise: " + overlay + " by " + few_digits(error / exact) + " of itself"};
  }
  if (!on_grid && error > 0.01 * exact) return {Verdict::lost, error, "small area wrong: " + both};
  if (validity != "valid") return {Verdict::invalid, exact, "not valid: " + overlay};
  return {};
}

}  // namespace

Judgement judge(const std::string& answer, const trust::TrackerCase& given) {
  std::istringstream lines(answer);
  std::string version, input;
  double grid = 0;
  std::getline(lines, version);
  lines >> grid >> std::ws;
  std::getline(lines, input);
  std::array<double, trust::area_count> exact{};
  for (std::size_t k = 0; k < trust::area_count; ++k) exact[k] = std::strtod(given.areas[k].c_str(), nullptr);
  const double slack = std::max(1e-9 * exact[trust::area_union], rounding_of_coordinates(given, grid));
  Finding worst;
  std::size_t found = 0;
  for (std::string line; std::getline(lines, line); ++found) {
    std::istringstream words(line);
    std::string name, validity;
    double area = 0;
    words >> name >> area >> std::ws;
    std::getline(words, validity);
    const auto k = std::find(trust::area_names.begin(), trust::area_names.end(), name) - trust::area_names.begin();
    if (k == std::ssize(trust::area_names)) return {Verdict::failed, "no answer"};
    const Finding one = judge_overlay(name, area, validity, exact[static_cast<std::size_t>(k)], slack, grid > 0);
    if (std::pair(one.verdict, one.size) > std::pair(worst.verdict, worst.size)) worst = one;
  }
  if (found == 0 && !input.empty()) return {Verdict::not_taken, "-"};
  if (found != 4) return {Verdict::failed, "crash, or no answer in time"};
  if (worst.verdict == Verdict::right) return {Verdict::right, "right"};
  if (input != "valid") return {Verdict::no_input, "input not valid for it"};
  return {worst.verdict, worst.text};
}

}  // namespace lober::bench
