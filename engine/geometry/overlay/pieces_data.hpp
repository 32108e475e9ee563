// The contents of Pieces (private to geometry/).
#pragma once

#include <cstdint>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::detail {

struct PiecesData {
  Buffer<double> areas;
  Buffer<std::uint32_t> begin{0};  // in `steps`, of each piece
  Buffer<std::uint32_t> steps;     // steps of outer boundaries
  std::vector<PieceHole> holes;    // in order of their pieces

  [[nodiscard]] std::size_t size() const { return areas.size(); }
  /// The outer boundary of a piece as steps.
  [[nodiscard]] std::span<const std::uint32_t> outer(std::size_t piece) const {
    return std::span(steps).subspan(begin[piece], begin[piece + 1] - begin[piece]);
  }
  [[nodiscard]] std::span<const PieceHole> holes_of(std::size_t piece) const;
};

}  // namespace lober::detail
