#include "cli/report/json_file.hpp"

#include <utility>

namespace lober::cli {

JsonFile::JsonFile(const std::string& path, std::string_view command) : file_(path) {
  file_.write("{");
  member("program", program_json());
  member("command", command);
}

void JsonFile::begin_member(std::string_view key) {
  std::string text;
  append_all(text, "\"", key, "\": ");
  file_.write(text);
}

void JsonFile::member(std::string_view key, const Json& value) {
  begin_member(key);
  file_.write(dumped(value) + ",\n");
}

void JsonFile::finish(const Json& timing) {
  begin_member("timing");
  file_.write(dumped(timing) + "}\n");
  file_.commit();
}

void write_listing(const std::string& path, std::string_view command, const std::string& key, Json list) {
  detail::OutputFile file(path);
  const Json all{{"program", program_json()}, {"command", command}, {key, std::move(list)}};
  file.write(all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  file.commit();
}

}  // namespace lober::cli
