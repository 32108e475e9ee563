#include "viewer/series.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "viewer/bits.hpp"
#include "viewer/grid.hpp"
#include "viewer/predictor.hpp"

namespace lober::viewer {
namespace {

using Axes = std::vector<std::span<const double>>;  // one or two
using Grids = std::array<Grid, 2>;

constexpr std::uint64_t first_long = 64;  // number that is not its own symbol
constexpr int long_symbol = 64, break_symbol = 129;

// What is written of a part, and, without `writes`, only how many bits that takes, about.
struct Numbers {
  bool writes = false;
  double bits = 0;
  std::array<std::string, 2> symbols = {};
  BitWriter rest = {};

  void add(std::size_t rank, std::uint64_t number, bool is_break) {
    const int width = static_cast<int>(std::bit_width(number));
    const bool is_long = number >= first_long || is_break;
    bits += width + (is_long ? 1 : 0);
    if (!writes) return;
    symbols[rank] +=
        static_cast<char>(is_long ? (is_break ? break_symbol : long_symbol) + width : static_cast<int>(number));
    if (is_long) rest.add(number, width - 1);
  }
};

// Where there are breaks. Those of curves that were densified segment by segment stand out: the ratios of neighbouring
// distances are alike but there.
enum class Breaks { nowhere, where_distances_jump, everywhere };

std::vector<bool> jumps_of_distance(const Axes& axes) {
  const std::size_t size = axes[0].size();
  std::vector<bool> jumps(size, false);
  if (axes.size() < 2) return jumps;
  std::vector<double> growth(size, 0);  // of the distance, at a point
  double before = 0;
  for (std::size_t k = 0; k + 1 < size; ++k) {
    const double dx = axes[0][k + 1] - axes[0][k], dy = axes[1][k + 1] - axes[1][k];
    const double distance = std::sqrt(dx * dx + dy * dy);
    growth[k] = distance / before - 1;
    before = distance;
  }
  constexpr double min_jump = 1e-9, min_ratio = 4;
  for (std::size_t k = 2; k + 2 < size; ++k) {
    const double jump = std::fabs(growth[k] - (growth[k - 1] + growth[k + 1]) / 2);
    jumps[k + 1] = jump > min_jump && jump > min_ratio * std::fabs(growth[k + 1] - growth[k - 1]);
  }
  return jumps;
}

// Writes values one after the other. A copy tries out how many bits a block takes in some way.
class Encoder {
 public:
  void block(const Axes& axes, const std::vector<bool>& jumps, std::size_t begin, std::size_t end, const Grids& grids,
             int way, Breaks breaks, Numbers& numbers) {
    for (std::size_t k = begin; k < end; ++k) {
      double steps = 1, along = 1;
      std::array<double, 2> point{};
      const auto first = static_cast<std::size_t>(axes.size() < 2 ? 0 : predictor_.primary());
      for (std::size_t rank = 0; rank < axes.size(); ++rank) {
        const std::size_t axis = rank == 0 ? first : 1 - first;
        const Grid& grid = grids[axis];
        const double mapped = grid.mapped(axes[axis][k]);
        const std::uint64_t expected = order_of(grid.mapped(predictor_.at(static_cast<int>(axis), along)));
        const std::uint64_t number = zigzag(order_of(mapped) - expected);
        point[axis] = grid.value(mapped);
        const bool is_break = rank == 0 && breaks_at(k, jumps, breaks, static_cast<double>(number));
        numbers.add(rank, number, is_break);
        if (rank > 0 || axes.size() < 2) continue;
        along = predictor_.steps_to(static_cast<int>(axis), point[axis]);
        if (is_break) steps = along;
      }
      predictor_.add(point, steps, way);
    }
  }

 private:
  bool breaks_at(std::size_t k, const std::vector<bool>& jumps, Breaks breaks, double number) {
    constexpr double unusual = 4, memory = 0.9;
    if (breaks == Breaks::everywhere) return true;
    if (breaks == Breaks::where_distances_jump && jumps[k] && number > unusual * usual_) return true;
    usual_ = memory * usual_ + (1 - memory) * number;
    return false;
  }

  Predictor predictor_;
  double usual_ = 0;  // number where there is no break
};

void append_bytes(std::string& bytes, std::uint64_t number, int count) {
  for (int k = 0; k < count; ++k) bytes += static_cast<char>(number >> (8 * k) & 0xff);
}

std::string encoded(const Axes& axes, double step, std::span<const std::uint32_t> exact) {
  const std::size_t size = axes[0].size();
  const std::vector<bool> jumps = jumps_of_distance(axes);
  Encoder encoder;
  Numbers written{.writes = true};
  std::string bytes;
  for (std::size_t begin = 0; begin < size; begin += series_block) {
    const std::size_t end = std::min(begin + series_block, size);
    const auto within = std::lower_bound(exact.begin(), exact.end(), begin);
    const bool rounds = within == exact.end() || *within >= end;
    Grids grids;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      grids[axis] = grid_for(axes[axis].subspan(begin, end - begin), rounds ? step : 0);
    }
    int best_way = Predictor::ways - 2;
    Breaks best_breaks = Breaks::nowhere;
    double fewest = std::numeric_limits<double>::infinity();
    const auto try_out = [&](int way, Breaks breaks) {
      Numbers numbers;
      Encoder(encoder).block(axes, jumps, begin, end, grids, way, breaks, numbers);
      if (numbers.bits >= fewest) return;
      fewest = numbers.bits;
      best_way = way;
      best_breaks = breaks;
    };
    try_out(best_way, Breaks::nowhere);
    if (axes.size() == 2) {
      try_out(best_way, Breaks::where_distances_jump);
      try_out(best_way, Breaks::everywhere);
    }
    for (int way = 0; way < Predictor::ways; ++way) try_out(way, best_breaks);
    encoder.block(axes, jumps, begin, end, grids, best_way, best_breaks, written);
    append_bytes(bytes, static_cast<std::uint64_t>(best_way), 1);
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      append_bytes(bytes, static_cast<std::uint64_t>(grids[axis].code), 2);
    }
  }
  for (std::size_t axis = 0; axis < axes.size(); ++axis) bytes += written.symbols[axis];
  return bytes += written.rest.bytes();
}

std::array<std::vector<double>, 2> decoded(std::string_view bytes, std::size_t count, std::size_t axes) {
  const std::size_t head = 1 + 2 * axes, symbols = (count + series_block - 1) / series_block * head;
  if (bytes.size() < symbols + axes * count) throw std::out_of_range("a series is cut off");
  BitReader rest(bytes.substr(symbols + axes * count));
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
  Predictor predictor;
  Grids grids;
  int way = 0;
  std::array<std::vector<double>, 2> values;
  for (std::size_t k = 0; k < count; ++k) {
    if (k % series_block == 0) {
      const std::size_t at = k / series_block * head;
      way = byte(at) % Predictor::ways;
      for (std::size_t axis = 0; axis < axes; ++axis) {
        grids[axis] = grid_of(static_cast<std::int16_t>(byte(at + 1 + 2 * axis) | byte(at + 2 + 2 * axis) << 8));
      }
    }
    double steps = 1, along = 1;
    std::array<double, 2> point{};
    const auto first = static_cast<std::size_t>(axes < 2 ? 0 : predictor.primary());
    for (std::size_t rank = 0; rank < axes; ++rank) {
      const std::size_t axis = rank == 0 ? first : 1 - first;
      const int symbol = byte(symbols + rank * count + k),
                width = symbol - (symbol < break_symbol ? long_symbol : break_symbol);
      std::uint64_t number = static_cast<std::uint64_t>(symbol);
      if (width > 64) throw std::out_of_range("a series has a number of too many bits");
      if (width > 0) {
        number = rest.number(width - 1) | 1ull << (width - 1);
      } else if (width == 0) {
        number = 0;
      }
      const Grid& grid = grids[axis];
      const std::uint64_t expected = order_of(grid.mapped(predictor.at(static_cast<int>(axis), along)));
      point[axis] = grid.value(of_order(expected + unzigzag(number)));
      if (rank == 0 && axes == 2) {
        along = predictor.steps_to(static_cast<int>(axis), point[axis]);
        if (symbol >= break_symbol) steps = along;
      }
    }
    predictor.add(point, steps, way);
    for (std::size_t axis = 0; axis < axes; ++axis) values[axis].push_back(point[axis]);
  }
  return values;
}

}  // namespace

std::string encode_series(std::span<const double> values, double step, std::span<const std::uint32_t> exact) {
  return encoded({values}, step, exact);
}

std::string encode_points(std::span<const double> x, std::span<const double> y, double step,
                          std::span<const std::uint32_t> exact) {
  return encoded({x, y}, step, exact);
}

std::vector<double> decode_series(std::string_view bytes, std::size_t count) {
  return decoded(bytes, count, 1)[0];
}

std::array<std::vector<double>, 2> decode_points(std::string_view bytes, std::size_t count) {
  return decoded(bytes, count, 2);
}

}  // namespace lober::viewer
