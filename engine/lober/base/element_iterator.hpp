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
  using value_type = decltype(std::declval<const Range&>()[0]);
  using difference_type = std::ptrdiff_t;
  using iterator_concept = std::random_access_iterator_tag;
  using iterator_category = std::input_iterator_tag;  // in C++17 a stronger category needs references

  ElementIterator() = default;
  ElementIterator(const Range& range, std::size_t at) : range_(&range), at_(static_cast<difference_type>(at)) {}

  value_type operator*() const { return (*range_)[static_cast<std::size_t>(at_)]; }
  value_type operator[](difference_type step) const { return *(*this + step); }
  ElementIterator& operator+=(difference_type step) { return at_ += step, *this; }
  ElementIterator& operator-=(difference_type step) { return at_ -= step, *this; }
  ElementIterator& operator++() { return *this += 1; }
  ElementIterator& operator--() { return *this -= 1; }
  ElementIterator operator++(int) { return std::exchange(*this, *this + 1); }
  ElementIterator operator--(int) { return std::exchange(*this, *this - 1); }

  friend ElementIterator operator+(ElementIterator at, difference_type step) { return at += step; }
  friend ElementIterator operator+(difference_type step, ElementIterator at) { return at += step; }
  friend ElementIterator operator-(ElementIterator at, difference_type step) { return at -= step; }
  friend difference_type operator-(const ElementIterator& last, const ElementIterator& first) {
    return last.at_ - first.at_;
  }
  friend bool operator==(const ElementIterator& first, const ElementIterator& second) {
    return first.at_ == second.at_;
  }
  friend std::strong_ordering operator<=>(const ElementIterator& first, const ElementIterator& second) {
    return first.at_ <=> second.at_;
  }

 private:
  const Range* range_ = nullptr;
  difference_type at_ = 0;
};

}  // namespace lober
