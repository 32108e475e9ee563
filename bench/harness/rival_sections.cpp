#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <sstream>

#include "bench/harness/child.hpp"
#include "bench/harness/errors.hpp"
#include "bench/harness/measure.hpp"
#include "bench/harness/sections.hpp"
#include "bench/harness/table.hpp"

namespace lober::bench {
namespace {

// Areas that differ by more than this, or another number of pieces, are a wrong answer.
constexpr double right_areas = 1e-6;

std::array<double, 4> areas_of(const RivalResult& result) {
  return {result.areas[0], result.areas[1], result.areas[2], result.areas[3]};
}

template <typename Counts>
std::string list(const Counts& pieces) {
  std::ostringstream text;
  for (std::size_t k = 0; k < 4; ++k) text << (k == 0 ? "" : "/") << pieces[k];
  return text.str();
}

std::string ratio(double rival, const OverlayTimes& ours) {
  return digits3(rival / ours.seconds);
}

// Remarks on the rows of a table, as a list to print below it.
class Remarks {
 public:
  void add(const SceneKind& kind, std::string_view rival, const std::string& remark) {
    if (remark.empty()) return;
    text_ << "- " << kind.name << ", " << rival << ": " << remark << "\n";
  }
  friend std::ostream& operator<<(std::ostream& stream, const Remarks& remarks) {
    const std::string text = remarks.text_.str();
    return text.empty() ? stream
                        : stream << "Remarks (pieces are C1 - C2 / C2 - C1 / intersection / union):\n\n"
                                 << text << '\n';
  }

 private:
  std::ostringstream text_;
};

// The fault of an answer; empty when it is right.
std::string fault(const RivalResult& result, const OverlayTimes& ours, double error) {
  std::string text;
  if (!std::equal(ours.pieces.begin(), ours.pieces.end(), result.pieces)) {
    text = "pieces " + list(result.pieces) + ", ours " + list(ours.pieces);
  }
  if (!(error <= right_areas)) text += (text.empty() ? "" : "; ") + ("areas wrong by " + one_digit(error));
  return text;
}

OverlayTimes time_ours(const Scene& scene, const Options& options) {
  return time_overlay(scene, 1, {.index = options.index}, options.repeat);
}

RivalResult run_rival(const Rival& rival, const SceneKind& kind, std::size_t points, const Options& options) {
  std::cerr << kind.name << ", " << rival.name << " at " << points << " points ..." << std::endl;
  return run_rival_apart(rival, kind, points, options.limit);
}

// A rival that did not finish, on a tenth of the points.
std::string with_fewer_points(const Rival& rival, const SceneKind& kind, const Options& options) {
  const std::size_t points = options.points / 10;
  const RivalResult result = run_rival(rival, kind, points, options);
  const std::string at = "; at " + std::to_string(points) + " points ";
  if (!result.ran) return at + result.note;
  const Scene scene = kind.make(points);
  const OverlayTimes ours = time_ours(scene, options);
  const std::string wrong = fault(result, ours, area_error(areas_of(result), ours.areas, scene));
  return at + milliseconds(result.seconds) + " ms, ratio " + ratio(result.seconds, ours) +
         (wrong.empty() ? "" : ", " + wrong);
}

}  // namespace

void fast_rivals_section(const Options& options, std::ostream& out) {
  out << "### Against general overlay libraries, " << options.points << " + " << options.points << " points\n\n"
      << "All four pairings with pieces, one thread, times in ms; theirs without bringing the points into "
         "their form. "
         "`alone`: their intersection alone against our whole job. `error`: the worst of the four areas "
         "against ours, relative. "
         "The last column is for the fastest rival that gets the areas to "
      << right_areas << " and the number of pieces. A rival that is not done after " << options.limit
      << " s is run on a tenth of the points.\n\n";
  std::vector<std::string> header{"scene", "lober"};
  for (const Rival& rival : rivals()) {
    if (rival.fast) header.insert(header.end(), {std::string(rival.name), "ratio", "alone", "error"});
  }
  header.push_back("fastest right");
  Table table(header);
  Remarks remarks;
  for (const SceneKind* kind : options.scenes) {
    const Scene scene = kind->make(options.points);
    const OverlayTimes ours = time_ours(scene, options);
    std::vector<std::string> row{std::string(kind->name), milliseconds(ours.seconds)};
    double fastest = std::numeric_limits<double>::infinity();
    for (const Rival& rival : rivals()) {
      if (!rival.fast) continue;
      const RivalResult result = run_rival(rival, *kind, options.points, options);
      if (!result.ran) {
        row.insert(row.end(), {"-", "-", "-", "-"});
        remarks.add(*kind, rival.name, result.note + with_fewer_points(rival, *kind, options));
        continue;
      }
      const double error = area_error(areas_of(result), ours.areas, scene);
      const std::string wrong = fault(result, ours, error);
      row.insert(row.end(), {milliseconds(result.seconds), ratio(result.seconds, ours),
                             ratio(result.intersection_seconds, ours), one_digit(error)});
      remarks.add(*kind, rival.name, wrong);
      if (wrong.empty()) fastest = std::min(fastest, result.seconds);
    }
    row.push_back(ratio(fastest, ours));
    table.add(row);
  }
  out << table << remarks << std::flush;
}

void all_rivals_section(const Options& options, std::ostream& out) {
  const double factor = static_cast<double>(options.points) / static_cast<double>(options.small_points);
  out << "### Run time against error, " << options.small_points << " + " << options.small_points << " points\n\n"
      << "One thread, times in ms. `error`: the worst of the four areas, relative, against CGAL's exact "
         "arithmetic "
         "(rounded to double); in brackets against ours, where CGAL is not done after "
      << options.limit
      << " s. CGAL's polygons that touch in a vertex are joined into one piece. The quadratic method is that "
         "of Naik, Lekien & Ross (2017); the last column is its time extrapolated to "
      << options.points << " points by the square.\n\n";
  std::vector<std::string> header{"scene", "lober", "error"};
  for (const Rival& rival : rivals()) {
    header.insert(header.end(), {std::string(rival.name), "ratio"});
    if (!rival.exact) header.push_back("error");
  }
  header.push_back("extrapolated");
  Table table(header);
  Remarks remarks;
  for (const SceneKind* kind : options.scenes) {
    const Scene scene = kind->make(options.small_points);
    const OverlayTimes ours = time_ours(scene, options);
    std::vector<RivalResult> results;
    std::array<double, 4> reference = ours.areas;
    bool exact = false;
    for (const Rival& rival : rivals()) {
      results.push_back(run_rival(rival, *kind, options.small_points, options));
      if (!rival.exact || !results.back().ran) continue;
      exact = true;
      reference = areas_of(results.back());
    }
    const auto format_error = [&](double error) { return exact ? one_digit(error) : "(" + one_digit(error) + ")"; };
    std::vector<std::string> row{std::string(kind->name), milliseconds(ours.seconds),
                                 exact ? one_digit(area_error(ours.areas, reference, scene)) : "-"};
    std::string extrapolated = "-";
    for (std::size_t k = 0; k < results.size(); ++k) {
      const Rival& rival = rivals()[k];
      const RivalResult& result = results[k];
      const double error = area_error(areas_of(result), reference, scene);
      row.push_back(result.ran ? milliseconds(result.seconds) : "-");
      row.push_back(result.ran ? ratio(result.seconds, ours) : "-");
      if (!rival.exact) row.push_back(result.ran ? format_error(error) : "-");
      remarks.add(*kind, rival.name, result.ran ? fault(result, ours, error) : result.note);
      if (rival.quadratic && result.ran) extrapolated = digits3(result.seconds * factor * factor) + " s";
    }
    row.push_back(extrapolated);
    table.add(row);
  }
  out << table << remarks << std::flush;
}

}  // namespace lober::bench
