// Body of keep_near (kernels/all.inl).
#pragma once

#include "kernels/frame_filter.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// Distance of centres beside `a` and beside `b` against the reach of both.
inline unsigned certainly_apart(const Frame& a, const Frame* const (&b)[lanes]) {
  Lanes rows[lanes];
  for (std::size_t k = 0; k < lanes; ++k) rows[k] = load(&b[k]->middle.x);
  transpose(rows);
  const Lanes length = {b[0]->length, b[1]->length, b[2]->length, b[3]->length};
  const Lanes width = {b[0]->width, b[1]->width, b[2]->width, b[3]->width};
  const Lanes ax = splat(a.along.x), ay = splat(a.along.y);
  const Lanes dx = rows[0] - splat(a.middle.x), dy = rows[1] - splat(a.middle.y), bx = rows[2], by = rows[3];
  const Lanes parallel = absolute(ax * bx + ay * by), across = absolute(ax * by - ay * bx);
  const Lanes beside_a = absolute(ax * dy - ay * dx), beside_b = absolute(bx * dy - by * dx);
  return mask_bits((beside_a > splat(a.width) + (width * parallel + length * across)) |
                   (beside_b > width + (splat(a.width) * parallel + splat(a.length) * across)));
}

inline std::size_t keep_nodes(const Frame& frame, FramePyramid pyramid, TreeNode* list, std::size_t count) {
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    const std::size_t together = count - begin < lanes ? count - begin : lanes;
    TreeNode nodes[lanes];
    const Frame* frames[lanes];
    for (std::size_t k = 0; k < lanes; ++k) {
      nodes[k] = list[begin + (k < together ? k : 0)];
      frames[k] = &pyramid.frames[pyramid.begin[nodes[k].level] + nodes[k].index];
    }
    const unsigned apart = certainly_apart(frame, frames);
    for (std::size_t k = 0; k < together; ++k) {
      list[kept] = nodes[k];
      kept += ~apart >> k & 1U;
    }
  }
  return kept;
}

}  // namespace
}  // namespace lober::detail
