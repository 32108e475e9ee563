// The claims of the documents about systems are true.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "lober/dynamics/systems.hpp"
#include "tests/paths.hpp"

namespace lober {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<fs::path> documents() {
  const fs::path root(LOBER_SOURCE_DIR);
  std::vector<fs::path> files{root / "README.md", root / "cli/batch/operations_list.cpp"};
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  }
  return files;
}

bool has_parameter(const std::string& system, const std::string& parameter) {
  for (const SystemInfo& info : list_systems()) {
    if (info.name != system) continue;
    return std::any_of(info.parameters.begin(), info.parameters.end(),
                       [&](const Parameter& each) { return each.name == parameter; });
  }
  return false;
}

// Manifests: system = "NAME", parameters = { P = ..., Q = ... }. Command lines: lober transport NAME --param P=...
TEST(Documents, NameParametersThatTheSystemsHave) {
  const std::regex manifest(R"re(system = "([a-z0-9-]+)", parameters = \{([^}]*)\})re");
  const std::regex setting(R"(([A-Za-z_][A-Za-z0-9_]*) *=)");
  const std::regex command(R"((?:transport|grow|escape|--system) ([a-z0-9-]+)((?: --param [A-Za-z]+=[^ \n]+)+))");
  int checked = 0;
  for (const fs::path& path : documents()) {
    const std::string text = content(path);
    for (const std::regex& form : {manifest, command}) {
      for (std::sregex_iterator found(text.begin(), text.end(), form), end; found != end; ++found) {
        const std::string system = (*found)[1], settings = (*found)[2];
        for (std::sregex_iterator each(settings.begin(), settings.end(), setting); each != end; ++each) {
          EXPECT_TRUE(has_parameter(system, (*each)[1])) << path << ": " << found->str();
          ++checked;
        }
      }
    }
  }
  EXPECT_GE(checked, 5);
}

}  // namespace
}  // namespace lober
