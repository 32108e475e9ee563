// SHA-256 as FIPS 180-4 (2015) defines it. The constants are what the standard says they are: the first 32
// bits of the fractional parts of the square and cube roots of the first primes, computed here in integers.
#include "engine/files/sha256.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "lober/files.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#define LOBER_SHA_INSTRUCTIONS 1
#include <cpuid.h>
#include <immintrin.h>
#endif

namespace lober {
namespace {

using State = std::array<std::uint32_t, 8>;
constexpr std::size_t block_size = 64;

// An extension that both compilers have.
__extension__ using Wide = unsigned __int128;

constexpr std::array<std::uint64_t, 64> first_primes() {
  std::array<std::uint64_t, 64> primes{};
  std::size_t found = 0;
  for (std::uint64_t candidate = 2; found < primes.size(); ++candidate) {
    bool prime = true;
    for (std::size_t i = 0; i < found && prime; ++i) prime = candidate % primes[i] != 0;
    if (prime) primes[found++] = candidate;
  }
  return primes;
}

/// floor(2^32 p^(1/degree)) mod 2^32 by bisection; the root of p < 2^9 is below 2^5.
constexpr std::uint32_t root_fraction(std::uint64_t p, int degree) {
  std::uint64_t low = 0;
  std::uint64_t high = std::uint64_t{1} << 37;
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    const Wide square = Wide{middle} * middle;
    const bool fits = degree == 2 ? square <= (Wide{p} << 64) : square * middle <= (Wide{p} << 96);
    (fits ? low : high) = middle;
  }
  return static_cast<std::uint32_t>(low);
}

constexpr State initial_state() {
  State state{};
  const auto primes = first_primes();
  for (std::size_t i = 0; i < state.size(); ++i) state[i] = root_fraction(primes[i], 2);
  return state;
}

constexpr std::array<std::uint32_t, 64> round_constants() {
  std::array<std::uint32_t, 64> constants{};
  const auto primes = first_primes();
  for (std::size_t i = 0; i < constants.size(); ++i) constants[i] = root_fraction(primes[i], 3);
  return constants;
}

alignas(16) constexpr std::array<std::uint32_t, 64> K = round_constants();

void compress_portable(State& state, const std::byte* data, std::size_t blocks) {
  for (; blocks != 0; --blocks, data += block_size) {
    std::array<std::uint32_t, 64> w;
    for (std::size_t t = 0; t < 16; ++t) {
      w[t] = 0;
      for (std::size_t i = 0; i < 4; ++i) w[t] = w[t] << 8 | std::to_integer<std::uint32_t>(data[4 * t + i]);
    }
    for (std::size_t t = 16; t < 64; ++t) {
      const std::uint32_t s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ (w[t - 15] >> 3);
      const std::uint32_t s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ (w[t - 2] >> 10);
      w[t] = w[t - 16] + s0 + w[t - 7] + s1;
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t t = 0; t < 64; ++t) {
      const std::uint32_t choice = (e & f) ^ (~e & g);
      const std::uint32_t majority = (a & b) ^ (a & c) ^ (b & c);
      const std::uint32_t t1 = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + choice + K[t] + w[t];
      const std::uint32_t t2 = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + majority;
      h = g;
      g = f;
      f = e;
      e = d + t1;
      d = c;
      c = b;
      b = a;
      a = t1 + t2;
    }
    const State working{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < state.size(); ++i) state[i] += working[i];
  }
}

#if LOBER_SHA_INSTRUCTIONS

bool has_sha_instructions() {
  unsigned a = 0;
  unsigned b = 0;
  unsigned c = 0;
  unsigned d = 0;
  if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c & bit_SSE4_1) == 0 || (c & bit_SSSE3) == 0) return false;
  return __get_cpuid_count(7, 0, &a, &b, &c, &d) != 0 && (b & (1U << 29)) != 0;
}

/// The same with the SHA instructions, which keep the state as the two vectors (a b e f) and (c d g h),
/// highest lane first, and do two rounds at a time on the two low lanes of w + K.
__attribute__((target("sha,ssse3,sse4.1"))) void compress_sha(State& state, const std::byte* data, std::size_t blocks) {
  const __m128i big_endian = _mm_set_epi64x(0x0c0d0e0f08090a0b, 0x0405060700010203);
  auto* const memory = reinterpret_cast<__m128i*>(state.data());
  const __m128i dcba = _mm_loadu_si128(memory);
  const __m128i hgfe = _mm_loadu_si128(memory + 1);
  const __m128i cdab = _mm_shuffle_epi32(dcba, 0xB1);
  const __m128i efgh = _mm_shuffle_epi32(hgfe, 0x1B);
  __m128i abef = _mm_alignr_epi8(cdab, efgh, 8);
  __m128i cdgh = _mm_blend_epi16(efgh, cdab, 0xF0);

  for (; blocks != 0; --blocks, data += block_size) {
    const __m128i abef_before = abef;
    const __m128i cdgh_before = cdgh;
    __m128i w[4];
#pragma GCC unroll 16
    for (int group = 0; group < 16; ++group) {  // four rounds each
      __m128i& now = w[group % 4];
      if (group < 4) {
        now = _mm_shuffle_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i*>(data) + group), big_endian);
      } else {
        const __m128i before1 = w[(group + 3) % 4];
        const __m128i before2 = w[(group + 2) % 4];
        const __m128i before3 = w[(group + 1) % 4];
        const __m128i w_minus_7 = _mm_alignr_epi8(before1, before2, 4);
        now = _mm_sha256msg2_epu32(_mm_add_epi32(_mm_sha256msg1_epu32(now, before3), w_minus_7), before1);
      }
      const __m128i wk = _mm_add_epi32(now, _mm_load_si128(reinterpret_cast<const __m128i*>(K.data()) + group));
      cdgh = _mm_sha256rnds2_epu32(cdgh, abef, wk);
      abef = _mm_sha256rnds2_epu32(abef, cdgh, _mm_shuffle_epi32(wk, 0x0E));
    }
    abef = _mm_add_epi32(abef, abef_before);
    cdgh = _mm_add_epi32(cdgh, cdgh_before);
  }

  const __m128i feba = _mm_shuffle_epi32(abef, 0x1B);
  const __m128i dchg = _mm_shuffle_epi32(cdgh, 0xB1);
  _mm_storeu_si128(memory, _mm_blend_epi16(feba, dchg, 0xF0));
  _mm_storeu_si128(memory + 1, _mm_alignr_epi8(dchg, feba, 8));
}

#endif

void compress(State& state, const std::byte* data, std::size_t blocks) {
#if LOBER_SHA_INSTRUCTIONS
  static const bool fast = has_sha_instructions();
  if (fast) return compress_sha(state, data, blocks);
#endif
  compress_portable(state, data, blocks);
}

template <typename Compress>
std::string digest(std::span<const std::byte> bytes, const Compress& compress_blocks) {
  State state = initial_state();
  const std::size_t whole = bytes.size() / block_size;
  compress_blocks(state, bytes.data(), whole);

  // The padding: a one bit, zeros, and the length in bits as 64 bits, to a multiple of a block.
  std::array<std::byte, 2 * block_size> tail{};
  const std::span<const std::byte> rest = bytes.subspan(whole * block_size);
  if (!rest.empty()) std::memcpy(tail.data(), rest.data(), rest.size());
  tail[rest.size()] = std::byte{0x80};
  const std::size_t tail_blocks = rest.size() + 9 <= block_size ? 1 : 2;
  const auto bits = static_cast<std::uint64_t>(bytes.size()) * 8;
  for (std::size_t i = 0; i < 8; ++i) {
    tail[tail_blocks * block_size - 1 - i] = static_cast<std::byte>(bits >> (8 * i) & 0xFF);
  }
  compress_blocks(state, tail.data(), tail_blocks);

  std::string text(64, '0');
  auto digit = text.begin();
  for (const std::uint32_t word : state) {
    for (int shift = 28; shift >= 0; shift -= 4) *digit++ = "0123456789abcdef"[word >> shift & 0xF];
  }
  return text;
}

}  // namespace

std::string sha256(std::span<const std::byte> bytes) {
  return digest(bytes, compress);
}

std::string sha256_portable(std::span<const std::byte> bytes) {
  return digest(bytes, compress_portable);
}

}  // namespace lober
