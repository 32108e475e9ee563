#include "cli/program/wrapped_text.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace lober::cli {

std::size_t text_width() {
  constexpr std::size_t narrowest = 80, widest = 120, elsewhere = 100;
  if (const char* const columns = std::getenv("COLUMNS")) {
    const std::string_view text(columns);
    std::size_t width = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), width);
    if (error == std::errc{} && end == text.data() + text.size() && width > 0) {
      return std::clamp(width, narrowest, widest);
    }
  }
  winsize size{};
  if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return elsewhere;
  return std::clamp(static_cast<std::size_t>(size.ws_col), narrowest, widest);
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent, std::size_t used) {
  std::string lines;
  std::size_t column = used;
  bool is_first = true;  // word of its line
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    if (!is_first && column + 1 + word.size() > width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
      is_first = true;
    }
    if (!is_first) lines += ' ';
    lines += word;
    column += word.size() + (is_first ? 0 : 1);
    is_first = false;
  }
  return lines;
}

std::string list_entry(std::string_view label, std::string_view text, std::size_t column, std::size_t width) {
  std::string entry = "  " + std::string(label);
  if (entry.size() + 1 < column) {
    entry.append(column - entry.size(), ' ');
  } else {
    entry += "\n" + std::string(column, ' ');
  }
  return entry + wrapped(text, width, column, column) + "\n";
}

}  // namespace lober::cli
