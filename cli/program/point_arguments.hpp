// Points on the command line: X,Y, or the files that hold them, as curves are named.
#pragma once

#include <string>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/point.hpp"

namespace lober::cli {

/// The texts that are not X,Y and so name files; a file called X,Y is ./X,Y. Throws UsageError, with the name
/// of the option, for a point that is not finite.
[[nodiscard]] std::vector<std::string> point_files(const char* option, const std::vector<std::string>& texts);

/// The points in the order of the texts, all zones of each file, or the one of FILE#ZONE; FILE:COLUMNS chooses columns.
/// Throws UsageError, DataError, also when a file has columns of latitude and longitude and the curve beside which the
/// points lie those of longitude and latitude.
[[nodiscard]] Buffer<Point> points_of(const char* option, const std::vector<std::string>& texts,
                                      const Curve* beside = nullptr);

}  // namespace lober::cli
