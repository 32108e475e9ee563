#include "kernels/shoelace.hpp"

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"

#include "kernels/shoelace.inl"

namespace lober::detail {

DD shoelace_prefixes_avx2(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& prefixes);

void sums_at_avx2(const LeafPrefixes& prefixes, const std::uint32_t* segments, const DD* t, std::size_t count,
                  DD* sums);

DD shoelace_prefixes(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& prefixes) {
  return has_avx2() ? shoelace_prefixes_avx2(points, origin, start, extra, prefixes)
                    : prefixes_of(points, origin, start, extra, prefixes);
}

void sums_at(const LeafPrefixes& prefixes, const std::uint32_t* segments, const DD* t, std::size_t count, DD* sums) {
  has_avx2() ? sums_at_avx2(prefixes, segments, t, count, sums) : all_sums_at(prefixes, segments, t, count, sums);
}

}  // namespace lober::detail
