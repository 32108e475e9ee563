// The options of pictures, and pictures of extreme windows.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "cli/picture/conversion.hpp"
#include "cli/picture/figure_svg.hpp"
#include "cli/picture/panels.hpp"
#include "cli/picture/rich_text.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/picture/ticks.hpp"
#include "tests/cli/program.hpp"
#include "tests/paths.hpp"

namespace lober::cli {
namespace {

std::string texts(const Ticks& ticks) {
  std::string all;
  for (const Tick& tick : ticks.list) all += tick.text + " ";
  return all + "| " + ticks.offset + " | " + std::to_string(ticks.power);
}

TEST(Ticks, AreRoundAndTellNumbersApart) {
  EXPECT_EQ(texts(ticks_between(-1, 1, 4)), "\u22121.0 \u22120.5 0.0 0.5 1.0 |  | 0");
  EXPECT_EQ(texts(ticks_between(1, 4, 8, true)), "1 2 3 4 |  | 0");
  const Ticks far = ticks_between(1e6, 1e6 + 1e-6, 4);
  EXPECT_EQ(far.offset, "\u2212 1000000");
  EXPECT_EQ(far.power, -6);
  ASSERT_GE(far.list.size(), 3U);
  EXPECT_NE(far.list[0].text, far.list[1].text);
}

// The largest number in a picture, which browsers keep in 32 bits.
double largest_number(const std::string& svg) {
  double largest = 0;
  for (std::size_t at = svg.find(" d=\""); at != std::string::npos; at = svg.find(" d=\"", at + 1)) {
    const std::size_t end = svg.find('"', at + 4);
    for (std::size_t k = at + 4; k < end;) {
      char* after = nullptr;
      const double value = std::strtod(svg.c_str() + k, &after);
      const auto next = static_cast<std::size_t>(after - svg.c_str());
      largest = std::max(largest, next > k ? std::fabs(value) : 0);
      k = std::max(next, k + 1);
    }
  }
  return largest;
}

TEST(FigureSvg, HasSmallCoordinatesInAnyWindow) {
  for (const double scale : {1e-300, 1e-12, 1.0, 1e12, 1e300}) {
    Figure figure;
    figure.layers.push_back(line_layer("line", "", palette::ink));
    // Through the middle of the window, from far beyond it.
    figure.layers.back().lines.push_back({.own = {{-1e6 * scale, -1e6 * scale}, {1e6 * scale, 1e6 * scale}}});
    figure.window = {-scale, -scale, scale, scale};
    const std::string svg = figure_svg(figure, {});
    EXPECT_LT(largest_number(svg), 40'000) << scale;
    EXPECT_NE(svg.find("stroke-width=\"24\" d=\"M"), std::string::npos) << scale;
    EXPECT_EQ(svg.find("nan"), std::string::npos) << scale;
    EXPECT_EQ(svg.find("inf"), std::string::npos) << scale;
  }
}

TEST(FigureSvg, SaysPowersOfTenAndCategories) {
  Figure figure;
  figure.plane = false;
  figure.x.exponents = true;
  figure.y.categories = {"first", "second", "third"};
  figure.window = {-3, -0.5, 0, 1.5};
  const std::string svg = figure_svg(figure, {});
  EXPECT_NE(svg.find("second"), std::string::npos);
  EXPECT_EQ(svg.find("third"), std::string::npos);  // beyond the window
  EXPECT_NE(svg.find(">10<"), std::string::npos);   // with a superscript behind it
}

// Long texts are set smaller, broken, then cut; none is smaller than can be read or wider than the picture.
TEST(FigureSvg, BreaksAndCutsLongTexts) {
  const auto sizes_at_least = [](const std::string& svg, double least) {
    for (std::size_t at = svg.find("font-size=\""); at != std::string::npos; at = svg.find("font-size=\"", at + 1)) {
      EXPECT_GE(std::stod(svg.substr(at + 11)), least) << svg.substr(at, 100);
    }
  };
  Figure figure;
  figure.title = "title";
  figure.window = {0, 0, 1, 1};
  figure.x = {"a displacement of the pendulum from its position of rest, along the longer of both axes", "m"};
  figure.y = figure.x;
  std::string svg = figure_svg(figure, {});
  sizes_at_least(svg, min_text_size);
  EXPECT_NE(svg.find("axes (m)<"), std::string::npos) << "the unit is in the second line";
  EXPECT_EQ(svg.find("\u2026"), std::string::npos);
  const std::string word(10'000, 'w');
  figure.title = figure.x.name = word;
  figure.layers.push_back(line_layer("line", word, palette::ink));
  svg = figure_svg(figure, {});
  sizes_at_least(svg, min_text_size);
  EXPECT_NE(svg.find("<title>" + word + "</title>"), std::string::npos);
  std::size_t longest = 0;
  for (std::size_t at = svg.find('w'), end; at != std::string::npos; at = svg.find('w', end)) {
    end = std::min(svg.find_first_not_of('w', at), svg.size());
    if (svg.compare(end, 8, "</title>") != 0 && svg.compare(end, 5, " (m)<") != 0)
      longest = std::max(longest, end - at);
  }
  EXPECT_LE(static_cast<double>(longest) * text_width("w", min_text_size), 241);
  EXPECT_LT(std::stod(svg.substr(svg.find("height=\"") + 8)), 120);  // mm
}

// A height that texts do not leave room for is exceeded; nothing is cut off.
TEST(FigureSvg, IsAsHighAsItsTexts) {
  Figure figure;
  figure.window = {0, 0, 1, 1};
  for (const char* const text : {"one", "two", "three"}) {
    figure.layers.push_back(line_layer(text, std::string(text) + " and so on, which is long", palette::ink));
  }
  const auto height = [&](FigureStyle style) {
    const std::string svg = figure_svg(figure, style);
    return std::stod(svg.substr(svg.find("height=\"") + 8));
  };
  EXPECT_NEAR(height({.width = 60, .height = 60.0}), 60, 0.01);
  EXPECT_GT(height({.width = 30, .height = 30.0}), 31);
  EXPECT_NEAR(height({.width = 30, .height = 30.0, .legend = false}), 30, 0.01);
}

TEST(Ticks, SayPowersOfOffsetsAsOneFactor) {
  EXPECT_EQ(ticks_between(1e12 - 1, 1e12 + 1, 5, false).offset, "\u2212 10^{12}");
  EXPECT_EQ(ticks_between(3e12 - 1, 3e12 + 1, 5, false).offset, "\u2212 3\u00b710^{12}");
}

// A text is never cut within a character or a subscript.
TEST(RichText, IsWrappedBetweenLetters) {
  const std::string text = "\u03b1\u03b2\u03b3L_{12}(1) and more";
  for (double width = 1; width < 120; width += 3) {
    std::string all;
    for (const std::string& line : wrapped(text, 7, width, 100)) {
      EXPECT_TRUE(text_width(line, 7) <= width || text_width(line, 7) < 12) << line;  // one letter, or a subscript
      EXPECT_NE(static_cast<unsigned char>(line[0]) & 0xC0U, 0x80U) << line;
      EXPECT_EQ(line.find("_{") == std::string::npos, line.find('}') == std::string::npos) << line;
      all += line;
    }
    std::string letters = text;
    std::erase(letters, ' ');
    std::erase(all, ' ');
    EXPECT_EQ(all, letters);
    const std::vector<std::string> one = wrapped(text, 7, width, 1);
    ASSERT_EQ(one.size(), 1);
    EXPECT_EQ(one[0] == text, whole_of_cut(one, text).empty());
  }
}

// The coordinates that a summary names, with units; nothing of other sentences.
TEST(SystemFigure, NamesAxesBySummary) {
  const auto names = [](const char* summary) {
    System system;
    system.info.summary = summary;
    Figure figure;
    name_axes(figure, system);
    EXPECT_EQ(figure.plane, figure.x.unit == figure.y.unit);
    return figure.x.name + "|" + figure.x.unit + "|" + figure.y.name + "|" + figure.y.unit;
  };
  EXPECT_EQ(names("Standard map; plane (x, p)"), "x||p|");
  EXPECT_EQ(names("Pendulum x'' = -sin x; period map in (x, x')"), "x||x'|");
  EXPECT_EQ(names("Proton in a trap; map in (position (um), momentum [kg m/s])"), "position|um|momentum|kg m/s");
  EXPECT_EQ(names("Eddies in the plane (longitude [degrees], latitude [degrees]), daily"),
            "longitude|degrees|latitude|degrees");
  EXPECT_EQ(names("Map (x, y) -> (y, x)"), "x||y|");
  EXPECT_EQ(names("As in (Meiss, 1992)"), "x||y|");
  EXPECT_EQ(names("Defined in (f(x, y), g"), "x||y|");
  EXPECT_EQ(names("Flow in (x, y, z)"), "x||y|");
}

// The legend explains only parts that the window shows.
TEST(FigureSvg, ExplainsWhatIsSeen) {
  Figure figure;
  figure.layers.push_back(line_layer("line", "a line", palette::ink));
  figure.layers.back().lines.push_back({.own = {{0, 0}, {1, 1}}});
  figure.layers.push_back(dot_layer("dots", "some dots", {{5, 5}}));
  figure.layers.push_back(box_layer("boxes", "a box", palette::ink));
  figure.layers.back().boxes.push_back({4, 4, 6, 6});
  figure.layers.push_back(fill_layer("fill", "a fill", palette::ink));
  figure.layers.back().lines.push_back({.own = {{4, 4}, {6, 4}, {6, 6}}, .closed = true});
  figure.window = {0, 0, 6, 6};
  FigureStyle style;
  const auto explained = [&](const char* text) { return figure_svg(figure, style).find(text) != std::string::npos; };
  for (const char* text : {"a line", "some dots", "a box", "a fill"}) EXPECT_TRUE(explained(text)) << text;
  style.window = Rectangle{0, 0, 2, 2};
  EXPECT_TRUE(explained("a line"));
  for (const char* text : {"some dots", "a box", "a fill"}) EXPECT_FALSE(explained(text)) << text;
  style.window = Rectangle{4.5, 4, 5.5, 6};
  EXPECT_FALSE(explained("a line"));
  for (const char* text : {"some dots", "a box", "a fill"}) EXPECT_TRUE(explained(text)) << text;
}

// An inset lies in the plot, hides neither its window nor, where there is room, lines.
TEST(FigureSvg, PutsTheInsetWhereThereIsRoom) {
  Figure figure;
  figure.layers.push_back(line_layer("frame", "", palette::ink));
  figure.layers.back().lines.push_back({.own = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, .closed = true});
  figure.layers.back().lines.push_back({.own = {{1, 9}, {9, 9}, {9, 1}}});
  figure.window = {0, 0, 10, 10};
  FigureStyle style;
  style.inset = Rectangle{8.5, 8.5, 9.5, 9.5};
  const std::string svg = figure_svg(figure, style);
  const auto number = [&](std::size_t from, const char* name) {
    return std::strtod(svg.c_str() + svg.find(name, from) + std::string(name).size(), nullptr);
  };
  const std::size_t plot = svg.find("<clipPath id=\"plot\">"), inset = svg.find("<clipPath id=\"inset\">");
  ASSERT_NE(inset, std::string::npos);
  const double left = number(plot, "x=\""), width = number(plot, " width=\"");
  const double right_of_inset = number(inset, "x=\"") + number(inset, " width=\"");
  EXPECT_GT(number(inset, "x=\""), left);
  EXPECT_LT(right_of_inset, left + 0.9 * width);  // left of the line x = 9
}

// Where the ticks of an inset count from another number than those of the plot, both of its axes say so.
TEST(FigureSvg, NamesTheAxesOfAnInsetWithOffsets) {
  Figure figure;
  figure.layers.push_back(line_layer("line", "", palette::ink));
  figure.layers.back().lines.push_back({.own = {{0, 0}, {10, 10}}});
  figure.window = {0, 0, 10, 10};
  FigureStyle style;
  style.inset = Rectangle{4.5, 3, 4.5 + 1e-7, 3 + 1e-7};
  const std::string svg = figure_svg(figure, style);
  const std::string inset = svg.substr(svg.find("<clipPath id=\"inset\">"));
  EXPECT_NE(inset.find(">x \u2212 4.5"), std::string::npos) << inset;
  EXPECT_NE(inset.find(">y \u2212 3"), std::string::npos) << inset;
}

TEST(PanelsSvg, HasOneLegendAndNamesEachFrame) {
  Figure figure;
  figure.layers.push_back(dot_layer("dots", "the same dots", {{1, 1}}));
  figure.window = {0, 0, 2, 2};
  const std::array<Figure, 3> figures{figure, figure, figure};
  const std::string svg = panels_svg("three", figures, 2, {.width = 170});
  EXPECT_NE(svg.find("width=\"170mm\""), std::string::npos);
  for (const char* id : {"plot0", "plot1", "plot2"}) {
    EXPECT_NE(svg.find("<clipPath id=\"" + std::string(id) + "\""), std::string::npos);
    EXPECT_NE(svg.find("url(#" + std::string(id) + ")"), std::string::npos);
  }
  const std::size_t first = svg.find("the same dots");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(svg.find("the same dots", first + 1), std::string::npos);
}

class PictureProgram : public ProgramTest {};

TEST_F(PictureProgram, TakesATitle) {
  const auto title_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"levels", "capsize", "--energy", "0.28", "--picture", "p.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments).status, 0);
    return read("p.svg");
  };
  EXPECT_NE(title_of({}).find("energy = 0.28"), std::string::npos);
  const std::string own = title_of({"--title", "Hill's region <e_{1}>"});
  EXPECT_EQ(own.find("energy = 0.28"), std::string::npos);
  EXPECT_NE(own.find("Hill's region &lt;e"), std::string::npos);
  EXPECT_EQ(title_of({"--no-title"}).find("energy = 0.28"), std::string::npos);
  EXPECT_EQ(run({"levels", "capsize", "--title", "none"}).status, 2);  // needs a picture
}

TEST_F(PictureProgram, WritesEachFormat) {
  const std::string curve = std::string(LOBER_SOURCE_DIR) + "/examples/six-crossings.dat";
  const std::vector<std::string> overlay{"overlay", curve + "#C1", curve + "#C2"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), overlay.begin(), overlay.end());
    return run(more);
  };
  ASSERT_EQ(with({"--picture", "p.svg", "--size", "120", "--no-legend", "--inset", "2,-1,4,1"}).status, 0);
  const std::string svg = read("p.svg");
  EXPECT_NE(svg.find("width=\"120mm\""), std::string::npos);
  EXPECT_NE(svg.find("url(#inset)"), std::string::npos);
  EXPECT_EQ(svg.find("C1, area"), std::string::npos);
  ASSERT_EQ(with({"--data", "p.csv"}).status, 0);
  EXPECT_TRUE(read("p.csv").starts_with("layer,item,name,x,y,error\n"));
  ASSERT_EQ(with({"--data", "p.json"}).status, 0);
  EXPECT_NE(read("p.json").find("\"layers\""), std::string::npos);
  const Outcome pdf = with({"--picture", "p.pdf"}), png = with({"--picture", "p.png"});
  if (!reason_no_conversion().empty()) {
    EXPECT_EQ(pdf.status, 1);
    EXPECT_NE(pdf.err.find("install the package"), std::string::npos) << pdf.err;
    GTEST_SKIP() << reason_no_conversion();
  }
  ASSERT_EQ(pdf.status, 0) << pdf.err;
  ASSERT_EQ(png.status, 0) << png.err;
  EXPECT_TRUE(read("p.pdf").starts_with("%PDF"));
  EXPECT_TRUE(read("p.png").starts_with("\x89PNG"));
  const std::string first = read("p.pdf");
  ASSERT_EQ(with({"--picture", "p.pdf"}).status, 0);
  EXPECT_EQ(read("p.pdf"), first);
}

TEST_F(PictureProgram, RefusesAnInsetThatIsNotInTheWindow) {
  const std::string curve = std::string(LOBER_SOURCE_DIR) + "/examples/six-crossings.dat";
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"overlay", curve + "#C1", curve + "#C2", "--picture", "p.svg"});
    return run(more);
  };
  const Outcome outside = with({"--inset", "50,50,60,60"});
  EXPECT_EQ(outside.status, 2);
  EXPECT_NE(outside.err.find("--inset 50,50,60,60 lies outside of the part of the plane that the picture shows, -1"),
            std::string::npos)
      << outside.err;
  EXPECT_FALSE(exists("p.svg"));
  EXPECT_NE(outside.err.find("p.svg is not written"), std::string::npos) << outside.err;
  EXPECT_NE(outside.out.find("crossings"), std::string::npos) << "what was computed is not lost";
  EXPECT_EQ(with({"--inset", "50,50,60,60", "--json", "kept.json"}).status, 2);
  EXPECT_EQ(Json::parse(read("kept.json"))["crossings"].size(), 6);
  const Outcome beyond = with({"--inset", "4,-1,9,1", "--window", "0,-2,6,2"});
  EXPECT_EQ(beyond.status, 2);
  EXPECT_NE(beyond.err.find("reaches beyond the part of the plane that the picture shows, 0,-2,6,2"), std::string::npos)
      << beyond.err;
  EXPECT_EQ(with({"--inset", "4,-1,6,1", "--window", "0,-2,6,2"}).status, 0);
  for (const char* const option : {"--window", "--inset"}) {
    const Outcome infinite = with({option, "-inf,0,1,inf"});
    EXPECT_EQ(infinite.status, 2);
    EXPECT_NE(infinite.err.find("have to be finite"), std::string::npos) << infinite.err;
  }
  ASSERT_EQ(with({"--title", "caf\xe9 \x01 <&>"}).status, 0);
  EXPECT_NE(read("p.svg").find("caf\u00e9   &lt;&amp;&gt;"), std::string::npos) << "bytes that are not UTF-8";
  const Outcome nothing = with({"--window", "100,100,101,101"});
  EXPECT_EQ(nothing.status, 0);
  EXPECT_NE(nothing.err.find("shows nothing; all is in -1"), std::string::npos) << nothing.err;
}

// The text of an axis: those of y are turned.
bool has_text(const std::string& svg, const std::string& text) {
  return svg.find(">" + text + "</text>") != std::string::npos;
}

TEST_F(PictureProgram, NamesAxesAsTheFileDoes) {
  const std::string square = "0,0\n1,0\n1,1\n0,1\n";
  write("plain.csv", square);
  write("units.csv", "easting (km), northing [km]\n" + square);
  write("quoted.csv", "\"depth, down\",\"<b> & time (s)\"\n" + square);
  write("degrees.csv", "longitude,latitude\n" + square);
  write("tecplot.dat", "VARIABLES=\"q\" \"p [kg m/s]\"\nZONE T=\"a\"\n0 0\n1 0\n1 1\n0 1\n");
  const auto picture = [&](const std::string& file) {
    const Outcome outcome = run({"winding", file, "--grid", "4,4", "--picture", "p.svg"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read("p.svg");
  };
  const auto names = [&](const std::string& file, const std::string& x, const std::string& y) {
    const std::string svg = picture(file);
    EXPECT_TRUE(has_text(svg, x)) << file;
    EXPECT_TRUE(has_text(svg, y)) << file;
  };
  names("plain.csv", "x", "y");
  names("units.csv", "easting (km)", "northing (km)");
  names("quoted.csv", "depth, down", "&lt;b&gt; &amp; time (s)");
  names("degrees.csv", "longitude (degrees)", "latitude (degrees)");
  names("tecplot.dat", "q", "p (kg m/s)");
}

TEST_F(PictureProgram, DrawsSystemsByNameOnly) {
  EXPECT_EQ(run({"systems", "--picture", "p.svg"}).status, 2);
  ASSERT_EQ(run({"systems", "henon", "--picture", "p.svg"}).status, 0);
  const std::string svg = read("p.svg");
  for (const char* const text :
       {"henon: k = 0.5", "U, unstable manifolds", "1 saddle, \u03bb &gt; 0", "1 elliptic point"}) {
    EXPECT_TRUE(has_text(svg, text)) << text;
  }
  // The same for any number of threads.
  ASSERT_EQ(run({"systems", "henon", "--picture", "q.svg"}).status, 0);
  EXPECT_EQ(read("q.svg"), svg);
}

class BatchPicture : public ProgramTest {
 protected:
  BatchPicture() {
    write("job.toml",
          "operation = \"transport\"\noptions = { system = \"henon\", iterates = 1 }\n"
          "grid = { parameters.k = [0.8, 0.9, 1.0], tolerance = [1e-2, 1e-3] }\n");
    EXPECT_EQ(run({"batch", "run", "job.toml"}).status, 0);
  }
  [[nodiscard]] Outcome picture(std::vector<std::string> more) const {
    more.insert(more.begin(), {"batch", "picture", "job.results", "--picture", "p.svg"});
    return run(more);
  }
};

TEST_F(BatchPicture, DrawsAResultOverTwoOptionsOrOne) {
  ASSERT_EQ(picture({"--data", "p.csv"}).status, 0);
  std::string svg = read("p.svg");
  for (const char* const text : {"henon: lobe_area12", "k", "tolerance", "0.001", "0.9"}) {
    EXPECT_TRUE(has_text(svg, text)) << text;
  }
  // Each job is a box, two corners.
  const std::string data = read("p.csv");
  EXPECT_EQ(std::count(data.begin(), data.end(), '\n'), 1 + 2 * 6);
  EXPECT_EQ(data.find(",,"), std::string::npos) << "a box without the number that it stands for: " << data;
  ASSERT_EQ(picture({"--where", "tolerance=0.001", "--value", "points_u"}).status, 0);
  svg = read("p.svg");
  EXPECT_TRUE(has_text(svg, "points_u"));
  EXPECT_TRUE(has_text(svg, "3 jobs"));
}

class PictureOfPoints : public ProgramTest {};

// `points` of densify is an option, of passes, and a number of the result.
TEST_F(PictureOfPoints, ValuesAreColumnsWhereAnOptionHasTheirName) {
  write("square", "0 0\n2 0\n2 2\n0 2\n");
  write("job.toml",
        "operation = \"densify\"\ncurves = \"square\"\npairs = \"single\"\ngrid = { max_length = [0.5, 1] }\n");
  ASSERT_EQ(run({"batch", "run", "job.toml"}).status, 0);
  ASSERT_EQ(
      run({"batch", "picture", "job.results", "--value", "points", "--picture", "p.svg", "--data", "p.csv"}).status, 0);
  const std::string data = read("p.csv");
  EXPECT_NE(data.find("0.5,16"), std::string::npos) << data;
  EXPECT_NE(data.find("1,8"), std::string::npos) << data;
}

class EscapePicture : public ProgramTest {};

// Fractions are lists whose length depends on the options: each element is a column, and one of them is drawn.
TEST_F(EscapePicture, DrawsAFractionOverTheEnergy) {
  write("job.toml",
        "operation = \"escape\"\noptions = { system = \"capsize\", crossings = 2, monte_carlo = 0, tolerance = 1e-4 }\n"
        "grid = { energy = [0.251, 0.27] }\n");
  ASSERT_EQ(run({"batch", "run", "job.toml"}).status, 0);
  ASSERT_EQ(run({"batch", "picture", "job.results", "--picture", "p.svg"}).status, 0);
  EXPECT_TRUE(has_text(read("p.svg"), "capsize: fraction_1_1_2"));
  const std::string table = run({"batch", "export", "job.results"}).out, head = table.substr(0, table.find('\n'));
  for (const char* const column : {"energy", "fraction_1_1_2", "fraction_2_1_1_error", "fraction_2_2_2"}) {
    EXPECT_NE(head.find(std::string(",") + column + ","), std::string::npos) << head;
  }
  const std::string lines = run({"batch", "export", "job.results", "--format", "jsonl"}).out;
  const Json job = Json::parse(lines.substr(0, lines.find('\n')));
  const Json single = Json::parse(run({"escape", "capsize", "--energy", "0.251", "--crossings", "2", "--monte-carlo",
                                       "0", "--tolerance", "1e-4", "--json", "-"})
                                      .out);
  ASSERT_EQ(single["table"].size(), 8);
  for (std::size_t k = 0; k < 8; ++k) {
    const Json& row = single["table"][k];
    const std::string name =
        "fraction_" + std::to_string(k / 4 + 1) + "_" + std::to_string(k / 2 % 2 + 1) + "_" + row["crossings"].dump();
    EXPECT_EQ(job[name], row["fraction"]) << name;
    EXPECT_EQ(job[name + "_error"], row["error"]) << name;
    EXPECT_EQ(row["entrance"] == single["table"][0]["entrance"], k < 4) << k;
  }
  ASSERT_EQ(run({"batch", "export", "job.results", "-o", "job.npy"}).status, 0);
  EXPECT_NE(read("job.npy").find("fraction_2_2_2_error"), std::string::npos);
}

TEST_F(BatchPicture, SaysWhatToChoose) {
  const auto refused = [&](const std::vector<std::string>& more, const std::string& why) {
    const Outcome outcome = picture(more);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
  };
  refused({"--x", "kk"}, "--x kk: the jobs have no such value; there are ");
  refused({"--value", "lobe_area21_"}, "did you mean lobe_area21?");
  refused({"--x", "k", "--y", "k"}, "several jobs have the same k = 0.8 and k = 0.8; they differ in tolerance");
  refused({"--where", "k=7"}, "no job that is done has this value");
  refused({"--where", "k"}, "NAME=VALUE");
  refused({"--overlaps", "0"}, "the job has no overlaps of lobes");
  refused({"--overlaps", "99"}, "no job of this number is done");
  refused({"--operation", "overlay"}, "the store has no job of it; there are transport");
  EXPECT_EQ(run({"batch", "picture", "job.results"}).status, 2);
}

}  // namespace
}  // namespace lober::cli
