#include "cli/view/repeated_result.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include "cli/program/system_options.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/json.hpp"
#include "engine/base/text.hpp"
#include "engine/files/curve_spec.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

// The operation that a command runs with these options.
const operations::Operation* repeated_operation(const std::string& command, const Json& result) {
  if (command == "overlay") return &operations::named(result.contains("rule") ? "regions" : "overlay");
  if (command == "tangle") return &operations::named(result.contains("system") ? "manifold_tangle" : "tangle");
  if (command == "regions") return &operations::named("regions");
  if (command == "curve-transport" || (command == "transport" && result.contains("inputs"))) {
    return &operations::named("curve_transport");
  }
  for (const char* const name : {"transport", "escape", "grow"}) {
    if (command == name && result.contains("system")) return &operations::named(name);
  }
  return nullptr;
}

std::string argument_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return detail::format_number(value.get<double>());
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& one : value) text += (text.empty() ? "" : ",") + argument_text(one);
  return text;
}

// The name of a file that could be taken for an option.
std::string as_argument(const std::string& name) {
  return name.starts_with('-') ? "./" + name : name;
}

// Options whose names on the command line are not those of the table.
std::string repeated_argument(const std::string& key, const Json& value) {
  if (key == "side") return value == "stable" ? "--stable" : "--unstable";  // the key of a choice could be any text
  if (key == "bip_near") return "--bip-near=" + argument_text(value);
  if (key == "max_memory") return "--memory=" + argument_text(value);
  return option_name(key) + "=" + argument_text(value);
}

// The system that a result names, as the command takes it: a built-in one, or the library that the user names. Nothing
// that a file says is loaded: it may come from anybody.
std::string repeated_system(const Json& system, const std::string& path, const std::string& library) {
  std::string name = system.at("name").get<std::string>();
  if (library.empty()) {
    if (is_built_in(name)) return name;
    throw UsageError(path + ": is a result of the system \"" + name +
                     "\", which is not one of lober; give --library FILE, the shared library that has it, if you trust "
                     "its code, which runs");
  }
  if (const std::string own = make_system(library, {}, {}).info.name; own != name) {
    throw UsageError("--library: " + library + " has the system \"" + own + "\", and " + path + " is a result of \"" +
                     name + "\"");
  }
  if (const Json made = system.value("library", Json());
      made.is_object() && made.at("sha256") != sha256_of_file(library)) {
    throw DataError("--library: " + library + " is not the one with which " + path +
                    " was computed, whose SHA-256 is another; run the command again");
  }
  return library;
}

// Options that follow from the system where they are not given: results name the values that were used, and a tangle
// that is given is not the system's own, which knows more about it.
std::map<std::string, Json> connection_of(const std::string& chosen, const Json& system) {
  std::map<std::string, Json> known;
  ParameterValues values;
  for (const auto& [name, value] : system.at("parameters").items()) values.emplace_back(name, value.get<double>());
  const auto input = operations::system_input(chosen, values, {});
  if (!input.system->connection) return known;
  const Connection& connection = *input.system->connection;
  known = {{"from", point_json(connection.from)},
           {"to", point_json(connection.to)},
           {"u_direction", point_json(connection.u_direction)},
           {"s_direction", point_json(connection.s_direction)}};
  if (connection.bip) known["bip"] = point_json(*connection.bip);
  return known;
}

void add_repeated_options(std::vector<std::string>& arguments, const operations::Operation& operation,
                          const Json& options, const std::string& path, const std::map<std::string, Json>& known,
                          bool bip_is_point) {
  const auto fail_at = [&](const std::string& key) {
    throw DataError(path + ": the option " + key + " is not one of this version; run the command again");
  };
  for (const auto& [key, value] : options.items()) {
    const auto spec = std::find_if(operation.options.begin(), operation.options.end(),
                                   [&, name = key](const auto& one) { return one.is_for(name); });
    if (spec == operation.options.end()) fail_at(key);
    if (value.is_null()) continue;
    if (const auto own = known.find(key); own != known.end() && own->second == value) continue;
    if (value.is_boolean()) {
      const bool on = value.get<bool>();
      if (spec->fallback == operations::OptionValue(on)) continue;
      arguments.push_back((on ? "--" : "--no-") + option_name(key).substr(2));
    } else if (key == "rule" || key == "side" || spec->optional ||
               argument_text(value) != operations::to_string(spec->fallback)) {
      const std::string bip_near = "bip_near";
      arguments.push_back(bip_is_point && key == bip_near ? "--bip=" + argument_text(value)
                                                          : repeated_argument(key, value));
    }
  }
}

// The names of curves, if their files are as they were.
void add_repeated_curves(std::vector<std::string>& arguments, const Json& result, const std::string& path) {
  const auto require_same = [&](const std::string& file, const Json& hash) {
    if (sha256_of_file(file) == hash.get<std::string>()) return;
    throw DataError(file + ": is not as it was when " + path + " was computed; run the command again");
  };
  std::string reversed;
  const Json& inputs = result.at("inputs");
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const Json& input = inputs[k];
    const bool is_name = input.is_string();  // where the command is an operation of the table
    std::string name = is_name ? input.get<std::string>() : input.value("spec", input.at("file").get<std::string>());
    if (!is_name && input.contains("zone") && !input.contains("spec")) name.append("#").append(input.at("zone").dump());
    require_same(detail::file_of_curve(name), is_name ? result.at("sha256").at(k) : input.at("sha256"));
    if (is_system(name)) {
      std::string message = path;
      throw DataError(message.append(": names the system ").append(name).append(" where a curve is expected"));
    }
    arguments.push_back(as_argument(name));
    if (!is_name && input.value("reversed", false)) reversed += k == 0 ? "u" : "s";
  }
  if (!reversed.empty()) arguments.push_back("--reverse=" + (reversed == "us" ? "both" : reversed));
  const Json periods = result.value("periodic", Json::object());
  for (const auto& [name, period] : periods.items()) {
    arguments.push_back("--periodic=" + name + "=" + argument_text(period));
  }
}

// A parameter that is an option of the command too, as the energy of an escape, is given once.
void add_repeated_system(std::vector<std::string>& arguments, const std::string& chosen, const Json& system,
                         const Json& options) {
  arguments.push_back(as_argument(chosen));
  for (const auto& [name, value] : system.at("parameters").items()) {
    if (!options.contains(name)) arguments.push_back("--param=" + name + "=" + argument_text(value));
  }
  if (system.contains("integration_tolerance")) {
    arguments.push_back("--integration-tolerance=" + argument_text(system.at("integration_tolerance")));
  }
}

RepeatedResult repeated(const Json& result, const std::string& path, const std::string& library) {
  RepeatedResult run{result.at("command").get<std::string>(), {}};
  const operations::Operation* const operation = repeated_operation(run.command, result);
  if (operation == nullptr) {
    throw DataError(path + ": is a result of lober " + run.command +
                    ", which has no page; there are pages of overlay, regions, tangle, transport, escape and grow");
  }
  const bool from_curves = !result.contains("system");
  std::map<std::string, Json> known;
  if (from_curves) {
    if (!library.empty()) throw UsageError("--library: " + path + " is a result of curves, which needs no system");
    if (run.command == "transport") run.arguments.emplace_back("--manifolds");
    add_repeated_curves(run.arguments, result, path);
  } else {
    const Json& system = result.at("system");
    const std::string name = repeated_system(system, path, library);
    add_repeated_system(run.arguments, name, system, result.at("options"));
    if (run.command != "escape") known = connection_of(name, system);
  }
  const bool bip_is_point = from_curves && run.command != "curve-transport";  // --bip, which takes a number there
  add_repeated_options(run.arguments, *operation, result.at("options"), path, known, bip_is_point);
  return run;
}

}  // namespace

std::optional<RepeatedResult> repeated_result(const std::string& path, const std::string& library) {
  std::ifstream file(path, std::ios::binary);
  constexpr std::size_t head = 64;
  std::string text(head, '\0');
  file.read(text.data(), static_cast<std::streamsize>(head));
  text.resize(static_cast<std::size_t>(file.gcount()));
  // As JsonFile begins; any other file of curves may be large.
  if (!text.starts_with("{\"program\"") && text.find("\"program\"") == std::string::npos) return std::nullopt;
  file.clear();
  text.append(std::istreambuf_iterator<char>(file), {});
  const Json result = Json::parse(text, nullptr, false);
  if (!result.is_object() || !result.contains("program") || !result.contains("command")) return std::nullopt;
  try {
    return repeated(result, path, library);
  } catch (const Json::exception& error) {
    throw DataError(path + ": cannot be read as a result of lober: " + error.what());
  }
}

}  // namespace lober::cli
