// The JSON object of `lober overlay --rule`. Its members are a contract; more may be added, none renamed.

#include "cli/overlay/regions_report.hpp"
#include "cli/report/json_file.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {
namespace {

Json counts_json(const RegionCounts& counts) {
  return {{"nodes", counts.nodes},
          {"edges", counts.edges},
          {"faces", counts.faces},
          {"meetings", {{"c1", counts.self1}, {"c2", counts.self2}, {"c1_c2", counts.mutual}}}};
}

Json statistics_json(const RegionCounts& counts) {
  return {{"index", name(counts.index)},
          {"boxes_tested", counts.search.boxes_tested},
          {"pairs_tested", counts.search.pairs_proposed},
          {"filter_failures", counts.predicates.filter_failures},
          {"exact_calls", counts.predicates.exact_calls},
          {"exact_parameters", counts.exact_parameters},
          {"exact_orders", counts.exact_orders},
          {"skipped", {{"blocks", counts.search.blocks_skipped}}}};
}

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
  Json inputs = Json::array();
  for (std::size_t k = 0; k < 2; ++k) {
    inputs.push_back(input_json(report.inputs[k], std::abs(result.signed_areas()[k]), report.orientations()[k]));
  }
  json.member("inputs", inputs);
  json.member("options",
              {{"index", name(report.index)}, {"areas_only", report.areas_only}, {"rule", name(report.rule)}});
  json.member("rule", name(report.rule));
  json.member("arrangement", counts_json(result.counts()));
  json.list("winding", result.table().size(), [&](std::string& text, std::size_t k) {
    const WindingArea& entry = result.table()[k];
    put(text, "{\"c1\":", entry.w1, ",\"c2\":", entry.w2, ",\"area\":", entry.area, "}");
  });
  json.member("areas", areas_json(result.areas(report.rule)));
  if (!report.areas_only) write_pieces(json.file(), report);
  json.member("error",
              {{"rounding", areas_json(result.rounding(report.rule))},
               {"meaning", {{"rounding", "bound on |area - exact area of the region of the polygons as given|"}}}});
  json.member("statistics", statistics_json(result.counts()));
  const RegionTiming& timing = result.timing();
  report.write_seconds += watch.seconds();
  const Json seconds{{"read", report.read_seconds},     {"index", timing.index},         {"search", timing.search},
                     {"nodes", timing.nodes},           {"graph", timing.graph},         {"faces", timing.faces},
                     {"pieces", report.pieces_seconds}, {"write", report.write_seconds}, {"total", seconds_so_far()}};
  json.finish(seconds);
}

}  // namespace lober::cli
