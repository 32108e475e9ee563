// Contacts in order along the second curve: a radix sort by segment, then exact order on each segment.

#include <algorithm>
#include <array>
#include <atomic>

#include "engine/crossings/contacts.hpp"
#include "engine/parallel/parallel.hpp"

namespace lober {
namespace {

struct Item {
  std::uint32_t segment;
  std::uint32_t contact;
};

constexpr std::size_t grain = std::size_t{1} << 15;
constexpr std::uint32_t digit_bits = 11;
constexpr std::size_t digits = std::size_t{1} << digit_bits;

// One stable pass of counting sort by the digit at `shift`. The grain fixes the pieces, so the result does not depend
// on threads (a stable sort has one result anyway).
void sort_by_digit(const Buffer<Item>& from, Buffer<Item>& to, std::uint32_t shift) {
  const std::size_t pieces = (from.size() + grain - 1) / grain;
  std::vector<std::array<std::uint32_t, digits>> begin(pieces);
  const auto digit = [shift](const Item& item) { return (item.segment >> shift) & (digits - 1); };
  for_each_block(from.size(), grain, [&](std::size_t first, std::size_t last) {
    auto& count = begin[first / grain];
    count.fill(0);
    for (std::size_t k = first; k < last; ++k) ++count[digit(from[k])];
  });
  std::uint32_t total = 0;
  for (std::size_t value = 0; value < digits; ++value) {
    for (auto& piece : begin) {
      const std::uint32_t count = piece[value];
      piece[value] = total;
      total += count;
    }
  }
  for_each_block(from.size(), grain, [&](std::size_t first, std::size_t last) {
    auto& next = begin[first / grain];
    for (std::size_t k = first; k < last; ++k) to[next[digit(from[k])]++] = from[k];
  });
}

// Moves items[k] down to its place among the items before it, which are sorted; not further than a few places.
// Returns whether that was enough.
bool settle(Item* items, std::size_t k) {
  constexpr std::size_t furthest = 8;
  const Item item = items[k];
  const std::size_t lowest = k < furthest ? 0 : k - furthest;
  std::size_t m = k;
  for (; m > lowest && items[m - 1].segment > item.segment; --m) items[m] = items[m - 1];
  items[m] = item;
  return m == 0 || items[m - 1].segment <= item.segment;
}

// Sorts by insertion as long as items have to move by a few places only, which is so where the curves run side by side
// in the same direction. Gives up otherwise; then equal items are in their order still.
bool sort_if_nearly_sorted(Buffer<Item>& items) {
  std::atomic<bool> sorted{true};
  for_each_block(items.size(), grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = 1; k < last - first && sorted.load(std::memory_order_relaxed); ++k) {
      if (!settle(&items[first], k)) sorted = false;
    }
  });
  for (std::size_t border = grain; border < items.size() && sorted; border += grain) {
    for (std::size_t k = border; k < items.size() && items[k].segment < items[k - 1].segment; ++k) {
      if (!settle(items.data(), k)) return false;
    }
  }
  return sorted;
}

}  // namespace

void sort_along_second(const Buffer<Contact>& contacts, const CurveView& c1, const CurveView& c2,
                       Buffer<std::uint32_t>& order, std::uint64_t& exact_orders) {
  const std::size_t count = contacts.size();
  Buffer<Item> items(count);
  for_each_block(count, grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) items[k] = {contacts[k].segment2, static_cast<std::uint32_t>(k)};
  });
  if (!sort_if_nearly_sorted(items)) {
    const auto less = [](const Item& x, const Item& y) { return x.segment < y.segment; };
    if (count < digits) {
      std::stable_sort(items.begin(), items.end(), less);
    } else {
      Buffer<Item> other(count);
      for (std::uint32_t shift = 0; (c2.segments() - 1) >> shift != 0; shift += digit_bits) {
        sort_by_digit(items, other, shift);
        items.swap(other);
      }
    }
  }

  const auto implicit = [&](const Contact& contact) -> ImplicitPoint {
    if (contact.vertex2) {
      const Point vertex = c2.points[contact.segment2];
      return {vertex, vertex, true};
    }
    const auto [a, b] = c1.segment(contact.segment1);
    return contact.proper ? ImplicitPoint{a, b} : ImplicitPoint{a, a, true};
  };
  std::atomic<std::uint64_t> exact{0};
  order.resize(count);
  for_each_block(count, grain, [&](std::size_t first, std::size_t last) {
    std::uint64_t exact_here = 0;
    const auto before = [&](std::uint32_t x, std::uint32_t y) {
      const Contact &cx = contacts[x], &cy = contacts[y];
      if (cx.vertex2 != cy.vertex2) return cx.vertex2;
      const double difference = (cx.t2.hi - cy.t2.hi) + (cx.t2.lo - cy.t2.lo);
      if (difference < -parameter_doubt) return true;
      if (difference > parameter_doubt || x == y) return false;
      ++exact_here;
      const auto [c, d] = c2.segment(cx.segment2);
      return compare_along(c, d, implicit(cx), implicit(cy)) < 0;
    };
    // Each piece orders the segments whose first contact lies in it; `items` is only read, other pieces read it too.
    while (first > 0 && first < last && items[first].segment == items[first - 1].segment) ++first;
    for (std::size_t k = first; k < last;) {
      std::size_t end = k;
      for (; end < count && items[end].segment == items[k].segment; ++end) order[end] = items[end].contact;
      if (end - k == 2) {
        if (before(order[k + 1], order[k])) std::swap(order[k], order[k + 1]);
      } else if (end - k > 2) {
        std::sort(&order[k], &order[k] + (end - k), before);
      }
      k = end;
    }
    exact += exact_here;
  });
  exact_orders += exact;
}

}  // namespace lober
