#include "cli/report/outcome_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/report/table.hpp"

namespace lober::cli {
namespace {

using operations::Field;
using operations::FieldKind;
using operations::FieldValue;

constexpr std::size_t rows_shown = 50, numbers_shown = 4, characters_shown = 40;

std::string number_and(std::size_t count, const char* one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

// A value in a word or two; "-" where nothing is known.
struct Text {
  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(double value) const { return std::isnan(value) ? "-" : fmt::format("{:.15g}", value); }
  std::string operator()(const Measured& value) const { return (*this)(value.value); }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(bool value) const { return value ? "yes" : "no"; }
  std::string operator()(const std::string& value) const { return value.empty() ? "-" : value; }
  std::string operator()(const std::vector<std::string>& value) const {
    return fmt::format("{}", fmt::join(value, "; "));
  }
  std::string operator()(const std::vector<double>& value) const {
    return value.size() > numbers_shown ? number_and(value.size(), "number")
                                        : fmt::format("{:.12g}", fmt::join(value, " "));
  }
  std::string operator()(const std::vector<std::int64_t>& value) const {
    return value.size() > numbers_shown ? number_and(value.size(), "number") : fmt::format("{}", fmt::join(value, " "));
  }
  std::string operator()(Point value) const { return fmt::format("({:.15g}, {:.15g})", value.x, value.y); }
  std::string operator()(const std::vector<Point>& value) const { return number_and(value.size(), "point"); }
  std::string operator()(const operations::Matrix& value) const {
    return fmt::format("{} x {} numbers", value.rows, value.columns);
  }
};

std::string bar_of(const FieldValue& value) {
  const auto* const measured = std::get_if<Measured>(&value);
  return measured == nullptr || std::isnan(measured->value) ? "" : fmt::format("{:.1e}", measured->error);
}

// Whether a field of a list fits a cell.
bool is_column(const Field& field) {
  return field.kind != FieldKind::object && field.kind != FieldKind::list && field.kind != FieldKind::matrix;
}

using Row = std::vector<std::string>;

// Long texts in a table, such as why a row failed: the beginning in the cell, all of it below the table, each text
// once.
class LongTexts {
 public:
  // The cell of a column in a row that begins with `row`.
  std::string cell(const std::string& column, const std::string& row, std::string text) {
    if (text.size() <= characters_shown || table_format() == TableFormat::markdown) return text;
    std::size_t end = characters_shown - 3;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // within a character
    std::string shortened = text.substr(0, end) + "...";
    const auto known = std::find_if(lines_.begin(), lines_.end(), [&](const Line& line) { return line.text == text; });
    if (known == lines_.end()) {
      lines_.push_back({column + " at " + row, std::move(text)});
    } else {
      ++known->more;
    }
    return shortened;
  }
  [[nodiscard]] std::string below() const {
    std::string all;
    for (const Line& line : lines_) {
      all +=
          "  " + line.where + (line.more > 0 ? fmt::format(" and {} more", line.more) : "") + ": " + line.text + '\n';
    }
    return all;
  }

 private:
  struct Line {
    std::string where, text;
    std::size_t more = 0;
  };
  std::vector<Line> lines_;
};

// Columns as wide as the widest cell.
std::string table_of(std::vector<Column> columns, const std::vector<Row>& rows) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    columns[k].width = columns[k].name.size();
    columns[k].gap = 2;
    for (const Row& row : rows) columns[k].width = std::max(columns[k].width, row[k].size());
  }
  const Table table(std::move(columns));
  std::string text = table.head();
  for (const Row& row : rows) text += table.row(row);
  return text;
}

class OutcomeText {
 public:
  void add(std::span<const Field> fields, const void* whole, const std::string& prefix) {
    for (const Field& field : fields) {
      const std::string name = prefix + field.name;
      if (field.kind == FieldKind::object) {
        field.part(whole, [&](const void* part) { add(field.members, part, name + "."); });
      } else if (field.kind == FieldKind::list) {
        add_list(field, whole, name);
      } else {
        add_line(field, whole, name);
      }
    }
  }
  [[nodiscard]] std::string text() const {
    std::size_t name = 0, value = 0;
    for (const Line& line : lines_) {
      name = std::max(name, line.name.size());
      value = std::max(value, std::min<std::size_t>(line.value.size(), 24));
    }
    if (table_format() == TableFormat::markdown) return markdown_lines() + lists_;
    std::string all;
    for (const Line& line : lines_) {
      std::string written = fmt::format("{:<{}}  {:>{}}", line.name, name, line.value, value);
      if (!line.bar.empty()) written += "  +- " + line.bar;
      if (!line.unit.empty()) written += "  " + line.unit;
      all += written + '\n';
    }
    return all + lists_;
  }

 private:
  struct Line {
    std::string name, value, bar, unit;
  };

  // Aligned lines have no names of columns; a table of Markdown has.
  [[nodiscard]] std::string markdown_lines() const {
    if (lines_.empty()) return {};
    const Table table({{"", 0, Align::left}, {"value"}, {"+-"}, {"unit", 0, Align::left}});
    std::string text = table.head();
    for (const Line& line : lines_) text += table.row({line.name, line.value, line.bar, line.unit});
    return text;
  }

  void add_line(const Field& field, const void* whole, const std::string& name) {
    const FieldValue value = field.get(whole);
    if (std::holds_alternative<std::monostate>(value) && !field.null) return;
    lines_.push_back({name, std::visit(Text{}, value), bar_of(value), field.unit});
  }

  void add_list(const Field& field, const void* whole, const std::string& name) {
    const Field::Elements all = field.elements(whole);
    if (!all.known) return;
    lines_.push_back({name, std::to_string(all.size), "", ""});
    if (all.size == 0) return;
    std::vector<Row> rows;
    std::vector<Column> columns;
    for (const Field& member : field.members) {
      if (!is_column(member)) continue;
      columns.push_back({.name = member.name, .unit = member.unit});
      if (!member.bar.empty()) columns.push_back({.name = "+-", .unit = member.unit});
    }
    LongTexts long_texts;
    for (std::size_t k = 0; k < std::min(all.size, rows_shown); ++k) {
      all.at(k, [&](const void* element) {
        Row& row = rows.emplace_back();
        for (const Field& member : field.members) {
          if (!is_column(member)) continue;
          const FieldValue value = member.get(element);
          std::string text = std::visit(Text{}, value);
          if (!row.empty() && (member.kind == FieldKind::text || member.kind == FieldKind::lines)) {
            text = long_texts.cell(member.name, columns.front().name + " = " + row.front(), std::move(text));
          }
          row.push_back(std::move(text));
          if (!member.bar.empty()) row.push_back(bar_of(value));
        }
      });
    }
    lists_ += '\n' + name + '\n' + table_of(columns, rows) + long_texts.below();
    if (all.size > rows_shown) lists_ += fmt::format("  and {} more (--json has all)\n", all.size - rows_shown);
  }

  std::vector<Line> lines_;
  std::string lists_;
};

}  // namespace

std::string outcome_table(std::span<const Field> fields, const void* whole) {
  OutcomeText text;
  text.add(fields, whole, "");
  return text.text();
}

}  // namespace lober::cli
