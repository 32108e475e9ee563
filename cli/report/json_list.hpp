// Lists in JSON, which can have millions of elements: formatted in parallel, one element a line, and never held in
// memory as a whole.
#pragma once

#include <cmath>
#include <string>

#include "cli/report/text.hpp"
#include "engine/base/output_file.hpp"
#include "engine/base/parallel/ordered_pipeline.hpp"

namespace lober::cli {

/// Numbers as nlohmann writes them: those that are not finite as null, whole ones with ".0".
struct JsonNumber {
  double value;
};
inline void append(std::string& text, JsonNumber number) {
  if (!std::isfinite(number.value)) {
    text += "null";
    return;
  }
  const std::size_t begin = text.size();
  cli::append(text, number.value);
  if (text.find_first_of(".e", begin) == std::string::npos) text += ".0";
}

template <typename... Values>
void put(std::string& text, const Values&... values) {
  const auto one = [&](const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
      append(text, JsonNumber{value});
    } else {
      cli::append(text, value);
    }
  };
  (one(values), ...);
}

/// Writes "[" element, element ... "]", each element by `format(text, index)`.
template <typename Format>
void write_list(detail::OutputFile& file, std::size_t size, const Format& format) {
  constexpr std::size_t block = 2048;
  struct Slot {
    std::size_t begin = 0, end = 0;
    std::string text;
  };
  file.write("[");
  std::size_t next = 0;
  detail::ordered_pipeline<Slot>(
      [&](Slot& slot) {
        slot.begin = next;
        slot.end = next = std::min(size, next + block);
        return slot.begin < slot.end;
      },
      [&](Slot& slot) {
        slot.text.clear();
        for (std::size_t k = slot.begin; k < slot.end; ++k) {
          slot.text += k == 0 ? "\n  " : ",\n  ";
          format(slot.text, k);
        }
      },
      [&](const Slot& slot) { file.write(slot.text); });
  file.write(size == 0 ? "]" : "\n]");
}

}  // namespace lober::cli
