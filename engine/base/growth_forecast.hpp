// The expected cost of the next member of a sequence, such as the points of the images of a curve, which multiply about
// evenly.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/elementary.hpp"

namespace lober::detail {

class GrowthForecast {
 public:
  /// The next member is known. Members are positive.
  void add(double value) {
    before_last_ = last_;
    last_ = value;
    ++count_;
  }
  /// The member `ahead` places behind the last one: each is as many times the one before as the last one was, never
  /// fewer; as many as the last one where there is only one. 0 when none is known.
  [[nodiscard]] double next(int ahead = 1) const { return last_ * elementary::power(ratio(), ahead); }
  /// The sum of the next members, as many as asked for.
  [[nodiscard]] double sum(int ahead) const {
    double sum = 0;
    for (int k = 1; k <= ahead; ++k) sum += next(k);
    return sum;
  }
  [[nodiscard]] double ratio() const {
    return count_ < 2 || !(before_last_ > 0) ? 1 : std::max(1.0, last_ / before_last_);
  }
  [[nodiscard]] int count() const { return count_; }

 private:
  double last_ = 0, before_last_ = 0;
  int count_ = 0;
};

}  // namespace lober::detail
