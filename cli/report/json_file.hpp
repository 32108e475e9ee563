// The JSON object that a command writes: member by member, so that no long list stands in memory as a whole.
#pragma once

#include <string>
#include <string_view>

#include "cli/report/json.hpp"
#include "cli/report/json_list.hpp"
#include "engine/base/output_file.hpp"

namespace lober::cli {

class JsonFile {
 public:
  /// Begins with the members `program` and `command`. The file appears under its name when it is finished.
  JsonFile(const std::string& path, std::string_view command);

  void member(std::string_view key, const Json& value);
  /// An array, each element by `format(text, index)`.
  template <typename Format>
  void list(std::string_view key, std::size_t size, const Format& format) {
    begin_member(key);
    write_list(file_, size, format);
    file_.write(",\n");
  }
  /// The last member, `timing`.
  void finish(const Json& timing);

  /// For members that are written in another way, each up to and with ",\n".
  [[nodiscard]] detail::OutputFile& file() { return file_; }

 private:
  void begin_member(std::string_view key);

  detail::OutputFile file_;
};

/// Writes a small file that has only `program`, `command` and the member `key`, indented.
void write_listing(const std::string& path, std::string_view command, const std::string& key, Json list);

}  // namespace lober::cli
