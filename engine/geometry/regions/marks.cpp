#include "engine/geometry/regions/marks.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "engine/base/parallel/counting_sort.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/countable.hpp"
#include "engine/geometry/curve/point_along.hpp"
#include "kernels/crossing_parameters.hpp"

namespace lober {
namespace {

constexpr std::size_t grain = std::size_t{1} << 15;

// Makes marks of the sites: the two ends of each incidence, then the lone ones, tips and extreme vertices.
class MarkMaker {
 public:
  MarkMaker(const Strands& strands, const Incidences& incidences, std::array<std::uint32_t, 2> extreme)
      : strands_(strands), incidences_(incidences.list), lone_(incidences.tips) {
    tips_ = lone_.size();
    for (int curve = 0; curve < strands.curves(); ++curve) lone_.push_back(extreme[static_cast<std::size_t>(curve)]);
    // There are at most so many edges, each with two half-edges to be numbered.
    require_countable(2 * incidences_.size() + lone_.size(), "places where the curves meet");
  }

  Marks make() {
    sort_sites();
    take_marks();
    unite();
    count_plain();
    for (int curve = 0; curve < strands_.curves(); ++curve) {
      const std::size_t site = 2 * incidences_.size() + tips_ + static_cast<std::size_t>(curve);
      result_.extreme[static_cast<std::size_t>(curve)] = mark_of_[site];
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::size_t sites() const { return 2 * incidences_.size() + lone_.size(); }

  [[nodiscard]] Mark mark_at(std::uint32_t site) const {
    if (site >= 2 * incidences_.size()) {
      const std::uint32_t segment = lone_[site - 2 * incidences_.size()];
      return {{}, segment, segment, 0, Mark::Kind::at_start};
    }
    const Incidence& incidence = incidences_[site / 2];
    const bool first = site % 2 == 0;
    const bool starts = first ? incidence.starts1 : incidence.starts2;
    const bool other_starts = first ? incidence.starts2 : incidence.starts1;
    const std::uint32_t segment = first ? incidence.first : incidence.second;
    if (starts) return {{}, segment, segment, 0, Mark::Kind::at_start};
    return {first ? incidence.t1 : incidence.t2, segment, first ? incidence.second : incidence.first, 0,
            other_starts ? Mark::Kind::at_vertex : Mark::Kind::at_crossing};
  }

  // Order along one segment.
  int compare(const Mark& x, const Mark& y, std::uint64_t& exact) const {
    const bool starts_x = x.kind == Mark::Kind::at_start, starts_y = y.kind == Mark::Kind::at_start;
    if (starts_x || starts_y) return static_cast<int>(starts_y) - static_cast<int>(starts_x);
    if (x.kind == y.kind && x.other == y.other) return 0;
    const double difference = (x.t.hi - y.t.hi) + (x.t.lo - y.t.lo);
    if (difference < -parameter_doubt) return -1;
    if (difference > parameter_doubt) return 1;
    ++exact;
    const auto [a, b] = strands_.segment(x.segment);
    return compare_along(a, b, implicit_point(strands_, x), implicit_point(strands_, y));
  }

  // Brings all sites in order along the curves and finds out where a new mark begins.
  void sort_sites() {
    const std::size_t count = sites();
    const Buffer<KeyedNumber> items = sorted_by_key(
        count, strands_.segments() - 1, [&](std::size_t k) { return mark_at(static_cast<std::uint32_t>(k)).segment; });
    order_.resize(count);
    fresh_.resize(count);
    std::atomic<std::uint64_t> exact_orders{0};
    for_each_block(count, grain, [&](std::size_t begin, std::size_t end) {
      std::uint64_t exact = 0;
      const auto before = [&](std::uint32_t x, std::uint32_t y) {
        const Mark mark_x = mark_at(x), mark_y = mark_at(y);
        const int order = compare(mark_x, mark_y, exact);
        if (order != 0) return order < 0;
        if (mark_x.kind != mark_y.kind) return mark_x.kind < mark_y.kind;
        return mark_x.other < mark_y.other;
      };
      // Each block orders the segments whose first site lies in it; `items` is only read, other blocks read it too.
      while (begin > 0 && begin < end && items[begin].key == items[begin - 1].key) ++begin;
      for (std::size_t k = begin; k < end;) {
        std::size_t last = k;
        for (; last < count && items[last].key == items[k].key; ++last) order_[last] = items[last].number;
        if (last - k > 1) std::sort(&order_[k], &order_[k] + (last - k), before);
        fresh_[k] = 1;
        for (std::size_t m = k + 1; m < last; ++m) {
          fresh_[m] = compare(mark_at(order_[m - 1]), mark_at(order_[m]), exact) != 0;
        }
        k = last;
      }
      exact_orders += exact;
    });
    result_.exact_orders = exact_orders;
  }

  void take_marks() {
    const std::size_t count = sites();
    mark_of_.resize(count);
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < count; ++k) {
      number += fresh_[k];
      mark_of_[order_[k]] = number - 1;
    }
    result_.list.resize(number);
    for_each_block(count, grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        if (fresh_[k] != 0) result_.list[mark_of_[order_[k]]] = mark_at(order_[k]);
      }
    });
    const std::uint32_t second = strands_.first_of(1);
    const auto first_of_second = std::partition_point(result_.list.begin(), result_.list.end(),
                                                      [&](const Mark& mark) { return mark.segment < second; });
    result_.begin = {0, static_cast<std::uint32_t>(first_of_second - result_.list.begin()), number};
    order_ = {};
    fresh_ = {};
  }

  // Marks to nodes: a forest in which the root of each tree is its first mark.
  void unite() {
    Buffer<std::uint32_t> parent(result_.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t mark) {
      while (parent[mark] != mark) mark = parent[mark] = parent[parent[mark]];
      return mark;
    };
    for (std::size_t k = 0; k < incidences_.size(); ++k) {
      const std::uint32_t x = root(mark_of_[2 * k]), y = root(mark_of_[2 * k + 1]);
      if (x != y) parent[std::max(x, y)] = std::min(x, y);
    }
    // A parent comes before its children, so its node is known.
    for (std::uint32_t mark = 0; mark < result_.size(); ++mark) {
      result_.list[mark].node = parent[mark] == mark ? result_.nodes++ : result_.list[parent[mark]].node;
    }
  }

  // How many nodes are there only because an extreme vertex is.
  void count_plain() {
    Buffer<std::uint8_t> plain(result_.nodes, 1);
    for (std::size_t site = 0; site < 2 * incidences_.size() + tips_; ++site) {
      plain[result_.list[mark_of_[site]].node] = 0;
    }
    result_.plain = static_cast<std::uint32_t>(std::count(plain.begin(), plain.end(), 1));
  }

  const Strands& strands_;
  const Buffer<Incidence>& incidences_;
  std::vector<std::uint32_t> lone_;
  std::size_t tips_ = 0;
  Buffer<std::uint32_t> order_;    // site numbers along the curves
  Buffer<std::uint8_t> fresh_;     // whether a new mark begins there
  Buffer<std::uint32_t> mark_of_;  // by site
  Marks result_;
};

}  // namespace

Marks make_marks(const Strands& strands, const Incidences& incidences, std::array<std::uint32_t, 2> extreme) {
  return MarkMaker(strands, incidences, extreme).make();
}

ImplicitPoint implicit_point(const Strands& strands, const Mark& mark) {
  const auto [c, d] = strands.segment(mark.other);  // at_start: the segment itself
  return mark.kind == Mark::Kind::at_crossing ? ImplicitPoint{c, d} : ImplicitPoint{c, c, true};
}

Point place(const Strands& strands, const Mark& mark) {
  if (mark.kind != Mark::Kind::at_crossing) return strands.start(mark.other);
  return point_along(strands.segment(mark.segment), mark.t);
}

}  // namespace lober
