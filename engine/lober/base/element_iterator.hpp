// The iterator of ranges that make their elements when asked for them.
#pragma once

#include <compare>
#include <cstddef>
#include <iterator>
#include <utility>

namespace lober {

/// Runs over the elements range[0], range[1], ..., which are values: `*at` gives one, there is nothing to assign to.
/// Random access. Valid as long as the range is.
template <typename Range>
class ElementIterator {
 public:
  using value_type = decltype(std::declval<const Range&>()[0]);  ///< an element, by value
  using difference_type = std::ptrdiff_t;                        ///< distance of two positions
  using iterator_concept = std::random_access_iterator_tag;      ///< for the algorithms of C++20
  /// For those of C++17.
  using iterator_category = std::input_iterator_tag;  // in C++17 a stronger category needs references

  ElementIterator() = default;
  /// The iterator at an index of the range, which has to outlive it.
  ElementIterator(const Range& range, std::size_t at) : range_(&range), at_(static_cast<difference_type>(at)) {}

  /// The element.
  value_type operator*() const { return (*range_)[static_cast<std::size_t>(at_)]; }
  /// The element some steps on.
  value_type operator[](difference_type step) const { return *(*this + step); }
  /// Goes some steps on.
  ElementIterator& operator+=(difference_type step) { return at_ += step, *this; }
  /// Goes some steps back.
  ElementIterator& operator-=(difference_type step) { return at_ -= step, *this; }
  /// Goes one step on.
  ElementIterator& operator++() { return *this += 1; }
  /// Goes one step back.
  ElementIterator& operator--() { return *this -= 1; }
  /// Goes one step on; returns the position before.
  ElementIterator operator++(int) { return std::exchange(*this, *this + 1); }
  /// Goes one step back; returns the position before.
  ElementIterator operator--(int) { return std::exchange(*this, *this - 1); }

  /// The position some steps on.
  friend ElementIterator operator+(ElementIterator at, difference_type step) { return at += step; }
  /// The position some steps on.
  friend ElementIterator operator+(difference_type step, ElementIterator at) { return at += step; }
  /// The position some steps back.
  friend ElementIterator operator-(ElementIterator at, difference_type step) { return at -= step; }
  /// The number of steps from the first to the last.
  friend difference_type operator-(const ElementIterator& last, const ElementIterator& first) {
    return last.at_ - first.at_;
  }
  /// Whether both are at the same index.
  friend bool operator==(const ElementIterator& first, const ElementIterator& second) {
    return first.at_ == second.at_;
  }
  /// The order of the indices.
  friend std::strong_ordering operator<=>(const ElementIterator& first, const ElementIterator& second) {
    return first.at_ <=> second.at_;
  }

 private:
  const Range* range_ = nullptr;
  difference_type at_ = 0;
};

}  // namespace lober
