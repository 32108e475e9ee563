#include "cli/report/curve_file.hpp"

#include "cli/program/output_names.hpp"
#include "cli/program/written_files.hpp"
#include "cli/report/report.hpp"
#include "lober/base/version.hpp"
#include "lober/curve/formats.hpp"

namespace lober::cli {

std::string note_on(const NamedCurve& input) {
  return spec_of(input) + " sha256 " + input.sha256;
}

std::vector<std::pair<std::string, std::string>> notes_of(std::string_view command, const operations::Outcome& outcome,
                                                          const std::vector<std::string>& inputs,
                                                          const std::string& system) {
  std::vector<std::pair<std::string, std::string>> notes{{"lober", std::string(version())},
                                                         {"command", std::string(command)}};
  for (std::size_t k = 0; k < inputs.size(); ++k) notes.emplace_back("input " + std::to_string(k + 1), inputs[k]);
  if (!system.empty()) notes.emplace_back("system", system);
  std::string options;
  for (const operations::OptionSetting& setting : outcome.settings()) {
    options += (options.empty() ? "" : " ") + setting.key + "=" + operations::to_string(setting.value);
  }
  if (!options.empty()) notes.emplace_back("options", options);
  return notes;
}

void write_curve_file(const std::string& path, std::span<const Zone> zones, const CurveFileOptions& options) {
  write_curves(path, zones,
               {.format = curve_format(path, options.format, true),
                .closed = options.closed,
                .zone_lines = options.zone_lines,
                .provenance = path == "-" ? decltype(options.notes){} : options.notes});  // a stream is not kept
  std::size_t points = 0;
  for (const Zone& zone : zones) points += zone.points.size();
  note_curves_written(path, zones.size(), points);
}

void write_curve_file(const std::string& path, std::span<const Point> points, const CurveFileOptions& options) {
  const Zone zone{{}, {points.begin(), points.end()}, 1};
  write_curve_file(path, {&zone, 1}, options);
}

}  // namespace lober::cli
