// A partition into disjoint sets, which are joined one by one.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace lober::oracle {

/// The elements 0, 1, ..., each at first a set of its own.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// The element that stands for the set of this one.
  [[nodiscard]] std::size_t find(std::size_t element) {
    while (parent_[element] != element) element = parent_[element] = parent_[parent_[element]];
    return element;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace lober::oracle
