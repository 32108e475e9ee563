#include "cli/doctor/self_test.hpp"

#include <spdlog/fmt/fmt.h>

#include <utility>
#include <vector>

#include "engine/base/stopwatch.hpp"
#include "lober/base/threads.hpp"
#include "lober/overlay.hpp"

namespace lober::cli {
namespace {

constexpr int teeth = 100;

// Teeth upward from y = 0 to 2 n, each one wide and one apart, on a bar from y = -1 to 0.
std::vector<Point> upright_comb() {
  std::vector<Point> points{{0, -1}, {2.0 * teeth - 1, -1}};
  for (int k = teeth - 1; k >= 0; --k) {
    const double left = 2.0 * k, top = 2.0 * teeth;
    points.insert(points.end(), {{left + 1, top}, {left, top}});
    if (k > 0) points.insert(points.end(), {{left, 0}, {left - 1, 0}});
  }
  return points;
}

// Teeth to the right from x = -1 to 2 n, at half whole heights, on a bar from x = -2 to -1.
std::vector<Point> lying_comb() {
  std::vector<Point> points{{-2, 2.0 * teeth - 0.5}, {-2, 0.5}};
  for (int k = 0; k < teeth; ++k) {
    const double low = 2.0 * k + 0.5, right = 2.0 * teeth;
    points.insert(points.end(), {{right, low}, {right, low + 1}});
    if (k + 1 < teeth) points.insert(points.end(), {{-1, low + 1}, {-1, low + 2}});
  }
  return points;
}

std::string difference(const char* name, double found, double expected) {
  return found == expected ? std::string() : fmt::format("{} is {:.17g}, not {:.17g}", name, found, expected);
}

// The first of the areas that is wrong.
std::string wrong_area(const Areas& found) {
  constexpr double n = teeth, common = n * n, upright = 2 * n - 1 + 2 * n * n, lying = 2 * n - 1 + n * (2 * n + 1);
  for (const auto& [name, area, expected] : {std::tuple{"the area of C1", found.c1, upright},
                                             {"the area of C2", found.c2, lying},
                                             {"the area of the intersection", found.intersection, common},
                                             {"the area of the union", found.union_, upright + lying - common},
                                             {"the area of C1 \\ C2", found.c1_minus_c2, upright - common},
                                             {"the area of C2 \\ C1", found.c2_minus_c1, lying - common}}) {
    if (std::string failure = difference(name, area, expected); !failure.empty()) return failure;
  }
  return {};
}

void test(SelfTest& result) {
  const ClosedCurve c1(upright_comb()), c2(lying_comb());
  const Overlay found = overlay(c1, c2);
  result.points = c1.points().size() + c2.points().size();
  result.crossings = found.nodes.crossings();
  result.pieces = 0;
  for (const Pairing pairing : {Pairing::c1_minus_c2, Pairing::c2_minus_c1, Pairing::intersection}) {
    result.pieces += found.pieces(pairing).size();
  }
  constexpr std::size_t squares = std::size_t{teeth} * teeth;
  std::string failure = wrong_area(found.areas);
  if (failure.empty()) {
    failure = difference("the number of crossings", static_cast<double>(result.crossings), 4.0 * squares);
  }
  if (failure.empty()) {
    failure = difference("the number of pieces", static_cast<double>(result.pieces), 3.0 * squares + 2);
  }
  if (!failure.empty()) failure = "overlay: " + failure;
  if (failure.empty()) {
    failure = wrong_area(interior_areas(c1, c2).areas);
    if (!failure.empty()) failure = "interior: " + failure;
  }
  if (result.failure.empty()) result.failure = failure;
}

}  // namespace

SelfTest run_self_test() {
  SelfTest result;
  const detail::Stopwatch watch;
  try {
    run_with_threads(1, [&] { test(result); });
    run_with_threads(0, [&] { test(result); });
  } catch (const std::exception& error) {
    result.failure = error.what();
  }
  result.seconds = watch.seconds();
  return result;
}

}  // namespace lober::cli
