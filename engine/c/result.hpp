// A result as the C interface hands it out: named arrays, and what lives as long as they do (private to engine/c).
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lober/lober.h"
#include "lober/overlay/overlay.hpp"
#include "lober/tangle/tangle.hpp"

struct lober_result {
 public:
  using Doubles = std::vector<double>;
  using Integers = std::vector<std::int64_t>;

  void add(std::string name, double value) { add(std::move(name), Doubles{value}); }
  /// The number of rows is that of the values over that of the columns.
  void add(std::string name, Doubles values, std::size_t columns = 1);
  void add(std::string name, Integers values, std::size_t columns = 1);
  void add(std::string name, std::string text);
  /// Points that the result keeps.
  void add_points(std::string name, std::vector<lober::Point> points);
  /// Points that `owner` keeps.
  void add_points(std::string name, std::span<const lober::Point> points, std::shared_ptr<const void> owner);

  [[nodiscard]] const std::deque<lober_array>& arrays() const { return arrays_; }
  [[nodiscard]] const lober_array* find(std::string_view name) const;

  /// For lober_outline: what the pieces are of, and the curves given.
  std::deque<std::vector<lober::Point>> inputs;
  std::shared_ptr<const lober::Overlay> overlay;
  std::shared_ptr<const lober::Tangle> tangle;

 private:
  void add(std::string name, int type, const void* data, std::size_t rows, std::size_t columns);

  std::deque<std::string> names_, texts_;  // a deque leaves them where they are
  std::deque<Doubles> doubles_;
  std::deque<Integers> integers_;
  std::deque<lober_array> arrays_;
  std::vector<std::shared_ptr<const void>> owners_;
};
