#include "tests/oracle/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "tests/oracle/exact_curve.hpp"

namespace lober::oracle {
namespace {

constexpr std::array all_families{
    Family{"stars", family::stars},
    Family{"scattered_points", family::scattered_points},
    Family{"mixed", family::mixed},
    Family{"wavy", family::wavy},
    Family{"lattice", family::lattice},
    Family{"polyominoes", family::polyominoes},
    Family{"rectangles", family::rectangles},
    Family{"combs", family::combs},
    Family{"spirals", family::spirals},
    Family{"collinear", family::collinear},
    Family{"shared_same_way", family::shared_same_way},
    Family{"shared_border", family::shared_border},
    Family{"shared_on_lattice", family::shared_on_lattice},
    Family{"shared_to_one_ulp", family::shared_to_one_ulp},
    Family{"identical", family::identical},
    Family{"nested", family::nested},
    Family{"disjoint", family::disjoint},
    Family{"touching", family::touching},
    Family{"inscribed", family::inscribed},
    Family{"own_scales", family::own_scales},
    Family{"anisotropic", family::anisotropic},
    Family{"log_uniform", family::log_uniform},
    Family{"slivers", family::slivers},
    Family{"far_away", family::far_away},
    Family{"extreme_scale", family::extreme_scale},
    Family{"powers_of_2_200", family::powers_of_2_200},
    Family{"denormal_axis", family::denormal_axis},
};

std::uint64_t hash(std::string_view text) {  // FNV-1a
  std::uint64_t value = 0xcbf29ce484222325U;
  for (const char character : text) value = (value ^ static_cast<unsigned char>(character)) * 0x100000001b3U;
  return value;
}

// Any orientation, any first vertex, and sometimes vertices that are there twice or three times.
void disguise(Random& random, Polygon& polygon) {
  if (random.chance(0.5)) std::reverse(polygon.begin(), polygon.end());
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(random.index(polygon.size())),
              polygon.end());
  if (!random.chance(0.125)) return;
  Polygon repeated;
  for (const Point& point : polygon) {
    const int times = random.chance(0.25) ? random.integer(2, 3) : 1;
    for (int k = 0; k < times; ++k) repeated.push_back(point);
  }
  if (random.chance(0.5)) repeated.push_back(repeated.front());
  polygon = repeated;
}

double extent(const CurvePair& pair) {
  double size = 0;
  for (const Polygon* polygon : {&pair.first, &pair.second}) {
    for (const Point& point : *polygon) {
      size = std::max({size, std::abs(point.x - pair.first[0].x), std::abs(point.y - pair.first[0].y)});
    }
  }
  return size;
}

}  // namespace

std::span<const Family> families() {
  return all_families;
}

CurvePair make_curve_pair(const Family& family, std::uint64_t seed) {
  Random seeds(hash(family.name) ^ Random(seed).bits());
  for (int attempt = 0; attempt < 1000; ++attempt) {
    Random random(seeds.bits());
    auto [first, second] = family.make(random);
    if (!is_simple(first) || !is_simple(second)) continue;
    disguise(random, first);
    disguise(random, second);
    return {std::string(family.name), seed, std::move(first), std::move(second)};
  }
  throw std::logic_error("no simple pair in family " + std::string(family.name));
}

CurvePair rearranged(const CurvePair& pair) {
  CurvePair result{pair.family + " rearranged", pair.seed, pair.second, pair.first};
  std::reverse(result.first.begin(), result.first.end());
  std::rotate(result.second.begin(), result.second.begin() + static_cast<std::ptrdiff_t>(result.second.size() / 2),
              result.second.end());
  return result;
}

CurvePair transformed(const CurvePair& pair) {
  Random random(hash(pair.family) + 3 * pair.seed + 1);
  const int kind = random.integer(0, 2);
  const bool round = random.chance(0.5);  // keeps the degeneracies of integer grids
  const double size = extent(pair);
  const auto shift = [&] {
    const double value = kind == 1 ? 0 : 1e6 * size * random.uniform(0.5, 1);
    return round ? std::floor(value) : value;
  };
  // Curves that are large already only shrink: their areas have to stay finite.
  double scale = kind == 0 ? 1 : random.log_uniform(1e-8, size > 1e100 ? 1 : 1e8);
  if (round) scale = std::exp2(std::floor(std::log2(scale)));
  const double shift_x = shift();
  const Point offset{scale * shift_x, scale * shift()};
  CurvePair result = pair;
  result.family += " moved";
  result.first = moved(pair.first, {scale, scale}, offset);
  result.second = moved(pair.second, {scale, scale}, offset);
  return result;
}

}  // namespace lober::oracle
