#include "kernels/predicates.hpp"

#include "kernels/exact_number.hpp"

namespace lober::detail {
namespace {

// |u v| for u = b - a, v = d - c.
ExactNumber exact_cross(Point a, Point b, Point c, Point d) {
  return exact_difference(b.x, a.x) * exact_difference(d.y, c.y) -
         exact_difference(b.y, a.y) * exact_difference(d.x, c.x);
}

struct Ratio {
  ExactNumber above, below;  // below > 0
};

Ratio parameter_ratio(Point a, Point b, const ImplicitPoint& p) {
  Ratio ratio;
  if (p.vertex) {  // on the segment: any axis along which the segment extends will do
    const bool along_x = a.x != b.x;
    ratio.above = along_x ? exact_difference(p.c.x, a.x) : exact_difference(p.c.y, a.y);
    ratio.below = along_x ? exact_difference(b.x, a.x) : exact_difference(b.y, a.y);
  } else {
    ratio.above = exact_cross(a, p.c, p.c, p.d);  // |c - a, d - c|
    ratio.below = exact_cross(a, b, p.c, p.d);    // |b - a, d - c|
  }
  if (ratio.below.sign() < 0) {
    ratio.above = ExactNumber() - ratio.above;
    ratio.below = ExactNumber() - ratio.below;
  }
  return ratio;
}

}  // namespace

int cross_sign_beyond_filter(Point a, Point b, Point c, Point d, PredicateCounts& counts) {
  ++counts.filter_failures;
  const auto ux = two_diff(b.x, a.x), uy = two_diff(b.y, a.y), vx = two_diff(d.x, c.x), vy = two_diff(d.y, c.y);
  if (ux.lo == 0 && uy.lo == 0 && vx.lo == 0 && vy.lo == 0) {
    const auto left = two_product(ux.hi, vy.hi), right = two_product(uy.hi, vx.hi);
    // The products are exact if nothing over- or underflowed: a zero product of zero factors, or one of safe size.
    const auto safe = [](double product, double u, double v) {
      const double size = std::fabs(product);
      return u == 0 || v == 0 ||
             (size > 0x1p-900 && size < 0x1p900 && std::fabs(u) < 0x1p900 && std::fabs(v) < 0x1p900);
    };
    if (safe(left.hi, ux.hi, vy.hi) && safe(right.hi, uy.hi, vx.hi)) {
      if (left.hi != right.hi) return left.hi > right.hi ? 1 : -1;
      return (left.lo > right.lo) - (left.lo < right.lo);
    }
  }
  ++counts.exact_calls;
  return exact_cross(a, b, c, d).sign();
}

bool on_segment(Point a, Point b, Point p, PredicateCounts& counts) {
  const bool in_box = (a.x <= b.x ? a.x <= p.x && p.x <= b.x : b.x <= p.x && p.x <= a.x) &&
                      (a.y <= b.y ? a.y <= p.y && p.y <= b.y : b.y <= p.y && p.y <= a.y);
  return in_box && orient2d(a, b, p, counts) == 0;
}

int compare_along(Point a, Point b, const ImplicitPoint& p, const ImplicitPoint& q) {
  const Ratio first = parameter_ratio(a, b, p), second = parameter_ratio(a, b, q);
  return (first.above * second.below - second.above * first.below).sign();
}

DD exact_parameter(Point a, Point b, const ImplicitPoint& p) {
  if (p.vertex) {  // a quotient of two differences, which double-double holds exactly
    const bool along_x = a.x != b.x;
    const DD above = along_x ? two_diff(p.c.x, a.x) : two_diff(p.c.y, a.y);
    const DD below = along_x ? two_diff(b.x, a.x) : two_diff(b.y, a.y);
    const auto safe = [](double size) { return size == 0 || (size > 0x1p-900 && size < 0x1p900); };
    if (safe(std::fabs(above.hi)) && safe(std::fabs(below.hi))) return above / below;
  }
  const Ratio ratio = parameter_ratio(a, b, p);
  return exact_ratio(ratio.above, ratio.below);
}

}  // namespace lober::detail
