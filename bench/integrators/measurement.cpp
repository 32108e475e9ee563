#include "bench/integrators/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bench/harness/table.hpp"

namespace lober::bench {
namespace {

std::string two_digits(double error) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", error);
  return text;
}

}  // namespace

double nanoseconds_at(const WorkPrecision& curve, double rms) {
  // Where rounding sets in a finer tolerance takes longer and errs more: only what is better than all that is faster
  // counts.
  std::vector<Measurement> best = curve.points;
  std::sort(best.begin(), best.end(),
            [](const Measurement& a, const Measurement& b) { return a.nanoseconds < b.nanoseconds; });
  double result = std::numeric_limits<double>::quiet_NaN();
  const Measurement* before = nullptr;
  for (const Measurement& here : best) {
    if (before && !(here.rms < before->rms)) continue;
    if (before && here.rms <= rms && rms <= before->rms) {
      const double part = std::log(before->rms / rms) / std::log(before->rms / here.rms);
      result = before->nanoseconds * std::pow(here.nanoseconds / before->nanoseconds, part);
      break;
    }
    before = &here;
  }
  return result;
}

void print_measurements(std::ostream& stream, const std::string& system, const std::vector<WorkPrecision>& curves) {
  Table table({"system", "method", "tolerance", "ns a point", "largest error", "rms error", "time / Odeint"});
  for (const WorkPrecision& curve : curves) {
    if (curve.points.empty()) table.add({system, curve.method, "not there", "", "", "", ""});
    for (const Measurement& point : curve.points) {
      table.add({system, curve.method, one_digit(point.tolerance), digits3(point.nanoseconds),
                 two_digits(point.largest), two_digits(point.rms),
                 digits3(point.nanoseconds / nanoseconds_at(curves.front(), point.rms))});
    }
  }
  stream << table;
}

void print_summary(std::ostream& stream, const std::string& system, const std::vector<WorkPrecision>& curves) {
  constexpr double errors[] = {1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14};
  std::vector<std::string> header{system + ", ns at rms error"};
  for (const double error : errors) header.push_back(one_digit(error));
  Table table(header);
  for (const WorkPrecision& curve : curves) {
    std::vector<std::string> row{curve.method};
    for (const double error : errors) row.push_back(digits3(nanoseconds_at(curve, error)));
    table.add(row);
  }
  stream << table;
}

}  // namespace lober::bench
