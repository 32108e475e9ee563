// Sets of curves for the throughput of the batch engine, as NPY files with a manifest beside them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "kernels/point.hpp"

namespace lober::bench {
using namespace lober::detail;

struct CurveSet {
  std::string name;
  std::vector<std::vector<Point>> curves;
};

/// Wavy circles that cross each other some eight times.
[[nodiscard]] CurveSet wavy_set(std::string name, std::size_t curves, std::size_t points);
/// A circle about the fixed point of the standard map (K = 1.2) that reaches into the chaotic sea, and its iterates.
[[nodiscard]] CurveSet iterates(std::string name, std::size_t curves, std::size_t points);
/// 60 curves of 10^3 points, 10 of 10^4, 2 of 10^6.
[[nodiscard]] CurveSet mixed_set(std::string name);

/// Writes curve.0, curve.1, ... and job.toml, all pairs.
void write_set(const CurveSet& set, const std::filesystem::path& folder);

}  // namespace lober::bench
