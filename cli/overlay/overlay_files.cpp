// The files of lobes and of crossings.

#include <algorithm>

#include "cli/overlay/overlay_report.hpp"
#include "cli/report/text.hpp"
#include "engine/base/json_text.hpp"
#include "engine/base/output_file.hpp"
#include "engine/base/parallel/ordered_pipeline.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "lober/curve/formats.hpp"

namespace lober::cli {
namespace {

constexpr const char* crossings_header =
    "# Where the two curves meet, in order along C1.\n"
    "# index     from 0; `class` and the pieces of the JSON output speak of it\n"
    "# x,y       the point (of a shared arc: where it begins along C1)\n"
    "# rho       1: C1 leaves the region of C2; -1: it enters; 0: it does not cross (both "
    "counter-clockwise)\n"
    "# kind      crossing, touch or shared_arc\n"
    "# segment1,t1 segment2,t2   the same point on C1 and C2: t in [0, 1) along the segment from vertex "
    "`segment`, from 0\n"
    "# class     equivalence class of a crossing under sigma; empty if it has none or totals only were asked "
    "for\n"
    "# order2    its place along C2, from 0\n"
    "# end_...   where a shared arc ends along C1; empty for points\n";
constexpr const char* sigma_header =
    "# along1,along2 sigma class s   of A1 \\ A2 (_12) and A2 \\ A1 (_21): the next crossing along C1 and C2 in the "
    "direction of the pairing, sigma, its class, and the integral of x dy - y dx to it\n";
constexpr const char* crossings_columns =
    "index,x,y,rho,kind,segment1,t1,segment2,t2,class,order2,end_x,end_y,end_segment1,end_t1,end_segment2,end_t2";

void format_crossing(std::string& text, const CurveOverlay& result, std::size_t k) {
  const Node node = result.nodes[k];
  append_all(text, k, ",", node.begin.x, ",", node.begin.y, ",", node.rho, ",", kind_of(node), ",", node.begin1.segment,
             ",", node.begin1.t, ",", node.begin2.segment, ",", node.begin2.t, ",");
  if (!result.classes.empty() && result.classes[k] != Overlay::no_class) append(text, result.classes[k]);
  append_all(text, ",", result.nodes.rank2(k));
  if (node.shared == 0) {
    text += ",,,,,,";
  } else {
    append_all(text, ",", node.end.x, ",", node.end.y, ",", node.end1.segment, ",", node.end1.t, ",", node.end2.segment,
               ",", node.end2.t);
  }
  if (result.steps) append_sigma(text, result, k);
  text += "\n";
}

// The zones of one piece: its outer polygon, then its holes.
std::vector<Zone> zones_of(Pairing pairing, std::size_t piece, double area, std::vector<std::vector<Point>> polygons) {
  std::string title(name(pairing));
  append_all(title, " ", piece, " area=", area);
  std::vector<Zone> zones;
  for (std::vector<Point>& polygon : polygons) {
    zones.push_back({title, std::move(polygon)});
    zones.back().hole = zones.size() > 1;
    zones.back().numbers = {{"piece", static_cast<double>(piece)}};
    if (!zones.back().hole) zones.back().numbers.emplace_back("area", area);  // that of the piece, once
    title = name(pairing);
    append_all(title, " ", piece, " hole ", zones.size());
  }
  return zones;
}

// Writes `count(pairing)` pieces of C1 \ C2 and C2 \ C1, each by `zones(pairing, piece)`.
template <typename Count, typename Zones>
void write_pieces(const std::string& path, const CurveFileOptions& options, const Count& count, const Zones& zones) {
  std::vector<Zone> all;
  for (const Pairing pairing : {Pairing::c1_minus_c2, Pairing::c2_minus_c1}) {
    std::vector<std::vector<Zone>> by_piece(count(pairing));
    detail::for_each_block(by_piece.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) by_piece[k] = zones(pairing, k);
    });
    for (std::vector<Zone>& piece : by_piece) std::move(piece.begin(), piece.end(), std::back_inserter(all));
  }
  write_curve_file(path, all, options);
}

}  // namespace

void write_lobes(const std::string& path, const CurveOverlay& found, const CurveFileOptions& options) {
  write_pieces(
      path, options, [&](Pairing pairing) { return found.pieces(pairing).size(); },
      [&](Pairing pairing, std::size_t k) {
        return zones_of(pairing, k, found.pieces(pairing).areas()[k], outline(found, pairing, k));
      });
}

void write_lobes(const std::string& path, const CurveRegions& found, const CurveFileOptions& options) {
  const auto pieces_of = [&](Pairing pairing) -> const RegionPieces& {
    return (*found.pieces)[static_cast<std::size_t>(pairing)];
  };
  write_pieces(
      path, options, [&](Pairing pairing) { return pieces_of(pairing).size(); },
      [&](Pairing pairing, std::size_t k) {
        return zones_of(pairing, k, pieces_of(pairing).areas()[k], pieces_of(pairing).outline(k));
      });
}

void write_rings(detail::OutputFile& file, const CurveOverlay& found) {
  std::string text = "\"rings\": {";
  for (const Pairing pairing : all_pairings) {
    append_all(text, pairing == all_pairings.front() ? "\"" : ",\n \"", name(pairing), "\": [");
    for (std::size_t k = 0; k < found.pieces(pairing).size(); ++k) {
      text += k == 0 ? "\n  [" : ",\n  [";
      bool first = true;
      for (const std::vector<Point>& ring : outline(found, pairing, k)) {
        text += first ? "[" : ",[";
        first = false;
        for (const Point& point : ring) {
          text += &point == ring.data() ? "[" : ",[";
          detail::append_json_number(text, point.x);
          text += ',';
          detail::append_json_number(text, point.y);
          text += ']';
        }
        text += ']';
      }
      text += ']';
      file.write(text);
      text.clear();
    }
    text += ']';
  }
  file.write(text + "},\n");
}

void write_crossings(const std::string& path, const CurveOverlay& found) {
  if (format_of_name(path) == Format::npy) return write_crossings_npy(path, found);
  detail::OutputFile file(path);
  file.write(crossings_header);
  if (found.steps) file.write(sigma_header);
  file.write(crossings_columns + (found.steps ? sigma_columns() : std::string()) + "\n");
  std::string text;
  for (std::size_t k = 0; k < found.nodes.size(); ++k) {
    format_crossing(text, found, k);
    if (text.size() < (std::size_t{1} << 20)) continue;
    file.write(text);
    text.clear();
  }
  file.write(text);
  file.commit();
}

}  // namespace lober::cli
