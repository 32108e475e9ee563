#include "lober/overlay/overlay.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/crossings/require_simple.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/curve/scaled.hpp"
#include "engine/geometry/index/orientation.hpp"
#include "engine/geometry/index/sums_along.hpp"
#include "engine/geometry/overlay/arc_sums.hpp"
#include "engine/geometry/overlay/faces.hpp"
#include "engine/geometry/overlay/pieces_data.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr Membership only1{true, false}, only2{false, true}, both{true, true}, neither{false, false};

double half(DD twice) {
  return std::max(0.0, 0.5 * (twice.hi + twice.lo));
}
// Twice the area of a curve that runs so, from its signed sum.
DD turned(DD twice_area, Orientation orientation) {
  return orientation == Orientation::clockwise ? -twice_area : twice_area;
}

// Puts an Overlay together. One for each call.
class OverlayBuilder {
 public:
  // The curves are the caller's times 2^exponent.
  OverlayBuilder(const IndexedCurve& c1, const IndexedCurve& c2, const OverlayOptions& options, int exponent)
      : c1_(c1), c2_(c2), options_(options), exponent_(exponent) {}

  // The result speaks of the caller's curves.
  Overlay build(const IndexedCurve& caller1, const IndexedCurve& caller2) {
    const Stopwatch watch;
    report(0);
    if (options_.check_simple) {
      for (const SimpleCheck& check :
           {require_simple_scaled(c1_, 1, exponent_), require_simple_scaled(c2_, 2, exponent_)}) {
        result_.statistics.check_simple += check.search;
        result_.statistics.check_simple_pairs += check.pairs;
      }
    }
    if (options_.check_simple) result_.timing.check = watch.seconds();
    report(0.3);
    const IndexKind kind = options_.index == IndexKind::automatic ? choose_index(c1_, c2_) : options_.index;
    NodeGraph graph = build_node_graph(c1_, c2_, kind);
    result_.timing.crossings = graph.search_seconds;
    result_.timing.order = graph.order_seconds;
    report(0.7);

    sums_ = sum_arcs(c1_, c2_, graph);
    measure_curves();
    result_.orientation1 = orientation(c1_, sums_.total1, extent());
    result_.orientation2 = orientation(c2_, sums_.total2, extent());
    result_.statistics.index = kind;
    result_.statistics.counts = graph.counts;
    result_.statistics.index_bytes = c1_.tree().memory() + c2_.tree().memory();
    result_.nodes = make_crossings(std::move(graph), c1_, c2_, result_.orientation1, result_.orientation2);
    if (result_.nodes.size() > 0) {
      overlay_connected();
    } else {
      overlay_apart();
    }
    if (exponent_ != 0) rescale(-2 * exponent_, caller1, caller2);
    const auto pieces = std::make_shared<const std::array<PiecesData, 4>>(std::move(pieces_));
    for (std::size_t k = 0; k < pieces->size(); ++k) {
      result_.all_pieces[k] = Pieces(std::shared_ptr<const PiecesData>(pieces, &(*pieces)[k]));
    }
    OverlayTiming& timing = result_.timing;
    timing.total = watch.seconds();
    timing.areas = std::max(0.0, timing.total - timing.check - timing.crossings - timing.order);
    report(1);
    return std::move(result_);
  }

 private:
  // Multiplies all areas by a power of two and lets the result speak of other points.
  void rescale(int exponent, const IndexedCurve& c1, const IndexedCurve& c2) {
    scale(result_.areas, exponent);
    scale_bounds(result_.areas, result_.rounding, exponent);
    for (PiecesData& pieces : pieces_) {
      for (double& area : pieces.areas) area = std::ldexp(area, exponent);
    }
    for (double* length : {&result_.largest_coordinate, &result_.longest_segment}) {
      *length = std::ldexp(*length, exponent / 2);
    }
    result_.nodes = moved_to(result_.nodes, c1, c2);
  }

  void report(double fraction) const {
    if (!options_.progress(fraction)) throw Cancelled();
  }

  [[nodiscard]] double extent() const { return union_of(c1_.tree().box(), c2_.tree().box()).extent(); }

  void measure_curves() {
    constexpr std::size_t leaves_a_task = 4096;
    for (const IndexedCurve* curve : {&c1_, &c2_}) {
      const BoxTree& tree = curve->tree();
      for (const double lane : tree.box().lane) {
        result_.largest_coordinate = std::max(result_.largest_coordinate, std::fabs(lane));
      }
      std::atomic<double> longest{result_.longest_segment};
      for_each_block(tree.leaves(), leaves_a_task, [&](std::size_t begin, std::size_t end) {
        double here = 0;
        for (std::size_t leaf = begin; leaf < end; ++leaf) here = std::max(here, tree.leaf_boxes()[leaf].extent());
        double known = longest;
        while (known < here && !longest.compare_exchange_weak(known, here)) {
        }
      });
      result_.longest_segment = longest;
    }
  }

  [[nodiscard]] DD twice_area1() const { return turned(sums_.total1, result_.orientation1); }
  [[nodiscard]] DD twice_area2() const { return turned(sums_.total2, result_.orientation2); }
  [[nodiscard]] Orientations orientations() const { return {result_.nodes.clockwise1(), result_.nodes.clockwise2()}; }
  PiecesData& pieces(Pairing pairing) { return pieces_[static_cast<std::size_t>(pairing)]; }

  // Twice the areas of A1 \ A2, A2 \ A1 and A1 n A2; none for a region that is empty, the only one whose area is known
  // without error. A thin region may well have a computed area of 0, and then has a bound.
  using TwiceArea = std::optional<DD>;
  void set_areas(const TwiceArea& minus12, const TwiceArea& minus21, const TwiceArea& common) {
    const double lost = lost_in_sums(extent(), result_.nodes.size(), c1_.segments() + c2_.segments());
    const auto set = [&](double Areas::*area, DD twice, bool some = true) {
      result_.areas.*area = half(twice);
      result_.rounding.*area = some ? result_.areas.*area * 0x1p-53 + lost : 0;
    };
    const DD difference12 = minus12.value_or(DD{}), difference21 = minus21.value_or(DD{}),
             in_both = common.value_or(DD{});
    set(&Areas::c1, twice_area1());
    set(&Areas::c2, twice_area2());
    set(&Areas::c1_minus_c2, difference12, minus12.has_value());
    set(&Areas::c2_minus_c1, difference21, minus21.has_value());
    set(&Areas::intersection, in_both, common.has_value());
    set(&Areas::symmetric_difference, difference12 + difference21, minus12.has_value() || minus21.has_value());
    set(&Areas::union_, difference12 + difference21 + in_both);
  }

  // ------------------------------------------------------------------------------ curves that meet

  void overlay_connected() {
    const NodeGraph& graph = graph_of(result_.nodes);
    const FaceTotals totals = total_of_faces(graph, sums_, orientations());
    // The arrangement is connected: every face has a corner at some node.
    const auto unless_empty = [&](Membership wanted, DD twice) {
      const bool some = std::any_of(graph.order.begin(), graph.order.end(),
                                    [&](std::uint8_t order) { return sectors_at(order, orientations(), wanted) > 0; });
      return some ? TwiceArea(twice) : std::nullopt;
    };
    set_areas(unless_empty(only1, totals.only1), unless_empty(only2, totals.only2), unless_empty(both, totals.both));
    if (!options_.pieces) return;
    parallel_if(
        graph.size() > 4096,
        [&] {
          auto [difference12, in_both] = walk_faces(graph, sums_, orientations(), {only1, both});
          take_faces(std::move(difference12), Pairing::c1_minus_c2);
          take_faces(std::move(in_both), Pairing::intersection);
          classify();
        },
        [&] {
          auto [difference21, outside] = walk_faces(graph, sums_, orientations(), {only2, neither});
          take_faces(std::move(difference21), Pairing::c2_minus_c1);
          unite_connected(outside);
        });
  }

  void take_faces(Faces faces, Pairing pairing) {
    PiecesData& target = pieces(pairing);
    for (double& area : faces.area) area = std::max(area, 0.0);
    target.areas = std::move(faces.area);
    target.begin = std::move(faces.begin);
    target.steps = std::move(faces.steps);
    // One curve inside the other with a single touch: the walk runs round both, but the enclosed region has a hole.
    const NodeGraph& graph = graph_of(result_.nodes);
    if (graph.size() == 1 && graph.span(0).direction == 0 && target.steps.size() == 2) {
      const std::uint32_t hole = pairing == Pairing::c1_minus_c2 ? 1 : 0;
      target.steps = {pack({0, 1 - hole})};
      target.begin = {0, 1};
      target.holes.push_back({0, {pack({0, hole})}});
    }
  }

  // The union is what the faces outside both curves leave. It is in one piece, unless the curves only touch from
  // outside.
  void unite_connected(const Faces& faces) {
    const NodeGraph& graph = graph_of(result_.nodes);
    PiecesData& target = pieces(Pairing::union_);
    bool one_piece = false;
    for (std::uint32_t node = 0; node < graph.size() && !one_piece; ++node) {
      one_piece = graph.span(node).direction != 0 || sectors_at(graph.order[node], orientations(), both) > 0;
    }
    if (!one_piece) {
      const auto round = [&](std::uint32_t curve, bool backward) {
        std::vector<std::uint32_t> steps(graph.size());
        for (std::uint32_t k = 0; k < graph.size(); ++k) steps[k] = pack({curve == 0 ? k : graph.along2()[k], curve});
        if (backward) std::reverse(steps.begin(), steps.end());
        return steps;
      };
      add_piece(target, result_.areas.c1, round(0, orientations().clockwise1));
      add_piece(target, result_.areas.c2, round(1, orientations().clockwise2));
      return;
    }
    if (faces.size() == 0) fail_not_simple();
    const auto outside =
        static_cast<std::size_t>(std::min_element(faces.area.begin(), faces.area.end()) - faces.area.begin());
    for (std::size_t k = 0; k < faces.size(); ++k) {
      if (k != outside) {
        std::vector<std::uint32_t> steps(faces.begin[k + 1] - faces.begin[k]);
        reverse_face(faces, k, steps.data());
        target.holes.push_back({0, std::move(steps)});
      }
    }
    target.areas = {result_.areas.union_};
    target.steps.resize(faces.begin[outside + 1] - faces.begin[outside]);
    target.begin = {0, static_cast<std::uint32_t>(target.steps.size())};
    reverse_face(faces, outside, target.steps.data());
  }

  static void add_piece(PiecesData& target, double area, std::span<const std::uint32_t> steps) {
    target.areas.push_back(area);
    target.steps.insert(target.steps.end(), steps.begin(), steps.end());
    target.begin.push_back(static_cast<std::uint32_t>(target.steps.size()));
  }

  // A face walked the other way round, so that the outside of it is on the left.
  static void reverse_face(const Faces& faces, std::size_t face, std::uint32_t* steps) {
    const std::uint32_t begin = faces.begin[face], end = faces.begin[face + 1];
    for (std::uint32_t k = end; k-- > begin;) {
      const Step arc_before = unpack(faces.steps[k == begin ? end - 1 : k - 1]);
      *steps++ = pack({unpack(faces.steps[k]).node, arc_before.curve});
    }
  }

  // Equivalence classes of the crossings under sigma. The pieces of C1 \ C2 are known.
  void classify() {
    const NodeGraph& graph = graph_of(result_.nodes);
    const std::uint32_t count = graph.size();
    result_.classes.assign(count, Overlay::no_class);
    if (result_.nodes.crossings() == count) {  // then classes are faces, which are numbered the same way
      const PiecesData& faces = pieces(Pairing::c1_minus_c2);
      for (std::size_t face = 0; face < faces.size(); ++face) {
        for (const std::uint32_t step : faces.outer(face))
          result_.classes[unpack(step).node] = static_cast<std::uint32_t>(face);
      }
      result_.class_count = faces.size();
      return;
    }
    const Buffer<std::uint32_t>& along2 = graph.along2();
    const auto next_crossing = [&](std::uint32_t node, bool on_first, bool forward) {
      do {
        const std::uint32_t index = on_first ? node : graph.rank2[node];
        const std::uint32_t next =
            forward ? (index + 1 == count ? 0 : index + 1) : (index == 0 ? count - 1 : index - 1);
        node = on_first ? next : along2[next];
      } while (result_.nodes.rho(node) == 0);
      return node;
    };
    for (std::uint32_t start = 0; start < count; ++start) {
      if (result_.nodes.rho(start) == 0 || result_.classes[start] != Overlay::no_class) continue;
      const auto number = static_cast<std::uint32_t>(result_.class_count++);
      for (std::uint32_t node = start; result_.classes[node] == Overlay::no_class;) {
        result_.classes[node] = number;
        node = result_.nodes.rho(node) > 0 ? next_crossing(node, true, !orientations().clockwise1)
                                           : next_crossing(node, false, orientations().clockwise2);
      }
    }
  }

  // ------------------------------------------------------------------------------ curves that do not meet

  void overlay_apart() {
    const DD area1 = twice_area1(), area2 = twice_area2();
    constexpr std::uint32_t whole1 = whole_curve1, whole2 = whole_curve2;
    if (result_.nodes.same_curve()) {
      set_areas(std::nullopt, std::nullopt, area1);
      add_whole(Pairing::intersection, result_.areas.c1, whole1);
      add_whole(Pairing::union_, result_.areas.c1, whole1);
    } else if (contains(c1_, c2_.view().points[0])) {
      set_areas(area1 - area2, std::nullopt, area2);
      add_whole(Pairing::c1_minus_c2, result_.areas.c1_minus_c2, whole1, whole2);
      add_whole(Pairing::intersection, result_.areas.c2, whole2);
      add_whole(Pairing::union_, result_.areas.c1, whole1);
    } else if (contains(c2_, c1_.view().points[0])) {
      set_areas(std::nullopt, area2 - area1, area1);
      add_whole(Pairing::c2_minus_c1, result_.areas.c2_minus_c1, whole2, whole1);
      add_whole(Pairing::intersection, result_.areas.c1, whole1);
      add_whole(Pairing::union_, result_.areas.c2, whole2);
    } else {
      set_areas(area1, area2, std::nullopt);
      add_whole(Pairing::c1_minus_c2, result_.areas.c1, whole1);
      add_whole(Pairing::c2_minus_c1, result_.areas.c2, whole2);
      add_whole(Pairing::union_, result_.areas.c1, whole1);
      add_whole(Pairing::union_, result_.areas.c2, whole2);
    }
  }

  void add_whole(Pairing pairing, double area, std::uint32_t curve, std::uint32_t hole = 0) {
    if (!options_.pieces) return;
    PiecesData& target = pieces(pairing);
    add_piece(target, area, std::array{curve});
    if (hole != 0) target.holes.push_back({static_cast<std::uint32_t>(target.size() - 1), {hole}});
  }

  const IndexedCurve& c1_;
  const IndexedCurve& c2_;
  const OverlayOptions& options_;
  int exponent_;
  ArcSums sums_;
  std::array<PiecesData, 4> pieces_;
  Overlay result_;
};

}  // namespace

Overlay overlay(const IndexedCurve& c1, const IndexedCurve& c2, const OverlayOptions& options) {
  require_region(c1.view(), "curve 1", "overlay");
  require_region(c2.view(), "curve 2", "overlay");
  const int exponent = scaling_exponent(union_of(c1.tree().box(), c2.tree().box()));
  if (exponent == 0) return OverlayBuilder(c1, c2, options, 0).build(c1, c2);
  const std::vector<Point> first = scaled(c1.view(), exponent), second = scaled(c2.view(), exponent);
  const IndexedCurve scaled1(CurveView{first}), scaled2(CurveView{second});
  return OverlayBuilder(scaled1, scaled2, options, exponent).build(c1, c2);
}

Overlay overlay(const ClosedCurve& c1, const ClosedCurve& c2, const OverlayOptions& options) {
  require_region(c1, "curve 1", "overlay");
  require_region(c2, "curve 2", "overlay");
  const Stopwatch watch;
  const IndexedCurve first(c1), second(c2);
  // The streaming pass over the points sees a coordinate that is not finite; only then is it worth another to say
  // which.
  if (!first.finite()) validate(c1, "curve 1");
  if (!second.finite()) validate(c2, "curve 2");
  const double index_seconds = watch.seconds();
  Overlay result = overlay(first, second, options);
  result.timing.index = index_seconds;
  result.timing.total += index_seconds;
  return result;
}

}  // namespace lober
