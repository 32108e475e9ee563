#include "engine/dynamics/transport/partition.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "lober/curve.hpp"
#include "lober/error.hpp"
#include "lober/interior.hpp"

namespace lober::detail {
namespace {

// Boundaries that enclose others.
class Nesting {
 public:
  explicit Nesting(std::span<const Barrier> barriers) {
    for (const Barrier& barrier : barriers) {
      outlines_.push_back(outline_of(barrier, 0));
      areas_.push_back(enclosed_area(barrier, 0));
    }
    parents_.resize(barriers.size());
    for (std::size_t c = 0; c < barriers.size(); ++c) {
      for (std::size_t d = 0; d < barriers.size(); ++d) {
        if (c != d && contains(d, c) && (!parents_[c] || areas_[d].value < areas_[*parents_[c]].value)) parents_[c] = d;
      }
    }
  }
  [[nodiscard]] std::optional<std::size_t> parent(std::size_t barrier) const { return parents_[barrier]; }
  [[nodiscard]] const std::vector<Point>& outline(std::size_t barrier) const { return outlines_[barrier]; }
  [[nodiscard]] Measured area(std::size_t barrier) const { return areas_[barrier]; }

 private:
  [[nodiscard]] bool contains(std::size_t outer, std::size_t inner) const {
    constexpr double negligible = 1e-6;
    const double whole = areas_[inner].value;
    const double common = area_in_common(outlines_[outer], outlines_[inner], 0).value;
    if (common <= negligible * whole) return false;
    if (common < (1 - negligible) * std::min(whole, areas_[outer].value)) {
      throw DataError("transport: boundaries " + std::to_string(std::min(inner, outer) + 1) + " and " +
                      std::to_string(std::max(inner, outer) + 1) + " cross: they do not bound regions");
    }
    return whole < areas_[outer].value;
  }

  std::vector<std::vector<Point>> outlines_;
  std::vector<Measured> areas_;
  std::vector<std::optional<std::size_t>> parents_;
};

}  // namespace

Partition::Partition(std::span<const Barrier> barriers, const Point* hole) {
  const Nesting nesting(barriers);
  const std::size_t count = barriers.size();
  // The region inside `barrier`, or inside none.
  const auto region = [&](std::optional<std::size_t> barrier) {
    Region found;
    found.coefficients.assign(count + 1, 0);
    found.coefficients[barrier ? *barrier + 1 : 0] = 1;
    found.bounded = barrier.has_value();
    bool holds_hole =
        barrier && hole != nullptr && winding(IndexedCurve(CurveView{nesting.outline(*barrier)}), *hole).number != 0;
    if (barrier) found.area = nesting.area(*barrier);
    for (std::size_t c = 0; c < count; ++c) {
      if (nesting.parent(c) != barrier) continue;
      found.coefficients[c + 1] = -1;
      found.area = found.area - nesting.area(c);
      if (holds_hole && winding(IndexedCurve(CurveView{nesting.outline(c)}), *hole).number != 0) holds_hole = false;
    }
    if (holds_hole) found.bounded = false;
    if (!found.bounded) found.area = {std::numeric_limits<double>::quiet_NaN(), 0};
    return found;
  };
  std::vector<std::optional<std::size_t>> order{std::size_t{0}, nesting.parent(0)};
  for (std::size_t c = 1; c < count; ++c) {
    if (std::find(order.begin(), order.end(), std::optional(c)) == order.end()) order.emplace_back(c);
  }
  if (std::find(order.begin(), order.end(), std::nullopt) == order.end()) order.emplace_back(std::nullopt);
  for (const std::optional<std::size_t>& barrier : order) regions_.push_back(region(barrier));
}

Measured Partition::combine(std::size_t i, std::size_t j,
                            const std::function<Measured(std::size_t, std::size_t)>& quantity) const {
  Measured sum{};
  const std::vector<int>&first = regions_[i].coefficients, &second = regions_[j].coefficients;
  for (std::size_t c = 0; c < first.size(); ++c) {
    for (std::size_t d = 0; d < second.size(); ++d) {
      if (const int factor = first[c] * second[d]; factor != 0) sum = sum + factor * quantity(c, d);
    }
  }
  return sum;
}

}  // namespace lober::detail
