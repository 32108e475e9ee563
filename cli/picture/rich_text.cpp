#include "cli/picture/rich_text.hpp"

#include <cmath>

#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr double script_scale = 0.72;

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

}  // namespace

double hundredth(double value) {
  return std::round(100 * value) / 100 + 0.0;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
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

std::vector<std::string> wrapped(std::string_view text, double size, double width) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t blank = text.find(' ');
    const std::string word(text.substr(0, blank));
    text.remove_prefix(blank == std::string_view::npos ? text.size() : blank + 1);
    if (!line.empty() && text_width(line + " " + word, size) > width) {
      lines.push_back(std::move(line));
      line = word;
      continue;
    }
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
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
