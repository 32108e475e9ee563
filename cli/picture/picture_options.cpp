#include "cli/picture/picture_options.hpp"

#include <algorithm>
#include <cmath>

#include "cli/picture/conversion.hpp"
#include "cli/picture/figure_data.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/picture/view.hpp"
#include "cli/program/log.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/running.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/drawing.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_named = 30;
constexpr double png_resolution = 400;  // pixels an inch

Rectangle corners(const char* option, const std::vector<double>& values) {
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
    throw UsageError(std::string(option) + ": the corners have to be finite");
  }
  if (!(values[0] < values[2] && values[1] < values[3])) {
    throw UsageError(std::string(option) + ": the corners have to have X0 < X1 and Y0 < Y1");
  }
  return Rectangle::of({values[0], values[1]}, {values[2], values[3]});
}

std::string corners_text(const Rectangle& box) {
  return rounded(box.min_x) + "," + rounded(box.min_y) + "," + rounded(box.max_x) + "," + rounded(box.max_y);
}

bool are_apart(const Rectangle& a, const Rectangle& b) {
  return a.min_x >= b.max_x || a.max_x <= b.min_x || a.min_y >= b.max_y || a.max_y <= b.min_y;
}

// The error of an inset, which magnifies a part of the window, unless it lies in there.
std::string inset_error(const Rectangle& inset, const Rectangle& window) {
  const auto is_in = [](const Rectangle& inner, const Rectangle& outer) {
    return inner.min_x >= outer.min_x && inner.max_x <= outer.max_x && inner.min_y >= outer.min_y &&
           inner.max_y <= outer.max_y;
  };
  if (is_in(inset, widened(window, 1e-4))) return {};  // messages name corners with six digits
  const bool apart = are_apart(inset, window);
  return "--inset " + corners_text(inset) + (apart ? " lies outside of" : " reaches beyond") +
         " the part of the plane that the picture shows, " + corners_text(window) +
         "; give corners inside of it, or another --window";
}

}  // namespace

std::vector<Output> PictureRequest::outputs() const {
  const FigureStyle asked = style();
  if (asked.window) require_inset_in(*asked.window);
  if (labels && no_labels) throw UsageError("--labels and --no-labels contradict each other; give one of them");
  std::vector<Output> outputs;
  if (!file.empty()) outputs.push_back({"--picture", file});
  if (!data.empty()) outputs.push_back({"--data", data});
  return outputs;
}

void PictureRequest::require_inset_in(const Rectangle& shown) const {
  const FigureStyle asked = style();
  if (!asked.inset) return;
  const std::string error = inset_error(*asked.inset, asked.window.value_or(shown));
  if (!error.empty()) throw UsageError(error);
}

FigureStyle PictureRequest::style() const {
  FigureStyle style;
  if (!window.empty()) style.window = corners("--window", window);
  if (!inset.empty()) style.inset = corners("--inset", inset);
  if (!size.empty()) style.width = size[0];
  if (size.size() > 1) style.height = size[1];
  style.legend = !no_legend;
  style.title = no_title ? "" : title;
  return style;
}

bool PictureRequest::labels_for(std::size_t count) const {
  return labels || (!no_labels && count <= max_named);
}

Option add_further_picture(OptionParser& parser, const char* names, std::string& file, const std::string& what) {
  const std::string help =
      "Draw " + what + " in FILE, as SVG, PDF or PNG by its ending .svg, .pdf or .png (default: no file).";
  return parser.add(names, file, help.c_str()).value("FILE");
}

Option add_picture_options(OptionParser& parser, PictureRequest& request, const std::string& what,
                           const std::string& named_things, const char* names) {
  const Option picture = add_further_picture(parser, names, request.file, what);
  parser
      .add("--data", request.data,
           "Write the points of all that the picture shows to FILE, as comma-separated columns (.csv) or JSON (.json) "
           "(default: no file).")
      .value("FILE");
  parser
      .add("--window", request.window,
           "Two corners of the part of the plane that the picture shows, X0 < X1 and Y0 < Y1 (default: all).")
      .comma_separated()
      .count(4)
      .value("X0,Y0,X1,Y1")
      .needs(picture);
  parser
      .add("--inset", request.inset,
           "Two corners of a part of the plane that the picture shows once more, magnified, where that hides least "
           "(default: none).")
      .comma_separated()
      .count(4)
      .value("X0,Y0,X1,Y1")
      .needs(picture);
  parser
      .add("--size", request.size,
           "The width of the picture in print, and its height, in mm (default: 85, a column of a journal, and the "
           "height that the window asks for).")
      .comma_separated()
      .count(1, 2)
      .range(30.0, 2000.0)
      .value("WIDTH[,HEIGHT]")
      .needs(picture);
  const Option title =
      parser
          .add_call(
              "--title", [&request](const std::string& text) { request.title = text; },
              "The line above the picture, with _{...} for subscripts and ^{...} for superscripts (default: the system "
              "and its parameters, or the curves).")
          .value("TITLE")
          .needs(picture);
  parser.add_flag("--no-title", request.no_title, "Leave out the line above the picture.")
      .needs(picture)
      .excludes(title);
  parser.add_flag("--no-legend", request.no_legend, "Leave out the legend of the picture.").needs(picture);
  if (!named_things.empty()) {
    parser
        .add_flag("--labels", request.labels,
                  ("Name " + named_things +
                   " in the picture, as far as there is room (default: where there are at most 30 lobes or points).")
                      .c_str())
        .needs(picture);
    parser.add_flag("--no-labels", request.no_labels, "Name nothing in the picture.").needs(picture);
  }
  return picture;
}

void write_figure(const std::string& path, const Figure& figure, const FigureStyle& style) {
  const std::string svg = figure_svg(figure, style);
  switch (picture_format(path)) {
    case PictureFormat::svg:
      return write_file(path, svg);
    case PictureFormat::pdf:
      return write_file(path, pdf_of(svg));
    case PictureFormat::png:
      return write_file(path, png_of(svg, png_resolution));
  }
}

void write_figure(const PictureRequest& request, const Figure& figure) {
  const FigureStyle style = request.style();
  bool is_drawn = !request.file.empty();
  if (style.inset && is_drawn) {
    const std::string error = inset_error(*style.inset, drawable_window(style.window.value_or(figure.window)));
    if (!error.empty()) keep_error(error + "; " + request.file + " is not written");
    is_drawn = error.empty();
  }
  if (style.window && are_apart(*style.window, drawable_window(figure.window))) {
    log_warning("--window " + corners_text(*style.window) + " shows nothing; all is in " + corners_text(figure.window));
  }
  if (is_drawn) write_figure(request.file, figure, style);
  if (request.data.empty()) return;
  write_file(request.data, request.data.ends_with(".json") ? figure_json(figure) : figure_csv(figure));
}

}  // namespace lober::cli
