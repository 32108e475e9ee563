// The shapes of those segments of a curve that crossings ask for (private to smooth/).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geometry/smooth/smooth_curve.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// Segments are asked for one after the other and fitted together; neighbours in the curve that are asked for next to
/// each other are fitted once.
class SegmentShapes {
 public:
  SegmentShapes(const SmoothCurve& curve, std::size_t expected) : curve_(&curve) {
    segments_.reserve(expected);
    shapes_.reserve(expected);
    windows_.reserve(expected);
  }

  /// The number of the shape of a segment, if it is there: looks for it beside the shape `near`.
  [[nodiscard]] std::optional<std::uint32_t> find(std::int64_t segment, std::uint32_t near) const {
    for (const std::uint32_t number : {near, near + 1, near - 1}) {
      if (number < segments_.size() && segments_[number] == segment) return number;
    }
    return std::nullopt;
  }
  /// The same, but a segment whose shape is not there will have one after the next fit().
  std::uint32_t ask_for(std::int64_t segment, std::uint32_t near) {
    const std::optional<std::uint32_t> found = find(segment, near);
    return found ? *found : add(segment);
  }
  /// The same, beside the last one.
  std::uint32_t ask_for(std::int64_t segment) {
    const std::size_t size = segments_.size();
    if (size > 0 && segments_[size - 1] == segment) return static_cast<std::uint32_t>(size - 1);
    if (size > 1 && segments_[size - 2] == segment) return static_cast<std::uint32_t>(size - 2);
    return add(segment);
  }

  /// Fits what was asked for since the last time.
  void fit();

  [[nodiscard]] std::int64_t segment(std::uint32_t number) const { return segments_[number]; }
  [[nodiscard]] const SmoothSegment& operator[](std::uint32_t number) const { return shapes_[number]; }
  [[nodiscard]] const SmoothSegment* data() const { return shapes_.data(); }

 private:
  std::uint32_t add(std::int64_t segment) {
    segments_.push_back(segment);
    return static_cast<std::uint32_t>(segments_.size() - 1);
  }

  const SmoothCurve* curve_;
  Buffer<std::int64_t> segments_;
  Buffer<SmoothSegment> shapes_;
  std::vector<const Point*> windows_;  // eight points each, of the shapes to be fitted
};

}  // namespace lober::detail
