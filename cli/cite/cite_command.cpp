// The facts are those of CITATION.cff, which the tests compare.
#include "cli/cite/cite_command.hpp"

#include <spdlog/fmt/fmt.h>

#include "cli/program/command_line.hpp"
#include "cli/program/option_parser.hpp"
#include "cli/program/wrapped_text.hpp"
#include "lober/base/version.hpp"

namespace lober::cli {
namespace {

constexpr const char* abstract = "Exact crossings, lobes and areas of curves for phase-space transport";
constexpr const char* article_title =
    "Computational method for phase space transport with applications to lobe dynamics and rate of escape";

std::string citation_text() {
  const std::size_t width = text_width();
  return wrapped("Please cite lober together with the article whose methods it implements.", width) + "\n\n  " +
         wrapped(fmt::format("The lober authors. lober {}: {}. Software, BSD-3-Clause.", version(), abstract), width, 4,
                 2) +
         "\n\n  " +
         wrapped(fmt::format("Shibabrat Naik, Francois Lekien and Shane D. Ross. {}. Regular and Chaotic Dynamics 22 "
                             "(3), 272-297, 2017. doi:10.1134/S1560354717030078",
                             article_title),
                 width, 4, 2) +
         "\n\nlober cite --bibtex prints both as entries of BibTeX.\n";
}

std::string bibtex() {
  return fmt::format(R"(@software{{lober,
  author  = {{{{The lober authors}}}},
  title   = {{lober: {}}},
  version = {{{}}},
  license = {{BSD-3-Clause}}
}}

@article{{NaikLekienRoss2017,
  author  = {{Naik, Shibabrat and Lekien, Francois and Ross, Shane D.}},
  title   = {{{}}},
  journal = {{Regular and Chaotic Dynamics}},
  volume  = {{22}},
  number  = {{3}},
  pages   = {{272--297}},
  year    = {{2017}},
  doi     = {{10.1134/S1560354717030078}}
}}
)",
                     abstract, version(), article_title);
}

}  // namespace

void run_cite(const std::vector<std::string>& arguments) {
  bool as_bibtex = false;
  OptionParser parser(
      "Prints how to cite lober, and the article by Naik, Lekien & Ross (2017) whose methods it implements.",
      "lober cite");
  parser.add_example("lober cite", "both citations as text");
  parser.add_example("lober cite --bibtex", "and as entries of BibTeX");
  parser.add_flag("--bibtex", as_bibtex, "Print entries of BibTeX instead of text.");
  if (parser.parse(arguments)) print(as_bibtex ? bibtex() : citation_text());
}

}  // namespace lober::cli
