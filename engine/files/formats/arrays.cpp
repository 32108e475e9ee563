#include "engine/files/formats/arrays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "engine/base/machine_memory.hpp"
#include "engine/base/text.hpp"
#include "engine/files/geographic.hpp"
#include "engine/files/text_points.hpp"

namespace lober::detail {
namespace {

// "x (10 x 2)"
std::string described(const ArrayInfo& array) {
  std::string text = array.name + " (";
  for (const std::size_t& size : array.shape) text += (&size == array.shape.data() ? "" : " x ") + std::to_string(size);
  return text + (array.shape.empty() ? "a number)" : ")");
}

std::string last_part(const std::string& name) {
  return name.substr(name.rfind('/') + 1);
}

bool holds_points(const ArrayInfo& array) {
  return array.shape.size() == 2 && (array.shape[0] == 2 || array.shape[1] == 2) && array.size() > 0;
}

// The arrays that a choice names.
struct Chosen {
  std::vector<std::size_t> coordinates;  // one or two
  std::optional<std::size_t> group, offsets;
};

class CurvesOfArrays {
 public:
  CurvesOfArrays(ArrayFile& source, CurveFile& file) : source_(source), arrays_(source.arrays()), file_(file) {}

  void read(std::string_view choice) {
    const Chosen chosen = choice.empty() ? evident() : chosen_by(choice);
    if (chosen.coordinates.size() == 1) {
      const ArrayInfo& array = arrays_[chosen.coordinates[0]];
      if (!holds_points(array)) fail("array " + described(array) + ": expected N x 2 or 2 x N numbers");
      take_points(chosen.coordinates[0]);
    } else {
      take_coordinates(chosen.coordinates[0], chosen.coordinates[1], !chosen.group && !chosen.offsets);
    }
    if (chosen.offsets) {
      part_at_offsets(*chosen.offsets);
    } else if (chosen.group) {
      part_by_group(*chosen.group);
    } else if (!rows_.empty()) {
      part_into_rows();
    } else {
      part_at_gaps();
    }
    if (file_.zones.empty()) fail("no points");
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw DataError(file_.path + ": " + message); }

  [[nodiscard]] std::string list() const {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t k = 0; k < std::min(arrays_.size(), most); ++k)
      text += (k == 0 ? "" : ", ") + described(arrays_[k]);
    return arrays_.size() > most ? text + " and " + std::to_string(arrays_.size() - most) + " more" : text;
  }

  [[nodiscard]] std::string holds() const {
    return arrays_.empty() ? "it holds no arrays of numbers" : "it holds " + list();
  }

  [[nodiscard]] std::optional<std::size_t> whole(std::string_view name) const {
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      if (arrays_[k].name == name || arrays_[k].name == "/" + std::string(name)) return k;
    }
    return std::nullopt;
  }

  // By its whole name, or by the last part of only one.
  [[nodiscard]] std::optional<std::size_t> found(std::string_view name) const {
    if (const std::optional<std::size_t> index = whole(name)) return index;
    std::optional<std::size_t> by_part;
    bool several = false;
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      if (last_part(arrays_[k].name) != name) continue;
      several = by_part.has_value();
      by_part = k;
    }
    if (several) fail("several arrays are called " + quoted_text(name) + "; " + holds());
    return by_part;
  }

  [[nodiscard]] std::size_t named(std::string_view name) const {
    const std::optional<std::size_t> index = found(name);
    if (!index) fail("has no array of real numbers called " + quoted_text(name) + "; " + holds());
    return *index;
  }

  [[nodiscard]] Chosen chosen_by(std::string_view choice) const {
    Chosen chosen;
    for (std::string_view rest = choice;;) {
      const std::size_t comma = rest.find(',');
      const std::string_view one = rest.substr(0, comma);
      if (one.starts_with("by=")) {
        chosen.group = named(one.substr(3));
      } else if (one.starts_with("offsets=")) {
        chosen.offsets = named(one.substr(8));
      } else {
        chosen.coordinates.push_back(named(one));
      }
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    if (chosen.coordinates.empty() || chosen.coordinates.size() > 2 || (chosen.group && chosen.offsets)) {
      fail("arrays are chosen by \"X,Y\" or \"XY\", and perhaps by=ID or offsets=O, not by " + quoted_text(choice));
    }
    return chosen;
  }

  // The choice that is meant where nothing is chosen.
  [[nodiscard]] Chosen evident() const {
    constexpr std::array<std::array<std::string_view, 2>, 4> pairs{
        {{"x", "y"}, {"lon", "lat"}, {"longitude", "latitude"}, {"X", "Y"}}};
    if (const auto points = whole("points"), offsets = whole("offsets"); points && offsets) {
      return {{*points}, std::nullopt, offsets};
    }
    for (const auto& [first, second] : pairs) {
      const auto x = whole(first), y = whole(second);
      if (x && y && arrays_[*x].shape == arrays_[*y].shape && arrays_[*x].axes == arrays_[*y].axes)
        return {{*x, *y}, std::nullopt, std::nullopt};
    }
    if (std::count_if(arrays_.begin(), arrays_.end(), holds_points) == 1) {
      const auto only = std::find_if(arrays_.begin(), arrays_.end(), holds_points);
      return {{static_cast<std::size_t>(only - arrays_.begin())}, std::nullopt, std::nullopt};
    }
    fail("which arrays are x and y? Name them, " + file_.path + ":X,Y, or one of N x 2, " + file_.path + ":XY; " +
         holds());
  }

  [[nodiscard]] Buffer<double> numbers(std::size_t index) const {
    require_fitting_memory(file_.path, arrays_[index]);
    return source_.numbers(index);
  }

  void take_points(std::size_t index) {
    const ArrayInfo& array = arrays_[index];
    const Buffer<double> all = numbers(index);
    const bool rows = array.shape[1] == 2;
    points_.resize(all.size() / 2);
    for (std::size_t k = 0; k < points_.size(); ++k) {
      points_[k] = rows ? Point{all[2 * k], all[2 * k + 1]} : Point{all[k], all[points_.size() + k]};
    }
  }

  // Points of two arrays; of those of two axes only the points that are there.
  void take_coordinates(std::size_t first, std::size_t second, bool rows_are_curves) {
    const ArrayInfo &x = arrays_[first], &y = arrays_[second];
    file_.header = last_part(x.name) + "," + last_part(y.name);
    std::vector<std::size_t> shape = x.shape;
    if (shape != y.shape) fail("arrays " + described(x) + " and " + described(y) + ": expected equal shapes");
    std::erase(shape, 1);
    if (shape.size() > 2) fail("array " + described(x) + ": expected one axis, or two, curves and their points");
    const Buffer<double> xs = numbers(first), ys = numbers(second);
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
    for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
      const double begin = offsets[k], end = offsets[k + 1];
      if (!(begin >= 0 && begin < end && end <= static_cast<double>(points_.size())) || begin != std::floor(begin) ||
          end != std::floor(end)) {
        fail("array " + described(arrays_[index]) + ": curve " + std::to_string(k) + " from " + format_number(begin) +
             " to " + format_number(end) + " is not among " + std::to_string(points_.size()) + " points");
      }
      add_zone(k < titles.size() ? titles[k] : std::string(), static_cast<std::size_t>(begin),
               static_cast<std::size_t>(end));
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

void apply_conventions(Buffer<double>& numbers, const std::array<std::optional<double>, 2>& none,
                       std::optional<double> scale, std::optional<double> shift) {
  constexpr double never_written = 9.969209968386869e+36;  // NC_FILL_DOUBLE and NC_FILL_FLOAT
  for (double& number : numbers) {
    if (number == none[0] || number == none[1] || number == never_written) {
      number = std::numeric_limits<double>::quiet_NaN();
    } else {
      if (scale) number *= *scale;
      if (shift) number += *shift;
    }
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
