// The table of `lober overlay --rule` for people.

#include <spdlog/fmt/fmt.h>

#include "cli/overlay/regions_report.hpp"
#include "cli/report/regions_parts.hpp"

namespace lober::cli {
namespace {

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
  std::string text = inputs_text(report.inputs, orientations_of(report.result));
  text += windings_text(report.result);
  text += region_areas_text(report.result, report.rule);
  if (!report.areas_only) {
    add_pieces(text, report, Pairing::c1_minus_c2, "C1 \\ C2");
    add_pieces(text, report, Pairing::c2_minus_c1, "C2 \\ C1");
  }
  return text;
}

}  // namespace lober::cli
