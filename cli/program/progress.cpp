#include "cli/program/progress.hpp"

#include <cmath>
#include <exception>

#include "cli/program/interrupt.hpp"
#include "cli/program/meter.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {

Progress::Progress() : exceptions_(std::uncaught_exceptions()) {}

Progress::~Progress() {
  if (std::uncaught_exceptions() > exceptions_) return;  // the phase that failed is the last one
  if (Meter* const meter = run_meter()) meter->phase("writing");
}

void Progress::phase(std::string_view name, double begin, double end) {
  begin_ = begin;
  end_ = end;
  if (Meter* const meter = run_meter()) meter->phase(name);
  if (!advance(0)) throw Cancelled();
}

bool Progress::advance(double fraction) {
  if (Meter* const meter = run_meter()) {
    const double whole = begin_ + fraction * (end_ - begin_);
    meter->fraction(whole);
    if (total_ > 0) meter->count(std::floor(total_ * whole), total_unit_);
  }
  return !interrupted();
}

void Progress::file(std::size_t k, std::size_t files) {
  const double share = (end_ - begin_) / static_cast<double>(files);
  if (Meter* const meter = run_meter()) meter->expect_file(begin_ + share * static_cast<double>(k), share);
  static_cast<void>(advance(static_cast<double>(k) / static_cast<double>(files)));
}

void Progress::count(double amount, std::string_view unit) {
  if (Meter* const meter = run_meter()) meter->count(amount, unit);
}

void Progress::of(double total, std::string_view unit) {
  total_ = total;
  total_unit_ = unit;
}

void Progress::label(std::string_view what) {
  if (Meter* const meter = run_meter()) meter->label(what);
}

bool Progress::step(std::string_view what) {
  if (Meter* const meter = run_meter(); meter != nullptr && !what.empty()) meter->step(what);
  return !interrupted();
}

std::function<bool(double, const std::string&)> told_to(Progress& progress) {
  return [&progress](double fraction, const std::string& line) {
    return std::isnan(fraction) ? progress.step(line) : progress.advance(fraction);
  };
}

}  // namespace lober::cli
