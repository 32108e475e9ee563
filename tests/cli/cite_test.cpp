// `lober cite` says what CITATION.cff says.

#include <fstream>
#include <map>
#include <regex>

#include "tests/cli/program.hpp"
#include "tests/paths.hpp"

namespace lober::cli {
namespace {

class Cite : public ProgramTest {};

// The scalars of the file by their keys, in its order. The program has all of those that the test does not leave out.
std::multimap<std::string, std::string> facts_of_citation() {
  std::ifstream file(std::string(LOBER_SOURCE_DIR) + "/CITATION.cff");
  std::multimap<std::string, std::string> facts;
  const std::regex scalar(R"re(^[ -]*([a-z-]+): *"?([^"]+?)"?\s*$)re");
  std::smatch found;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_match(line, found, scalar)) facts.emplace(found[1], found[2]);
  }
  return facts;
}

TEST_F(Cite, HasTheFactsOfTheCitationFile) {
  const Environment environment("COLUMNS", "120");
  const Outcome text = run({"cite"}), bibtex = run({"cite", "--bibtex"});
  EXPECT_EQ(text.status, 0);
  EXPECT_EQ(bibtex.status, 0);
  std::string words = std::regex_replace(text.out, std::regex("\\s+"), " ");
  const auto facts = facts_of_citation();
  EXPECT_GE(facts.size(), 17U);
  EXPECT_EQ(facts.count("family-names"), 3U);
  for (const auto& [key, value] : facts) {
    if (key == "cff-version" || key == "type" || key == "message") continue;
    std::string wanted = value;
    if (key == "abstract") wanted.pop_back();  // the full stop
    EXPECT_NE(words.find(wanted), std::string::npos) << key << ": " << wanted << "\n" << text.out;
    EXPECT_NE(bibtex.out.find(wanted), std::string::npos) << key << ": " << wanted << "\n" << bibtex.out;
  }
}

TEST_F(Cite, IsBibtex) {
  const std::string bibtex = run({"cite", "--bibtex"}).out;
  EXPECT_TRUE(bibtex.starts_with("@software{lober,\n")) << bibtex;
  EXPECT_NE(bibtex.find("\n@article{NaikLekienRoss2017,\n"), std::string::npos);
  EXPECT_NE(bibtex.find("author  = {Naik, Shibabrat and Lekien, Francois and Ross, Shane D.},\n"), std::string::npos);
  EXPECT_NE(bibtex.find("pages   = {272--297},\n"), std::string::npos);
  EXPECT_EQ(std::count(bibtex.begin(), bibtex.end(), '{'), std::count(bibtex.begin(), bibtex.end(), '}'));
}

}  // namespace
}  // namespace lober::cli
