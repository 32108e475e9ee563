// Common parts of the tests of the readers and writers.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/read_memory.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"

namespace lober::test {
using namespace lober::detail;

inline std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

/// Reads text that is in memory under the name "in".
inline CurveFile read(std::string_view text, std::size_t chunk_size = default_chunk_size) {
  return read_curve_bytes("in", bytes_of(text), chunk_size);
}

/// The message of the DataError that `action` throws.
template <typename Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const DataError& error) {
    return error.what();
  }
  return "no error";
}

inline std::string read_error(std::string_view text, std::size_t chunk_size = default_chunk_size) {
  return error_of([&] { static_cast<void>(read(text, chunk_size)); });
}

inline bool same_bits(std::span<const Point> a, std::span<const Point> b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const Point& p, const Point& q) { return bits(p.x) == bits(q.x) && bits(p.y) == bits(q.y); });
}

/// A folder of its own for each test, removed afterwards.
class FolderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("lober-") + info->test_suite_name() + "-" + info->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  [[nodiscard]] std::string put(const std::string& name, std::string_view content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  [[nodiscard]] static std::string content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }

  /// How many files the folder has; more than expected means that a temporary one was left behind.
  [[nodiscard]] std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator());
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace lober::test
