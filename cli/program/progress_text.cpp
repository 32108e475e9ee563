#include "cli/program/progress_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/program/terminal.hpp"
#include "cli/report/json.hpp"

namespace lober::cli {
namespace {

std::string format_duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

// The text in at most that number of bytes, without a part of a character of UTF-8.
std::string shortened(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  std::size_t end = bytes < 3 ? 0 : bytes - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + std::string("...").substr(0, std::min<std::size_t>(bytes, 3));
}

Json number_or_null(double value) {
  return value > 0 ? Json(value) : Json(nullptr);
}

}  // namespace

double rate_of(const ProgressState& state) {
  if (state.unit.empty()) return 0;
  return state.amount / std::max(state.counting_seconds > 0 ? state.counting_seconds : state.seconds, 1e-9);
}

std::optional<double> seconds_left(const ProgressState& state) {
  // Even a thousandth of long work tells something.
  if (state.fraction < 0.01 && !(state.fraction > 0 && state.seconds > 10)) return std::nullopt;
  return state.seconds * (1 - std::min(state.fraction, 1.0)) / state.fraction;
}

std::string progress_line(const ProgressState& state, std::size_t width) {
  std::string line = ":";
  const std::optional<double> left = seconds_left(state);
  if (left) line += fmt::format(" {:.{}f} %,", 100 * state.fraction, state.fraction < 0.01 ? 2 : 0);
  if (!state.unit.empty() && state.amount > 0) {
    line += fmt::format(" {:.3g} {}, {:.3g} {}/s,", state.amount, state.unit, rate_of(state), state.unit);
  }
  line += " " + format_duration(state.seconds);
  if (left) {
    line += ", about " + format_duration(*left) + " left";
  } else if (state.next_step > 0) {
    line += ", next step in about " + format_duration(state.next_step);
  } else {
    line += ", time left not known yet";
  }
  const std::string what = printable(state.what);
  if (what.size() + line.size() <= width) return what + line;
  constexpr std::size_t least = 8;  // letters of `what`
  return shortened(shortened(what, std::max(least, width - std::min(width, line.size()))) + line, width);
}

std::string progress_json(const std::string& command, const ProgressState& state, std::string_view status) {
  const bool counts = !state.unit.empty();
  const std::optional<double> left = seconds_left(state);
  const Json object{{"command", command},
                    {"status", status},
                    {"what", state.what},
                    {"fraction", number_or_null(std::min(state.fraction, 1.0))},
                    {"amount", counts ? Json(state.amount) : Json(nullptr)},
                    {"unit", counts ? Json(state.unit) : Json(nullptr)},
                    {"rate", counts ? Json(rate_of(state)) : Json(nullptr)},
                    {"seconds", state.seconds},
                    {"seconds_left", left ? Json(*left) : Json(nullptr)}};
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lober::cli
