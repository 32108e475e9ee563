#include "cli/generate/generate_command.hpp"

#include "cli/formats/formats_command.hpp"
#include "cli/generate/completions.hpp"
#include "cli/generate/man_page.hpp"
#include "cli/generate/markdown.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/commands.hpp"
#include "engine/base/nearest_word.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

std::string page_of(const std::string& kind) {
  if (kind == "complete-bash") return bash_completion();
  if (kind == "complete-zsh") return zsh_completion();
  if (kind == "complete-fish") return fish_completion();
  if (kind == "markdown") return markdown_reference();
  if (kind == "formats") return markdown_formats();
  if (kind == "man") return program_man_page();
  if (kind == "commands") {
    std::string names;
    for (const std::string& name : command_names()) names += name + "\n";
    return names;
  }
  std::vector<std::string> known;
  for (const CommandExample& any : kinds_of_pages()) known.push_back(any.line);
  throw UsageError((kind.empty() ? "--generate needs a value" : "--generate: \"" + kind + "\" cannot be generated") +
                   "; there are " + detail::joined(known) + detail::did_you_mean(kind, known));
}

}  // namespace

void run_generate(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = arguments;  // behind --generate, or --generate=KIND
  const std::size_t equals = words[0].find('=');
  if (equals == std::string::npos) {
    words.erase(words.begin());
  } else {
    words[0].erase(0, equals + 1);
  }
  const std::string kind = words.empty() ? std::string() : words[0];
  const bool of_command = kind == "man" && words.size() == 2;
  const std::string page = of_command ? command_man_page(words[1]) : page_of(kind);
  if (words.size() > 1 && !of_command) throw UsageError("unexpected argument \"" + words.back() + "\" of --generate");
  print(page);
}

}  // namespace lober::cli
