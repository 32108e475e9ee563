#include "kernels/shoelace.hpp"
#include "kernels/simd.hpp"

#include "kernels/shoelace.inl"

namespace lober::detail {

DD shoelace_prefixes_avx2(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& prefixes) {
  return prefixes_of(points, origin, start, extra, prefixes);
}

void sums_at_avx2(const LeafPrefixes& prefixes, const std::uint32_t* segments, const DD* t, std::size_t count,
                  DD* sums) {
  all_sums_at(prefixes, segments, t, count, sums);
}

}  // namespace lober::detail
