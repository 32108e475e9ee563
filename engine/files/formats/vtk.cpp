// VTK's XML file of polydata (.vtp), which ParaView opens: closed curves are polygons, open ones lines. Their numbers
// are data of cells.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

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

}  // namespace

std::string vtk_bytes(std::span<const Zone> zones, const WriteOptions& options) {
  std::vector<double> points;
  std::vector<std::int64_t> connectivity, offsets, curve, hole;
  std::vector<std::string> titles;
  for (const Zone& zone : zones) {
    for (const Point& point : zone.points) {
      connectivity.push_back(static_cast<std::int64_t>(connectivity.size()));
      points.insert(points.end(), {point.x, point.y, 0.0});
    }
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    curve.push_back(static_cast<std::int64_t>(curve.size()));
    hole.push_back(zone.hole ? 1 : 0);
    titles.push_back(as_utf8(zone.title));
  }
  const auto count = [](const auto& list) { return std::to_string(list.size()); };
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  if (!options.provenance.empty()) {
    text += "<FieldData>\n";
    append_texts(text, "provenance", {provenance_text(options)});
    text += "</FieldData>\n";
  }
  const std::string lines = options.closed ? "0" : count(zones), polygons = options.closed ? count(zones) : "0";
  text += "<Piece NumberOfPoints=\"" + count(connectivity) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" + lines +
          "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + polygons + "\">\n<CellData>\n";
  append_array(text, "Int64", "curve", curve);
  append_array(text, "Int64", "hole", hole);
  append_texts(text, "title", titles);
  for (const std::string& name : names_of_numbers(zones)) {
    append_array(text, "Float64", name, numbers_called(name, zones));
  }
  text += "</CellData>\n<Points>\n";
  append_array(text, "Float64", "points", points, 3);
  text += options.closed ? "</Points>\n<Polys>\n" : "</Points>\n<Lines>\n";
  append_array(text, "Int64", "connectivity", connectivity);
  append_array(text, "Int64", "offsets", offsets);
  text += options.closed ? "</Polys>\n" : "</Lines>\n";
  return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace lober::detail
