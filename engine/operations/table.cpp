// All operations, of the list in table.hpp.
#include "engine/operations/table.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/operations/curve_of.hpp"
#include "lober/base/error.hpp"

namespace lober::operations {
namespace {

// Operations run with inputs of their kinds only.
template <std::size_t size>
std::array<Operation, size> checked(std::array<Operation, size> table) {
  for (Operation& one : table) {
    one.run = [name = one.name, run = std::move(one.run)](std::span<const Input> inputs, const Options& options,
                                                          const Context& context) {
      const Operation& operation = named(name);
      detail::table::require_inputs(operation, inputs);
      if (operation.check) operation.check(options, inputs.size());
      return run(inputs, options, context);
    };
  }
  return table;
}

}  // namespace

std::span<const Operation> all() {
  using namespace detail::table;
#define LOBER_MAKE(name) name##_operation(),
  static const std::array table = checked(std::array{LOBER_OPERATIONS(LOBER_MAKE)});
#undef LOBER_MAKE
  return table;
}

const Operation& named(std::string_view name) {
  const std::span<const Operation> table = all();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Operation& any) { return any.name == name; });
  if (found != table.end()) return *found;
  std::string known;
  for (const Operation& any : table) known += (known.empty() ? "" : ", ") + any.name;
  throw UsageError("there is no operation \"" + std::string(name) + "\"; there are " + known);
}

}  // namespace lober::operations
