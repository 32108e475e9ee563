#include "tests/trust/exact_case.hpp"

#include <charconv>
#include <cstdlib>

#include "tests/oracle/exact_curve.hpp"
#include "tests/oracle/slab_arrangement.hpp"
#include "tests/oracle/trapezoid_area.hpp"

namespace lober::trust {
namespace {

using oracle::Rational;

std::string shortest_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

void append_zone(std::string& text, const char* title, const std::vector<Point>& curve) {
  text += std::string("ZONE T=\"") + title + "\" I=" + std::to_string(curve.size()) + "\n";
  for (const Point& point : curve) text += shortest_text(point.x) + " " + shortest_text(point.y) + "\n";
}

}  // namespace

ExactCase exact_case(const TrackerCase& given) {
  ExactCase result{joined(given.a), joined(given.b), false, {}, {}};
  const auto single = [](const Shape& shape) { return shape.size() == 1 && shape.front().size() == 1; };
  result.simple = single(given.a) && single(given.b) && oracle::is_simple(result.c1) && oracle::is_simple(result.c2);
  const oracle::SlabArrangement slabs(result.c1, result.c2);
  for (const auto& [windings, area] : slabs.areas()) {
    const bool in1 = windings.first != 0, in2 = windings.second != 0;
    if (in1) result.areas[area_c1] += area;
    if (in2) result.areas[area_c2] += area;
    if (in1 && !in2) result.areas[area_c1_minus_c2] += area;
    if (!in1 && in2) result.areas[area_c2_minus_c1] += area;
    if (in1 && in2) result.areas[area_intersection] += area;
    if (in1 || in2) result.areas[area_union] += area;
  }
  result.intersection_by_trapezoids = oracle::trapezoid_intersection(result.c1, result.c2);
  return result;
}

std::string digits(const Rational& area) {
  char* text = nullptr;
  const mpf_class value(area, 1024);
  gmp_asprintf(&text, "%.30Fg", value.get_mpf_t());
  std::string result = text;
  std::free(text);  // NOLINT(cppcoreguidelines-no-malloc): as GMP wants it
  return result;
}

std::string case_text(const TrackerCase& given, const ExactCase& exact) {
  std::string text = given.hand_written;
  const std::string file = given.name + ".dat";
  text += "# command: lober overlay " + file + "#C1 " + file + "#C2" + (exact.simple ? "" : " --rule nonzero") + "\n";
  for (std::size_t k = 0; k < area_count; ++k) {
    text += "# area " + std::string(area_names[k]) + ": " + digits(exact.areas[k]) + "\n";
  }
  text += "VARIABLES=\"x\" \"y\"\n";
  append_zone(text, "C1", exact.c1);
  append_zone(text, "C2", exact.c2);
  return text;
}

}  // namespace lober::trust
