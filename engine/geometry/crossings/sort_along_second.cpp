// Contacts in order along the second curve: by segment, then exact order on each segment.

#include <algorithm>
#include <atomic>

#include "engine/base/parallel/counting_sort.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/crossings/contacts.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t crossings_a_task = std::size_t{1} << 15;

// Sorts contacts by segment of C2 where few have to move and not far, but for those behind the first vertex of C2 that
// come before the others: so it is for curves that run side by side. In one pass over the segments, without an array of
// keys.
class NearlySorted {
 public:
  NearlySorted(const ContactList& contacts, std::uint32_t largest)
      : contacts_(contacts), count_(contacts.size()), order_(count_) {
    std::size_t start = 0;
    for (std::size_t k = 1; k < count_ && start == 0; ++k) {
      if (contacts.segment2(k) < contacts.segment2(k - 1) &&
          contacts.segment2(k - 1) - contacts.segment2(k) > largest / 2) {
        start = k;
      }
    }
    std::atomic<bool> nearly{true};
    for_each_block(count_, crossings_a_task, [&](std::size_t first, std::size_t last) {
      if (!nearly.load(std::memory_order_relaxed)) return;
      for (std::size_t k = first; k < last; ++k) {
        order_[k] = static_cast<std::uint32_t>(k + start < count_ ? k + start : k + start - count_);
      }
      if (!put_in_place(first + 1, last, first)) nearly = false;
    });
    sorted_ = nearly;
    for (std::size_t border = crossings_a_task; border < count_ && sorted_; border += crossings_a_task) {
      sorted_ = put_in_place(border, count_, 0, true);
    }
  }
  [[nodiscard]] bool sorted() const { return sorted_; }
  // The numbers of the contacts; those on one segment ascend.
  [[nodiscard]] Buffer<std::uint32_t>& order() { return order_; }

 private:
  [[nodiscard]] std::uint64_t key(std::uint32_t number) const {
    return std::uint64_t{contacts_.segment2(number)} << 32 | number;
  }
  // Moves each of the contacts from `begin` on down to its place among those before it, which are sorted, but not below
  // `lowest` and by a few places only. Returns whether that was enough. With `joins` it ends at the first that is in
  // its place.
  bool put_in_place(std::size_t begin, std::size_t end, std::size_t lowest, bool joins = false) {
    constexpr std::size_t furthest = 8;
    std::uint64_t largest = key(order_[begin - 1]);
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t number = order_[k];
      const std::uint64_t own = key(number);
      if (own > largest) {
        if (joins) return true;
        largest = own;
        continue;
      }
      const std::size_t floor = k - lowest < furthest ? lowest : k - furthest;
      std::size_t m = k;
      for (; m > floor && key(order_[m - 1]) > own; --m) order_[m] = order_[m - 1];
      order_[m] = number;
      if (m > lowest && key(order_[m - 1]) > own) return false;
    }
    return true;
  }

  const ContactList& contacts_;
  std::size_t count_;
  Buffer<std::uint32_t> order_;
  bool sorted_ = false;
};

// The numbers of the contacts by segment of C2; those on one segment ascend.
Buffer<std::uint32_t> sorted_by_segment(const ContactList& contacts, std::uint32_t largest) {
  NearlySorted nearly(contacts, largest);
  Buffer<std::uint32_t> order = std::move(nearly.order());
  if (nearly.sorted()) return order;
  const Buffer<KeyedNumber> items =
      sorted_by_key(contacts.size(), largest, [&](std::size_t k) { return contacts.segment2(k); });
  for_each_block(items.size(), crossings_a_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) order[k] = items[k].number;
  });
  return order;
}

}  // namespace

Buffer<std::uint32_t> sort_along_second(const ContactList& contacts, const CurveView& c1, const CurveView& c2,
                                        ContactCounts& counts) {
  const std::size_t count = contacts.size();
  Buffer<std::uint32_t> order = sorted_by_segment(contacts, static_cast<std::uint32_t>(c2.segments() - 1));
  const auto implicit = [&](const Contact& contact) -> ImplicitPoint {
    if (contact.vertex2) {
      const Point vertex = c2.points[contact.segment2];
      return {vertex, vertex, true};
    }
    const auto [a, b] = c1.segment(contact.segment1);
    return contact.proper() ? ImplicitPoint{a, b} : ImplicitPoint{a, a, true};
  };
  // Each piece orders the segments whose first contact lies in it.
  const std::size_t pieces = (count + crossings_a_task - 1) / crossings_a_task;
  const auto segment = [&](std::size_t k) { return contacts.segment2(order[k]); };
  Buffer<std::size_t> begin(pieces + 1);
  begin[0] = 0;
  begin[pieces] = count;
  for (std::size_t piece = 1; piece < pieces; ++piece) {
    std::size_t k = std::max(piece * crossings_a_task, begin[piece - 1]);
    while (k < count && k > 0 && segment(k) == segment(k - 1)) ++k;
    begin[piece] = k;
  }
  std::atomic<std::uint64_t> exact{0}, comparisons{0};
  for_each_block(pieces, 1, [&](std::size_t piece, std::size_t) {
    std::uint64_t exact_here = 0, comparisons_here = 0;
    const auto before = [&](std::uint32_t x, std::uint32_t y) {
      ++comparisons_here;
      const bool vertex = contacts.kind(x).vertex2;
      if (vertex != contacts.kind(y).vertex2) return vertex;
      const DD tx = contacts.t2(x), ty = contacts.t2(y);
      const double difference = (tx.hi - ty.hi) + (tx.lo - ty.lo);
      if (difference < -parameter_uncertainty) return true;
      if (difference > parameter_uncertainty || x == y) return false;
      ++exact_here;
      const auto [c, d] = c2.segment(contacts.segment2(x));
      return compare_along(c, d, implicit(contacts[x]), implicit(contacts[y])) < 0;
    };
    const std::size_t last = begin[piece + 1];
    for (std::size_t k = begin[piece]; k < last;) {
      const std::uint32_t here = segment(k);
      std::size_t end = k + 1;
      while (end < last && segment(end) == here) ++end;
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
