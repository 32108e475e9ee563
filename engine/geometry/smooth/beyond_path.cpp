#include "engine/geometry/smooth/beyond_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/geometry/smooth/arc_boxes.hpp"

namespace lober::detail {
namespace {

using Quintic = std::array<double, 6>;

double integral_to(const Quintic& polynomial, double x) {
  double sum = 0;
  for (std::size_t power = polynomial.size(); power-- > 0;)
    sum = sum * x + polynomial[power] / static_cast<double>(power + 1);
  return sum * x;
}

// Where a polynomial changes sign in an interval: between neighbouring zeros of its derivative at most once.
std::vector<double> sign_changes(const Quintic& polynomial, double from, double to) {
  Quintic derivative{};
  bool constant = true;
  for (std::size_t power = 1; power < polynomial.size(); ++power) {
    derivative[power - 1] = static_cast<double>(power) * polynomial[power];
    constant = constant && polynomial[power] == 0;
  }
  std::vector<double> found;
  if (constant) return found;
  std::vector<double> ends = sign_changes(derivative, from, to);
  ends.push_back(to);
  double begin = from;
  bool positive = value_at(polynomial, begin) > 0;
  for (const double end : ends) {
    const bool positive_at_end = value_at(polynomial, end) > 0;
    if (positive_at_end != positive) {
      double low = begin, high = end;
      for (double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2)
        (value_at(polynomial, middle) > 0 ? positive_at_end : positive) ? high = middle : low = middle;
      found.push_back(high);
    }
    begin = end;
    positive = positive_at_end;
  }
  return found;
}

// The region between a chord and its arc y = f(x), 0 <= x <= 1, and the legs of the path that come near, in units of
// the chord. The polygon and the smooth curve have another side of those parts of the path only that lie in it. A part
// that comes in by the chord and goes out by the arc is one crossing of either, which has been moved from the chord to
// the arc. Any other part is a pair of crossings that only one of both has, or one where the path begins.
class RegionUnderArc {
 public:
  RegionUnderArc(const Quintic& f, std::span<const Point> legs, bool begins, bool ends)
      : f_(f), points_(legs), begins_(begins), ends_(ends) {
    for (const double coefficient : f) largest_ += std::fabs(coefficient);
    for (std::size_t leg = 0; leg + 1 < points_.size(); ++leg) meet(leg);
    std::stable_sort(events_.begin(), events_.end(), [](Event x, Event y) { return x.at < y.at; });
  }

  [[nodiscard]] double hidden() const {
    double area = 0;
    std::vector<Event> events;
    if (begins_) events.push_back({0, Kind::end});
    events.insert(events.end(), events_.begin(), events_.end());
    if (ends_) events.push_back({static_cast<double>(points_.size() - 1), Kind::end});
    for (std::size_t k = 0; k + 1 < events.size(); ++k) {
      const Event &from = events[k], &to = events[k + 1];
      const bool arc = from.kind == Kind::arc || to.kind == Kind::arc;
      const bool chord = from.kind == Kind::chord || to.kind == Kind::chord;
      if (!arc && !chord) continue;
      if (inside((from.at + std::min(to.at, std::floor(from.at) + 1)) / 2)) {
        if (!(arc && chord)) area += between(from.at, to.at, arc);
      } else if (from.kind == Kind::arc && to.kind == Kind::arc && crosses_chord(from.at, to.at)) {
        // The crossing may have been moved from the chord to any of several on the arc.
        area += between(from.at, to.at, true);
      }
    }
    return area;
  }

 private:
  enum class Kind : std::uint8_t { chord, arc, end };
  struct Event {
    double at;  // number of a leg and parameter on it
    Kind kind;
  };

  [[nodiscard]] std::size_t leg_of(double at) const {
    return std::min(static_cast<std::size_t>(at), points_.size() - 2);
  }
  [[nodiscard]] Point point(double at) const {
    const std::size_t leg = leg_of(at);
    const double v = at - static_cast<double>(leg);
    return points_[leg] + Point{v * (points_[leg + 1].x - points_[leg].x), v * (points_[leg + 1].y - points_[leg].y)};
  }
  [[nodiscard]] bool inside(double at) const {
    const Point p = point(at);
    const double height = value_at(f_, p.x);
    return p.x > 0 && p.x < 1 && std::fabs(p.y) < std::fabs(height) && (p.y > 0) == (height > 0);
  }
  [[nodiscard]] bool crosses_chord(double from, double to) const {
    if (leg_of(from) != leg_of(to)) return false;
    return std::any_of(events_.begin(), events_.end(), [&](const Event& event) {
      return event.kind == Kind::chord && leg_of(event.at) == leg_of(from);
    });
  }

  void meet(std::size_t leg) {
    // From the point that the curve begins in, where that is its end: the constant term is zero there.
    const Point last = points_[leg + 1];
    const bool backward = last.x == 0 && last.y == 0;
    const Point start = points_[backward ? leg + 1 : leg];
    const Point whole = points_[backward ? leg : leg + 1] - start;
    double from = 0, to = 1;  // above the chord
    if (whole.x == 0) {
      if (!(start.x >= 0 && start.x <= 1)) return;
    } else {
      const double one = -start.x / whole.x, other = (1 - start.x) / whole.x;
      from = std::max(from, std::min(one, other));
      to = std::min(to, std::max(one, other));
    }
    if (!(from < to)) return;
    const Point origin{start.x + from * whole.x, start.y + from * whole.y};
    const Point along{(to - from) * whole.x, (to - from) * whole.y};
    const double least = std::min(std::fabs(origin.y), std::fabs(origin.y + along.y));
    if (least > largest_ && (origin.y > 0) == (origin.y + along.y > 0)) return;
    const auto add = [&](double w, Kind kind) {
      const double v = from + w * (to - from), at = backward ? 1 - v : v;
      if (!(at >= 0 && at < 1) || (at == 0 && leg == 0 && begins_)) return;
      events_.push_back({static_cast<double>(leg) + at, kind});
    };
    if (along.y != 0) {
      const double w = -origin.y / along.y;
      if (w >= 0 && w <= 1) add(w, Kind::chord);
    }
    Quintic above{};  // f less y along the leg
    for (std::size_t power = f_.size(); power-- > 0;) {
      for (std::size_t k = above.size(); k-- > 0;)
        above[k] = above[k] * origin.x + (k > 0 ? above[k - 1] * along.x : f_[power]);
    }
    above[0] -= origin.y;
    above[1] -= along.y;
    if (above[0] == 0) {  // begins on the curve, which is no event
      std::copy(above.begin() + 1, above.end(), above.begin());
      above.back() = 0;
    }
    for (const double w : sign_changes(above, 0, 1)) add(w, Kind::arc);
  }

  // The area between the path and the arc, or the chord.
  [[nodiscard]] double between(double from, double to, bool arc) const {
    double sum = 0;
    Point here = point(from);
    const double first = here.x;
    const auto go_to = [&](Point next) {
      sum += (next.x - here.x) * (here.y + next.y) / 2;
      here = next;
    };
    for (auto corner = static_cast<std::size_t>(from) + 1; static_cast<double>(corner) < to; ++corner)
      go_to(points_[corner]);
    go_to(point(to));
    if (arc) sum -= integral_to(f_, here.x) - integral_to(f_, first);
    return std::fabs(sum);
  }

  const Quintic& f_;
  std::span<const Point> points_;
  bool begins_, ends_;  // whether the path does
  double largest_ = 0;  // the arc is nowhere farther from its chord
  std::vector<Event> events_;
};

// The largest area that `hidden` finds of an arc where it is, and as far beside as it may be wrong.
double largest_hidden(const SmoothSegment& segment, double square, std::span<const Point> legs, bool begins,
                      bool ends) {
  const double beside = 3 * segment.error / square;  // times u (1 - u): the area that it may be wrong by
  double largest = 0;
  for (const double by : {-beside, 0.0, beside}) {
    Quintic f = segment.f;
    f[1] += by;
    f[2] -= by;
    largest = std::max(largest, RegionUnderArc(f, legs, begins, ends).hidden());
  }
  return largest;
}

struct LegBesideArc {
  std::size_t segment, leg;
  friend bool operator<(LegBesideArc x, LegBesideArc y) {
    return x.segment != y.segment ? x.segment < y.segment : x.leg < y.leg;
  }
};

class LegSearch {
 public:
  LegSearch(const ArcBoxes& boxes, std::span<const Point> path, std::size_t segments)
      : boxes_(boxes), path_(path), segments_(segments) {}

  /// By segment, then by leg.
  [[nodiscard]] std::vector<LegBesideArc> find() {
    for (std::size_t leg = 0; leg + 1 < path_.size(); ++leg) walk({boxes_.levels() - 1, 0}, leg);
    std::sort(found_.begin(), found_.end());
    return std::move(found_);
  }

 private:
  void walk(TreeNode node, std::size_t leg) {
    const Point a = path_[leg], b = path_[leg + 1];
    const Box& box = boxes_.box(node);
    if (!meet(box, Box::of(a, b))) return;
    const Point along = b - a, centre{(box.min_x() + box.max_x()) / 2, (box.min_y() + box.max_y()) / 2};
    // With room for rounding.
    const double reach = std::fabs(along.x) * box.height() + std::fabs(along.y) * box.width();
    if (std::fabs(cross(along, centre - a)) > 0.75 * reach) return;
    if (node.level > 0) {
      for (std::uint32_t child = 2 * node.index; child < 2 * node.index + 2; ++child) {
        if (child < boxes_.nodes(node.level - 1)) walk({node.level - 1, child}, leg);
      }
      return;
    }
    const std::size_t end = std::min(boxes_.end(node.index), segments_);
    for (std::size_t k = node.index * ArcBoxes::segments_a_leaf; k < end; ++k) found_.push_back({k, leg});
  }

  const ArcBoxes& boxes_;
  std::span<const Point> path_;
  std::size_t segments_;
  std::vector<LegBesideArc> found_;
};

}  // namespace

double twice_beyond_path(const SmoothCurve& curve, std::span<const Point> path, std::size_t segments) {
  ArcBoxes boxes(curve);
  boxes.add_all();
  const std::vector<LegBesideArc> near = LegSearch(boxes, path, segments).find();
  double area = 0;
  std::vector<Point> legs;
  for (std::size_t k = 0, end = 0; k < near.size(); k = end) {
    // Legs in a row beside one arc.
    while (end < near.size() && near[end].segment == near[k].segment && near[end].leg - near[k].leg == end - k) ++end;
    const auto number = static_cast<std::int64_t>(near[k].segment);
    const SmoothSegment segment = curve.segment(number);
    const double square = dot(segment.chord, segment.chord);
    if (!(square > 0)) continue;
    legs.clear();
    for (const Point corner : path.subspan(near[k].leg, end - k + 1)) {
      const Point to = corner - curve.vertex(number);
      legs.push_back({dot(segment.chord, to) / square, cross(segment.chord, to) / square});
    }
    const bool begins = near[k].leg == 0, ends = near[end - 1].leg + 2 == path.size();
    area += square * largest_hidden(segment, square, legs, begins, ends);
  }
  // Sums up to crossings count what lies there as on the other side: they may take away what is to be added.
  return 2 * 2 * area;
}

}  // namespace lober::detail
