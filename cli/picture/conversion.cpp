#include "cli/picture/conversion.hpp"

#include <cmath>
#include <memory>

#include "engine/files/formats/optional_library.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

using detail::OptionalLibrary;

// The functions are declared here, as their headers come with forty packages: each has been as it is for as long as the
// name of its library, which changes with its binary interface.
constexpr OptionalLibrary rsvg_library("librsvg-2.so.2", "librsvg2-2", "librsvg2-2");
constexpr OptionalLibrary cairo_library("libcairo.so.2", "libcairo2", "libcairo2");
constexpr OptionalLibrary gobject_library("libgobject-2.0.so.0", "libglib2.0-0", "libglib2.0-0");

struct GlibError {
  unsigned domain;
  int code;
  char* message;
};
struct RsvgBox {
  double x, y, width, height;
};
using WriteFunction = int (*)(void* closure, const unsigned char* data, unsigned length);
using NewHandle = void* (*)(const unsigned char* data, std::size_t size, GlibError** error);
using RenderDocument = int (*)(void* handle, void* cairo, const RsvgBox* viewport, GlibError** error);
using SizeInPixels = int (*)(void* handle, double* width, double* height);
using Release = void (*)(void*);
using NewPdf = void* (*)(WriteFunction, void* closure, double width, double height);
using SetMetadata = void (*)(void* surface, int what, const char* text);
using NewImage = void* (*)(int format, int width, int height);
using NewCairo = void* (*)(void* surface);
using GetStatus = int (*)(void*);
using WritePng = int (*)(void* surface, WriteFunction, void* closure);
using StatusText = const char* (*)(int status);

int take(void* closure, const unsigned char* data, unsigned length) noexcept {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return 0;
}

using Held = std::unique_ptr<void, Release>;

Held held(void* thing, const OptionalLibrary& library, const char* release) {
  return {thing, library.function<Release>(release)};
}

void require_success(int status) {
  if (status != 0) {
    throw DataError(std::string("cairo cannot draw the picture: ") +
                    cairo_library.function<StatusText>("cairo_status_to_string")(status));
  }
}

[[noreturn]] void fail(const GlibError* error) {
  throw DataError("librsvg cannot draw the picture: " + std::string(error != nullptr ? error->message : "unknown"));
}

Held read_svg(const std::string& svg) {
  if (const std::string reason = reason_no_conversion(); !reason.empty()) throw DataError(reason);
  GlibError* error = nullptr;
  void* const handle = rsvg_library.function<NewHandle>("rsvg_handle_new_from_data")(
      reinterpret_cast<const unsigned char*>(svg.data()), svg.size(), &error);
  if (handle == nullptr) fail(error);
  return held(handle, gobject_library, "g_object_unref");
}

// Draws on a surface of this size in its own units.
void draw(void* handle, void* surface, double width, double height) {
  const Held cairo = held(cairo_library.function<NewCairo>("cairo_create")(surface), cairo_library, "cairo_destroy");
  GlibError* error = nullptr;
  const RsvgBox viewport{0, 0, width, height};
  if (rsvg_library.function<RenderDocument>("rsvg_handle_render_document")(handle, cairo.get(), &viewport, &error) ==
      0) {
    fail(error);
  }
  require_success(cairo_library.function<GetStatus>("cairo_status")(cairo.get()));
}

struct SvgSize {
  double width, height;  // points of print
};
// A pixel of librsvg is 1/96 inch, as in CSS (set_resolution).
SvgSize size_of(void* handle) {
  SvgSize size{};
  if (rsvg_library.function<SizeInPixels>("rsvg_handle_get_intrinsic_size_in_pixels")(handle, &size.width,
                                                                                      &size.height) == 0) {
    throw DataError("the picture has no size");
  }
  return {size.width * 72 / 96, size.height * 72 / 96};
}

void set_resolution(void* handle) {
  rsvg_library.function<void (*)(void*, double)>("rsvg_handle_set_dpi")(handle, 96);
}

}  // namespace

std::string reason_no_conversion() {
  for (const OptionalLibrary* library : {&rsvg_library, &cairo_library, &gobject_library}) {
    if (std::string reason = library->reason_it_is_missing(); !reason.empty()) return reason;
  }
  return {};
}

std::string pdf_of(const std::string& svg) {
  const Held handle = read_svg(svg);
  set_resolution(handle.get());
  const SvgSize size = size_of(handle.get());
  std::string bytes;
  const Held surface = held(
      cairo_library.function<NewPdf>("cairo_pdf_surface_create_for_stream")(&take, &bytes, size.width, size.height),
      cairo_library, "cairo_surface_destroy");
  constexpr int create_date = 5;  // CAIRO_PDF_METADATA_CREATE_DATE
  // The same picture has the same bytes, so not the time of day.
  cairo_library.function<SetMetadata>("cairo_pdf_surface_set_metadata")(surface.get(), create_date,
                                                                        "1970-01-01T00:00:00Z");
  draw(handle.get(), surface.get(), size.width, size.height);
  cairo_library.function<Release>("cairo_surface_finish")(surface.get());
  require_success(cairo_library.function<GetStatus>("cairo_surface_status")(surface.get()));
  return bytes;
}

std::string png_of(const std::string& svg, double resolution) {
  const Held handle = read_svg(svg);
  set_resolution(handle.get());
  const SvgSize size = size_of(handle.get());
  const auto pixels = [&](double points) { return static_cast<int>(std::lround(points * resolution / 72)); };
  const int width = pixels(size.width), height = pixels(size.height);
  const Held surface = held(cairo_library.function<NewImage>("cairo_image_surface_create")(0, width, height),
                            cairo_library, "cairo_surface_destroy");
  require_success(cairo_library.function<GetStatus>("cairo_surface_status")(surface.get()));
  draw(handle.get(), surface.get(), width, height);
  std::string bytes;
  require_success(cairo_library.function<WritePng>("cairo_surface_write_to_png_stream")(surface.get(), &take, &bytes));
  return bytes;
}

}  // namespace lober::cli
