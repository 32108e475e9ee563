#include "cli/report/regions_parts.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace lober::cli {

std::array<Orientation, 2> orientations_of(const Regions& regions) {
  const auto sign = [](double area) {
    return area > 0 ? Orientation::counter_clockwise : area < 0 ? Orientation::clockwise : Orientation::degenerate;
  };
  return {sign(regions.signed_areas()[0]), sign(regions.signed_areas()[1])};
}

std::string windings_text(const Regions& regions) {
  constexpr std::size_t most = 20;
  const RegionCounts& counts = regions.counts();
  std::string text =
      fmt::format("\n{}, {}\n", counted(counts.nodes, "node", "nodes"), counted(counts.faces, "face", "faces"));
  text += fmt::format("\n{:>8} {:>8} {:>23}\n", "C1 winds", "C2 winds", "area");
  const std::size_t size = regions.table().size();
  for (const WindingArea& entry : regions.table().first(std::min(most, size))) {
    text += fmt::format("{:>8} {:>8} {:>23.16g}\n", entry.w1, entry.w2, entry.area);
  }
  if (size > most) text += fmt::format("{:>8} and {} more pairs\n", "...", size - most);
  return text;
}

std::string region_areas_text(const Regions& regions, FillRule rule) {
  std::string text = fmt::format("\n{:<16} {:>23}  {:>10}\n", std::string(name(rule)) + " area of", "", "+- rounding");
  const Areas areas = regions.areas(rule), bounds = regions.rounding(rule);
  for (const NamedArea& area : named_areas) {
    text += fmt::format("{:<16} {:>23.16g}  {:>11.1e}\n", area.label, areas.*area.member, bounds.*area.member);
  }
  return text;
}

Json inputs_json(const std::array<NamedCurve, 2>& inputs, const Regions& regions) {
  Json list = Json::array();
  for (std::size_t k = 0; k < 2; ++k) {
    list.push_back(input_json(inputs[k], std::abs(regions.signed_areas()[k]), orientations_of(regions)[k]));
  }
  return list;
}

Json arrangement_json(const RegionCounts& counts) {
  return {{"nodes", counts.nodes},
          {"edges", counts.edges},
          {"faces", counts.faces},
          {"meetings", {{"c1", counts.self1}, {"c2", counts.self2}, {"c1_c2", counts.mutual}}}};
}

Json region_statistics_json(const RegionCounts& counts) {
  return {{"index", name(counts.index)},
          {"boxes_tested", counts.search.boxes_tested},
          {"pairs_tested", counts.search.pairs_proposed},
          {"filter_failures", counts.predicates.filter_failures},
          {"exact_calls", counts.predicates.exact_calls},
          {"exact_parameters", counts.exact_parameters},
          {"exact_orders", counts.exact_orders},
          {"skipped", {{"blocks", counts.search.blocks_skipped}}}};
}

void list_windings(JsonFile& json, const Regions& regions) {
  json.list("winding", regions.table().size(), [&](std::string& text, std::size_t k) {
    const WindingArea& entry = regions.table()[k];
    put(text, "{\"c1\":", entry.w1, ",\"c2\":", entry.w2, ",\"area\":", entry.area, "}");
  });
}

Json region_errors_json(const Regions& regions, FillRule rule) {
  return {{"rounding", areas_json(regions.rounding(rule))},
          {"meaning", {{"rounding", "bound on |area - exact area of the region of the polygons as given|"}}}};
}

Json region_timing_json(const RegionTiming& timing) {
  return {{"index", timing.index},
          {"search", timing.search},
          {"nodes", timing.nodes},
          {"graph", timing.graph},
          {"faces", timing.faces}};
}

}  // namespace lober::cli
