#include "engine/c/result.hpp"

#include <limits>
#include <utility>

#include "engine/c/call.hpp"
#include "lober/base/error.hpp"

using lober::Point;

void lober_result::add(std::string name, int type, const void* data, std::size_t rows, std::size_t columns) {
  names_.push_back(std::move(name));
  arrays_.push_back({names_.back().c_str(), type, data, rows, columns});
}

void lober_result::add(std::string name, Doubles values, std::size_t columns) {
  doubles_.push_back(std::move(values));
  add(std::move(name), LOBER_DOUBLES, doubles_.back().data(), doubles_.back().size() / columns, columns);
}

void lober_result::add(std::string name, Integers values, std::size_t columns) {
  integers_.push_back(std::move(values));
  add(std::move(name), LOBER_INTEGERS, integers_.back().data(), integers_.back().size() / columns, columns);
}

void lober_result::add(std::string name, std::string text) {
  texts_.push_back(std::move(text));
  add(std::move(name), LOBER_TEXT, texts_.back().c_str(), 1, texts_.back().size());
}

void lober_result::add_points(std::string name, std::span<const Point> points, std::shared_ptr<const void> owner) {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  owners_.push_back(std::move(owner));
  add(std::move(name), LOBER_DOUBLES, points.data(), points.size(), 2);
}

void lober_result::add_points(std::string name, std::vector<Point> points) {
  const auto kept = std::make_shared<const std::vector<Point>>(std::move(points));
  add_points(std::move(name), *kept, kept);
}

const lober_array* lober_result::find(std::string_view name) const {
  for (const lober_array& array : arrays_) {
    if (name == array.name) return &array;
  }
  return nullptr;
}

namespace {

const lober_result& there(const lober_result* result) {
  if (result == nullptr) throw lober::UsageError("no result is given");
  return *result;
}

lober_array& room(lober_array* array) {
  if (array == nullptr) throw lober::UsageError("array is a null pointer");
  return *array;
}

}  // namespace

size_t lober_array_count(const lober_result* result) {
  return result ? result->arrays().size() : 0;
}

int lober_array_at(const lober_result* result, size_t number, lober_array* array) {
  return lober::detail::c::guarded([&] {
    const auto& arrays = there(result).arrays();
    if (number >= arrays.size()) {
      throw lober::UsageError("there is no array " + std::to_string(number) + "; the result has " +
                              std::to_string(arrays.size()) + ", from 0");
    }
    room(array) = arrays[number];
  });
}

int lober_array_named(const lober_result* result, const char* name, lober_array* array) {
  return lober::detail::c::guarded([&] {
    const lober_array* const found = name ? there(result).find(name) : nullptr;
    if (!found) {
      std::string names;
      for (const lober_array& one : there(result).arrays())
        names += (names.empty() ? "" : ", ") + std::string(one.name);
      throw lober::UsageError("there is no array \"" + std::string(name ? name : "") + "\"; there are " + names);
    }
    room(array) = *found;
  });
}

double lober_number(const lober_result* result, const char* name) {
  const lober_array* const found = result && name ? result->find(name) : nullptr;
  if (found && found->rows == 1 && found->columns == 1) {
    if (found->type == LOBER_DOUBLES) return *static_cast<const double*>(found->data);
    if (found->type == LOBER_INTEGERS) return static_cast<double>(*static_cast<const std::int64_t*>(found->data));
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void lober_result_free(lober_result* result) {
  delete result;
}
