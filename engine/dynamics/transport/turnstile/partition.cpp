#include "engine/dynamics/transport/turnstile/partition.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/transport/turnstile/cylinder.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// Boundaries that enclose others.
class Nesting {
 public:
  explicit Nesting(std::span<const Barrier> barriers) : barriers_(barriers) {
    for (const Barrier& barrier : barriers) {
      outlines_.push_back(outline_of(barrier, 0));
      areas_.push_back(enclosed_area(barrier));
    }
    parents_.resize(size());
    contains_.resize(size() * size());
    for (std::size_t c = 0; c < size(); ++c) {
      for (std::size_t d = 0; d < size(); ++d) {
        if (c == d || !contains(d, c)) continue;
        contains_[d * size() + c] = true;
        if (!parents_[c] || areas_[d].value < areas_[*parents_[c]].value) parents_[c] = d;
      }
    }
  }
  [[nodiscard]] std::size_t size() const { return barriers_.size(); }
  [[nodiscard]] std::optional<std::size_t> parent(std::size_t barrier) const { return parents_[barrier]; }
  [[nodiscard]] const std::vector<Measured>& areas() const { return areas_; }
  [[nodiscard]] Measured in_common(std::size_t c, std::size_t d) const {
    if (c == d || contains_[d * size() + c]) return areas_[c];
    return contains_[c * size() + d] ? areas_[d] : Measured{};
  }

 private:
  // The areas inside c, inside d and inside both; for boundaries that run round a cylinder, above some height.
  struct Insides {
    double c, d, both;
  };
  [[nodiscard]] Insides insides(std::size_t c, std::size_t d) {
    const Barrier &one = barriers_[c], &other = barriers_[d];
    if (turns_of(one) == 0) return {areas_[c].value, areas_[d].value, area_inside(outlines_[c], other, 0).value};
    if (c > d) {  // the same the other way round
      const Insides found = insides(d, c);
      return {found.d, found.c, found.both};
    }
    const auto known = below_.find({c, d});
    if (known != below_.end()) return known->second;
    const double low = std::min(lowest(outlines_[c], one.lattice), lowest(outlines_[d], one.lattice));
    const double bottom = low - length(one.lattice);
    const double below = -bottom * length(one.lattice);
    return below_[{c, d}] = {areas_[c].value + below, areas_[d].value + below, area_below_both(one, other, bottom)};
  }
  [[nodiscard]] bool contains(std::size_t outer, std::size_t inner) {
    constexpr double negligible = 1e-6;
    const int turns_outer = turns_of(barriers_[outer]), turns_inner = turns_of(barriers_[inner]);
    if (turns_inner != 0 && turns_outer == 0) return false;
    const Insides area = insides(inner, outer);
    if (area.both <= negligible * area.c) return false;
    const double smaller = turns_outer != 0 && turns_inner == 0 ? area.c : std::min(area.c, area.d);
    if (area.both < (1 - negligible) * smaller) {
      throw DataError("transport: boundaries " + std::to_string(std::min(inner, outer) + 1) + " and " +
                      std::to_string(std::max(inner, outer) + 1) +
                      " cross: they do not bound regions; with a smaller tolerance or a smaller perturbation they may");
    }
    return turns_outer != turns_inner && turns_inner == 0 ? true : area.c < area.d;
  }

  std::span<const Barrier> barriers_;
  std::vector<std::vector<Point>> outlines_;
  std::vector<Measured> areas_;
  std::vector<std::optional<std::size_t>> parents_;
  std::vector<bool> contains_;                                    // row by row
  std::map<std::pair<std::size_t, std::size_t>, Insides> below_;  // insides of two boundaries that run round
};

}  // namespace

Partition::Partition(std::span<const Barrier> barriers) {
  const Nesting nesting(barriers);
  const std::size_t count = barriers.size();
  areas_ = nesting.areas();
  for (std::size_t c = 0; c < count; ++c) {
    for (std::size_t d = 0; d < count; ++d) at_rest_.push_back(nesting.in_common(c, d));
  }
  // The region inside `barrier`, or inside none.
  const auto region = [&](std::optional<std::size_t> barrier) {
    Region found;
    found.coefficients.assign(count + 1, 0);
    found.coefficients[barrier ? *barrier + 1 : 0] = 1;
    found.bounded = barrier.has_value();
    bool is_lower_end = barrier && turns_of(barriers[*barrier]) != 0;
    if (barrier) found.area = areas_[*barrier];
    for (std::size_t c = 0; c < count; ++c) {
      if (nesting.parent(c) != barrier) continue;
      found.coefficients[c + 1] = -1;
      found.area = found.area - areas_[c];
      if (turns_of(barriers[c]) != 0) is_lower_end = false;
    }
    if (is_lower_end) found.bounded = false;
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
