#include "engine/geometry/smooth/segment_shapes.hpp"

namespace lober::detail {

void SegmentShapes::fit() {
  const std::size_t begin = shapes_.size();
  shapes_.resize(segments_.size());
  windows_.clear();
  // Runs of segments with a window are fitted together.
  std::size_t from = begin;
  const auto fit_run = [&](std::size_t end) {
    if (fit_smooth_segments(windows_.data(), windows_.size(), shapes_.data() + from)) {
      for (std::size_t k = from; k < end; ++k) shapes_[k] = curve_->segment(segments_[k]);
    }
    windows_.clear();
    from = end + 1;
  };
  for (std::size_t k = begin; k < segments_.size(); ++k) {
    if (const Point* window = curve_->window(segments_[k])) {
      windows_.push_back(window);
      continue;
    }
    fit_run(k);
    shapes_[k] = curve_->segment(segments_[k]);
  }
  fit_run(segments_.size());
}

}  // namespace lober::detail
