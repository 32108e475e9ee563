// The JSON object of `lober overlay`. Its members are a contract; more may be added, none renamed.

#include <algorithm>

#include "cli/overlay/overlay_report.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/json_file.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {
namespace {

Json statistics_json(const OverlayStatistics& statistics) {
  Json object{{"index", name(statistics.index)}, {"index_bytes", statistics.index_bytes}};
  object.update(counts_json(statistics.counts));
  object["simple_check"] = simple_check_json(statistics.simple_check, statistics.simple_check_pairs);
  return object;
}

void format_node(std::string& text, const Node& node, std::size_t index, std::uint32_t class_number,
                 std::uint32_t rank2) {
  put(text, "{\"index\":", index, ",\"kind\":\"", kind_of(node), "\",\"rho\":", node.rho);
  const auto end_point = [&](Point point, Position on1, Position on2) {
    put(text, "\"x\":", point.x, ",\"y\":", point.y, ",\"segment1\":", on1.segment, ",\"t1\":", on1.t,
        ",\"segment2\":", on2.segment, ",\"t2\":", on2.t);
  };
  put(text, ",");
  end_point(node.begin, node.begin1, node.begin2);
  if (node.shared != 0) {
    put(text, ",\"shared\":", node.shared, ",\"end\":{");
    end_point(node.end, node.end1, node.end2);
    put(text, "}");
  }
  put(text, ",\"class\":");
  if (class_number == Overlay::no_class) {
    put(text, "null");
  } else {
    put(text, class_number);
  }
  put(text, ",\"order2\":", rank2, "}");
}

void write_crossings_member(detail::OutputFile& file, const OverlayReport& report) {
  const Overlay& result = report.result;
  Json head = meetings_json(result.nodes);
  if (report.options.pieces) head["classes"] = result.class_count;
  std::string text = dumped(head);
  text.back() = ',';  // the object goes on with the list
  file.write("\"crossings\": ");
  file.write(text);
  file.write("\"list\": ");
  write_list(file, result.nodes.size(), [&](std::string& line, std::size_t k) {
    const std::uint32_t class_number = result.classes.empty() ? Overlay::no_class : result.classes[k];
    format_node(line, result.nodes[k], k, class_number, result.nodes.rank2(k));
  });
  file.write("},\n");
}

void write_pieces_member(detail::OutputFile& file, const OverlayReport& report) {
  file.write("\"pieces\": {");
  for (const Pairing pairing : all_pairings) {
    const Pieces& pieces = report.result.pieces(pairing);
    const std::vector<Point>& centroids = report.centroids_of(pairing);
    const std::vector<std::uint32_t>& slivers = report.slivers_of(pairing).pieces;
    std::string key;
    append_all(key, pairing == all_pairings[0] ? "\"" : ",\n\"", name(pairing), "\": ");
    file.write(key);
    write_list(file, pieces.size(), [&](std::string& text, std::size_t k) {
      const Piece piece = pieces[k];
      put(text, "{\"area\":", piece.area, ",\"centroid\":[", centroids[k].x, ",", centroids[k].y, "],\"crossings\":[");
      const char* separator = "";
      for (const std::uint32_t node : piece.crossings) {
        put(text, separator, node);
        separator = ",";
      }
      const bool sliver = std::binary_search(slivers.begin(), slivers.end(), static_cast<std::uint32_t>(k));
      put(text, "],\"holes\":", piece.holes, ",\"sliver\":", sliver ? "true" : "false", "}");
    });
  }
  file.write("},\n");
}

Json slivers_json(const OverlayReport& report) {
  Json object;
  for (const Pairing pairing : all_pairings) {
    const Slivers& slivers = report.slivers_of(pairing);
    object[std::string(name(pairing))] = {{"count", slivers.pieces.size()}, {"area", slivers.area}};
  }
  return object;
}

Json error_json(const OverlayReport& report) {
  Json error{{"rounding", areas_json(report.result.rounding)}, {"discretisation", areas_json(report.discretisation)}};
  Json meaning{
      {"rounding", "bound on |area - exact area of the polygons as given|"},
      {"discretisation", "estimate of |area of the polygons - area between smooth curves through the same points|"}};
  if (report.consistency) {
    error["consistency"] = areas_json(*report.consistency);
    meaning["consistency"] = "|area by the overlay - area by the interior method|";
  }
  error["meaning"] = std::move(meaning);
  return error;
}

}  // namespace

void write_overlay_json(const std::string& path, OverlayReport& report, const std::function<double()>& seconds_so_far) {
  const detail::Stopwatch watch;
  const Overlay& result = report.result;
  JsonFile json(path, "overlay");
  json.member("inputs", Json::array({input_json(report.inputs[0], result.areas.c1, result.orientation1),
                                     input_json(report.inputs[1], result.areas.c2, result.orientation2)}));
  json.member("options", {{"index", name(report.options.index)},
                          {"areas_only", !report.options.pieces},
                          {"check_simple", report.options.check_simple},
                          {"verify", report.consistency.has_value()},
                          {"smooth", report.smooth.has_value()},
                          {"classes", report.steps.has_value()}});
  write_crossings_member(json.file(), report);
  if (report.steps) json.member("sigma", sigma_json(report));
  if (report.consistency || report.smooth || report.steps) {
    add_agreement(json, report.agreement);
  }
  json.member("areas", areas_json(result.areas));
  if (report.smooth) {
    const SmoothAreas& smooth = *report.smooth;
    json.member("smooth", {{"areas", areas_json(smooth.areas)},
                           {"error", areas_json(smooth.error)},
                           {"fallback_segments", smooth.fallback_segments},
                           {"fallback_crossings", smooth.fallback_crossings}});
  }
  if (report.options.pieces) {
    write_pieces_member(json.file(), report);
    json.member("slivers", slivers_json(report));
  }
  json.member("error", error_json(report));
  json.member("statistics", statistics_json(result.statistics));
  ReportTiming& timing = report.timing;
  timing.write += watch.seconds();
  Json seconds{{"read", timing.read},           {"index", timing.index}, {"check", timing.check},
               {"crossings", timing.crossings}, {"order", timing.order}, {"areas", timing.areas},
               {"measures", timing.measures}};
  if (report.consistency) seconds["verify"] = timing.verify;
  if (report.smooth) seconds["smooth"] = timing.smooth;
  seconds["write"] = timing.write;
  seconds["total"] = seconds_so_far();
  json.finish(seconds);
}

}  // namespace lober::cli
