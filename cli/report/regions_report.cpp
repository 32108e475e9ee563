#include "cli/report/regions_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/program/running.hpp"
#include "cli/report/report.hpp"

namespace lober::cli {
namespace {

using operations::CurveRegions;

// Signs of the signed areas.
std::array<Orientation, 2> orientations_of(const Regions& regions) {
  const auto sign = [](double area) {
    return area > 0 ? Orientation::counter_clockwise : area < 0 ? Orientation::clockwise : Orientation::degenerate;
  };
  return {sign(regions.signed_areas()[0]), sign(regions.signed_areas()[1])};
}

void add_windings(std::string& text, const Regions& regions) {
  constexpr std::size_t most = 20;
  const RegionCounts& counts = regions.counts();
  text += fmt::format("\n{}, {}\n", counted(counts.nodes, "node", "nodes"), counted(counts.faces, "face", "faces"));
  const Table table({{"C1 winds", 8, Align::right, 0}, {"C2 winds", 8}, {"area", 23}});
  text += "\n" + table.head();
  const std::size_t size = regions.table().size();
  for (const WindingArea& entry : regions.table().first(std::min(most, size))) {
    text += table.row({std::to_string(entry.w1), std::to_string(entry.w2), fmt::format("{:.16g}", entry.area)});
  }
  if (size > most) text += fmt::format("{:>8} and {} more pairs\n", "...", size - most);
}

void add_areas(std::string& text, const Regions& regions, FillRule rule) {
  const Table table = areas_table(std::string(name(rule)) + " area of", "");
  text += "\n" + table.head();
  const Areas areas = regions.areas(rule), bounds = regions.rounding(rule);
  for (const NamedArea& area : named_areas) text += table.row(area_cells(area, areas, bounds));
}

void add_pieces(std::string& text, const RegionPieces& pieces, const char* label) {
  text += fmt::format("\n{}: {}\n", label, pieces.size() == 0 ? "no lobe" : counted(pieces.size(), "lobe", "lobes"));
  if (pieces.size() == 0) return;
  const Table table({{"lobe", 8, Align::right, 0}, {"area", 23}, {"holes", 6}});
  text += table.head();
  const std::vector<std::uint32_t> order = largest(pieces.areas());
  for (const std::uint32_t number : order) {
    text += table.row(
        {std::to_string(number), fmt::format("{:.16g}", pieces[number].area), std::to_string(pieces[number].holes)});
  }
  if (pieces.size() > order.size()) text += fmt::format("{:>8} and {} more\n", "...", pieces.size() - order.size());
}

}  // namespace

std::string regions_table(const CurvesReport& report) {
  const auto& found = report.outcome.as<CurveRegions>();
  std::string text = inputs_text(report.inputs, orientations_of(found.regions));
  add_windings(text, found.regions);
  add_areas(text, found.regions, found.rule);
  if (!found.pieces) return text;
  add_pieces(text, (*found.pieces)[static_cast<std::size_t>(Pairing::c1_minus_c2)], "C1 \\ C2");
  add_pieces(text, (*found.pieces)[static_cast<std::size_t>(Pairing::c2_minus_c1)], "C2 \\ C1");
  return text;
}

void write_regions_json(const std::string& path, std::string_view command, CurvesReport& report,
                        const std::function<double()>& seconds_so_far) {
  const Regions& regions = report.outcome.as<CurveRegions>().regions;
  const RegionTiming& timing = regions.timing();
  const auto [area1, area2] = regions.signed_areas();
  write_curves_json(
      path, command, "regions", report, {std::abs(area1), std::abs(area2)}, orientations_of(regions),
      {{"search", timing.search}, {"nodes", timing.nodes}, {"graph", timing.graph}, {"faces", timing.faces}},
      seconds_so_far);
}

void report_regions_timing(const CurvesReport& report) {
  const RegionTiming& timing = report.outcome.as<CurveRegions>().regions.timing();
  report_seconds({{"read", report.read_seconds},
                  {"index", report.index_seconds},
                  {"search", timing.search},
                  {"nodes", timing.nodes},
                  {"graph", timing.graph},
                  {"faces", timing.faces},
                  {"write", report.write_seconds}});
}

}  // namespace lober::cli
