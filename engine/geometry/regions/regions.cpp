#include "lober/overlay/regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "engine/base/stopwatch.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/curve/scaled.hpp"
#include "engine/geometry/index/orientation.hpp"
#include "engine/geometry/index/sums_along.hpp"
#include "engine/geometry/regions/arrangement.hpp"

namespace lober {
using namespace detail;

std::string_view name(FillRule rule) {
  switch (rule) {
    case FillRule::nonzero:
      return "nonzero";
    case FillRule::evenodd:
      return "evenodd";
    case FillRule::positive:
      return "positive";
    case FillRule::negative:
      return "negative";
  }
  return "";
}

bool inside(FillRule rule, int winding) {
  switch (rule) {
    case FillRule::nonzero:
      return winding != 0;
    case FillRule::evenodd:
      return winding % 2 != 0;
    case FillRule::positive:
      return winding > 0;
    case FillRule::negative:
      return winding < 0;
  }
  return false;
}

bool detail::belongs(Windings windings, FillRule rule, Pairing pairing) {
  const bool in1 = inside(rule, windings.of1), in2 = inside(rule, windings.of2);
  switch (pairing) {
    case Pairing::c1_minus_c2:
      return in1 && !in2;
    case Pairing::c2_minus_c1:
      return in2 && !in1;
    case Pairing::intersection:
      return in1 && in2;
    case Pairing::union_:
      return in1 || in2;
  }
  return false;
}

double Arrangement::area(DD twice) const {
  return scaled_area(std::max(0.0, 0.5 * (twice.hi + twice.lo)), area_exponent);
}

namespace {

// Puts a result together. One for each call.
class RegionBuilder {
 public:
  // The curves are those of the caller times 2^exponent.
  RegionBuilder(const IndexedCurve& c1, const IndexedCurve* c2, const RegionOptions& options, int exponent)
      : c1_(c1), c2_(c2), options_(options), exponent_(exponent) {}

  Regions build(const IndexedCurve& caller1, const IndexedCurve* caller2, double index_seconds) {
    const Stopwatch watch;
    report(0);
    auto arrangement = std::make_shared<Arrangement>();
    Arrangement& scene = *arrangement;
    scene.edge_chains = c2_ == nullptr ? EdgeChains(c1_.view()) : EdgeChains(c1_.view(), c2_->view());
    const IndexKind kind = c2_ == nullptr                           ? IndexKind::tree
                           : options_.index != IndexKind::automatic ? options_.index
                                                                    : choose_index(c1_, *c2_);
    const std::array<std::uint32_t, 2> extreme = extreme_segments(scene.edge_chains);
    Incidences incidences = find_incidences(c1_, c2_, kind, extreme);
    RegionTiming& timing = scene.timing;
    timing.index = index_seconds;
    timing.search = watch.seconds();
    report(0.5);

    const Stopwatch node_watch;
    const IncidenceCounts found = incidences.counts;
    scene.events = make_events(scene.edge_chains, std::move(incidences), extreme);
    timing.nodes = node_watch.seconds();
    report(0.7);

    const Stopwatch graph_watch;
    scene.graph = connect(scene.edge_chains, scene.events);
    scene.events.next_at_node = {};
    timing.graph = graph_watch.seconds();

    const Stopwatch face_watch;
    const EdgeSums sums = sum_edges(scene);
    PredicateCounts placing;
    scene.faces = make_faces(scene.edge_chains, scene.events, scene.graph, sums, found.mutual > 0, c1_, c2_, placing);
    scene.area_exponent = -2 * exponent_;
    make_table(scene);
    const double bound = scaled_bound(scene.lost, scene.area_exponent);
    for (const WindingArea& entry : scene.table) require_known(entry.area, bound);
    timing.faces = face_watch.seconds();

    count(scene, found, placing, kind);
    if (exponent_ != 0) {  // the result speaks of the caller's points
      scene.edge_chains = c2_ == nullptr ? EdgeChains(caller1.view()) : EdgeChains(caller1.view(), caller2->view());
    }
    scene.owners = {caller1.owner(), caller2 == nullptr ? nullptr : caller2->owner()};
    timing.total = watch.seconds() + index_seconds;
    report(1);
    return Regions(std::move(arrangement));
  }

 private:
  void report(double fraction) const {
    if (!options_.progress(fraction)) throw Cancelled();
  }

  // The segments whose first ends are the extreme vertices; that of C1 twice where there is no C2.
  [[nodiscard]] std::array<std::uint32_t, 2> extreme_segments(const EdgeChains& edge_chains) const {
    const std::uint32_t first = extreme_segment(c1_.tree());
    return {first, c2_ == nullptr ? first : edge_chains.first_of(1) + extreme_segment(c2_->tree())};
  }

  // Shoelace sums of all edges about one origin. Also bounds what areas lose: the gap at each node
  // (crossing_parameters.hpp) times the size of the scene, and the additions of RunningSum, relative to the largest
  // sum.
  EdgeSums sum_edges(Arrangement& scene) {
    const Events& events = scene.events;
    EdgeSums sums;
    sums.second = events.begin[1];
    double largest = 0, additions = 4096;
    for (int curve = 0; curve < scene.edge_chains.curves(); ++curve) {
      const BoxTree& tree = curve == 0 ? c1_.tree() : c2_->tree();
      const std::uint32_t first = events.begin[static_cast<std::size_t>(curve)];
      const std::uint32_t count = events.begin[static_cast<std::size_t>(curve) + 1] - first;
      const std::uint32_t offset = scene.edge_chains.first_of(curve);
      Buffer<DD>& up_to = sums.up_to[static_cast<std::size_t>(curve)];
      up_to.resize(count + std::size_t{1});
      const SumAlong along = sum_along(
          tree, c1_.view().points[0], count,
          [&](std::size_t k) {
            const Event event = events[first + static_cast<std::uint32_t>(k)];
            return PrecisePosition{event.segment - offset, event.t};
          },
          [&](std::size_t k, DD sum) { up_to[k] = sum; });
      up_to[count] = up_to[0] + along.total;
      largest = std::max({largest, along.largest, std::fabs(along.total.hi)});
      for (std::uint32_t k = 0; k < count; ++k) largest = std::max(largest, std::fabs(up_to[k].hi));
      additions += static_cast<double>(tree.segments()) / 1024;
      scene.signed_areas[static_cast<std::size_t>(curve)] =
          scaled_area(0.5 * (along.total.hi + along.total.lo), -2 * exponent_);
    }
    const double extent = (c2_ == nullptr ? c1_.tree().box() : union_of(c1_.tree().box(), c2_->tree().box())).extent();
    const double size = extent * extent;
    scene.lost = size * events.size() * 0x1p-91 + (size + largest) * additions * 0x1p-104;
    return sums;
  }

  void make_table(Arrangement& scene) {
    std::map<Windings, RunningSum> sums;
    // Faces have few pairs of winding numbers, mostly: those met last are found without a search.
    std::array<std::map<Windings, RunningSum>::iterator, 64> recent;
    recent.fill(sums.end());
    const RegionFaces& faces = scene.faces;
    for (std::uint32_t face = 0; face < faces.size(); ++face) {
      const Windings windings = faces.labels[face].windings;
      if (windings == Windings{0, 0}) continue;
      const auto slot = static_cast<std::uint32_t>(windings.of1) + 8 * static_cast<std::uint32_t>(windings.of2);
      auto& found = recent[slot % recent.size()];
      if (found == sums.end() || found->first != windings) found = sums.try_emplace(windings).first;
      found->second.add(faces.twice_area[face]);
    }
    for (const auto& [windings, sum] : sums) {
      scene.table.push_back({windings.of1, windings.of2, scene.area(sum.value())});
      scene.twice_areas.push_back(sum.value());
    }
  }

  void count(Arrangement& scene, const IncidenceCounts& found, const PredicateCounts& placing, IndexKind kind) {
    RegionCounts& counts = scene.counts;
    counts.nodes = scene.events.nodes - scene.events.degree2 + found.along;
    // A node of degree 2 cuts an edge in two, unless it is the only one of its curve.
    counts.edges = scene.events.size() - scene.graph.merged - scene.events.degree2 + found.along;
    if (found.mutual == 0 && found.self1 == 0) ++counts.edges;
    if (found.mutual == 0 && found.self2 == 0 && c2_ != nullptr) ++counts.edges;
    counts.faces = scene.faces.size();
    counts.self1 = found.self1;
    counts.self2 = found.self2;
    counts.mutual = found.mutual;
    counts.index = kind;
    counts.search = found.search;
    counts.predicates = found.predicates;
    counts.predicates += scene.graph.predicates;
    counts.predicates += placing;
    counts.exact_parameters = found.exact_parameters;
    counts.exact_orders = scene.events.exact_orders;
  }

  const IndexedCurve& c1_;
  const IndexedCurve* c2_;
  const RegionOptions& options_;
  int exponent_;
};

// The areas by what they are made of.
struct RegionPart {
  double Areas::*area;
  bool (*wanted)(bool in1, bool in2);
};
constexpr std::array<RegionPart, 7> region_parts{{
    {&Areas::c1, [](bool in1, bool) { return in1; }},
    {&Areas::c2, [](bool, bool in2) { return in2; }},
    {&Areas::intersection, [](bool in1, bool in2) { return in1 && in2; }},
    {&Areas::union_, [](bool in1, bool in2) { return in1 || in2; }},
    {&Areas::c1_minus_c2, [](bool in1, bool in2) { return in1 && !in2; }},
    {&Areas::c2_minus_c1, [](bool in1, bool in2) { return !in1 && in2; }},
    {&Areas::symmetric_difference, [](bool in1, bool in2) { return in1 != in2; }},
}};

bool takes(const RegionPart& part, FillRule rule, const WindingArea& entry) {
  return part.wanted(inside(rule, entry.w1), inside(rule, entry.w2));
}

}  // namespace

Regions::Regions() {
  static const auto nothing = std::make_shared<const Arrangement>();
  arrangement_ = nothing;
}

std::span<const WindingArea> Regions::table() const& {
  return arrangement_->table;
}
std::array<double, 2> Regions::signed_areas() const {
  return arrangement_->signed_areas;
}
const RegionCounts& Regions::counts() const& {
  return arrangement_->counts;
}
const RegionTiming& Regions::timing() const& {
  return arrangement_->timing;
}

Areas Regions::areas(FillRule rule) const {
  const Arrangement& scene = *arrangement_;
  Areas areas;
  for (const RegionPart& part : region_parts) {
    RunningSum sum;
    for (std::size_t k = 0; k < scene.table.size(); ++k) {
      if (takes(part, rule, scene.table[k])) sum.add(scene.twice_areas[k]);
    }
    areas.*part.area = scene.area(sum.value());
  }
  return areas;
}

double Regions::rounding(double area) const {
  return area * 0x1p-53 + scaled_bound(arrangement_->lost, arrangement_->area_exponent);
}

Areas Regions::rounding(FillRule rule) const {
  const Areas computed = areas(rule);
  Areas bounds;
  for (const RegionPart& part : region_parts) {
    const bool some =
        std::any_of(table().begin(), table().end(), [&](const WindingArea& entry) { return takes(part, rule, entry); });
    bounds.*part.area = some ? rounding(computed.*part.area) : 0;  // the area of nothing is exact
  }
  return bounds;
}

namespace {

Regions build(const IndexedCurve& c1, const IndexedCurve* c2, const RegionOptions& options, double index_seconds = 0) {
  require_region(c1.view(), "curve 1", "regions");
  if (c2 != nullptr) require_region(c2->view(), "curve 2", "regions");
  const int exponent = scaling_exponent(c2 == nullptr ? c1.tree().box() : union_of(c1.tree().box(), c2->tree().box()));
  if (exponent == 0) return RegionBuilder(c1, c2, options, 0).build(c1, c2, index_seconds);
  const std::vector<Point> first = scaled(c1.view(), exponent);
  const IndexedCurve scaled1(CurveView{first});
  if (c2 == nullptr) return RegionBuilder(scaled1, nullptr, options, exponent).build(c1, c2, index_seconds);
  const std::vector<Point> second = scaled(c2->view(), exponent);
  const IndexedCurve scaled2(CurveView{second});
  return RegionBuilder(scaled1, &scaled2, options, exponent).build(c1, c2, index_seconds);
}

Regions index_and_build(const ClosedCurve& c1, const ClosedCurve* c2, const RegionOptions& options) {
  const Stopwatch watch;
  const auto indexed = [](const ClosedCurve& curve, std::string_view name) {
    require_region(curve, name, "regions");
    IndexedCurve result(curve);
    if (!result.finite()) validate(curve, name);
    return result;
  };
  const IndexedCurve first = indexed(c1, "curve 1");
  std::optional<IndexedCurve> second;
  if (c2 != nullptr) second.emplace(indexed(*c2, "curve 2"));
  return build(first, second ? &*second : nullptr, options, watch.seconds());
}

}  // namespace

Regions regions(const IndexedCurve& c1, const RegionOptions& options) {
  return build(c1, nullptr, options);
}

Regions regions(const IndexedCurve& c1, const IndexedCurve& c2, const RegionOptions& options) {
  return build(c1, &c2, options);
}

Regions regions(const ClosedCurve& c1, const RegionOptions& options) {
  return index_and_build(c1, nullptr, options);
}

Regions regions(const ClosedCurve& c1, const ClosedCurve& c2, const RegionOptions& options) {
  return index_and_build(c1, &c2, options);
}

}  // namespace lober
