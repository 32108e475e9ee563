#include "cli/picture/rich_text.hpp"

#include <cmath>

#include "cli/report/text.hpp"
#include "engine/base/utf8.hpp"

namespace lober::cli {
namespace {

constexpr double script_scale = 0.72;
constexpr std::string_view ellipsis = "\u2026";

struct TextRun {
  std::string text;
  int shift = 0;  // -1: below the line, +1: above
};

std::vector<TextRun> runs_of(std::string_view text) {
  std::vector<TextRun> runs{{}};
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool script = (text[k] == '_' || text[k] == '^') && k + 1 < text.size() && text[k + 1] == '{';
    const std::size_t end = script ? text.find('}', k) : std::string_view::npos;
    if (end == std::string_view::npos) {
      runs.back().text += text[k];
      continue;
    }
    runs.push_back({std::string(text.substr(k + 2, end - k - 2)), text[k] == '_' ? -1 : 1});
    runs.push_back({});
    k = end;
  }
  return runs;
}

// Advances of DejaVu Sans, in classes; other fonts are narrower.
double letter_width(char c) {
  if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) return 0;  // goes on with a letter
  if (static_cast<unsigned char>(c) >= 0x80) return 0.8;
  constexpr std::string_view thin = "ijl.,:;|'! ()[]/\\", wide = "mwMW%@";
  if (thin.find(c) != std::string_view::npos) return 0.36;
  if (wide.find(c) != std::string_view::npos) return 0.96;
  if (c == '-') return 0.4;
  if (c == 'f' || c == 't' || c == 'r' || c == 'I') return 0.42;
  if (c == '=' || c == '+' || c == '<' || c == '>') return 0.84;
  if (c >= 'A' && c <= 'Z') return 0.7;
  return 0.63;
}

// The length of the first letter of a text: a script or a character of UTF-8.
std::size_t letter_length(std::string_view text) {
  if ((text[0] == '_' || text[0] == '^') && text.substr(1, 1) == "{") {
    if (const std::size_t end = text.find('}'); end != std::string_view::npos) return end + 1;
  }
  std::size_t length = 1;
  while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) ++length;
  return length;
}

// The longest beginning of a text that is not wider, at least one letter.
std::string_view fitting_beginning(std::string_view text, double size, double width) {
  std::size_t end = 0;
  for (double so_far = 0; end < text.size();) {
    const std::size_t length = letter_length(text.substr(end));
    so_far += text_width(text.substr(end, length), size);
    if (end > 0 && so_far > width) break;
    end += length;
  }
  return text.substr(0, end);
}

}  // namespace

double hundredth(double value) {
  return std::round(100 * value) / 100 + 0.0;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : detail::as_utf8(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:  // XML has no control characters
        result += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return result;
}

double text_width(std::string_view text, double size) {
  double width = 0;
  for (const TextRun& run : runs_of(text)) {
    for (const char c : run.text) width += letter_width(c) * size * (run.shift == 0 ? 1 : script_scale);
  }
  return width;
}

std::vector<std::string> wrapped(std::string_view text, double size, double width, std::size_t max_lines) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::string_view line = fitting_beginning(text, size, width);
    const bool is_rest = line.size() == text.size();
    if (lines.size() + 1 == max_lines && !is_rest) {
      line = fitting_beginning(text, size, width - text_width(ellipsis, size));
      lines.push_back(std::string(line) + std::string(ellipsis));
      break;
    }
    const std::size_t blank = is_rest || text[line.size()] == ' ' ? std::string_view::npos : line.rfind(' ');
    if (blank != std::string_view::npos && blank > 0) line = line.substr(0, blank);
    text.remove_prefix(line.size());
    while (text.starts_with(' ')) text.remove_prefix(1);
    if (!line.empty()) lines.emplace_back(line);
  }
  return lines;
}

std::string_view whole_of_cut(const std::vector<std::string>& lines, std::string_view text) {
  return !lines.empty() && lines.back().ends_with(ellipsis) && !text.ends_with(ellipsis) ? text : std::string_view();
}

void add_text(std::string& svg, double x, double y, std::string_view text, const TextStyle& style) {
  append_all(svg, "<text");
  if (style.upward) {
    append_all(svg, " transform=\"translate(", hundredth(x), " ", hundredth(y), ") rotate(-90)\"");
  } else {
    append_all(svg, " x=\"", hundredth(x), "\" y=\"", hundredth(y), "\"");
  }
  append_all(svg, " font-size=\"", style.size, "\"");
  if (std::string_view(style.anchor) != "start") append_all(svg, " text-anchor=\"", style.anchor, "\"");
  if (std::string_view(style.colour) != "#222222") append_all(svg, " fill=\"", style.colour, "\"");
  if (style.halo) {
    svg +=
        " stroke=\"#ffffff\" stroke-width=\"1.2\" stroke-opacity=\"0.85\" stroke-linejoin=\"round\" "
        "paint-order=\"stroke\"";
  }
  svg += ">";
  if (!style.whole.empty()) append_all(svg, "<title>", escaped(style.whole), "</title>");
  double level = 0;
  for (const TextRun& run : runs_of(text)) {
    if (run.text.empty()) continue;
    const double wanted = run.shift < 0 ? 0.25 * style.size : run.shift > 0 ? -0.38 * style.size : 0;
    if (run.shift == 0 && wanted == level) {
      svg += escaped(run.text);
      continue;
    }
    append_all(svg, "<tspan dy=\"", hundredth(wanted - level), "\"");
    if (run.shift != 0) append_all(svg, " font-size=\"", hundredth(script_scale * style.size), "\"");
    append_all(svg, ">", escaped(run.text), "</tspan>");
    level = wanted;
  }
  svg += "</text>\n";
}

}  // namespace lober::cli
