// The gallery (docs/gallery/pictures.txt): each kind of picture as the pixels of a reference, and a proof that the
// comparison sees each part of it. LOBER_WRITE_GALLERY=1 writes the references anew.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "cli/picture/conversion.hpp"
#include "cli/program/commands.hpp"
#include "tests/cli/pixels.hpp"
#include "tests/cli/program.hpp"
#include "tests/paths.hpp"

namespace lober::cli {
namespace {

constexpr double picture_width = 85 / 25.4 * 72;         // points of print
constexpr double resolution = 400 / picture_width * 72;  // so that the width is 400 pixels
// Squares that may differ: another version of a library may smooth an edge in another way.
constexpr std::size_t max_squares = 1;
constexpr std::size_t visible_pixels = 16;
constexpr std::size_t max_removed_layers = 25;

struct GalleryPicture {
  std::string name;
  std::vector<std::string> command;
  std::vector<std::vector<std::string>> before;  // commands that make the files that it reads
};

void PrintTo(const GalleryPicture& picture, std::ostream* stream) {
  *stream << picture.name;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

// The words of a command of the list; what it reads from examples/ is in the sources.
std::vector<std::string> words_of(const std::string& text, const std::string& file) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) {
    if (word.starts_with("@")) word.erase(0, 1);
    words.push_back(word.starts_with("examples/") ? std::string(LOBER_SOURCE_DIR) + "/" + word : word);
  }
  words.push_back(file);
  return words;
}

const std::vector<GalleryPicture>& gallery() {
  static const std::vector<GalleryPicture> pictures = [] {
    std::vector<GalleryPicture> list;
    std::vector<std::vector<std::string>> before;
    std::ifstream file(std::string(LOBER_SOURCE_DIR) + "/docs/gallery/pictures.txt");
    for (std::string line; std::getline(file, line);) {
      const std::size_t first = line.find('|'), second = line.find('|', first + 1);
      if (line.starts_with('#') || line.starts_with('|') || second == std::string::npos) continue;
      const std::string name = trimmed(line.substr(0, first)), command = trimmed(line.substr(second + 1));
      if (name.find('.') != std::string::npos) {
        before.push_back(words_of(command, name));
      } else {
        list.push_back({name, words_of(command, name + ".svg"), before});
      }
    }
    return list;
  }();
  return pictures;
}

std::string reference_path(const std::string& name) {
  return std::string(LOBER_SOURCE_DIR) + "/tests/cli/gallery/" + name + ".png";
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Pixels drawn(const std::string& svg) {
  return pixels_of_png(png_of(svg, resolution));
}

// A text in the font of all pictures: references are those of one font.
Pixels font_sample() {
  return drawn(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"85mm\" height=\"10mm\" viewBox=\"0 0 241 28\" "
      "font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\">"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>"
      "<text x=\"4\" y=\"18\" font-size=\"8\">stable manifold, area 0.123456789</text></svg>");
}

bool is_writing() {
  return std::getenv("LOBER_WRITE_GALLERY") != nullptr;
}

void write_reference(const std::string& name, const Pixels& pixels) {
  std::ofstream(reference_path(name), std::ios::binary) << small_png_of(pixels);
}

// A part of a picture that one can do without: its lines, and whether it has to be seen in any case.
struct Part {
  std::string what;
  std::size_t begin, end;
  bool is_essential;
};

std::vector<std::string> svg_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<Part> parts_of_picture(const std::vector<std::string>& lines) {
  std::vector<Part> parts, layers;
  bool in_layers = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string& line = lines[k];
    if (line.starts_with("<g clip-path")) in_layers = true;
    if (line.starts_with("</g></g>")) in_layers = false;
    if (line.starts_with("<g transform=\"translate(")) {
      std::size_t end = k;
      while (!lines[end].ends_with("</g>")) ++end;
      parts.push_back({"legend", k, end + 1, true});
      k = end;
    } else if (line.starts_with("<path") || line.starts_with("<circle") || line.starts_with("<text")) {
      const bool is_guide = line.find("stroke-width=\"0.35\"") != std::string::npos;  // to be seen when looked for
      if (is_guide) continue;
      if (in_layers) {
        layers.push_back({"layer", k, k + 1, false});
      } else {
        const bool is_axes = line.starts_with("<path fill=\"none\" stroke=\"#222222\" stroke-width=\"0.5\" d=\"M");
        const bool is_name =
            line.find("font-size=\"8\"") != std::string::npos && line.find("stroke") == std::string::npos;
        parts.push_back({is_axes   ? "axes"
                         : is_name ? "title or name of an axis"
                                   : "text",
                         k, k + 1, is_axes || is_name});
      }
    }
  }
  // All lines and fills, and some of many dots.
  const std::size_t every = 1 + layers.size() / max_removed_layers;
  for (std::size_t k = 0; k < layers.size(); k += every) parts.push_back(layers[k]);
  return parts;
}

class Gallery : public ProgramTest, public testing::WithParamInterface<GalleryPicture> {};

TEST_P(Gallery, LooksLikeItsReferenceAndOnlyWhole) {
  const GalleryPicture& picture = GetParam();
  if (const std::string reason = reason_no_conversion(); !reason.empty()) GTEST_SKIP() << reason;
  for (const auto& command : picture.before) {
    const bool is_read =
        std::find(picture.command.begin(), picture.command.end(), command.back()) != picture.command.end();
    if (!is_read) continue;
    ASSERT_EQ(run(command).status, 0);
  }
  const Outcome outcome = run(picture.command);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string svg = read(picture.name + ".svg");
  const Pixels whole = drawn(svg);
  if (is_writing()) {
    write_reference(picture.name, whole);
    write_reference("font", font_sample());
  }
  if (const std::size_t squares = differing_squares(font_sample(), pixels_of_png(bytes_of(reference_path("font"))));
      squares > max_squares) {
    GTEST_SKIP() << "the font of pictures is not the one of the references (fonts-urw-base35): " << squares
                 << " squares differ";
  }
  const Pixels reference = pixels_of_png(bytes_of(reference_path(picture.name)));
  const std::size_t squares = differing_squares(whole, reference);
  ASSERT_LE(squares, max_squares) << picture.name << " does not look like " << reference_path(picture.name);
  // Without one of its parts it does not pass.
  const std::vector<std::string> lines = svg_lines(svg);
  std::size_t seen = 0;
  for (const Part& part : parts_of_picture(lines)) {
    std::string rest;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (k < part.begin || k >= part.end) rest += lines[k] + "\n";
    }
    const Pixels without = drawn(rest);
    if (!part.is_essential && differing_pixels(whole, without) < visible_pixels) continue;
    EXPECT_GT(differing_squares(without, reference), max_squares)
        << picture.name << " passes without a " << part.what << ": " << lines[part.begin].substr(0, 200);
    ++seen;
  }
  EXPECT_GE(seen, 6U) << "a picture has a title, axes with names, a legend and layers";
}

INSTANTIATE_TEST_SUITE_P(Pictures, Gallery, testing::ValuesIn(gallery()), [](const auto& one) {
  std::string name = one.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(GalleryList, HasEachCommandThatDraws) {
  ASSERT_FALSE(gallery().empty());
  for (const Command& command : all_commands()) {
    for (const CommandDescription& form : forms_of(command)) {
      const bool draws = std::any_of(form.options.begin(), form.options.end(), [](const OptionDescription& option) {
        return std::find(option.names.begin(), option.names.end(), "--picture") != option.names.end();
      });
      if (!draws) continue;
      const bool is_listed = std::any_of(gallery().begin(), gallery().end(), [&](const GalleryPicture& picture) {
        const std::string begin = "lober " + picture.command[0];
        return form.name == begin || form.name == begin + " " + picture.command[1] ||
               form.name.starts_with(begin + " ");
      });
      EXPECT_TRUE(is_listed) << form.name << " draws pictures and is not in docs/gallery/pictures.txt";
    }
  }
}

}  // namespace
}  // namespace lober::cli
