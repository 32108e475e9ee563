// A folder for the files of one test, and curves to put into it.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "lober/curve/curve.hpp"

namespace lober {

class ScratchFolder : public testing::Test {
 protected:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "lober-jobs-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  ~ScratchFolder() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }

 private:
  std::filesystem::path folder_;
};

/// A wavy circle; those of different numbers cross each other.
inline std::vector<Point> wavy(std::size_t points, int number) {
  std::vector<Point> curve(points);
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
    const double radius = 1 + 0.3 * std::sin((3 + number % 5) * angle + number);
    curve[k] = {radius * std::cos(angle) + 0.01 * number, radius * std::sin(angle)};
  }
  return curve;
}

}  // namespace lober
