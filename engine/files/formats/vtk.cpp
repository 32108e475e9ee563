// VTK's XML file of polydata (.vtp), which ParaView opens: closed curves are polygons, open ones lines. Their numbers
// are data of cells.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <numeric>

#include "engine/base/text.hpp"
#include "engine/base/utf8.hpp"
#include "engine/files/formats/provenance.hpp"
#include "engine/files/formats/readers.hpp"

namespace lober::detail {
namespace {

static_assert(std::endian::native == std::endian::little, "the head of the file says so");

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t bits = 0;
    const std::size_t present = std::min<std::size_t>(3, bytes.size() - k);
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8 | (i < present ? static_cast<unsigned char>(bytes[k + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += i <= present ? digits[bits >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

std::string xml_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&' || c == '<' || c == '>' || c == '"') {
      escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&quot;";
    } else {
      escaped += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? ' ' : c;
    }
  }
  return escaped;
}

// The numbers of an array in the file: their length in bytes, then themselves.
template <typename T>
void append_array(std::string& text, std::string_view type, std::string_view name, const std::vector<T>& numbers,
                  int components = 1) {
  const std::uint64_t length = numbers.size() * sizeof(T);
  std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
  bytes.append(reinterpret_cast<const char*>(numbers.data()), length);
  text += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + xml_text(name) + "\" NumberOfComponents=\"" +
          std::to_string(components) + "\" format=\"binary\">" + base64(bytes) + "</DataArray>\n";
}

// Texts are their bytes, each text with a zero behind it.
void append_texts(std::string& text, std::string_view name, const std::vector<std::string>& texts) {
  text += "<Array type=\"String\" Name=\"" + xml_text(name) + "\" NumberOfTuples=\"" + std::to_string(texts.size()) +
          "\" format=\"ascii\">";
  for (const std::string& one : texts) {
    for (const char c : one) text += std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + ' ';
    text += "0 ";
  }
  text += "</Array>\n";
}

// The points of cells of one kind, one cell after the other, and where each cell ends.
struct CellPoints {
  std::vector<std::int64_t> connectivity, offsets;
};

void append_cells(std::string& text, const std::string& kind, const CellPoints& cells) {
  if (cells.offsets.empty()) return;
  text += "<" + kind + ">\n";
  append_array(text, "Int64", "connectivity", cells.connectivity);
  append_array(text, "Int64", "offsets", cells.offsets);
  text += "</" + kind + ">\n";
}

}  // namespace

std::string vtk_bytes(std::span<const Zone> zones, const WriteOptions& options) {
  // All lines are before all polygons, in the data of cells too.
  std::vector<std::size_t> cells(zones.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  const auto first_polygon =
      std::stable_partition(cells.begin(), cells.end(), [&](std::size_t k) { return !is_closed(zones[k], options); });
  const auto lines = static_cast<std::size_t>(first_polygon - cells.begin());
  std::vector<double> points;
  std::vector<std::int64_t> curve, hole;
  std::vector<std::string> titles;
  CellPoints of_lines, of_polygons;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Zone& zone = zones[cells[k]];
    CellPoints& kind = k < lines ? of_lines : of_polygons;
    for (const Point& point : zone.points) {
      kind.connectivity.push_back(static_cast<std::int64_t>(points.size() / 3));
      points.insert(points.end(), {point.x, point.y, 0.0});
    }
    kind.offsets.push_back(static_cast<std::int64_t>(kind.connectivity.size()));
    curve.push_back(static_cast<std::int64_t>(cells[k]));
    hole.push_back(zone.hole ? 1 : 0);
    titles.push_back(as_utf8(zone.title));
  }
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  if (!options.provenance.empty()) {
    text += "<FieldData>\n";
    append_texts(text, "provenance", {provenance_text(options)});
    text += "</FieldData>\n";
  }
  text += "<Piece NumberOfPoints=\"" + std::to_string(points.size() / 3) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
          std::to_string(lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(cells.size() - lines) +
          "\">\n<CellData>\n";
  append_array(text, "Int64", "curve", curve);
  append_array(text, "Int64", "hole", hole);
  append_texts(text, "title", titles);
  for (const std::string& name : names_of_numbers(zones)) {
    const std::vector<double> by_zone = numbers_called(name, zones);
    std::vector<double> by_cell;
    by_cell.reserve(cells.size());
    for (const std::size_t zone : cells) by_cell.push_back(by_zone[zone]);
    append_array(text, "Float64", name, by_cell);
  }
  text += "</CellData>\n<Points>\n";
  append_array(text, "Float64", "points", points, 3);
  text += "</Points>\n";
  append_cells(text, "Lines", of_lines);
  append_cells(text, "Polys", of_polygons);
  return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace lober::detail
