#include "engine/files/formats/arrays.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>

#include "engine/base/machine_memory.hpp"
#include "engine/base/text.hpp"
#include "engine/files/formats/array_choice.hpp"

namespace lober::detail {
namespace {

class CurvesOfArrays {
 public:
  CurvesOfArrays(ArrayFile& source, CurveFile& file) : source_(source), arrays_(source.arrays()), file_(file) {}

  void read(std::string_view choice) {
    const ChosenArrays chosen = choose_arrays(arrays_, choice, file_.path);
    const bool is_parted = chosen.group || chosen.offsets || chosen.counts;
    const ArrayInfo& first = arrays_[chosen.coordinates[0]];
    if (chosen.coordinates.size() == 1) {
      if (!holds_points(first)) fail("array " + described(first) + ": expected N x 2 or 2 x N numbers");
      take_points(chosen.coordinates[0], !is_parted);
    } else {
      take_coordinates(chosen.coordinates[0], chosen.coordinates[1], !is_parted);
    }
    if (chosen.offsets) {
      part_at_offsets(*chosen.offsets);
    } else if (chosen.counts) {
      part_by_counts(numbers(*chosen.counts), *chosen.counts);
    } else if (chosen.group) {
      part_by_group(*chosen.group);
    } else if (!first.pieces.empty()) {
      Buffer<double> counts;
      for (const std::size_t points : first.pieces) counts.push_back(static_cast<double>(points));
      part_by_counts(counts, chosen.coordinates[0]);
    } else if (!rows_.empty()) {
      part_into_rows();
    } else if (!part_by_roles()) {
      part_at_gaps();
    }
    if (file_.zones.empty()) fail("no points");
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw DataError(file_.path + ": " + message); }

  [[nodiscard]] Buffer<double> numbers(std::size_t index) const {
    require_fitting_memory(file_.path, arrays_[index]);
    return source_.numbers(index);
  }

  void take_points(std::size_t index, bool rows_are_curves) {
    const ArrayInfo& array = arrays_[index];
    const Buffer<double> all = numbers(index);
    if (array.is_complex) return take_complex(all, array, rows_are_curves);
    const bool rows = array.shape[1] == 2;
    points_.resize(all.size() / 2);
    for (std::size_t k = 0; k < points_.size(); ++k) {
      points_[k] = rows ? Point{all[2 * k], all[2 * k + 1]} : Point{all[k], all[points_.size() + k]};
    }
  }

  void take_complex(const Buffer<double>& parts, const ArrayInfo& array, bool rows_are_curves) {
    Buffer<double> xs(parts.size() / 2), ys(parts.size() / 2);
    for (std::size_t k = 0; k < xs.size(); ++k) {
      xs[k] = parts[2 * k];
      ys[k] = parts[2 * k + 1];
    }
    take_rows(xs, ys, array, rows_are_curves);
  }

  // Points of two arrays; of those of two axes only the points that are there.
  void take_coordinates(std::size_t first, std::size_t second, bool rows_are_curves) {
    const ArrayInfo &x = arrays_[first], &y = arrays_[second];
    file_.header = last_part(x.name) + "," + last_part(y.name);
    if (x.is_complex || y.is_complex) {
      fail("array " + described(x.is_complex ? x : y) + ": complex numbers are points; name this array alone");
    }
    if (x.shape != y.shape || x.pieces != y.pieces) {
      fail("arrays " + described(x) + " and " + described(y) + ": expected equal shapes");
    }
    take_rows(numbers(first), numbers(second), x, rows_are_curves);
  }

  void take_rows(const Buffer<double>& xs, const Buffer<double>& ys, const ArrayInfo& array, bool rows_are_curves) {
    std::vector<std::size_t> shape = array.shape;
    std::erase(shape, 1);
    if (shape.size() > 2) {
      fail("array " + described(array) + ": expected one axis, or two, curves and their points");
    }
    if (xs.empty()) return;  // 10^9 curves without points are none
    if (shape.size() < 2 || !rows_are_curves) {
      points_.resize(xs.size());
      for (std::size_t k = 0; k < xs.size(); ++k) points_[k] = {xs[k], ys[k]};
      return;
    }
    const bool by_column = source_.curves_are_columns();
    const std::size_t curves = shape[by_column ? 1 : 0], longest = shape[by_column ? 0 : 1];
    points_.reserve(xs.size());
    for (std::size_t curve = 0; curve < curves; ++curve) {
      rows_.push_back(points_.size());
      for (std::size_t k = 0; k < longest; ++k) {
        const std::size_t at = by_column ? k * curves + curve : curve * longest + k;
        if (!std::isnan(xs[at]) && !std::isnan(ys[at])) points_.push_back({xs[at], ys[at]});
      }
    }
    rows_.push_back(points_.size());
  }

  void add_zone(std::string title, std::size_t begin, std::size_t end) {
    if (begin == end) return;
    for (std::size_t k = begin; k < end; ++k) require_finite(k);
    const auto at = [&](std::size_t k) { return points_.begin() + static_cast<std::ptrdiff_t>(k); };
    file_.zones.push_back({std::move(title), {at(begin), at(end)}, 1});
  }

  // Without the points that are not there.
  void add_curve(std::string title, std::size_t begin, std::size_t end) {
    Zone zone{std::move(title), {}, 1};
    zone.points.reserve(end - begin);
    for (std::size_t k = begin; k < end; ++k) {
      if (std::isnan(points_[k].x) || std::isnan(points_[k].y)) continue;
      require_finite(k);
      zone.points.push_back(points_[k]);
    }
    if (!zone.points.empty()) file_.zones.push_back(std::move(zone));
  }

  void require_finite(std::size_t k) const {
    if (!std::isfinite(points_[k].x) || !std::isfinite(points_[k].y)) {
      fail("point " + std::to_string(k) + " is not a finite number");
    }
  }

  void part_at_gaps() {
    std::size_t begin = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (!std::isnan(points_[k].x) || !std::isnan(points_[k].y)) continue;
      add_zone({}, begin, k);
      begin = k + 1;
    }
    add_zone({}, begin, points_.size());
  }

  // A row without a point is none, and the others keep their numbers.
  void part_into_rows() {
    file_.titled_by_group = true;
    for (std::size_t k = 0; k + 1 < rows_.size(); ++k) add_zone(std::to_string(k), rows_[k], rows_[k + 1]);
  }

  void part_at_offsets(std::size_t index) {
    const Buffer<double> offsets = numbers(index);
    const std::vector<std::string> titles = source_.texts("titles");
    const bool numbered =
        titles.empty() && std::adjacent_find(offsets.begin(), offsets.end()) != offsets.end();  // one is empty
    file_.titled_by_group = numbered;
    for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
      const double begin = offsets[k], end = offsets[k + 1];
      if (!(begin >= 0 && begin <= end && end <= static_cast<double>(points_.size())) || begin != std::floor(begin) ||
          end != std::floor(end)) {
        fail("array " + described(arrays_[index]) + ": curve " + std::to_string(k) + " from " + format_number(begin) +
             " to " + format_number(end) + " is not among " + std::to_string(points_.size()) + " points");
      }
      add_curve(k < titles.size() ? titles[k]
                : numbered        ? std::to_string(k)
                                  : std::string(),
                static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
    }
  }

  // The points of a list of curves, by their numbers; nothing where they are not counts, or not those of all points.
  [[nodiscard]] bool fits(std::span<const double> counts) const {
    double sum = 0;
    for (const double count : counts) {
      if (!(count >= 0) || count != std::floor(count)) return false;
      sum += count;
    }
    return sum == static_cast<double>(points_.size());
  }

  void part_by_counts(const Buffer<double>& counts, std::size_t index) {
    if (!fits(counts)) {
      fail("array " + described(arrays_[index]) + ": expected numbers of points whose sum is " +
           std::to_string(points_.size()));
    }
    const std::vector<std::string> names = names_of(counts.size());
    file_.titled_by_group = true;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const std::size_t end = begin + static_cast<std::size_t>(counts[k]);
      add_curve(names[k], begin, end);
      begin = end;
    }
  }

  // The names of curves, or their numbers.
  [[nodiscard]] std::vector<std::string> names_of(std::size_t curves) const {
    std::vector<std::string> names;
    if (const std::string array = source_.names_of_curves(); !array.empty()) {
      names = source_.texts(array);
      const auto found =
          std::find_if(arrays_.begin(), arrays_.end(), [&](const ArrayInfo& one) { return one.name == array; });
      if (found != arrays_.end()) {
        for (const double number : numbers(static_cast<std::size_t>(found - arrays_.begin()))) {
          names.push_back(std::isnan(number) ? std::to_string(names.size()) : format_number(number));
        }
      }
    }
    if (names.size() >= curves) return names;
    names.clear();
    for (std::size_t k = 0; k < curves; ++k) names.push_back(std::to_string(k));
    return names;
  }

  // Curves one behind the other, as an array beside them says. False where there is none that fits.
  bool part_by_roles() {
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      const ArrayInfo& array = arrays_[k];
      const std::string name = last_part(array.name);
      const bool counts = array.role == ArrayInfo::Role::counts || same_in_any_case(name, "rowsize") ||
                          same_in_any_case(name, "row_size");
      if (counts && array.shape.size() == 1 && !array.is_complex) {
        const Buffer<double> all = numbers(k);
        if (!fits(all)) continue;
        part_by_counts(all, k);
        return true;
      }
      if (array.role != ArrayInfo::Role::instances || array.size() != points_.size()) continue;
      part_by_instances(k);
      return true;
    }
    return false;
  }

  void part_by_instances(std::size_t index) {
    part_by_group(index);
    const Buffer<double> instances = numbers(index);
    double last = -1;
    for (const double instance : instances) last = std::max(last, instance);
    if (!(last >= 0 && last < static_cast<double>(points_.size()))) return;
    const std::vector<std::string> names = names_of(static_cast<std::size_t>(last) + 1);
    for (Zone& zone : file_.zones) {
      std::size_t number = names.size();
      std::from_chars(zone.title.data(), zone.title.data() + zone.title.size(), number);
      if (number < names.size()) zone.title = names[number];
    }
  }

  void part_by_group(std::size_t index) {
    const Buffer<double> groups = numbers(index);
    if (groups.size() != points_.size()) {
      fail("array " + described(arrays_[index]) + ": expected a number for each of " + std::to_string(points_.size()) +
           " points");
    }
    file_.titled_by_group = true;
    std::map<double, std::size_t> zone_of;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (std::isnan(points_[k].x) && std::isnan(points_[k].y)) continue;
      require_finite(k);
      if (std::isnan(groups[k]))
        fail("array " + described(arrays_[index]) + ": number " + std::to_string(k) + " is NaN");
      const auto [at, is_new] = zone_of.try_emplace(groups[k], file_.zones.size());
      if (is_new) file_.zones.push_back({format_number(groups[k]), {}, 1});
      file_.zones[at->second].points.push_back(points_[k]);
    }
  }

  ArrayFile& source_;
  const std::vector<ArrayInfo>& arrays_;
  CurveFile& file_;
  Buffer<Point> points_;
  std::vector<std::size_t> rows_;  // where each row of arrays of two axes begins, and the end
};

}  // namespace

std::size_t ArrayInfo::size() const {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, [](std::size_t product, std::size_t size) {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    return size != 0 && product > most / size ? most : product * size;
  });
}

Buffer<double> last_axis_fastest(const Buffer<double>& numbers, const std::vector<std::size_t>& shape) {
  Buffer<double> result(numbers.size());
  std::vector<std::size_t> strides(shape.size(), 1), at(shape.size(), 0);
  for (std::size_t axis = 1; axis < shape.size(); ++axis) strides[axis] = strides[axis - 1] * shape[axis - 1];
  std::size_t from = 0;
  for (double& number : result) {
    number = numbers[from];
    for (std::size_t axis = shape.size(); axis-- > 0;) {
      from += strides[axis];
      if (++at[axis] < shape[axis]) break;
      from -= strides[axis] * shape[axis];
      at[axis] = 0;
    }
  }
  return result;
}

Buffer<double> interleaved(const Buffer<double>& real, const Buffer<double>& imaginary) {
  Buffer<double> both(2 * real.size());
  for (std::size_t k = 0; k < real.size(); ++k) {
    both[2 * k] = real[k];
    both[2 * k + 1] = imaginary[k];
  }
  return both;
}

std::optional<ArrayInfo> array_of_list(const std::string& name, const std::vector<ArrayInfo>& elements) {
  const auto is_vector = [](const ArrayInfo& element) {
    return std::count_if(element.shape.begin(), element.shape.end(), [](std::size_t size) { return size > 1; }) <= 1;
  };
  const auto all = [&](const auto& holds) {
    return std::all_of(elements.begin(), elements.end(),
                       [&](const ArrayInfo& one) { return one.size() == 0 || holds(one); });
  };
  const auto is_complex = [](const ArrayInfo& element) { return element.is_complex; };
  ArrayInfo list{name, {0}};
  list.is_complex = all([&](const ArrayInfo& one) { return is_complex(one) && is_vector(one); });
  const bool vectors = list.is_complex || all([&](const ArrayInfo& one) { return !is_complex(one) && is_vector(one); });
  if (!vectors && !all([&](const ArrayInfo& one) { return !is_complex(one) && holds_points(one); }))
    return std::nullopt;
  if (!vectors) list.shape.push_back(2);
  for (const ArrayInfo& element : elements) {
    list.pieces.push_back(vectors ? element.size() : element.size() / 2);
    if (element.size() > std::numeric_limits<std::size_t>::max() - list.shape[0]) return std::nullopt;
    list.shape[0] += list.pieces.back();
  }
  if (list.shape[0] == 0) return std::nullopt;
  return list;
}

void append_element(Buffer<double>& all, const Buffer<double>& numbers, const ArrayInfo& element,
                    const ArrayInfo& list) {
  const bool across = list.shape.size() == 2 && element.shape.size() == 2 && element.shape[1] != 2;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    all.push_back(across ? numbers[k % 2 * (numbers.size() / 2) + k / 2] : numbers[k]);
  }
}

bool can_hold(std::size_t stored, std::size_t size) {
  constexpr std::size_t max_ratio = 1032, always_fits = std::size_t{1} << 16;
  return size / max_ratio <= stored || size <= always_fits;
}

void require_fitting_memory(const std::string& path, const ArrayInfo& array) {
  if (array.size() <= memory_for_unknown_content() / sizeof(double)) return;
  throw DataError(path + ": array " + described(array) + ": is larger than a quarter of this machine's memory");
}

void read_arrays(ArrayFile& arrays, std::string_view choice, CurveFile& file) {
  CurvesOfArrays(arrays, file).read(choice);
}

}  // namespace lober::detail
