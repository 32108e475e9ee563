// All operations, of the list in table.hpp.
#include "engine/operations/table.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/nearest_word.hpp"
#include "engine/operations/curve_of.hpp"
#include "lober/base/error.hpp"

namespace lober::operations {
namespace {

#define LOBER_NAME(name) std::string_view(#name),
constexpr std::array names{LOBER_OPERATIONS(LOBER_NAME)};
#undef LOBER_NAME

// Each is made when it is asked for first: a program that runs one of them does not wait for the others.
struct Table {
  std::array<Operation, names.size()> operations{};
  std::array<std::once_flag, names.size()> made{};
};

Table& table() {
  static Table all;
  return all;
}

Operation made(std::size_t k) {
  using namespace detail::table;
#define LOBER_MAKER(name) &name##_operation,
  static constexpr std::array makers{LOBER_OPERATIONS(LOBER_MAKER)};
#undef LOBER_MAKER
  Operation one = makers[k]();
  // Operations run with inputs of their kinds only.
  one.run = [k, run = std::move(one.run)](std::span<const Input> inputs, const Options& options,
                                          const Context& context) {
    const Operation& operation = table().operations[k];
    require_inputs(operation, inputs);
    if (operation.check) operation.check(options, inputs.size());
    return run(inputs, options, context);
  };
  return one;
}

const Operation& at(std::size_t k) {
  std::call_once(table().made[k], [k] { table().operations[k] = made(k); });
  return table().operations[k];
}

}  // namespace

std::span<const Operation> all() {
  for (std::size_t k = 0; k < names.size(); ++k) (void)at(k);
  return table().operations;
}

const Operation& named(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return at(static_cast<std::size_t>(found - names.begin()));
  const std::vector<std::string> known(names.begin(), names.end());
  throw UsageError("there is no operation \"" + std::string(name) + "\"; there are " + lober::detail::joined(known) +
                   lober::detail::did_you_mean(name, known));
}

}  // namespace lober::operations
