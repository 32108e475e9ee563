#include "engine/geometry/regions/events.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "engine/base/parallel/counting_sort.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/countable.hpp"
#include "engine/geometry/curve/point_along.hpp"
#include "kernels/crossing_parameters.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t events_a_task = std::size_t{1} << 15;

// Makes events of the candidates: the two ends of each incidence, then the isolated ones, spikes and extreme vertices.
class EventMaker {
 public:
  EventMaker(const EdgeChains& edge_chains, const Incidences& incidences, std::array<std::uint32_t, 2> extreme)
      : edge_chains_(edge_chains), incidences_(incidences.list), isolated_(incidences.spikes) {
    spikes_ = isolated_.size();
    for (int curve = 0; curve < edge_chains.curves(); ++curve)
      isolated_.push_back(extreme[static_cast<std::size_t>(curve)]);
    // This bounds the number of edges, each with two half-edges to be numbered.
    require_countable(2 * incidences_.size() + isolated_.size(), "places where the curves meet");
  }

  Events make() {
    sort_candidates();
    take_events();
    union_of();
    count_degree2();
    for (int curve = 0; curve < edge_chains_.curves(); ++curve) {
      const std::size_t candidate = 2 * incidences_.size() + spikes_ + static_cast<std::size_t>(curve);
      result_.extreme[static_cast<std::size_t>(curve)] = event_of_[candidate];
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::size_t candidates() const { return 2 * incidences_.size() + isolated_.size(); }

  [[nodiscard]] Event event_at(std::uint32_t candidate) const {
    if (candidate >= 2 * incidences_.size()) {
      const std::uint32_t segment = isolated_[candidate - 2 * incidences_.size()];
      return {{}, segment, segment, 0, Event::Kind::at_start};
    }
    const Incidence& incidence = incidences_[candidate / 2];
    const bool first = candidate % 2 == 0;
    const bool starts = first ? incidence.starts1 : incidence.starts2;
    const bool other_starts = first ? incidence.starts2 : incidence.starts1;
    const std::uint32_t segment = first ? incidence.first : incidence.second;
    if (starts) return {{}, segment, segment, 0, Event::Kind::at_start};
    return {first ? incidence.t1 : incidence.t2, segment, first ? incidence.second : incidence.first, 0,
            other_starts ? Event::Kind::at_vertex : Event::Kind::at_crossing};
  }

  // Order along one segment.
  int compare(const Event& x, const Event& y, std::uint64_t& exact) const {
    const bool starts_x = x.kind == Event::Kind::at_start, starts_y = y.kind == Event::Kind::at_start;
    if (starts_x || starts_y) return static_cast<int>(starts_y) - static_cast<int>(starts_x);
    if (x.kind == y.kind && x.other == y.other) return 0;
    const double difference = (x.t.hi - y.t.hi) + (x.t.lo - y.t.lo);
    if (difference < -parameter_uncertainty) return -1;
    if (difference > parameter_uncertainty) return 1;
    ++exact;
    const auto [a, b] = edge_chains_.segment(x.segment);
    return compare_along(a, b, implicit_point(edge_chains_, x), implicit_point(edge_chains_, y));
  }

  // Brings all candidates in order along the curves and finds out where a new event begins.
  void sort_candidates() {
    const std::size_t count = candidates();
    const Buffer<KeyedNumber> items = sorted_by_key(count, edge_chains_.segments() - 1, [&](std::size_t k) {
      return event_at(static_cast<std::uint32_t>(k)).segment;
    });
    order_.resize(count);
    fresh_.resize(count);
    std::atomic<std::uint64_t> exact_orders{0};
    for_each_block(count, events_a_task, [&](std::size_t begin, std::size_t end) {
      std::uint64_t exact = 0;
      const auto before = [&](std::uint32_t x, std::uint32_t y) {
        const Event event_x = event_at(x), event_y = event_at(y);
        const int order = compare(event_x, event_y, exact);
        if (order != 0) return order < 0;
        if (event_x.kind != event_y.kind) return event_x.kind < event_y.kind;
        return event_x.other < event_y.other;
      };
      // Each block orders the segments whose first candidate lies in it; `items` is only read, other blocks read it
      // too.
      while (begin > 0 && begin < end && items[begin].key == items[begin - 1].key) ++begin;
      for (std::size_t k = begin; k < end;) {
        std::size_t last = k;
        for (; last < count && items[last].key == items[k].key; ++last) order_[last] = items[last].number;
        if (last - k > 1) std::sort(&order_[k], &order_[k] + (last - k), before);
        fresh_[k] = 1;
        for (std::size_t m = k + 1; m < last; ++m) {
          fresh_[m] = compare(event_at(order_[m - 1]), event_at(order_[m]), exact) != 0;
        }
        k = last;
      }
      exact_orders += exact;
    });
    result_.exact_orders = exact_orders;
  }

  void take_events() {
    const std::size_t count = candidates();
    event_of_.resize(count);
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < count; ++k) {
      number += fresh_[k];
      event_of_[order_[k]] = number - 1;
    }
    result_.list.resize(number);
    for_each_block(count, events_a_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        if (fresh_[k] != 0) result_.list[event_of_[order_[k]]] = event_at(order_[k]);
      }
    });
    const std::uint32_t second = edge_chains_.first_of(1);
    const auto first_of_second = std::partition_point(result_.list.begin(), result_.list.end(),
                                                      [&](const Event& event) { return event.segment < second; });
    result_.begin = {0, static_cast<std::uint32_t>(first_of_second - result_.list.begin()), number};
    order_ = {};
    fresh_ = {};
  }

  // Events to nodes: a forest in which the root of each tree is its first event.
  void union_of() {
    Buffer<std::uint32_t> parent(result_.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t event) {
      while (parent[event] != event) event = parent[event] = parent[parent[event]];
      return event;
    };
    for (std::size_t k = 0; k < incidences_.size(); ++k) {
      const std::uint32_t x = root(event_of_[2 * k]), y = root(event_of_[2 * k + 1]);
      if (x != y) parent[std::max(x, y)] = std::min(x, y);
    }
    // A parent comes before its children, so its node is known.
    for (std::uint32_t event = 0; event < result_.size(); ++event) {
      result_.list[event].node = parent[event] == event ? result_.nodes++ : result_.list[parent[event]].node;
    }
  }

  // How many nodes are there only because an extreme vertex is.
  void count_degree2() {
    Buffer<std::uint8_t> degree2(result_.nodes, 1);
    for (std::size_t candidate = 0; candidate < 2 * incidences_.size() + spikes_; ++candidate) {
      degree2[result_.list[event_of_[candidate]].node] = 0;
    }
    result_.degree2 = static_cast<std::uint32_t>(std::count(degree2.begin(), degree2.end(), 1));
  }

  const EdgeChains& edge_chains_;
  const Buffer<Incidence>& incidences_;
  std::vector<std::uint32_t> isolated_;
  std::size_t spikes_ = 0;
  Buffer<std::uint32_t> order_;     // candidate numbers along the curves
  Buffer<std::uint8_t> fresh_;      // whether a new event begins there
  Buffer<std::uint32_t> event_of_;  // by candidate
  Events result_;
};

}  // namespace

Events make_events(const EdgeChains& edge_chains, const Incidences& incidences, std::array<std::uint32_t, 2> extreme) {
  return EventMaker(edge_chains, incidences, extreme).make();
}

ImplicitPoint implicit_point(const EdgeChains& edge_chains, const Event& event) {
  const auto [c, d] = edge_chains.segment(event.other);  // at_start: the segment itself
  return event.kind == Event::Kind::at_crossing ? ImplicitPoint{c, d} : ImplicitPoint{c, c, true};
}

Point point_of(const EdgeChains& edge_chains, const Event& event) {
  if (event.kind != Event::Kind::at_crossing) return edge_chains.start(event.other);
  return point_along(edge_chains.segment(event.segment), event.t);
}

}  // namespace lober::detail
