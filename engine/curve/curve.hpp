// Curves: what they are, whether they can be used, and how they come from and go to files.
//
// A curve is an ordered list of vertices joined by straight segments; segment k joins vertex k to vertex
// k + 1. A closed curve has one more segment, from its last vertex to its first. Consecutive equal vertices
// are legal and carry no segment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/error.hpp"
#include "kernels/point.hpp"

namespace lober {

/// One straight piece of a curve, from a to b.
struct Segment {
  Point a, b;
};

/// A curve that somebody else owns. Cheap to copy; valid as long as the points are.
struct CurveView {
  std::span<const Point> points;
  bool closed = true;

  [[nodiscard]] std::size_t segments() const {
    return closed ? points.size() : (points.empty() ? 0 : points.size() - 1);
  }
  /// Segment k < segments().
  [[nodiscard]] Segment segment(std::size_t k) const { return {points[k], points[k + 1 == points.size() ? 0 : k + 1]}; }
};

/// A curve that owns its points. `name` is the zone title or the file it came from.
struct Curve {
  std::vector<Point> points;
  bool closed = true;
  std::string name;

  operator CurveView() const { return {points, closed}; }  // NOLINT(google-explicit-constructor)
};

enum class Orientation : std::int8_t { clockwise = -1, degenerate = 0, counter_clockwise = 1 };

/// Signed area of a closed curve (an open one is closed by its chord), positive for counter-clockwise:
/// 1/2 sum (x_i y_{i+1} - x_{i+1} y_i), DESIGN section 2. Correct to 2^-52 relative to |area| + 2^-95 times
/// the square of the curve's diameter. O(N), parallel; the same bits for any number of threads.
[[nodiscard]] double signed_area(CurveView curve);

/// Throws DataError unless the curve can be used: every coordinate finite, at least three distinct vertices
/// when closed and two when open, fewer than 2^31 vertices. `name` begins the message. O(N).
void validate(CurveView curve, std::string_view name);

/// The part of `validate` that need not look at every coordinate. O(1), unless the curve begins with repeated vertices.
void require_enough_vertices(CurveView curve, std::string_view name);

// ---------------------------------------------------------------------------------------------- files

enum class Format : std::uint8_t {
  tecplot,  ///< Tecplot ASCII: VARIABLES, TITLE, ZONE lines, then one point a line
  text,     ///< two columns separated by commas, semicolons, blanks or tabs; a header line is allowed
  npy,      ///< NumPy: N x 2 or 2 x N, float64 or float32 of either byte order, C or Fortran order
  raw,      ///< native float64 pairs, nothing else
};
[[nodiscard]] std::string_view name(Format format);

/// One zone of a file. Formats without zones have exactly one.
struct Zone {
  std::string title;
  std::vector<Point> points;
  std::size_t line = 1;  ///< where it starts in a text file, counted from 1
};

struct CurveFile {
  std::string path;
  Format format = Format::text;
  std::string sha256;  ///< of the whole file, lower-case hexadecimal
  std::vector<Zone> zones;
};

struct ReadOptions {
  bool hash = true;  ///< compute `sha256`; reading is faster without
};

/// Reads every zone of a file. The format is chosen by the content, never by the name. The file is
/// memory-mapped and text is parsed in parallel. Throws DataError "path:line: what is wrong" for a file that
/// is missing, unreadable, empty, has a zone without points, a line that is not two finite numbers, a column
/// count other than two, a declared count (I=, N=) that contradicts the points, or a truncated binary file.
/// What has no lines (a missing file, a binary one) is named by "path: what is wrong". A pipe is read to its
/// end;
/// "-" is standard input.
[[nodiscard]] CurveFile read_curve_file(const std::string& path, const ReadOptions& options = {});

/// A curve named on a command line: `FILE`, or `FILE#K` for zone K counted from 0, or `FILE#TITLE`. (A file
/// whose name really contains '#' is found first.) Closed curves lose a last vertex that repeats the first.
struct NamedCurve {
  Curve curve;
  std::string file;    ///< the path without the zone
  std::string sha256;  ///< of the whole file
  std::size_t zone = 0;
  std::size_t zones = 1;  ///< how many the file has
  std::string remark;     ///< on how a curve was closed (closing_remark); empty nearly always
};

/// Reads one curve and validates it. Throws DataError as `read_curve_file` and `validate` do, and when the
/// file has several zones and none is chosen, or the chosen one is not there.
[[nodiscard]] NamedCurve read_curve(const std::string& spec, bool closed, const ReadOptions& options = {});

/// Drops a last vertex that repeats the first (several, if several do).
void drop_closing_vertex(std::vector<Point>& points);

/// Writers. Numbers are written in the shortest form that reads back to the same bits. The file appears under
/// its name only when it is complete (written beside it, then renamed); on failure an existing file is left
/// as it was. What is no regular file (a pipe, /dev/stdout, "-" for standard output) is written straight
/// through. Throw DataError when the file cannot be written or a coordinate is not finite.
///
/// Raw float64 bears no mark: coordinates whose bytes all happen to be printable characters would be read as
/// text. Numbers of few digits never are, their low bytes being zero.
///
/// A single zone without a title needs no ZONE line in a Tecplot file.
enum class ZoneLines : std::uint8_t { where_needed, always };
void write_tecplot(const std::string& path, std::span<const Zone> zones, ZoneLines lines = ZoneLines::where_needed);
void write_text(const std::string& path, std::span<const Point> points, char separator = ' ');
void write_npy(const std::string& path, std::span<const Point> points);
void write_raw(const std::string& path, std::span<const Point> points);

/// Writes `content` the same way: complete under its name, or not at all.
void write_file(const std::string& path, std::string_view content);

/// SHA-256 (FIPS 180-4) of bytes in memory, lower-case hexadecimal.
[[nodiscard]] std::string sha256(std::span<const std::byte> bytes);

}  // namespace lober
