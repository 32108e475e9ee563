// Manual pages in roff, with the macros that man(7) of groff and of mandoc have in common.
#pragma once

#include <string>
#include <string_view>

namespace lober::cli {

/// Text such that roff prints it as it is: hyphens of options, quotes, backslashes.
[[nodiscard]] std::string roff(std::string_view text);

class ManPage {
 public:
  /// `name`: "lober-overlay". The date is that of SOURCE_DATE_EPOCH, as packages set it, or today.
  explicit ManPage(const std::string& name);

  void section(std::string_view title);
  void subsection(std::string_view title);
  void paragraph(std::string_view text);
  /// A command line, the first words bold.
  void call(const std::string& command, const std::string& arguments);
  /// An entry of a list: a bold label, and a text below it.
  void entry(std::string_view label, std::string_view text);
  /// A line that is not filled, and its meaning.
  void example(std::string_view line, std::string_view meaning);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void begin_paragraph();
  void lines(const std::string& escaped);

  std::string text_;
  bool after_heading_ = false;  // which begins a paragraph by itself
};

}  // namespace lober::cli
