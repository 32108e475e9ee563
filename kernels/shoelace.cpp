#include "kernels/shoelace.hpp"

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"

#include "kernels/shoelace.inl"

namespace lober {

DD shoelace_prefixes_avx2(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& prefixes);

DD shoelace_prefixes(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& prefixes) {
  return has_avx2() ? shoelace_prefixes_avx2(points, origin, start, extra, prefixes)
                    : prefixes_of(points, origin, start, extra, prefixes);
}

}  // namespace lober
