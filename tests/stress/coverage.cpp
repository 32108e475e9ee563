#include "tests/stress/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace lober::stress {
namespace {

// Below this, in squared units, doubles have fewer than 53 digits: bounds hold, their looseness means nothing.
constexpr double underflow = 1e-290;

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

double quantile_or_nan(const std::vector<double>& sorted, double fraction) {
  return sorted.empty() ? NAN : quantile(sorted, fraction);
}

}  // namespace

double quantile(const std::vector<double>& sorted, double fraction) {
  const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(sorted.size())));
  return sorted[rank == 0 ? 0 : std::min(rank, sorted.size()) - 1];
}

bool Coverage::add(double value, double bound, const oracle::Rational& exact) {
  ++areas_;
  if (!std::isfinite(value) || !std::isfinite(bound)) return false;
  const oracle::Rational error = abs(oracle::Rational(value) - exact), stated(bound);
  const bool holds = error <= stated;
  if (holds) ++inside_;
  if (sgn(error) == 0) ++exact_;
  if (bound > underflow) {
    if (sgn(error) != 0) looseness_.push_back(oracle::Rational(stated / error).get_d());
    if (value > underflow) size_.push_back(bound / value * 0x1p53);
  }
  return holds;
}

void Coverage::add(const Coverage& other) {
  areas_ += other.areas_;
  inside_ += other.inside_;
  exact_ += other.exact_;
  append(looseness_, other.looseness_);
  append(size_, other.size_);
}

void Coverage::sort() {
  std::sort(looseness_.begin(), looseness_.end());
  std::sort(size_.begin(), size_.end());
}

std::string Coverage::heading(const std::string& name) {
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(),
                "%-28s %9s %8s %8s | %-35s | %s\n%-28s %9s %8s %8s | %8s %8s %8s %8s | %8s %8s %8s\n", name.c_str(),
                "areas", "outside", "without", "bound / |error|", "bound / (area 2^-53)", "", "", "bound", "error",
                "least", "1 %", "median", "99 %", "median", "99 %", "most");
  return line.data();
}

std::string Coverage::row(const std::string& name) const {
  std::array<char, 256> line{};
  const auto loose = [&](double fraction) { return quantile_or_nan(looseness_, fraction); };
  const auto size = [&](double fraction) { return quantile_or_nan(size_, fraction); };
  std::snprintf(line.data(), line.size(), "%-28s %9zu %8zu %7.2f%% | %8.3g %8.3g %8.3g %8.2g | %8.3g %8.2g %8.2g\n",
                name.c_str(), areas_, areas_ - inside_,
                areas_ == 0 ? 0 : 100 * static_cast<double>(exact_) / static_cast<double>(areas_), loose(0),
                loose(0.01), loose(0.5), loose(0.99), size(0.5), size(0.99), size(1));
  return line.data();
}

}  // namespace lober::stress
