#include "cli/report/columns.hpp"

#include <algorithm>

#include "cli/program/output_names.hpp"
#include "cli/report/text.hpp"
#include "engine/base/output_file.hpp"
#include "engine/base/parallel/ordered_pipeline.hpp"
#include "engine/files/formats/plain_writers.hpp"
#include "engine/files/npy_header.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t block_rows = std::size_t{1} << 13;

struct Block {
  std::size_t begin = 0, end = 0;
  std::vector<double> numbers;
  std::string text;
};

std::string joined(const std::vector<std::string>& names, std::string_view before, std::string_view after,
                   std::string_view between) {
  std::string text;
  for (const std::string& name : names) {
    append_all(text, text.empty() ? "" : between, before, name, after);
  }
  return text;
}

// The line, or the bytes, before the first row.
std::string head_of(const Columns& columns, Format format) {
  switch (format) {
    case Format::csv:
      return joined(columns.names, "", "", ",") + "\n";
    case Format::text:
      return "# " + joined(columns.names, "", "", " ") + "\n";
    case Format::tecplot:
      return "VARIABLES=" + joined(columns.names, "\"", "\"", "") + "\n";
    case Format::npy: {
      std::vector<std::size_t> shape = columns.shape.empty() ? std::vector{columns.rows} : columns.shape;
      shape.push_back(columns.names.size());
      return detail::npy_head(shape);
    }
    default:
      break;  // raw
  }
  return {};
}

void format_rows(Block& block, std::size_t width, char separator) {
  block.text.clear();
  for (std::size_t k = 0; k < block.numbers.size(); ++k) {
    append(block.text, block.numbers[k]);
    block.text += (k + 1) % width == 0 ? '\n' : separator;
  }
}

}  // namespace

void write_columns(const std::string& path, const Columns& columns) {
  const Format format = table_format(path);
  const std::size_t width = columns.names.size();
  const bool binary = format == Format::npy || format == Format::raw;
  const bool tabs = format == Format::tecplot || detail::is_parted_by_tabs(path);
  const char separator = format == Format::csv ? ',' : tabs ? '\t' : ' ';
  detail::OutputFile file(path);
  file.write(head_of(columns, format));
  std::size_t next = 0;
  detail::ordered_pipeline<Block>(
      [&](Block& block) {
        block.begin = next;
        block.end = next = std::min(columns.rows, next + block_rows);
        return block.begin < block.end;
      },
      [&](Block& block) {
        block.numbers.resize((block.end - block.begin) * width);
        for (std::size_t row = block.begin; row < block.end; ++row) {
          columns.row(row, std::span(block.numbers).subspan((row - block.begin) * width, width));
        }
        if (!binary) format_rows(block, width, separator);
      },
      [&](const Block& block) {
        file.write(binary ? std::string_view(reinterpret_cast<const char*>(block.numbers.data()),
                                             block.numbers.size() * sizeof(double))
                          : std::string_view(block.text));
      });
  file.commit();
}

}  // namespace lober::cli
