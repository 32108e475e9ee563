// Which cells of a picture have been drawn on, so that strands on top of each other are drawn once.
#pragma once

#include <cstddef>
#include <vector>

#include "cli/report/svg.hpp"

namespace lober::cli {

/// Square cells of a frame from (0, 0) on.
class Coverage {
 public:
  Coverage(double width, double height, double cell);

  /// Marks the cells on the segment; whether any of them is new. At most one step of a cell's size a cell.
  bool mark(Pixel a, Pixel b);

 private:
  double cell_;
  std::size_t columns_, rows_;
  std::vector<bool> marked_;
};

}  // namespace lober::cli
