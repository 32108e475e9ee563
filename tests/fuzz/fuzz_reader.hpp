// The checks of every fuzz target: only DataError leaves a reader, and the points read can be written and read back.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/files/read_memory.hpp"

namespace lober::fuzz {
using namespace lober::detail;

/// Ends the run as a finding.
inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "finding: %s\n", what);
  std::abort();
}

inline bool same_bits(std::span<const Point> a, std::span<const Point> b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const Point& p, const Point& q) { return bits(p.x) == bits(q.x) && bits(p.y) == bits(q.y); });
}

inline bool same_zones(const CurveFile& a, const CurveFile& b) {
  return std::equal(a.zones.begin(), a.zones.end(), b.zones.begin(), b.zones.end(),
                    [](const Zone& p, const Zone& q) { return p.title == q.title && same_bits(p.points, q.points); });
}

/// The file, or nothing and the reason.
inline std::optional<CurveFile> read(std::span<const std::byte> bytes, std::size_t chunk_size, std::string& error,
                                     std::string_view columns = {}) {
  try {
    return read_curve_bytes("in", bytes, chunk_size, columns);
  } catch (const DataError& refused) {
    error = refused.what();
    return std::nullopt;
  }
}

inline std::optional<CurveFile> read(std::span<const std::byte> bytes) {
  std::string ignored;
  return read(bytes, default_chunk_size, ignored);
}

/// A file of this process to write to.
inline std::string scratch() {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("lober-fuzz-" + std::to_string(::getpid()))).string();
  static const int removed_at_exit = std::atexit([] { std::filesystem::remove(path); });
  static_cast<void>(removed_at_exit);
  return path;
}

/// Reads back what a writer wrote to `scratch()`; a refusal is a finding.
inline CurveFile read_back() {
  try {
    return read_curve_file(scratch(), {.hash = false});
  } catch (const DataError& refused) {
    require(false, refused.what());
    return {};
  }
}

}  // namespace lober::fuzz
