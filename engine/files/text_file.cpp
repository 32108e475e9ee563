#include "engine/files/text_file.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/base/file_activity.hpp"
#include "engine/base/parallel/ordered_pipeline.hpp"
#include "engine/files/source_location.hpp"
#include "engine/files/tecplot.hpp"
#include "engine/files/text_columns.hpp"
#include "engine/files/text_points.hpp"

namespace lober::detail {
namespace {

/// Takes the chunks in their order and builds the zones.
class Assembler {
 public:
  Assembler(std::size_t text_size, const TableHead& head, CurveFile& file)
      : text_left_(text_size),
        columns_(head.columns),
        is_table_(!columns_.are_all() && !columns_.is_tecplot),
        line_(head.skipped == 0 ? 1 : 2),
        implicit_line_(line_),
        file_(file) {
    file_.format = Format::text;
  }

  void add(const TextChunk& chunk) {
    std::size_t taken = 0;
    for (const OtherLine& other : chunk.others) {
      append(std::span(chunk.points).subspan(taken, other.points_before - taken));
      taken = other.points_before;
      read_other(other, line_ + other.line);
    }
    append(std::span(chunk.points).subspan(taken));
    if (chunk.error) SourceLocation{file_.path, line_ + chunk.error->line}.fail(chunk.error->message);
    line_ += chunk.lines;
    text_left_ -= chunk.text.size();
    if (file_.zones.size() == 1 && !reserved_) reserve(chunk);
  }

  void finish() {
    end_zone();
    if (file_.zones.empty()) throw DataError(file_.path + ": no points");
  }

 private:
  void append(std::span<const Point> points) {
    if (points.empty()) return;
    if (variables_line_ != 0 && variables_ != columns_.count) fail_variables(variables_line_);
    if (!in_zone_) begin_zone(implicit_line_);
    std::vector<Point>& all = file_.zones[zone_].points;
    all.insert(all.end(), points.begin(), points.end());
    open_record_ = TecplotRecord::none;
  }

  /// Most files are one long zone: ask for its memory once, in proportion to what the first chunk gave. A
  /// zone too many costs address space, not memory.
  void reserve(const TextChunk& chunk) {
    reserved_ = true;
    std::vector<Point>& all = file_.zones.back().points;
    const double points_per_byte =
        1.02 * static_cast<double>(chunk.points.size()) / static_cast<double>(chunk.text.size());
    all.reserve(all.size() + static_cast<std::size_t>(points_per_byte * static_cast<double>(text_left_)));
  }

  void read_other(const OtherLine& other, std::size_t line) {
    const bool is_table = file_.format == Format::text;
    switch (other.kind) {
      case OtherLine::Kind::blank:
        if (is_table && in_zone_ && !groups_) add_blank_line(line);
        break;
      case OtherLine::Kind::gap:
        if (!is_table) SourceLocation{file_.path, line}.fail("not a finite number: " + quoted_text(other.text));
        if (!groups_) begin_curve({}, line);
        break;
      case OtherLine::Kind::group:
        begin_group(text_of_cell(other.text), line);
        break;
      case OtherLine::Kind::text:
        if (is_table && other.text.front() == '>') {
          if (groups_) return;
          begin_curve(other.text.substr(std::min(other.text.find_first_not_of("> \t"), other.text.size())), line);
        } else {
          read_line(other.text, line);
        }
    }
  }

  void add_blank_line(std::size_t line) {
    const std::size_t points = file_.zones[zone_].points.size();
    if (blank_lines_.empty() || blank_lines_.back().points_before != points) blank_lines_.push_back({points, line + 1});
  }

  /// The points that follow belong to another curve of a table.
  void begin_curve(std::string_view title, std::size_t line) {
    end_zone();
    title_ = title;
    while (!title_.empty() && is_blank(title_.back())) title_.pop_back();
    implicit_line_ = line + 1;
  }

  /// Those that follow belong to the curve of this group, which need not be new.
  void begin_group(const std::string& group, std::size_t line) {
    groups_ = true;
    file_.titled_by_group = true;
    const auto [known, is_new] = zone_of_group_.try_emplace(group, file_.zones.size());
    if (is_new) {
      title_ = group;
      begin_zone(line);
    }
    zone_ = known->second;
  }

  void read_line(std::string_view text, std::size_t line) {
    const SourceLocation location{file_.path, line};
    const TecplotRecord record = tecplot_record(text);
    if (record == TecplotRecord::none) return continue_record(text, location);
    if (record == TecplotRecord::ignored) return;
    if (is_table_) location.fail("columns are chosen of tables, not of Tecplot files: " + quoted_text(text));
    file_.format = Format::tecplot;
    open_record_ = record;
    // Files put one behind the other: the points that follow belong to another curve.
    if (record != TecplotRecord::zone && in_zone_ && !file_.zones.back().points.empty()) {
      end_zone();
      implicit_line_ = line;
    }
    if (record == TecplotRecord::variables) {
      variables_ = 0;
      variables_line_ = line;
      add_variables(text, location);
    } else if (record == TecplotRecord::zone) {
      end_zone();
      begin_zone(line);
      add_attributes(text, location);
    }
  }

  /// A line that begins no record: it continues one, or is the header line of a text file, or is wrong.
  void continue_record(std::string_view text, const SourceLocation& location) {
    if (open_record_ == TecplotRecord::variables) return add_variables(text, location);
    if (open_record_ == TecplotRecord::zone) return add_attributes(text, location);
    const bool first_line = file_.format == Format::text && file_.zones.empty() && !header_line_seen_;
    if (first_line && !(is_table_ ? has_number(text, columns_.separator) : has_number(text))) {
      header_line_seen_ = true;
      file_.header = text;
      return;
    }
    // Units below the header.
    if (is_table_ && header_line_seen_ && !units_seen_ && file_.zones.empty() &&
        cells_of(text, columns_.separator, columns_.count).size() == columns_.count &&
        !has_number(text, columns_.separator)) {
      units_seen_ = true;
      return;
    }
    // Tables put one behind the other.
    if (header_line_seen_ && text == file_.header && (!in_zone_ || !blank_lines_.empty())) return;
    Point ignored;
    std::string message = parse_point_line(text, ignored);
    if (message.empty()) message = "not a point: " + quoted_text(text);
    location.fail(message);
  }

  void add_variables(std::string_view text, const SourceLocation& location) {
    variables_ += variable_names(text, location).size();
    file_.header += text;
    if (variables_ > columns_.count) fail_variables(location.line);
  }

  [[noreturn]] void fail_variables(std::size_t line) const {
    const std::string expected = columns_.count == 2 ? "two" : std::to_string(columns_.count);
    SourceLocation{file_.path, line}.fail("expected " + expected + " variables, found " + std::to_string(variables_) +
                                          (variables_ > 2 ? "; choose two by FILE:NAME,NAME" : ""));
  }

  void add_attributes(std::string_view text, const SourceLocation& location) {
    read_zone_attributes(text, location, header_);
    file_.zones.back().title = header_.title;
  }

  void begin_zone(std::size_t line) {
    header_ = {};
    in_zone_ = true;
    zone_ = file_.zones.size();
    file_.zones.push_back({std::exchange(title_, {}), {}, line});
  }

  /// Parts a table's zone where blank lines are, unless there is one behind each point.
  void part_at_blank_lines() {
    std::vector<BlankLine> at;
    at.swap(blank_lines_);
    const std::size_t size = file_.zones.back().points.size();
    while (!at.empty() && at.back().points_before == size) at.pop_back();
    if (at.empty() || at.size() + 1 == size) return;
    const std::vector<Point> points = std::move(file_.zones.back().points);
    const auto part = [&](std::size_t begin, std::size_t end) {
      const auto from = points.begin();
      return std::vector<Point>(from + static_cast<std::ptrdiff_t>(begin), from + static_cast<std::ptrdiff_t>(end));
    };
    file_.zones.back().points = part(0, at.front().points_before);
    for (std::size_t k = 0; k < at.size(); ++k) {
      const std::size_t end = k + 1 < at.size() ? at[k + 1].points_before : points.size();
      file_.zones.push_back({{}, part(at[k].points_before, end), at[k].next_line});
    }
  }

  void end_zone() {
    if (!in_zone_) return;
    in_zone_ = false;
    if (!blank_lines_.empty()) {
      if (file_.format == Format::text) part_at_blank_lines();
      blank_lines_.clear();
    }
    Zone& zone = file_.zones.back();
    const std::size_t points = zone.points.size();
    for (const TecplotZone::Count& count : header_.counts) {
      if (count.points == points) continue;
      SourceLocation{file_.path, count.line}.fail(count.key + "=" + std::to_string(count.points) +
                                                  " is declared, found " + std::to_string(points) +
                                                  (points == 1 ? " point" : " points"));
    }
    if (points == 0) SourceLocation{file_.path, zone.line}.fail("the zone has no points");
    if (zone.points.capacity() / 2 > points) zone.points.shrink_to_fit();
  }

  struct BlankLine {
    std::size_t points_before;  ///< points of the zone
    std::size_t next_line;
  };

  std::size_t text_left_;  ///< bytes after the last chunk
  const TextColumns& columns_;
  bool is_table_;              ///< whether some of several columns are read, which no Tecplot file has
  std::size_t line_;           ///< number of the first line of the next chunk
  std::size_t implicit_line_;  ///< where a zone begins that has no ZONE line
  CurveFile& file_;
  TecplotZone header_;                               ///< header of the last zone
  TecplotRecord open_record_ = TecplotRecord::none;  ///< that the next line may continue
  std::size_t variables_ = 0;
  std::size_t variables_line_ = 0;  ///< where they are named; 0: nowhere
  bool in_zone_ = false;
  std::size_t zone_ = 0;                ///< to which points are added
  std::string title_;                   ///< title of the curve that begins next
  std::vector<BlankLine> blank_lines_;  ///< in the zone, behind at least one point
  bool groups_ = false;                 ///< whether rows are grouped by a column
  std::map<std::string, std::size_t> zone_of_group_;
  bool header_line_seen_ = false, units_seen_ = false;
  bool reserved_ = false;
};

}  // namespace

void read_text(std::string_view text, std::string_view columns, std::size_t chunk_size, CurveFile& file) {
  const TableHead head = read_table_head(text, columns, file.path);
  std::string_view rest = text.substr(head.skipped);
  Assembler assembler(rest.size(), head, file);
  const auto next = [&](TextChunk& chunk) {
    if (rest.empty()) return false;
    const std::size_t line_end = chunk_size < rest.size() ? rest.find('\n', chunk_size - 1) : std::string_view::npos;
    chunk.text = rest.substr(0, line_end == std::string_view::npos ? rest.size() : line_end + 1);
    rest.remove_prefix(chunk.text.size());
    return true;
  };
  ordered_pipeline<TextChunk>(
      next, [&](TextChunk& chunk) { parse_chunk(chunk, head.columns); },
      [&](const TextChunk& chunk) {
        assembler.add(chunk);
        note_parsed(chunk.text.size(), text.size());
      });
  assembler.finish();
  if (!head.names.empty()) file.header = head.names;
}

}  // namespace lober::detail
