// `lober tangle U S`: reads the manifolds, runs the operation, and hands its findings to the reports.

#include "cli/tangle/tangle_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "cli/program/command_line.hpp"
#include "cli/program/curves_run.hpp"
#include "cli/program/log.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/running.hpp"
#include "cli/program/system_options.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/tangle/manifold_lift.hpp"
#include "cli/tangle/system_tangle_command.hpp"
#include "cli/tangle/tangle_outputs.hpp"
#include "engine/base/nearest_word.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/files/curve_spec.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

struct TangleRequest {
  std::array<std::string, 2> curves;
  std::array<bool, 2> reverse{};
  Periods periods;
  TangleOutputs outputs;
  std::vector<operations::OptionSetting> settings;
  int threads = 0;
};

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

// K, the number of a pip, or X,Y, a point near it.
operations::OptionSetting bip_of(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    if (const auto number = parse_number<std::uint32_t>(text)) return {"bip", std::int64_t{*number}};
  } else {
    const std::string_view view(text);
    const auto x = parse_number<double>(view.substr(0, comma)), y = parse_number<double>(view.substr(comma + 1));
    if (x && y && std::isfinite(*x) && std::isfinite(*y)) return {"bip_near", Point{*x, *y}};
  }
  throw UsageError("--bip takes the number of a pip, from 0, or a point X,Y near it, not \"" + text + "\"");
}

// Nothing when the arguments asked for help, which is printed.
std::optional<TangleRequest> parse_tangle(const std::vector<std::string>& arguments) {
  TangleRequest request;
  std::string bip;
  OptionParser parser(
      "Finds the tangle of an unstable manifold U and a stable manifold S, open curves ordered outward from their "
      "fixed points: primary intersection points (pips), lobes, boundary and turnstile. With the name of a system in "
      "their place the manifolds are grown from its equations (lober tangle SYSTEM --help).",
      "lober tangle");
  parser
      .add("U", request.curves[0],
           "The unstable manifold: FILE, or FILE#ZONE for one zone of it (by number from 0, or by title).")
      .required();
  parser.add("S", request.curves[1],
             "The stable manifold, in the same form (default: U is a file of two zones, which are U and S).");
  parser
      .add(
          "--bip", bip,
          "The boundary intersection point, the pip at which the boundary passes from U to S: its number K, from 0, or "
          "a point X,Y near it (default: the middle pip).")
      .value("K|X,Y");
  const TableOptions options(parser, operations::named("tangle"), {"bip", "bip_near"});
  request.outputs.add_options(parser);
  add_periodic_option(parser, request.periods);
  add_reverse_option(parser, request.reverse);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return std::nullopt;
  request.settings = options.settings();
  if (!bip.empty()) request.settings.push_back(bip_of(bip));
  return request;
}

// U alone is a file of two manifolds; a system would have been taken for one.
void require_file_or_system(const std::string& name) {
  const std::vector<SystemInfo> systems = list_systems();
  if (!std::filesystem::exists(detail::file_of_curve(name))) {
    std::vector<std::string> names;
    names.reserve(systems.size());
    for (const SystemInfo& info : systems) names.push_back(info.name);
    throw UsageError(name + " is neither a file nor a system; the systems are " + detail::joined(names) +
                     detail::did_you_mean(name, names));
  }
  if (std::any_of(systems.begin(), systems.end(), [&](const SystemInfo& info) { return info.name == name; })) {
    log_warning("the file " + name + " is read; --system " + name + " is the system of that name");
  }
}

void read_inputs(const TangleRequest& request, Progress& progress, TangleReport& report) {
  progress.phase("reading", 0, 0.3);
  std::array<std::string, 2> specs = request.curves;
  const bool one_file = specs[1].empty();
  if (one_file) {
    require_file_or_system(specs[0]);
    specs = {specs[0] + "#0", specs[0] + "#1"};
  }
  for (std::size_t k = 0; k < 2; ++k) {
    progress.file(k, 2);
    report.inputs[k] = read_manifold(specs[k], request.reverse[k], request.periods);
    if (one_file && report.inputs[k].zones != 2) {
      throw DataError(request.curves[0] + ": has " + counted(report.inputs[k].zones, "zone", "zones") +
                      "; alone it has to have two, U and S");
    }
  }
  report.specs = specs;
  report.periods = request.periods;
  warn_of_longitudes(report.inputs[0], report.inputs[1], request.periods);
  report.lift = lift_manifold(report.inputs[1].curve.points, report.inputs[0].curve.points, request.periods);
  require_same_columns(report.inputs[0].curve, report.inputs[1].curve);
  report.reversed = request.reverse;
}

TangleReport compute(const TangleRequest& request, Progress& progress) {
  TangleReport report;
  const operations::Options options = checked_options(report.operation(), request.settings);
  const detail::Stopwatch read_watch;
  read_inputs(request, progress, report);
  report.read_seconds = read_watch.seconds();
  std::vector<operations::Input> inputs;
  double points = 0;
  for (const NamedCurve& input : report.inputs) {
    inputs.emplace_back(operations::CurveInput{input.curve, spec_of(input)});
    points += static_cast<double>(input.curve.points.size());
  }
  progress.of(points, "points");
  progress.phase("tangle", 0.3, 0.9);
  operations::Context context;
  context.progress = [&](double fraction, const std::string&) { return progress.advance(fraction); };
  with_names_of(report.inputs[0], report.inputs[1],
                [&] { report.outcome = report.operation().run(inputs, options, context); });
  for (const std::string& remark : report.outcome.remarks) log_warning(fmt::format("warning: {}", remark));
  return report;
}

void run(const TangleRequest& request) {
  const detail::Stopwatch watch;
  std::vector<std::string> inputs{request.curves[0]};
  if (!request.curves[1].empty()) inputs.push_back(request.curves[1]);
  check_outputs(request.outputs.files(), inputs);
  TangleReport report;
  {
    Progress progress;
    report = compute(request, progress);
    progress.phase("writing", 0.9, 1);
    write_tangle(request.outputs, report, [&] { return watch.seconds(); });
  }
  print_tangle(request.outputs, report);
  const operations::CurveTangle& found = report.result();
  const TangleTiming& timing = found.timing;
  report_seconds({{"read", report.read_seconds},
                  {"index", timing.index},
                  {"check", timing.check},
                  {"crossings", timing.crossings},
                  {"order", timing.order},
                  {"pips", timing.pips},
                  {"areas", timing.areas},
                  {"measures", found.measures_seconds},
                  {"overlaps", found.overlaps_seconds},
                  {"write", report.write_seconds}});
  require_agreement(report.outcome.agreement);
}

}  // namespace

void run_tangle(const std::vector<std::string>& arguments) {
  if (names_system(arguments)) return run_system_tangle(arguments);
  const std::optional<TangleRequest> request = parse_tangle(arguments);
  if (!request) return;
  run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli
