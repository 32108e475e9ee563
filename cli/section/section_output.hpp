// Outputs of `lober section` for the orbits as they come: a file, and a field of how many points lie where.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cli/picture/figure.hpp"
#include "engine/base/output_file.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

/// Points per cell of a grid over a window.
class Density {
 public:
  Density(const Rectangle& window, std::size_t columns, std::size_t rows);
  void add(std::span<const Point> points);

  [[nodiscard]] const Rectangle& window() const { return window_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::uint32_t count(std::size_t column, std::size_t row) const {
    return counts_[row * columns_ + column];
  }
  [[nodiscard]] std::uint32_t largest() const;
  [[nodiscard]] std::uint64_t inside() const { return inside_; }    ///< points in the window
  [[nodiscard]] std::uint64_t outside() const { return outside_; }  ///< beside it

 private:
  Rectangle window_;
  std::size_t columns_, rows_;
  std::vector<std::uint32_t> counts_;
  std::uint64_t inside_ = 0, outside_ = 0;
};

/// The file of orbits, written as they come: .npy, an array of orbits x (iterates + 1) x 2, NaN where an orbit is lost;
/// .csv, a line "orbit,iterate,x,y" for each point that is not.
class OrbitFile {
 public:
  OrbitFile(const std::string& path, std::size_t orbits, std::size_t iterates);
  void add(std::size_t first, std::span<const Point> points);
  void finish() { file_.commit(); }
  /// Throws UsageError for a name with another ending.
  static void require_name(const std::string& path);

 private:
  detail::OutputFile file_;
  std::size_t each_;
  bool npy_;
};

/// The density, the darker the more points.
[[nodiscard]] Figure section_figure(const Density& density, const System& system);
/// The cells in colours by when their orbits leave; `iterates`: how far orbits were followed.
[[nodiscard]] Figure exit_times_figure(const operations::ExitTimes& times, std::size_t iterates, const System& system);

}  // namespace lober::cli
