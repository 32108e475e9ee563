// Four strips side by side.

#pragma once

#include "kernels/simd.hpp"
#include "kernels/strip.hpp"

namespace lober::detail {
namespace {

struct Strips {
  Lanes x, y, ax, ay, length, width, bend, reach;
};

inline void load_strips(const Strip* const (&from)[lanes], Strips& strips) {
  Lanes place[lanes], size[lanes];
  for (std::size_t k = 0; k < lanes; ++k) {
    place[k] = load(&from[k]->middle.x);
    size[k] = load(&from[k]->length);
  }
  transpose(place);
  transpose(size);
  strips = {place[0], place[1], place[2], place[3], size[0], size[1], size[2], size[3]};
}

}  // namespace
}  // namespace lober::detail
