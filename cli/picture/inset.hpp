// A part of the plot that is shown once more, magnified, where it hides least.
#pragma once

#include <string>

#include "cli/picture/figure.hpp"
#include "cli/picture/ticks.hpp"
#include "cli/picture/view.hpp"

namespace lober::cli {

class Inset {
 public:
  Inset(const Figure& figure, const View& plot, const Rectangle& window);

  /// The rectangle that it covers, texts of its ticks included.
  [[nodiscard]] const Frame& outer() const { return outer_; }
  /// Appends it, with the outline of its window in the plot and lines from one to the other.
  void draw(std::string& svg) const;

 private:
  const Figure& figure_;
  const View& plot_;
  Rectangle window_;
  Frame inner_, outer_;
  Ticks across_, up_;
};

}  // namespace lober::cli
