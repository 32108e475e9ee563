// Contacts in order along the second curve: a radix sort by segment, then exact order on each segment.

#include <algorithm>
#include <atomic>

#include "engine/base/parallel/counting_sort.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/crossings/contacts.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t crossings_a_task = std::size_t{1} << 15;

}  // namespace

Buffer<std::uint32_t> sort_along_second(const ContactList& contacts, const CurveView& c1, const CurveView& c2,
                                        ContactCounts& counts) {
  const std::size_t count = contacts.size();
  const Buffer<KeyedNumber> items = sorted_by_key(count, static_cast<std::uint32_t>(c2.segments() - 1),
                                                  [&](std::size_t k) { return contacts[k].segment2; });
  const auto implicit = [&](const Contact& contact) -> ImplicitPoint {
    if (contact.vertex2) {
      const Point vertex = c2.points[contact.segment2];
      return {vertex, vertex, true};
    }
    const auto [a, b] = c1.segment(contact.segment1);
    return contact.proper() ? ImplicitPoint{a, b} : ImplicitPoint{a, a, true};
  };
  std::atomic<std::uint64_t> exact{0}, comparisons{0};
  Buffer<std::uint32_t> order(count);
  for_each_block(count, crossings_a_task, [&](std::size_t first, std::size_t last) {
    std::uint64_t exact_here = 0, comparisons_here = 0;
    const auto before = [&](std::uint32_t x, std::uint32_t y) {
      ++comparisons_here;
      const Contact cx = contacts[x], cy = contacts[y];
      if (cx.vertex2 != cy.vertex2) return cx.vertex2;
      const double difference = (cx.t2.hi - cy.t2.hi) + (cx.t2.lo - cy.t2.lo);
      if (difference < -parameter_uncertainty) return true;
      if (difference > parameter_uncertainty || x == y) return false;
      ++exact_here;
      const auto [c, d] = c2.segment(cx.segment2);
      return compare_along(c, d, implicit(cx), implicit(cy)) < 0;
    };
    // Each piece orders the segments whose first contact lies in it; `items` is only read, other pieces read it too.
    while (first > 0 && first < last && items[first].key == items[first - 1].key) ++first;
    for (std::size_t k = first; k < last;) {
      std::size_t end = k;
      for (; end < count && items[end].key == items[k].key; ++end) order[end] = items[end].number;
      if (end - k == 2) {
        if (before(order[k + 1], order[k])) std::swap(order[k], order[k + 1]);
      } else if (end - k > 2) {
        std::sort(&order[k], &order[k] + (end - k), before);
      }
      k = end;
    }
    exact += exact_here;
    comparisons += comparisons_here;
  });
  counts.exact_orders += exact;
  counts.comparisons += comparisons;
  return order;
}

}  // namespace lober::detail
