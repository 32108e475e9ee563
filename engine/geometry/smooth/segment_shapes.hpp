// The shapes of those segments of a curve that crossings ask for (private to smooth/).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "engine/geometry/smooth/smooth_curve.hpp"

namespace lober::detail {

/// Segments are asked for one after the other and fitted together; neighbours in the curve that are asked for next to
/// each other are fitted once.
class SegmentShapes {
 public:
  SegmentShapes(const SmoothCurve& curve, std::size_t expected) : curve_(&curve) {
    segments_.reserve(expected);
    windows_.reserve(expected);
  }

  /// The number of the shape of a segment, which is there after the next fit(). Looks for it near the shape `near`.
  std::uint32_t ask_for(std::int64_t segment, std::uint32_t near) {
    for (const std::uint32_t number : {near, near + 1, near - 1}) {
      if (number < segments_.size() && segments_[number] == segment) return number;
    }
    segments_.push_back(segment);
    return static_cast<std::uint32_t>(segments_.size() - 1);
  }
  std::uint32_t ask_for(std::int64_t segment) {
    return ask_for(segment, static_cast<std::uint32_t>(segments_.size() - 1));
  }

  /// Fits what was asked for since the last time.
  void fit();

  [[nodiscard]] std::int64_t segment(std::uint32_t number) const { return segments_[number]; }
  [[nodiscard]] const SmoothSegment& operator[](std::uint32_t number) const { return shapes_[number]; }
  [[nodiscard]] const SmoothSegment* data() const { return shapes_.data(); }

 private:
  const SmoothCurve* curve_;
  std::vector<std::int64_t> segments_;
  std::vector<SmoothSegment> shapes_;
  std::vector<const Point*> windows_;  // of those to be fitted
};

}  // namespace lober::detail
