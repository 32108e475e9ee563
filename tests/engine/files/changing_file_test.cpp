// Files that change while they are read.

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"

namespace lober {
namespace {

// A file that is mapped would end the process here (SIGBUS).
TEST(ChangingFile, TruncatedWhileItIsReadIsAnError) {
  const std::string name =
      (std::filesystem::temp_directory_path() / ("lober-changing-" + std::to_string(::getpid()))).string();
  std::vector<Point> points(400'000);
  for (std::size_t k = 0; k < points.size(); ++k) points[k] = {std::sin(1e-3 * static_cast<double>(k)), 0.1};
  write_raw(name, points);
  const auto size = static_cast<::off_t>(points.size() * sizeof(Point));
  std::atomic<bool> end{false};
  std::thread truncating([&] {
    while (!end) {
      if (::truncate(name.c_str(), size / 3) != 0 || ::truncate(name.c_str(), size) != 0) return;
    }
  });
  int errors = 0, changed = 0;
  // On a busy machine the other thread may run between reads only, for a while.
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  for (int round = 0; round < 60 || (changed == 0 && std::chrono::steady_clock::now() < patience); ++round) {
    try {
      const CurveFile file = read_curve_file(name, {.hash = round % 2 == 0});
      const std::size_t read = file.zones.at(0).points.size();
      EXPECT_TRUE(read == points.size() || read == points.size() / 3) << read;
    } catch (const DataError& error) {
      ++errors;
      changed += std::string(error.what()).find("while it was read") != std::string::npos ? 1 : 0;
    }
  }
  end = true;
  truncating.join();
  std::filesystem::remove(name);
  EXPECT_GT(changed, 0) << errors << " errors";
}

TEST(ChangingFile, DevicesWithoutEndAreRefused) {
  for (const char* const name : {"/dev/zero", "/dev/urandom", "/dev/null"}) {
    try {
      (void)read_curve_file(name);
      ADD_FAILURE() << name << " was read";
    } catch (const DataError& error) {
      EXPECT_EQ(std::string(error.what()), std::string(name) + ": is a device, not a file");
    }
  }
}

}  // namespace
}  // namespace lober
