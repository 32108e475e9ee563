// The table of `lober overlay --rule` for people.

#include <spdlog/fmt/fmt.h>

#include "cli/overlay/regions_report.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t shown_windings = 20;

void add_windings(std::string& text, const Regions& result) {
  text += fmt::format("\n{:>8} {:>8} {:>23}\n", "C1 winds", "C2 winds", "area");
  const std::size_t size = result.table().size();
  for (const WindingArea& entry : result.table().first(std::min(shown_windings, size))) {
    text += fmt::format("{:>8} {:>8} {:>23.16g}\n", entry.w1, entry.w2, entry.area);
  }
  if (size > shown_windings) text += fmt::format("{:>8} and {} more pairs\n", "...", size - shown_windings);
}

void add_areas(std::string& text, const RegionsReport& report) {
  text += fmt::format("\n{:<16} {:>23}  {:>10}\n", std::string(name(report.rule)) + " area of", "", "+- rounding");
  const Areas areas = report.result.areas(report.rule), bounds = report.result.rounding(report.rule);
  for (const NamedArea& area : named_areas) {
    text += fmt::format("{:<16} {:>23.16g}  {:>11.1e}\n", area.label, areas.*area.member, bounds.*area.member);
  }
}

void add_pieces(std::string& text, const RegionsReport& report, Pairing pairing, const char* label) {
  const RegionPieces& pieces = report.pieces_of(pairing);
  text += fmt::format("\n{}: {}\n", label, pieces.size() == 0 ? "no lobe" : counted(pieces.size(), "lobe", "lobes"));
  if (pieces.size() == 0) return;
  text += fmt::format("{:>8} {:>23} {:>6}\n", "lobe", "area", "holes");
  const std::vector<std::uint32_t> order = largest(pieces.areas());
  for (const std::uint32_t number : order) {
    text += fmt::format("{:>8} {:>23.16g} {:>6}\n", number, pieces[number].area, pieces[number].holes);
  }
  if (pieces.size() > order.size()) text += fmt::format("{:>8} and {} more\n", "...", pieces.size() - order.size());
}

}  // namespace

std::string regions_table(const RegionsReport& report) {
  std::string text = inputs_text(report.inputs, report.orientations());
  const RegionCounts& counts = report.result.counts();
  text += fmt::format("\n{}, {}\n", counted(counts.nodes, "node", "nodes"), counted(counts.faces, "face", "faces"));
  add_windings(text, report.result);
  add_areas(text, report);
  if (!report.areas_only) {
    add_pieces(text, report, Pairing::c1_minus_c2, "C1 \\ C2");
    add_pieces(text, report, Pairing::c2_minus_c1, "C2 \\ C1");
  }
  return text;
}

}  // namespace lober::cli
