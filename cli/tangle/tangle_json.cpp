// The JSON object of `lober tangle`. Its members are a contract; more may be added, none renamed.

#include "cli/report/outcome_json.hpp"
#include "cli/tangle/tangle_report.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {
namespace {

Json manifold_json(const TangleReport& report, std::size_t k) {
  const NamedCurve& input = report.inputs[k];
  if (report.origin) return {{"grown", input.file}, {"points", input.curve.points.size()}};
  Json object{{"file", input.file},
              {"zone", input.zone},
              {"sha256", input.sha256},
              {"points", input.curve.points.size()},
              {"reversed", report.reversed[k]}};
  add_spec(object, input, report.specs[k]);
  return object;
}

}  // namespace

void write_tangle_json(const std::string& path, TangleReport& report, const std::function<double()>& seconds_so_far) {
  const detail::Stopwatch watch;
  std::vector<std::pair<std::string, Json>> inputs{
      {"inputs", Json::array({manifold_json(report, 0), manifold_json(report, 1)})}};
  if (report.periods.any()) inputs.emplace_back("periodic", periods_json(report.periods));
  if (report.origin) inputs.emplace_back("system", system_json(*report.origin->system, report.origin->integration));
  write_outcome_json(path, "tangle", inputs, report.operation(), report.outcome, [&] {
    const operations::CurveTangle& found = report.result();
    const TangleTiming& timing = found.timing;
    report.write_seconds += watch.seconds();
    return Json{{"read", report.read_seconds},
                {"index", timing.index},
                {"check", timing.check},
                {"crossings", timing.crossings},
                {"order", timing.order},
                {"pips", timing.pips},
                {"areas", timing.areas},
                {"tangle", timing.total},
                {"measures", found.measures_seconds},
                {"overlaps", found.overlaps_seconds},
                {"write", report.write_seconds},
                {"total", seconds_so_far()}};
  });
}

}  // namespace lober::cli
