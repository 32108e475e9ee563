// The table of `lober overlay` for people.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/overlay/overlay_report.hpp"
#include "cli/report/agreement_report.hpp"

namespace lober::cli {
namespace {

void add_areas(std::string& text, const CurveOverlay& found) {
  const std::optional<SmoothAreas>& smooth = found.smooth;
  Table table = areas_table("area of", smooth ? "polygons" : "");
  if (found.discretisation) table.add({"discretisation", 15});
  if (found.consistency) table.add({"consistency", 13});
  if (smooth) {
    table.add({"smooth", 23});
    table.add({"+-", 9, Align::right, 2});
  }
  text += "\n" + table.head();
  for (const NamedArea& area : named_areas) {
    std::vector<std::string> cells = area_cells(area, found.areas, found.rounding);
    if (found.discretisation) cells.push_back(fmt::format("{:.1e}", (*found.discretisation).*area.member));
    if (found.consistency) cells.push_back(fmt::format("{:.1e}", (*found.consistency).*area.member));
    if (smooth) {
      cells.push_back(fmt::format("{:.16g}", smooth->areas.*area.member));
      cells.push_back(fmt::format("{:.1e}", smooth->error.*area.member));
    }
    text += table.row(cells);
  }
  if (smooth && smooth->fallback_segments + smooth->fallback_crossings > 0) {
    text += fmt::format("not smooth: {}, {}\n", counted(smooth->fallback_segments, "segment", "segments"),
                        counted(smooth->fallback_crossings, "crossing", "crossings"));
  }
}

// "0 1 2 3 4 5 6 7 ... (20)": the crossings of a piece, shortened.
std::string crossings_text(const PieceCrossings& crossings) {
  constexpr std::size_t most = 8;
  std::string text;
  std::size_t count = 0;
  for (const std::uint32_t node : crossings) {
    if (count++ < most) text += fmt::format("{}{}", text.empty() ? "" : " ", node);
  }
  if (count > most) text += fmt::format(" ... ({})", count);
  return text.empty() ? "-" : text;
}

// As many digits as tell points of the curves apart, five across their extent: eddies of 100 m in coordinates of 5e6 m
// need more than those about the origin.
int centroid_digits(const CurveOverlay& found) {
  Rectangle box;
  for (const Point& point : found.nodes.curve1().points) box.add(point);
  for (const Point& point : found.nodes.curve2().points) box.add(point);
  constexpr int usual = 5, all = 17;
  const double largest =
      std::max({std::fabs(box.min_x), std::fabs(box.max_x), std::fabs(box.min_y), std::fabs(box.max_y)});
  int digits = usual;
  for (double extent = std::max(box.width(), box.height()); digits < all && largest >= 10 * extent; extent *= 10)
    ++digits;
  return digits;
}

void add_pieces(std::string& text, const CurveOverlay& found, Pairing pairing, const char* label) {
  const Pieces& pieces = found.pieces(pairing);
  const Slivers slivers = find_slivers(found, pairing);
  text += fmt::format("\n{}: {}\n", label, pieces.size() == 0 ? "no lobe" : counted(pieces.size(), "lobe", "lobes"));
  if (pieces.size() == 0) return;
  const int digits = centroid_digits(found), width = digits + 6;
  const Table table({{"lobe", 8, Align::right, 0},
                     {"area", 23},
                     {"centroid", 2 * static_cast<std::size_t>(width) + 4, Align::centre, 3},
                     {"holes", 6},
                     {"crossings", 0, Align::left, 2}});
  text += table.head();
  const std::vector<std::uint32_t> order = largest(pieces.areas());
  for (const std::uint32_t number : order) {
    const Piece piece = pieces[number];
    const Point at = centroid(found, pairing, number);
    text += table.row({std::to_string(number), fmt::format("{:.16g}", piece.area),
                       fmt::format("({:>{}.{}g}, {:>{}.{}g})", at.x, width, digits, at.y, width, digits),
                       std::to_string(piece.holes), crossings_text(piece.crossings)});
  }
  if (pieces.size() > order.size()) text += fmt::format("{:>8} and {} more\n", "...", pieces.size() - order.size());
  if (!slivers.pieces.empty()) {
    text += fmt::format("         {} no wider than rounding, {:.2g} in total\n",
                        counted(slivers.pieces.size(), "sliver", "slivers"), slivers.area);
  }
}

}  // namespace

std::string overlay_table(const CurvesReport& report) {
  const auto& found = report.outcome.as<CurveOverlay>();
  std::string text = agreement_text(found.agreement);
  text += inputs_text(report.inputs, {found.orientation1, found.orientation2});
  text += "\n" + meetings_text(found.nodes) + "\n";
  add_areas(text, found);
  if (found.has_pieces) {
    add_pieces(text, found, Pairing::c1_minus_c2, "C1 \\ C2");
    add_pieces(text, found, Pairing::c2_minus_c1, "C2 \\ C1");
  }
  return text + classes_text(found);
}

}  // namespace lober::cli
