#include "engine/files/foreign.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/files/head.hpp"

namespace lober::detail {
namespace {

constexpr std::string_view as_npy = "save its points as NPY, an N x 2 array";
constexpr std::string_view unpack = "unpack it first";
constexpr std::string_view as_points = "it holds no list of points";

/// A file that begins with these bytes.
struct Magic {
  std::string_view bytes;
  std::string_view what;
  std::string_view remedy;
};
using namespace std::string_view_literals;  // some hold zero bytes
constexpr std::string_view from_parquet = "in Python pandas and DataFrame.to_csv";
constexpr std::array magics{
    Magic{"Octave-1-L"sv, "an Octave binary file", "in Octave dlmwrite('points.txt', [x(:) y(:)], 'precision', 17)"},
    Magic{"GRIB"sv, "a GRIB file", as_npy},
    Magic{"PAR1"sv, "a Parquet file", from_parquet},
    Magic{"ARROW1"sv, "an Arrow file", from_parquet},
    Magic{"FEA1"sv, "a Feather file", from_parquet},
    Magic{"BZh"sv, "compressed by bzip2", "bunzip2 it first"},
    Magic{"\xFD"
          "7zXZ\0"sv,
          "compressed by xz", "unxz it first"},
    Magic{"\x28\xB5\x2F\xFD"sv, "compressed by zstd", "unzstd it first"},
    Magic{"7z\xBC\xAF\x27\x1C"sv, "a 7z archive", unpack},
    Magic{"Rar!\x1A\x07"sv, "a RAR archive", unpack},
    Magic{"\x89PNG\r\n\x1A\n"sv, "a PNG picture", as_points},
    Magic{"\xFF\xD8\xFF"sv, "a JPEG picture", as_points},
    Magic{"GIF8"sv, "a GIF picture", as_points},
    Magic{"II*\0"sv, "a TIFF picture", as_points},
    Magic{"MM\0*"sv, "a TIFF picture", as_points},
    Magic{"%PDF-"sv, "a PDF document", as_points},
    Magic{"%!PS"sv, "a PostScript document", as_points},
    Magic{"SQLite format 3\0"sv, "an SQLite database",
          "if it is the store of a batch, lober batch export makes tables of it"},
    Magic{"\x7F"
          "ELF"sv,
          "a program or a library", as_points},
    Magic{"#!TDV"sv, "a binary Tecplot file", "write it from Tecplot as ASCII, point data"},
    Magic{"#!SZPLT"sv, "a binary Tecplot file", "write it from Tecplot as ASCII, point data"},
    Magic{"# vtk DataFile"sv, "a VTK file", "write its points as two columns of text"},
};

std::string sentence(std::string_view what, std::string_view remedy) {
  return std::string(what) + ", which is not read: " + std::string(remedy);
}

/// A zip archive is named by its first member.
std::string zip_format(std::string_view bytes) {
  constexpr std::size_t name_size_at = 26, name_at = 30;
  const std::size_t name_size = number_at(bytes, name_size_at) & 0xFFFF;
  const std::string_view name = bytes.substr(std::min(name_at, bytes.size()), name_size);
  if (name == "[Content_Types].xml" || name.starts_with("xl/")) {
    return sentence("an Excel or Office document", "save its columns as CSV");
  }
  return sentence("a zip archive", unpack);
}

/// Unformatted Fortran: each record between two copies of its length.
bool is_fortran_records(std::string_view bytes) {
  const std::size_t length = number_at(bytes, 0);
  const std::size_t both_marks = 2 * sizeof(std::uint32_t);
  return length > 0 && bytes.size() >= both_marks && length <= bytes.size() - both_marks &&
         number_at(bytes, sizeof(std::uint32_t) + length) == length;
}

/// Every other byte of text in UTF-16 is zero, after a mark.
bool is_utf16(std::string_view bytes) {
  if (!bytes.starts_with("\xFF\xFE") && !bytes.starts_with("\xFE\xFF")) return false;
  const std::size_t first = bytes[0] == '\xFF' ? 3 : 2, end = std::min<std::size_t>(bytes.size(), 64);
  for (std::size_t k = first; k < end; k += 2) {
    if (bytes[k] != '\0') return false;
  }
  return end > first;
}

}  // namespace

std::string foreign_text(std::span<const std::byte> text) {
  const std::string_view first = beginning(text_of(text));
  constexpr std::array<std::string_view, 7> tags{"<?xml", "<!", "<svg", "<html", "<kml", "<gpx", "<VTKFile"};
  if (std::any_of(tags.begin(), tags.end(), [&](std::string_view tag) { return first.starts_with(tag); })) {
    return sentence("XML, HTML or SVG", "write its points as two columns of text");
  }
  return {};
}

std::string foreign_format(std::span<const std::byte> all) {
  const std::string_view bytes = text_of(all);
  for (const Magic& magic : magics) {
    if (bytes.starts_with(magic.bytes)) return sentence(magic.what, magic.remedy);
  }
  constexpr std::size_t tar_mark_at = 257;
  if (bytes.size() > tar_mark_at && bytes.substr(tar_mark_at).starts_with("ustar")) {
    return sentence("a tar archive", "unpack it first, tar xf, and name a file of it");
  }
  if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06")) return zip_format(bytes);
  if (bytes.starts_with("\x80\x04\x95") || bytes.starts_with("\x80\x05\x95")) {
    return sentence("a Python pickle", "save the array by numpy.save, N x 2");
  }
  if (is_fortran_records(bytes)) {
    return sentence("unformatted Fortran records", "write it with access='stream', or as formatted text");
  }
  if (is_utf16(bytes)) return sentence("text in UTF-16", "save it as UTF-8");
  // The first bytes decide, so that large files cost nothing.
  const std::string_view start = bytes.substr(0, std::size_t{1} << 16);
  const bool plain = std::all_of(start.begin(), start.end(), [](char letter) {
    return (letter >= ' ' && letter <= '~') || letter == '\t' || letter == '\r';
  });
  if (plain && start.find('\r') != std::string_view::npos) {
    return sentence("text whose lines end in carriage returns alone", "save it with lines that end in line feeds");
  }
  return {};
}

}  // namespace lober::detail
