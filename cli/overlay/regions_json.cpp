// The JSON object of `lober overlay --rule`. Its members are a contract; more may be added, none renamed.

#include "cli/overlay/regions_report.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/regions_parts.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {
namespace {

void write_pieces(detail::OutputFile& file, const RegionsReport& report) {
  file.write("\"pieces\": {");
  for (const Pairing pairing : all_pairings) {
    const RegionPieces& pieces = report.pieces_of(pairing);
    std::string key;
    append_all(key, pairing == all_pairings[0] ? "\"" : ",\n\"", name(pairing), "\": ");
    file.write(key);
    write_list(file, pieces.size(), [&](std::string& text, std::size_t k) {
      put(text, "{\"area\":", pieces[k].area, ",\"holes\":", pieces[k].holes, "}");
    });
  }
  file.write("},\n");
}

}  // namespace

void write_regions_json(const std::string& path, RegionsReport& report, const std::function<double()>& seconds_so_far) {
  const detail::Stopwatch watch;
  const Regions& result = report.result;
  JsonFile json(path, "overlay");
  json.member("inputs", inputs_json(report.inputs, result));
  json.member("options",
              {{"index", name(report.index)}, {"areas_only", report.areas_only}, {"rule", name(report.rule)}});
  json.member("rule", name(report.rule));
  json.member("arrangement", arrangement_json(result.counts()));
  list_windings(json, result);
  json.member("areas", areas_json(result.areas(report.rule)));
  if (!report.areas_only) write_pieces(json.file(), report);
  json.member("error", region_errors_json(result, report.rule));
  json.member("statistics", region_statistics_json(result.counts()));
  report.write_seconds += watch.seconds();
  Json seconds{{"read", report.read_seconds}};
  seconds.update(region_timing_json(result.timing()));
  seconds.update({{"pieces", report.pieces_seconds}, {"write", report.write_seconds}, {"total", seconds_so_far()}});
  json.finish(seconds);
}

}  // namespace lober::cli
