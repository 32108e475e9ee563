#include "engine/batch/export/table_columns.hpp"

#include <algorithm>
#include <limits>

namespace lober::detail {
namespace {

std::size_t longest_text(const Plan& plan, const std::string& key) {
  std::size_t width = 1;
  for (const JobGroup& group : plan.groups) {
    const OptionValue* const value = group.options.find(key);
    if (value != nullptr) width = std::max(width, to_string(*value).size());
  }
  return width;
}

}  // namespace

std::array<std::string, 5> texts_of(const Plan& plan, const Result& result) {
  const Job& job = plan.jobs[result.job];
  const JobGroup& group = plan.group_of(job);
  return {group.name, group.options.to_string(), plan.name(job.first), plan.name(job.second), result.error};
}

bool SweptColumn::is_text() const {
  return std::holds_alternative<std::string>(any) || !numbers_of(any).empty();
}

double swept_number(const OptionValue* value) {
  if (value == nullptr) return std::numeric_limits<double>::quiet_NaN();
  if (const auto* flag = std::get_if<bool>(value)) return *flag ? 1 : 0;
  if (const auto* whole = std::get_if<std::int64_t>(value)) return static_cast<double>(*whole);
  const auto* real = std::get_if<double>(value);
  return real == nullptr ? std::numeric_limits<double>::quiet_NaN() : *real;
}

TableColumns table_columns(const Plan& plan, const Operation& operation, const EachResult& results) {
  TableColumns columns;
  columns.widths.fill(1);
  results([&](const Result& result) {
    ++columns.rows;
    const auto all = texts_of(plan, result);
    for (std::size_t k = 0; k < all.size(); ++k) columns.widths[k] = std::max(columns.widths[k], all[k].size());
  });
  for (const SweptOption& option : swept_options(plan, operation)) {
    columns.swept.push_back(
        {option.key, option.column, any_value(option, plan, operation), longest_text(plan, option.key)});
  }
  return columns;
}

}  // namespace lober::detail
