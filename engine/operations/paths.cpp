// Numbers of results by their names.
#include <algorithm>
#include <limits>

#include "lober/base/error.hpp"
#include "lober/operations.hpp"

namespace lober::operations {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::size_t first_name(std::string_view path) {
  return std::min(path.find('.'), path.size());
}

// The field that a path begins with.
const Field& first_field(std::span<const Field> fields, std::string_view path) {
  const std::string_view name = path.substr(0, first_name(path));
  const bool deeper = name.size() < path.size();
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) {
    return field.name == name || (!deeper && !field.bar.empty() && field.bar == name);
  });
  if (found != fields.end() && !(deeper && found->get)) return *found;
  std::string known;
  for (const Field& field : fields) known += (known.empty() ? "" : ", ") + field.name;
  throw UsageError("there is no field \"" + std::string(name) + "\"; there are " + known);
}

// Walks the path behind number `depth`. Captures of one pointer, which take no memory of their own, lead from one
// field to the next.
template <typename Use>
struct Walk {
  std::span<const Field* const> path;
  bool bar;
  const Use& use;

  void go(std::size_t depth, const void* whole) const {
    const Field& field = *path[depth];
    if (field.number) {
      const Measured found = field.number(whole);
      return use(bar ? found.error : found.value);
    }
    if (field.get) return use(unknown);
    if (depth + 1 == path.size()) return;
    if (field.address) {
      if (const void* const part = field.address(whole)) go(depth + 1, part);
      return;
    }
    const struct Step {
      const Walk& walk;
      std::size_t next;
    } step{*this, depth + 1};
    field.each(whole, [&step](const void* part) { step.walk.go(step.next, part); });
  }
};

template <typename Use>
void each_number(std::span<const Field* const> path, bool bar, const void* whole, const Use& use) {
  Walk<Use>{path, bar, use}.go(0, whole);
}

}  // namespace

const Field& field_at(std::span<const Field> fields, std::string_view path) {
  const Field& field = first_field(fields, path);
  const std::size_t begin = first_name(path);
  return begin == path.size() ? field : field_at(field.members, path.substr(begin + 1));
}

NumberPath::NumberPath(std::span<const Field> fields, std::string_view path) {
  for (std::string_view rest = path;;) {
    const Field& field = first_field(fields, rest);
    fields_.push_back(&field);
    const std::size_t begin = first_name(rest);
    if (begin == rest.size()) {
      bar_ = field.name != rest;
      return;
    }
    rest.remove_prefix(begin + 1);
    fields = field.members;
  }
}

std::vector<double> NumberPath::all(const void* whole) const {
  std::vector<double> numbers;
  each_number(fields_, bar_, whole, [&](double number) { numbers.push_back(number); });
  return numbers;
}

double NumberPath::first(const void* whole) const {
  double found = unknown;
  bool is_found = false;
  each_number(fields_, bar_, whole, [&](double number) {
    if (!is_found) found = number;
    is_found = true;
  });
  return found;
}

std::vector<double> numbers_at(std::span<const Field> fields, const void* whole, std::string_view path) {
  return NumberPath(fields, path).all(whole);
}

}  // namespace lober::operations
