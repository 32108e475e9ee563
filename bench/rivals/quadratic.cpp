// The transverse method as Naik, Lekien & Ross (2017) describe it (sections 3.2 to 3.4): every segment of C1 against
// every segment of C2, crossings by the sign test of its two theorems on plain doubles, classes of sigma, areas by
// summing along the arcs.
//
// It does what the article says and no more: contacts other than crossings are not handled, and each orbit
// counts as a piece of its own even where it bounds a hole. The article forms one of the four pairings; the
// others are the same walk in other directions. Without crossings, one point-in-polygon test decides.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "bench/rivals/rival.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

struct Meeting {
  std::size_t segment[2];
  double t[2];
  Point point;
  int rho = 0;
};

// f(x, y) of the article for the line through a and b: zero on it, with opposite signs on its two sides.
struct Line {
  double x, y, constant;
  Line(Point a, Point b) : x(b.y - a.y), y(-(b.x - a.x)), constant(-a.x * b.y + a.y * b.x) {}
  [[nodiscard]] double at(Point point) const { return x * point.x + y * point.y + constant; }
};

std::vector<Meeting> find_contacts(std::span<const Point> first, std::span<const Point> second) {
  std::vector<Meeting> contacts;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Point a = first[i];
    const Point b = first[i + 1 == first.size() ? 0 : i + 1];
    const Line line(a, b);
    double before = line.at(second.back());
    for (std::size_t k = 0; k < second.size(); ++k) {
      const double after = line.at(second[k]);
      if (before * after <= 0) {  // the necessary condition; rarely true, so the rest is out of the way
        const std::size_t j = k == 0 ? second.size() - 1 : k - 1;
        const Line other(second[j], second[k]);
        const double at_a = other.at(a);
        const double at_b = other.at(b);
        if (at_a * at_b <= 0 && at_a != at_b && before != after) {
          const double t = at_a / (at_a - at_b);
          contacts.push_back({{i, j},
                              {t, before / (before - after)},
                              {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)},
                              at_a < 0 ? 1 : -1});
        }
      }
      before = after;
    }
  }
  return contacts;
}

// Everything about one curve that the walk needs: the contacts in order along it and sums along it.
class Walk {
 public:
  Walk(std::span<const Point> points, const std::vector<Meeting>& contacts, std::size_t curve)
      : points_(points), contacts_(contacts), curve_(curve), order_(contacts.size()), rank_(contacts.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t p, std::size_t q) {
      const auto key = [&](std::size_t k) { return std::pair(contacts[k].segment[curve], contacts[k].t[curve]); };
      return key(p) < key(q);
    });
    for (std::size_t k = 0; k < order_.size(); ++k) rank_[order_[k]] = k;
    sums_.resize(points.size() + 1);
    for (std::size_t k = 0; k < points.size(); ++k) {
      sums_[k + 1] = sums_[k] + cross(points[k], points[k + 1 == points.size() ? 0 : k + 1]);
    }
  }

  [[nodiscard]] double area() const { return sums_.back() / 2; }

  struct Step {
    std::size_t to;
    double sum;  ///< of x dy - y dx along the way
  };
  [[nodiscard]] Step forward(std::size_t from) const {
    const std::size_t to = order_[(rank_[from] + 1) % order_.size()];
    return {to, arc(from, to)};
  }
  [[nodiscard]] Step backward(std::size_t from) const {
    const std::size_t to = order_[(rank_[from] + order_.size() - 1) % order_.size()];
    return {to, -arc(to, from)};
  }

 private:
  static double cross(Point a, Point b) { return a.x * b.y - b.x * a.y; }

  [[nodiscard]] double arc(std::size_t from, std::size_t to) const {
    const Meeting& p = contacts_[from];
    const Meeting& q = contacts_[to];
    const bool same_segment = p.segment[curve_] == q.segment[curve_] && rank_[from] < rank_[to];
    if (same_segment) return cross(p.point, q.point);
    const std::size_t start = p.segment[curve_] + 1;  // first vertex after p
    const std::size_t end = q.segment[curve_];        // last vertex before q
    double between = sums_[end] - sums_[start];
    if (rank_[from] >= rank_[to]) between += sums_.back();
    return cross(p.point, points_[start % points_.size()]) + between + cross(points_[end], q.point);
  }

  std::span<const Point> points_;
  const std::vector<Meeting>& contacts_;
  std::size_t curve_;
  std::vector<std::size_t> order_, rank_;
  std::vector<double> sums_;
};

// One pairing: the orbits of the walk that leaves each contact along C1 or C2, forward or backward, as rho
// says.
template <typename Next>
void sum_orbits(std::size_t count, const Next& next, double& area, std::size_t& orbits) {
  std::vector<bool> seen(count);
  for (std::size_t k = 0; k < count; ++k) {
    if (seen[k]) continue;
    ++orbits;
    for (std::size_t at = k; !seen[at];) {
      seen[at] = true;
      const Walk::Step step = next(at);
      area += step.sum / 2;
      at = step.to;
    }
  }
}

bool inside(std::span<const Point> polygon, Point point) {
  bool result = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point a = polygon[k];
    const Point b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) result = !result;
  }
  return result;
}

void without_contacts(std::span<const Point> first, std::span<const Point> second, double area1, double area2,
                      RivalResult& result) {
  const double overlap = inside(second, first[0]) ? area1 : inside(first, second[0]) ? area2 : 0;
  const double areas[4] = {area1 - overlap, area2 - overlap, overlap, area1 + area2 - overlap};
  for (std::size_t k = 0; k < 4; ++k) {
    result.areas[k] = areas[k];
    result.pieces[k] = areas[k] > 0;
  }
  if (overlap == 0) result.pieces[3] = 2;
}

}  // namespace

RivalResult run_quadratic(std::span<const Point> first, std::span<const Point> second) {
  RivalResult result;
  const Stopwatch all;
  const std::vector<Meeting> contacts = find_contacts(first, second);
  const Walk c1(first, contacts, 0);
  const Walk c2(second, contacts, 1);
  if (contacts.empty()) {
    without_contacts(first, second, c1.area(), c2.area(), result);
  } else {
    const auto leaves = [&](std::size_t k) { return contacts[k].rho > 0; };  // C1 leaves A2
    const auto pairing = [&](std::size_t number, const auto& next) {
      sum_orbits(contacts.size(), next, result.areas[number], result.pieces[number]);
    };
    pairing(0, [&](std::size_t k) { return leaves(k) ? c1.forward(k) : c2.backward(k); });
    pairing(1, [&](std::size_t k) { return leaves(k) ? c1.backward(k) : c2.forward(k); });
    pairing(2, [&](std::size_t k) { return leaves(k) ? c2.forward(k) : c1.forward(k); });
    pairing(3, [&](std::size_t k) { return leaves(k) ? c1.forward(k) : c2.forward(k); });
  }
  result.seconds = all.seconds();
  result.intersection_seconds = result.seconds;
  result.note = "holes counted as pieces";
  result.ran = true;
  return result;
}

}  // namespace lober::bench
