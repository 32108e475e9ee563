// The columns of a table of results in binary formats, whose texts have a width (private to the exports).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/batch/export/export_formats.hpp"
#include "engine/batch/manifest/swept_options.hpp"

namespace lober::detail {

inline constexpr std::array<std::string_view, 5> text_columns{"group", "options", "first", "second", "message"};

/// The texts of a result, in the order of `text_columns`.
[[nodiscard]] std::array<std::string, 5> texts_of(const Plan& plan, const Result& result);

/// A column of an option that differs between jobs.
struct SweptColumn {
  std::string key, name;
  OptionValue any;    ///< whose type all values have
  std::size_t width;  ///< width of the longest value as text
  /// Points and lists are written as text.
  [[nodiscard]] bool is_text() const;
};

/// The number that stands for the value of such an option that is not text; NaN for none.
[[nodiscard]] double swept_number(const OptionValue* value);

struct TableColumns {
  std::size_t rows = 0;
  std::array<std::size_t, 5> widths{};  ///< those of the longest texts, at least 1
  std::vector<SweptColumn> swept;
};

/// Goes through all results once.
[[nodiscard]] TableColumns table_columns(const Plan& plan, const Operation& operation, const EachResult& results);

}  // namespace lober::detail
