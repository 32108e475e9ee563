#include "cli/generate/roff.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <ctime>

#include "cli/program/wrapped_text.hpp"
#include "lober/base/version.hpp"

namespace lober::cli {
namespace {

std::string page_date() {
  std::time_t seconds = std::time(nullptr);
  if (const char* const epoch = std::getenv("SOURCE_DATE_EPOCH")) {
    const std::string_view text(epoch);
    std::from_chars(text.data(), text.data() + text.size(), seconds);
  }
  std::tm day{};
  gmtime_r(&seconds, &day);
  char date[32];
  return {date, std::strftime(date, sizeof date, "%Y-%m-%d", &day)};
}

}  // namespace

std::string roff(std::string_view text) {
  std::string escaped;
  bool in_option = false;  // in a word whose hyphens are those of a command line
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    const bool begins = k == 0 || std::string_view(" ([|=,\"`").find(text[k - 1]) != std::string_view::npos;
    if (c == ' ') in_option = false;
    if (c == '-' && begins) in_option = true;
    switch (c) {
      case '\\':
        escaped += "\\e";
        break;
      case '-':
        escaped += in_option ? "\\-" : "-";
        break;
      case '\'':
        escaped += "\\(aq";
        break;
      case '`':
        escaped += "\\(ga";
        break;
      case '^':
        escaped += "\\(ha";
        break;
      case '~':
        escaped += "\\(ti";
        break;
      case '"':
        escaped += "\\(dq";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

ManPage::ManPage(const std::string& name) {
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return std::toupper(c); });
  text_ = ".TH " + title + " 1 " + page_date() + " \"lober " + version() +
          "\" \"lober\"\n.nh\n.ad l\n";  // options are not to be hyphenated
}

// Lines of roff may not begin with a dot or an apostrophe; mandoc asks for less than 80 characters.
void ManPage::lines(const std::string& escaped) {
  std::string broken = wrapped(escaped, 78);
  for (std::size_t at = 0; at < broken.size(); at = broken.find('\n', at), at = at == std::string::npos ? at : at + 1) {
    if (broken[at] == '.') broken.insert(at, "\\&");
  }
  text_ += broken + "\n";
}

void ManPage::section(std::string_view title) {
  text_ += ".SH \"" + roff(title) + "\"\n";
  after_heading_ = true;
}
void ManPage::subsection(std::string_view title) {
  text_ += ".SS \"" + roff(title) + "\"\n";
  after_heading_ = true;
}
void ManPage::begin_paragraph() {
  if (!after_heading_) text_ += ".PP\n";
  after_heading_ = false;
}
void ManPage::paragraph(std::string_view text) {
  begin_paragraph();
  lines(roff(text));
}
void ManPage::call(const std::string& command, const std::string& arguments) {
  begin_paragraph();
  text_ += ".B " + roff(command) + "\n";
  if (!arguments.empty()) lines(roff(arguments));
}
void ManPage::entry(std::string_view label, std::string_view text) {
  after_heading_ = false;
  text_ += ".TP\n.B " + roff(label) + "\n";
  lines(roff(text));
}
void ManPage::example(std::string_view line, std::string_view meaning) {
  after_heading_ = false;
  text_ += ".TP\n.B " + roff(line) + "\n";
  lines(roff(meaning));
}

}  // namespace lober::cli
