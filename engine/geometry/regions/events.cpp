#include "engine/geometry/regions/events.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "engine/base/parallel/counting_sort.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/countable.hpp"
#include "engine/geometry/curve/point_along.hpp"
#include "kernels/crossing_parameters.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t events_a_task = std::size_t{1} << 15;

// Makes events of the candidates, curve by curve.
class EventMaker {
 public:
  EventMaker(const EdgeChains& edge_chains, Incidences incidences, std::array<std::uint32_t, 2> extreme)
      : edge_chains_(edge_chains), begin_(incidences.begin), extreme_(extreme) {
    result_.incidences = std::move(incidences.list);
    result_.parameters = std::move(incidences.parameters);
    ends_ = static_cast<std::uint32_t>(2 * result_.incidences.size());
    // This bounds the number of edges, each with two half-edges to be numbered.
    require_countable(2 * result_.incidences.size() + incidences.spikes.size() + 2, "places where the curves meet");
    for (int curve = 0; curve < edge_chains.curves(); ++curve) {
      const auto c = static_cast<std::size_t>(curve);
      for (const std::uint32_t spike : incidences.spikes) {
        if (edge_chains.curve_of(spike) == curve) result_.isolated.push_back(spike);
      }
      spikes_end_[c] = result_.isolated.size();
      result_.isolated.push_back(extreme[c]);
    }
  }

  Events make() {
    event_of_.resize(ends_ + result_.isolated.size());
    result_.candidate.resize(event_of_.size());
    for (int curve = 0; curve < edge_chains_.curves(); ++curve) {
      const auto c = static_cast<std::size_t>(curve);
      result_.begin[c + 1] = result_.begin[c] + add_events_of(candidates_on(curve), curve, result_.begin[c]);
      result_.extreme[c] = event_of_[ends_ + spikes_end_[c]];
    }
    result_.begin[2] = result_.begin[static_cast<std::size_t>(edge_chains_.curves())];
    result_.candidate.resize(result_.begin[2]);
    join_nodes();
    return std::move(result_);
  }

 private:
  // The candidates on one curve: those of incidences with itself, its ends of incidences with the other one, those
  // without an incidence.
  struct OnCurve {
    std::uint32_t self_begin, self_count, mutual_begin, mutual_count, isolated_begin, isolated_count;
    [[nodiscard]] std::size_t size() const { return std::size_t{self_count} + mutual_count + isolated_count; }
    [[nodiscard]] std::uint32_t operator[](std::uint32_t k) const {
      if (k < self_count) return self_begin + k;
      if (k < self_count + mutual_count) return mutual_begin + 2 * (k - self_count);
      return isolated_begin + (k - self_count - mutual_count);
    }
  };

  [[nodiscard]] OnCurve candidates_on(int curve) const {
    const auto c = static_cast<std::size_t>(curve);
    const std::size_t isolated = curve == 0 ? 0 : spikes_end_[0] + 1;
    const auto number = [](std::size_t k) { return static_cast<std::uint32_t>(k); };
    return {number(2 * begin_[c]),     number(2 * (begin_[c + 1] - begin_[c])),
            number(2 * begin_[2] + c), number(begin_[3] - begin_[2]),
            number(ends_ + isolated),  number(spikes_end_[c] + 1 - isolated)};
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

  // Brings the candidates of one curve in order along it and makes an event, numbered from `first_event`, of all that
  // are one point. Returns the number of events.
  std::uint32_t add_events_of(const OnCurve& on_curve, int curve, std::uint32_t first_event) {
    const std::size_t count = on_curve.size();
    const std::uint32_t offset = edge_chains_.first_of(curve);
    const auto largest = static_cast<std::uint32_t>(edge_chains_.curve(curve).points.size() - 1);
    const Buffer<KeyedNumber> items = sorted_by_key(count, largest, [&](std::size_t k) {
      return result_.segment_of(on_curve[static_cast<std::uint32_t>(k)]) - offset;
    });
    // Each block has the segments whose first candidate lies in it; `items` is only read, other blocks read it too.
    const auto for_each_segment = [&](std::size_t begin, std::size_t end, const auto& take) {
      while (begin > 0 && begin < end && items[begin].key == items[begin - 1].key) ++begin;
      for (std::size_t k = begin; k < end;) {
        std::size_t last = k + 1;
        while (last < count && items[last].key == items[k].key) ++last;
        take(k, last);
        k = last;
      }
    };
    Buffer<std::uint32_t> order(count);  // candidates, with a bit where a new event begins
    std::vector<std::uint32_t> before((count + events_a_task - 1) / events_a_task + 1, 0);
    std::atomic<std::uint64_t> exact_orders{0};
    for_each_block(count, events_a_task, [&](std::size_t begin, std::size_t end) {
      std::uint64_t exact = 0;
      std::uint32_t events = 0;
      for_each_segment(begin, end, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) order[k] = on_curve[items[k].number];
        if (last - first > 1) sort_on_segment(&order[first], last - first, exact);
        order[first] |= fresh;
        for (std::size_t k = first; k < last; ++k) events += order[k] >= fresh ? 1 : 0;
      });
      before[begin / events_a_task + 1] = events;
      exact_orders += exact;
    });
    result_.exact_orders += exact_orders;
    for (std::size_t k = 1; k < before.size(); ++k) before[k] += before[k - 1];
    for_each_block(count, events_a_task, [&](std::size_t begin, std::size_t end) {
      std::uint32_t next = first_event + before[begin / events_a_task];
      for_each_segment(begin, end, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
          const std::uint32_t candidate = order[k] & ~fresh;
          if (order[k] >= fresh) result_.candidate[next++] = candidate;
          event_of_[candidate] = next - 1;
        }
      });
    });
    return before.back();
  }

  static constexpr std::uint32_t fresh = std::uint32_t{1} << 31;

  // Sorts candidates along their segment, and marks where a new event begins, but for the first one.
  void sort_on_segment(std::uint32_t* candidates, std::size_t count, std::uint64_t& exact) const {
    // Where several candidates are one point, one that does not depend on the order of incidences comes first.
    const auto preferred = [](const Event& x, const Event& y) {
      return x.kind != y.kind ? x.kind < y.kind : x.other < y.other;
    };
    if (count == 2) {
      const Event x = result_.of_candidate(candidates[0]), y = result_.of_candidate(candidates[1]);
      const int order = compare(x, y, exact);
      if (order > 0 || (order == 0 && preferred(y, x))) std::swap(candidates[0], candidates[1]);
      if (order != 0) candidates[1] |= fresh;
      return;
    }
    std::sort(candidates, candidates + count, [&](std::uint32_t x, std::uint32_t y) {
      const Event event_x = result_.of_candidate(x), event_y = result_.of_candidate(y);
      const int order = compare(event_x, event_y, exact);
      return order != 0 ? order < 0 : preferred(event_x, event_y);
    });
    Event last = result_.of_candidate(candidates[0]);
    for (std::size_t k = 1; k < count; ++k) {
      const Event event = result_.of_candidate(candidates[k]);
      if (compare(last, event, exact) != 0) candidates[k] |= fresh;
      last = event;
    }
  }

  // Events to nodes: a forest in which the root of each tree is its first event, and a ring of the events of each tree.
  // Counts how many nodes are there only because an extreme vertex is.
  void join_nodes() {
    const std::uint32_t count = result_.size();
    Buffer<std::uint32_t>&parent = result_.node, &next = result_.next_at_node;
    parent.resize(count);
    next.resize(count);
    for (std::uint32_t event = 0; event < count; ++event) parent[event] = next[event] = event;
    const auto root = [&](std::uint32_t event) {
      while (parent[event] != event) event = parent[event] = parent[parent[event]];
      return event;
    };
    std::array<bool, 2> met{};
    const auto meet_at_start = [&](std::uint32_t segment) {
      for (std::size_t curve = 0; curve < 2; ++curve) met[curve] = met[curve] || segment == extreme_[curve];
    };
    for (std::size_t k = 0; k < result_.incidences.size(); ++k) {
      const Incidence& incidence = result_.incidences[k];
      if (incidence.starts1) meet_at_start(incidence.first);
      if (incidence.starts2) meet_at_start(incidence.second);
      const std::uint32_t x = root(event_of_[2 * k]), y = root(event_of_[2 * k + 1]);
      if (x == y) continue;
      parent[std::max(x, y)] = std::min(x, y);
      std::swap(next[x], next[y]);
    }
    for (int curve = 0; curve < edge_chains_.curves(); ++curve) {
      const OnCurve on_curve = candidates_on(curve);
      for (std::uint32_t k = 0; k + 1 < on_curve.isolated_count; ++k) {
        meet_at_start(result_.isolated[on_curve.isolated_begin - ends_ + k]);
      }
      if (!met[static_cast<std::size_t>(curve)]) ++result_.degree2;
    }
    // A parent comes before its children, so its root is known.
    for (std::uint32_t event = 0; event < count; ++event) {
      parent[event] = parent[parent[event]];
      result_.nodes += parent[event] == event ? 1 : 0;
    }
  }

  const EdgeChains& edge_chains_;
  std::array<std::size_t, 4> begin_;  // where parts of the incidences begin
  std::array<std::uint32_t, 2> extreme_;
  std::uint32_t ends_ = 0;                   // candidates that are ends of incidences; the isolated ones follow:
  std::array<std::size_t, 2> spikes_end_{};  // by curve its spikes, then, with this number, its extreme vertex
  Buffer<std::uint32_t> event_of_;           // by candidate
  Events result_;
};

}  // namespace

Events make_events(const EdgeChains& edge_chains, Incidences incidences, std::array<std::uint32_t, 2> extreme) {
  return EventMaker(edge_chains, std::move(incidences), extreme).make();
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
