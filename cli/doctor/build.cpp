#include "cli/doctor/build.hpp"

#include <nettle/version.h>
#include <oneapi/tbb/version.h>
#include <spdlog/fmt/fmt.h>
#include <sqlite3.h>

#include <array>
#include <utility>

#include "engine/batch/operations/provenance.hpp"

namespace lober::cli {
namespace {

// As LOBER_HEADER_LIBRARIES of cli/CMakeLists.txt has them: "Boost 1.74.0;Eigen 3.4.0".
void add_header_libraries(std::vector<LibraryVersion>& list) {
  std::string_view rest = LOBER_HEADER_LIBRARIES;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find('|'));
    rest.remove_prefix(std::min(one.size() + 1, rest.size()));
    const std::size_t blank = one.find(' ');
    list.push_back({std::string(one.substr(0, blank)), std::string(one.substr(blank + 1))});
  }
}

LibraryVersion linked(const char* name, std::string runs, std::string built_with) {
  if (runs == built_with) built_with.clear();
  return {name, std::move(runs), std::move(built_with)};
}

}  // namespace

std::vector<LibraryVersion> library_versions() {
  std::vector<LibraryVersion> list;
  list.push_back(linked("TBB", TBB_runtime_version(), TBB_VERSION_STRING));
  list.push_back(linked("SQLite", sqlite3_libversion(), SQLITE_VERSION));
  list.push_back(linked("Nettle", fmt::format("{}.{}", nettle_version_major(), nettle_version_minor()),
                        fmt::format("{}.{}", NETTLE_VERSION_MAJOR, NETTLE_VERSION_MINOR)));
  add_header_libraries(list);
  return list;
}

std::string library_text() {
  std::string text;
  for (const LibraryVersion& one : library_versions()) {
    text += (text.empty() ? "" : ", ") + one.name + " " + one.version;
    if (!one.built_with.empty()) text += " (built with " + one.built_with + ")";
  }
  return text;
}

std::string build_text() {
  const detail::Provenance made = detail::provenance();
  const std::string commit = made.commit == "unknown" ? "" : "commit " + made.commit + ", ";
  return commit + made.compiler + ", " + made.flags;
}

}  // namespace lober::cli
