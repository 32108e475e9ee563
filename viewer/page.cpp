#include "viewer/page.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/append_text.hpp"
#include "engine/base/utf8.hpp"
#include "lober/base/version.hpp"
#include "lober/curve/files.hpp"
#include "viewer/base64.hpp"
#include "viewer/embedded.hpp"
#include "viewer/page_data.hpp"
#include "viewer/palette.hpp"

namespace lober::viewer {
namespace {

using detail::append_all;

// The form in which a content security policy names a script or a style.
std::string hash_source(std::string_view text) {
  const std::string digits = sha256(std::as_bytes(std::span(text)));
  std::string bytes;
  for (std::size_t k = 0; k + 1 < digits.size(); k += 2) {
    bytes += static_cast<char>(std::stoi(digits.substr(k, 2), nullptr, 16));
  }
  return "'sha256-" + base64(bytes) + "'";
}

std::string escaped_html(std::string_view text) {
  std::string html;
  for (const char c : detail::as_utf8(text)) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        if (c != '\0') html += c;
    }
  }
  return html;
}

// The template, each {{name}} in it replaced once; a text that is put in is not looked at again.
std::string filled(std::string_view form, const std::vector<std::pair<std::string_view, std::string_view>>& parts) {
  std::string html;
  while (true) {
    const std::size_t begin = form.find("{{");
    if (begin == std::string_view::npos) break;
    const std::size_t end = form.find("}}", begin);
    const std::string_view name = form.substr(begin + 2, end - begin - 2);
    html += form.substr(0, begin);
    for (const auto& [part, text] : parts) {
      if (part == name) html += text;
    }
    form.remove_prefix(end + 2);
  }
  return html += form;
}

std::string page_with(std::string_view form, const std::string& title, std::string_view script, std::string_view data) {
  // Nothing is loaded, and no script or style runs but these two.
  const std::string policy = "default-src 'none'; script-src " + hash_source(script) + "; style-src " +
                             hash_source(page_style) + "; img-src data: blob:; base-uri 'none'; form-action 'none'";
  return filled(form, {{"title", escaped_html(title)},
                       {"policy", policy},
                       {"version", version()},
                       {"style", page_style},
                       {"data", data},
                       {"script", script}});
}

}  // namespace

std::string page_of(const Scene& scene) {
  const PageData data = page_data(scene, max_exact_size);
  std::string text = "<script type=\"application/json\" id=\"scene\">" + data.json + "</script>\n";
  for (std::size_t k = 0; k < data.series.size(); ++k) {
    append_all(text, "<script type=\"text/plain\" id=\"s", k, "\">", data.series[k], "</script>\n");
  }
  return page_with(page_html, scene.title, page_script, text);
}

void write_page(const std::string& path, const Scene& scene) {
  write_file(path, page_of(scene));
}

std::string batch_page_of(const std::string& title, std::string_view json) {
  std::string text(json);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  std::string colours;
  for (const auto& [red, green, blue] : palette::heat) {
    append_all(colours, colours.empty() ? "[" : ",[", red, ",", green, ",", blue, "]");
  }
  return page_with(batch_html, title, batch_script,
                   "<script type=\"application/json\" id=\"batch\">" + text + "</script>\n" +
                       "<script type=\"application/json\" id=\"heat\">[" + colours + "]</script>\n");
}

}  // namespace lober::viewer
