#include "tests/oracle/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "tests/views.hpp"

namespace lober::oracle {
using namespace lober::detail;
namespace {

class Judge {
 public:
  Judge(const CurvePair& pair, const ExactOverlay& exact, const Overlay& found)
      : pair_(pair), exact_(exact), found_(found) {
    measure_box();
  }

  Verdict run() {
    count("crossings", found_.nodes.crossings(), exact_.crossings);
    count("touches", found_.nodes.touches(), exact_.touches);
    count("shared arcs", found_.nodes.shared_arcs(), exact_.shared_arcs);
    count("classes", found_.class_count, exact_.orbits);
    count("same curve", found_.nodes.same_curve(), exact_.same_curve);
    // One curve twice has neither a first nor a last common point: the engine counts an arc and lists no
    // node.
    count("nodes", found_.nodes.size(), exact_.same_curve ? 0 : exact_.nodes.size());
    if (found_.nodes.size() == exact_.nodes.size()) compare_nodes();
    compare_totals();
    for (std::size_t pairing = 0; pairing < 4; ++pairing) compare_pieces(pairing);
    verdict_.complaints = complaints_.str();
    return verdict_;
  }

 private:
  void measure_box() {
    Point low = pair_.first.front();
    Point high = low;
    for (const Polygon* polygon : {&pair_.first, &pair_.second}) {
      for (const Point& point : *polygon) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
      }
    }
    size_ = std::max({-low.x, high.x, -low.y, high.y});
    box_ = (Rational(high.x) - Rational(low.x)) * (Rational(high.y) - Rational(low.y));
    large_ = box_ * Rational(large_area);
    small_slack_ = large_ * Rational(large_error) + Rational(area_underflow);
  }

  void count(const std::string& what, std::size_t found, std::size_t exact) {
    if (found != exact) complaints_ << what << ": " << found << ", exactly " << exact << "\n";
  }

  // `bound` is what the engine states for this area.
  void area(const std::string& what, double found, const Rational& exact, double bound) {
    if (!std::isfinite(found)) {
      complaints_ << what << " is " << found << "\n";
      return;
    }
    const Rational error = abs(Rational(found) - exact);
    if (!std::isfinite(bound) || error > Rational(bound)) {
      complaints_.precision(17);
      complaints_ << what << ": " << found << " +- " << bound << ", exactly " << nearest_double(exact) << ", error "
                  << nearest_double(error) << "\n";
    }
    const bool large = exact > large_;
    const Rational slack = large ? exact * Rational(large_error) + Rational(area_underflow) : small_slack_;
    if (error > slack) {
      complaints_.precision(17);
      complaints_ << what << ": " << found << ", exactly " << nearest_double(exact) << ", error " << error.get_d()
                  << (large ? "" : " (small)") << "\n";
    }
    if (error <= Rational(area_underflow)) return;
    double& worst = large ? verdict_.relative_error : verdict_.small_error;
    worst = std::max(worst, Rational(error / (large ? exact : box_)).get_d());
  }

  void compare_totals() {
    const auto total = [&](const std::string& what, double Areas::*which, const Rational& exact) {
      area(what, found_.areas.*which, exact, found_.rounding.*which);
    };
    total("area of C1", &Areas::c1, exact_.area1);
    total("area of C2", &Areas::c2, exact_.area2);
    total("C1 minus C2", &Areas::c1_minus_c2, exact_.areas[c1_minus_c2]);
    total("C2 minus C1", &Areas::c2_minus_c1, exact_.areas[c2_minus_c1]);
    total("intersection", &Areas::intersection, exact_.areas[intersection]);
    total("union", &Areas::union_, exact_.areas[union_]);
    total("symmetric difference", &Areas::symmetric_difference, exact_.areas[c1_minus_c2] + exact_.areas[c2_minus_c1]);
  }

  void compare_nodes() {
    std::map<std::uint32_t, std::uint32_t> renumbered;
    for (std::size_t k = 0; k < exact_.nodes.size(); ++k) {
      const Node node = found_.nodes[k];
      const ExactNode& exact = exact_.nodes[k];
      if (node.rho != exact.rho || node.shared != exact.shared) {
        complaints_ << "node " << k << ": rho " << node.rho << ", shared " << node.shared << "; exactly " << exact.rho
                    << ", " << exact.shared << "\n";
      }
      compare_class(k, renumbered);
      compare_points("begin", k, node.begin, exact.begin);
      compare_points("end", k, node.end, exact.end);
      compare_points("begin1", k, at(pair_.first, node.begin1), exact.begin);
      compare_points("end1", k, at(pair_.first, node.end1), exact.end);
      compare_points("begin2", k, at(pair_.second, node.begin2), exact.begin);
      compare_points("end2", k, at(pair_.second, node.end2), exact.end);
    }
  }

  // Classes may be numbered in any way.
  void compare_class(std::size_t k, std::map<std::uint32_t, std::uint32_t>& renumbered) {
    const std::uint32_t exact = exact_.nodes[k].orbit;
    const std::uint32_t found = k < found_.classes.size() ? found_.classes[k] : no_orbit;
    if ((found == no_orbit) != (exact == no_orbit)) {
      complaints_ << "node " << k << (found == no_orbit ? " has no class\n" : " has a class\n");
    } else if (found != no_orbit) {
      const auto number = static_cast<std::uint32_t>(renumbered.size());
      if (renumbered.emplace(found, number).first->second != exact) complaints_ << "class of node " << k << "\n";
    }
  }

  static Point at(const Polygon& polygon, const Position& position) {
    if (position.segment >= polygon.size()) return {HUGE_VAL, HUGE_VAL};
    const Point& a = polygon[position.segment];
    const Point& b = polygon[(position.segment + 1) % polygon.size()];
    return {a.x + position.t * (b.x - a.x), a.y + position.t * (b.y - a.y)};
  }

  // Loose: an area shows a misplaced point much better. This is to find a point that is another one
  // altogether.
  void compare_points(const char* what, std::size_t k, const Point& found, const Point& exact) {
    const double error = std::max(std::abs(found.x - exact.x), std::abs(found.y - exact.y)) / size_;
    verdict_.point_error = std::max(verdict_.point_error, error);
    if (!(error < 1e-14)) {
      complaints_.precision(17);
      complaints_ << what << " of node " << k << ": (" << found.x << ", " << found.y << "), exactly (" << exact.x
                  << ", " << exact.y << ")\n";
    }
  }

  void compare_pieces(std::size_t pairing) {
    const std::string what(name(all_pairings[pairing]));
    const auto& pieces = found_.pieces(all_pairings[pairing]);
    const std::vector<ExactPiece>& exact = exact_.pieces[pairing];
    count("pieces of " + what, pieces.size(), exact.size());
    if (pieces.size() != exact.size()) return;
    std::vector<Piece> sorted;
    for (std::size_t k = 0; k < pieces.size(); ++k) sorted.push_back(pieces[k]);
    std::sort(sorted.begin(), sorted.end(), [](const Piece& a, const Piece& b) { return a.area > b.area; });
    // A piece is a part of its pairing's area, whose bound therefore holds for it.
    constexpr std::array totals{&Areas::c1_minus_c2, &Areas::c2_minus_c1, &Areas::intersection, &Areas::union_};
    for (std::size_t k = 0; k < sorted.size(); ++k)
      area("a piece of " + what, sorted[k].area, exact[k].area, found_.rounding.*totals[pairing]);
    compare_holes(what, sorted, exact);
    compare_corners(what, sorted);
  }

  // Pieces of nearly the same area may have changed their order: their holes are compared as a set.
  void compare_holes(const std::string& what, const std::vector<Piece>& found, const std::vector<ExactPiece>& exact) {
    for (std::size_t first = 0; first < exact.size();) {
      std::multiset<unsigned> holes;
      std::multiset<unsigned> expected;
      std::size_t k = first;
      do {
        holes.insert(found[k].holes);
        expected.insert(exact[k].holes);
        ++k;
      } while (k < exact.size() &&
               exact[k - 1].area - exact[k].area <= 2 * (exact[k].area * Rational(large_error) + small_slack_));
      if (holes != expected)
        complaints_ << "holes of the pieces " << first << " to " << k - 1 << " of " << what << "\n";
      first = k;
    }
  }

  // Round a crossing each of the four combinations of in and out has one sector, so that the boundaries of
  // the pieces of one pairing pass it once.
  void compare_corners(const std::string& what, const std::vector<Piece>& pieces) {
    std::vector<int> times(found_.nodes.size());
    for (const Piece& piece : pieces) {
      for (const std::uint32_t node : piece.crossings) {
        if (node < times.size()) {
          ++times[node];
        } else {
          complaints_ << "no such node: " << node << "\n";
        }
      }
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
      if (found_.nodes[k].rho != 0 && times[k] != 1) {
        complaints_ << "crossing " << k << " is " << times[k] << " times on pieces of " << what << "\n";
      }
    }
  }

  const CurvePair& pair_;
  const ExactOverlay& exact_;
  const Overlay& found_;
  double size_ = 0;
  Rational box_, large_, small_slack_;
  std::ostringstream complaints_;
  Verdict verdict_;
};

}  // namespace

Verdict judge(const CurvePair& pair, const ExactOverlay& exact, const Overlay& found) {
  return Judge(pair, exact, found).run();
}

Verdict try_pair(const CurvePair& pair) {
  try {
    const ExactOverlay exact = exact_overlay(pair.first, pair.second);
    return judge(pair, exact, overlay(CurveView{pair.first, true}, CurveView{pair.second, true}));
  } catch (const std::exception& error) {
    return {std::string("thrown: ") + error.what() + "\n", 0, 0, 0};
  }
}

}  // namespace lober::oracle
