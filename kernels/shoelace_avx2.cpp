#include "kernels/shoelace.hpp"
#include "kernels/simd.hpp"

#include "kernels/shoelace.inl"

namespace lober {

DD shoelace_prefixes_avx2(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& prefixes) {
  return prefixes_of(points, origin, start, extra, prefixes);
}

}  // namespace lober
