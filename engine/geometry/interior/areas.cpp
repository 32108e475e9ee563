// Q1, Q2, Q3 and the areas that follow from them.

#include <algorithm>
#include <cmath>

#include "engine/base/stopwatch.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/crossings/require_simple.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/curve/scaled.hpp"
#include "engine/geometry/index/orientation.hpp"
#include "engine/geometry/interior/arc_labels.hpp"
#include "engine/geometry/interior/insert_points.hpp"
#include "engine/geometry/interior/side_sums.hpp"
#include "lober/overlay/interior.hpp"

namespace lober {
using namespace detail;
namespace {

DD times(double power_of_two, DD value) {
  return {power_of_two * value.hi, power_of_two * value.lo};
}

double not_negative(DD value) {
  return std::max(0.0, value.hi + value.lo);
}

// Sums of a curve that runs clockwise count backwards.
SideSums counter_clockwise(SideSums sums, bool clockwise) {
  return clockwise ? SideSums{-sums.outside, -sums.on, -sums.inside, sums.error} : sums;
}

// Puts an InteriorAreas together. One for each call.
class InteriorBuilder {
 public:
  // The curves are the caller's times 2^exponent.
  InteriorBuilder(const IndexedCurve& c1, const IndexedCurve& c2, const InteriorOptions& options, int exponent)
      : c1_(c1), c2_(c2), options_(options), exponent_(exponent) {}

  InteriorAreas build() {
    const Stopwatch watch;
    report(0);
    if (options_.check_simple) {
      for (const SimpleCheck& check :
           {require_simple_scaled(c1_, 1, exponent_), require_simple_scaled(c2_, 2, exponent_)}) {
        result_.statistics.check_simple += check.search;
        result_.statistics.check_simple_pairs += check.pairs;
      }
    }
    result_.timing.check = watch.seconds();
    report(0.2);
    find_crossings();
    report(0.5);
    const double extent = union_of(c1_.tree().box(), c2_.tree().box()).extent();
    const bool split = options_.method == InteriorMethod::split;
    if (split) label_parts();
    const SideSums sums1 = split ? split_sums(1, extent) : end_sums(1, extent);
    report(0.75);
    const SideSums sums2 = split ? split_sums(2, extent) : end_sums(2, extent);
    set_areas(counter_clockwise(sums1, result_.nodes.clockwise1()),
              counter_clockwise(sums2, result_.nodes.clockwise2()), extent);
    result_.timing.total = watch.seconds();
    report(1);
    return std::move(result_);
  }

 private:
  void report(double fraction) const {
    if (!options_.progress(fraction)) throw Cancelled();
  }

  void find_crossings() {
    const IndexKind kind = options_.index == IndexKind::automatic ? choose_index(c1_, c2_) : options_.index;
    NodeGraph graph = build_node_graph(c1_, c2_, kind);
    result_.timing.crossings = graph.search_seconds;
    result_.timing.order = graph.order_seconds;
    result_.statistics.index = kind;
    result_.statistics.counts = graph.counts;
    result_.orientation1 = orientation(c1_);
    result_.orientation2 = orientation(c2_);
    result_.nodes = make_crossings(std::move(graph), c1_, c2_, result_.orientation1, result_.orientation2);
  }

  [[nodiscard]] const IndexedCurve& own(int curve) const { return curve == 1 ? c1_ : c2_; }
  [[nodiscard]] const IndexedCurve& other(int curve) const { return curve == 1 ? c2_ : c1_; }
  [[nodiscard]] Point origin() const { return c1_.view().points[0]; }

  void label_parts() {
    const Stopwatch watch;
    const std::array<ContactsAlong, 2> contacts{ContactsAlong(result_.nodes, 1), ContactsAlong(result_.nodes, 2)};
    labels_ = label_arcs(c1_, c2_, {result_.nodes.clockwise1(), result_.nodes.clockwise2()}, contacts);
    result_.timing.labels += watch.seconds();
  }

  SideSums split_sums(int curve, double extent) {
    const Stopwatch label_watch;
    const ContactsAlong contacts(result_.nodes, curve);
    ArcLabels& labels = labels_[static_cast<std::size_t>(curve) - 1];
    Side whole = Side::outside;
    if (contacts.size() == 0) {
      whole = locate(other(curve), own(curve).view().points[0]);
      ++labels.queries;
    }
    result_.statistics.queries += labels.queries;
    result_.statistics.arcs += std::max<std::size_t>(contacts.size(), 1);
    result_.timing.labels += label_watch.seconds();
    const Stopwatch sum_watch;
    const SideSums sums = sum_by_arcs(own(curve).tree(), origin(), extent, contacts, labels.after, whole);
    result_.timing.sums += sum_watch.seconds();
    return sums;
  }

  SideSums end_sums(int curve, double extent) {
    const Stopwatch label_watch;
    const CurveView& view = own(curve).view();
    const Buffer<Side> labels = label_vertices(result_.nodes, curve);
    const bool insert = options_.passes > 0 && options_.points > 0;
    LabelledCurve dense;
    if (insert) {
      dense = insert_points(view, labels, side_changes(result_.nodes, curve), options_.passes, options_.points,
                            options_.max_points);
      result_.statistics.points_inserted += dense.points.size() - view.points.size();
    }
    result_.timing.labels += label_watch.seconds();
    const Stopwatch sum_watch;
    const SideSums sums = insert ? sum_by_ends(dense.points, dense.labels, origin(), extent)
                                 : sum_by_ends(view.points, labels, origin(), extent);
    result_.timing.sums += sum_watch.seconds();
    return sums;
  }

  void set_areas(const SideSums& s1, const SideSums& s2, double extent) {
    const DD outside = s1.outside + s2.outside, on = s1.on + s2.on, inside = s1.inside + s2.inside;
    const DD q1 = times(0.5, outside - inside);
    const DD q2 = times(0.5, outside + times(0.5, on));
    const DD q3 = times(0.5, inside + times(0.5, on));
    const DD area1 = times(0.5, s1.total()), area2 = times(0.5, s2.total());
    const DD difference = times(0.5, area1 - area2), quarter = times(0.25, q1 + q2 - q3);
    const DD delta = times(0.25, q2 - q3 - q1);
    result_.q1 = q1.hi + q1.lo;
    result_.q2 = q2.hi + q2.lo;
    result_.q3 = q3.hi + q3.lo;
    result_.delta = std::fabs(delta.hi + delta.lo);
    result_.areas = {.c1 = not_negative(area1),
                     .c2 = not_negative(area2),
                     .intersection = not_negative(q3),
                     .union_ = not_negative(q2),
                     .c1_minus_c2 = not_negative(quarter + difference),
                     .c2_minus_c1 = not_negative(quarter - difference),
                     .symmetric_difference = not_negative(q1)};

    // The sums are of twice the areas; a contact is one and the same point on both curves to 2^-91 of the scene.
    const double contacts = static_cast<double>(graph_of(result_.nodes).contacts.size());
    const double lost = s1.error + s2.error + contacts * 0x1p-91 * extent * extent;
    const Areas& areas = result_.areas;
    const auto bound = [&](double area) { return area * 0x1p-53 + lost; };
    result_.rounding = {
        bound(areas.c1),          bound(areas.c2),          bound(areas.intersection),        bound(areas.union_),
        bound(areas.c1_minus_c2), bound(areas.c2_minus_c1), bound(areas.symmetric_difference)};
  }

  const IndexedCurve& c1_;
  const IndexedCurve& c2_;
  const InteriorOptions& options_;
  int exponent_;
  std::array<ArcLabels, 2> labels_;  // sides of the parts of either curve
  InteriorAreas result_;
};

InteriorAreas scaled_areas(const IndexedCurve& c1, const IndexedCurve& c2, const InteriorOptions& options,
                           int exponent) {
  const std::vector<Point> first = scaled(c1.view(), exponent), second = scaled(c2.view(), exponent);
  const IndexedCurve scaled1(CurveView{first}), scaled2(CurveView{second});
  InteriorAreas result = InteriorBuilder(scaled1, scaled2, options, exponent).build();
  for (double* value : {&result.q1, &result.q2, &result.q3, &result.delta}) *value = std::ldexp(*value, -2 * exponent);
  scale(result.areas, -2 * exponent);
  scale_bounds(result.areas, result.rounding, -2 * exponent);
  result.nodes = moved_to(result.nodes, c1, c2);
  return result;
}

}  // namespace

InteriorAreas interior_areas(const IndexedCurve& c1, const IndexedCurve& c2, const InteriorOptions& options) {
  require_region(c1.view(), "curve 1", "interior");
  require_region(c2.view(), "curve 2", "interior");
  const int exponent = scaling_exponent(union_of(c1.tree().box(), c2.tree().box()));
  if (exponent != 0) return scaled_areas(c1, c2, options, exponent);
  return InteriorBuilder(c1, c2, options, 0).build();
}

InteriorAreas interior_areas(const ClosedCurve& c1, const ClosedCurve& c2, const InteriorOptions& options) {
  require_region(c1, "curve 1", "interior");
  require_region(c2, "curve 2", "interior");
  const Stopwatch watch;
  const IndexedCurve first(c1), second(c2);
  if (!first.finite()) validate(c1, "curve 1");
  if (!second.finite()) validate(c2, "curve 2");
  const double index_seconds = watch.seconds();
  InteriorAreas result = interior_areas(first, second, options);
  result.timing.index = index_seconds;
  result.timing.total += index_seconds;
  return result;
}

}  // namespace lober
