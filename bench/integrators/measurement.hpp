// Measurements of an integrator on a problem: time and error, and their tables.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace lober::bench {

struct Measurement {
  double tolerance;
  double nanoseconds;   ///< a point
  double largest, rms;  ///< errors
};

struct WorkPrecision {
  std::string method;
  std::vector<Measurement> points;
};

/// Time for that rms error, between measurements by powers of the error; NaN beyond them.
[[nodiscard]] double nanoseconds_at(const WorkPrecision& curve, double rms);

/// All measurements; times are compared with those of the first curve at the same error.
void print_measurements(std::ostream& stream, const std::string& system, const std::vector<WorkPrecision>& curves);
/// Nanoseconds a point at a few errors.
void print_summary(std::ostream& stream, const std::string& system, const std::vector<WorkPrecision>& curves);

}  // namespace lober::bench
