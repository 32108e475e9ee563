#include "cli/doctor/doctor_command.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "cli/doctor/build.hpp"
#include "cli/doctor/machine.hpp"
#include "cli/doctor/optional_parts.hpp"
#include "cli/doctor/self_test.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/wrapped_text.hpp"
#include "cli/report/json_file.hpp"
#include "engine/batch/operations/provenance.hpp"
#include "kernels/cpu.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

struct Diagnosis {
  detail::Provenance program;
  Machine machine;
  std::string instruction_set, best_instruction_set;
  std::vector<OptionalPart> parts;
  bool shows_progress = false;
  std::string temporary;          ///< folder
  std::string temporary_failure;  ///< empty where files can be written there
  SelfTest test;
};

std::string name_of(detail::InstructionSet set) {
  return std::string(detail::instruction_set_names()[static_cast<std::size_t>(set)]);
}

// Writes a file and removes it; the reason where that fails.
std::string failure_to_write(const std::string& folder) {
  std::string name = folder + "/lober-doctor-XXXXXX";
  const int file = mkstemp(name.data());
  if (file < 0) return std::error_code(errno, std::generic_category()).message();
  const bool written = write(file, "lober", 5) == 5;
  std::string failure = written ? "" : std::error_code(errno, std::generic_category()).message();
  close(file);
  unlink(name.c_str());
  return failure;
}

Diagnosis diagnose() {
  Diagnosis found;
  found.program = detail::provenance();
  found.machine = this_machine();
  found.instruction_set = name_of(detail::instruction_set());
  found.best_instruction_set = name_of(detail::processor_instruction_set());
  found.parts = optional_parts();
  found.shows_progress = isatty(STDERR_FILENO) != 0;
  const char* const named = std::getenv("TMPDIR");
  found.temporary = named != nullptr && *named != '\0' ? named : "/tmp";
  found.temporary_failure = failure_to_write(found.temporary);
  found.test = run_self_test();
  return found;
}

std::string gibibytes(std::uint64_t bytes) {
  return fmt::format("{:.1f} GiB", static_cast<double>(bytes) / (1 << 30));
}

std::string threads_text(const Machine& machine) {
  std::string text = fmt::format("{} by default, of {} processors", machine.allowed, machine.processors);
  if (machine.processor_limit) text += fmt::format("; limit of the control group: {:.3g}", *machine.processor_limit);
  return text;
}

std::string memory_text(const Machine& machine) {
  std::string text = gibibytes(machine.memory);
  if (machine.available > 0) text += ", " + gibibytes(machine.available) + " available";
  if (machine.memory_limit) text += "; limit of the control group: " + gibibytes(*machine.memory_limit);
  return text;
}

std::string parts_text(const std::vector<OptionalPart>& parts) {
  std::string text;
  for (const OptionalPart& part : parts) {
    text += (text.empty() ? "" : ", ") + part.name + (part.available ? " yes" : " no");
    if (!part.library.empty() && !part.available) text += " (" + part.library + ")";
  }
  return text;
}

std::string test_text(const SelfTest& test) {
  if (!test.failure.empty()) return "failed: " + test.failure;
  return fmt::format("passed: {} crossings, {} pieces and all areas of two combs are exact, {:.0f} ms", test.crossings,
                     test.pieces, 1e3 * test.seconds);
}

std::string report_text(const Diagnosis& found) {
  std::string text;
  const auto line = [&, width = text_width()](const std::string& name, const std::string& value) {
    text += fmt::format("{:<12}", name) + wrapped(value, width, 12, 12) + "\n";
  };
  line("lober", found.program.version + ", " + build_text());
  line("libraries", library_text());
  line("system", found.machine.system);
  line("processor", (found.machine.processor.empty() ? "" : found.machine.processor + "; ") + found.instruction_set +
                        " in use, " + found.best_instruction_set + " is the best it has");
  line("threads", threads_text(found.machine));
  line("memory", memory_text(found.machine));
  line("parts", parts_text(found.parts));
  line("progress",
       found.shows_progress ? "shown: standard error is a terminal" : "not shown: standard error is not a terminal");
  line("temporary",
       found.temporary +
           (found.temporary_failure.empty() ? " can be written" : " cannot be written: " + found.temporary_failure));
  line("self-test", test_text(found.test));
  return text;
}

Json report_json(const Diagnosis& found) {
  Json libraries = Json::array(), parts = Json::array();
  for (const LibraryVersion& one : library_versions()) {
    libraries.push_back({{"name", one.name}, {"version", one.version}});
    if (!one.built_with.empty()) libraries.back()["built_with"] = one.built_with;
  }
  for (const OptionalPart& part : found.parts) {
    parts.push_back({{"name", part.name}, {"available", part.available}, {"library", part.library}});
  }
  const Machine& machine = found.machine;
  return {{"commit", found.program.commit == "unknown" ? Json() : Json(found.program.commit)},
          {"compiler", found.program.compiler},
          {"flags", found.program.flags},
          {"libraries", std::move(libraries)},
          {"system", machine.system},
          {"processor", machine.processor},
          {"instruction_set", found.instruction_set},
          {"best_instruction_set", found.best_instruction_set},
          {"processors", machine.processors},
          {"threads", machine.allowed},
          {"processor_limit", machine.processor_limit ? Json(*machine.processor_limit) : Json()},
          {"memory", machine.memory},
          {"memory_available", machine.available},
          {"memory_limit", machine.memory_limit ? Json(*machine.memory_limit) : Json()},
          {"parts", std::move(parts)},
          {"progress", found.shows_progress},
          {"temporary", {{"folder", found.temporary}, {"writable", found.temporary_failure.empty()}}},
          {"self_test",
           {{"passed", found.test.failure.empty()},
            {"failure", found.test.failure},
            {"points", found.test.points},
            {"crossings", found.test.crossings},
            {"pieces", found.test.pieces},
            {"seconds", found.test.seconds}}}};
}

}  // namespace

void run_doctor(const std::vector<std::string>& arguments) {
  std::string json;
  OptionParser parser(
      "Reports the versions of lober and its libraries, the processor, memory and limits of this machine, and a "
      "self-test of the engine: the text for a bug report. The exit status is 1 where something is wrong.",
      "lober doctor");
  parser.add_example("lober doctor", "the text for a bug report");
  parser.add_example("lober doctor --json -", "the same as JSON");
  add_json_option(parser, json, "the report");
  if (!parser.parse(arguments)) return;
  (void)checked_outputs({{"--json", json}}, {});
  const Diagnosis found = diagnose();
  if (!json.empty()) write_listing(json, "doctor", "report", report_json(found));
  if (json != "-") print(report_text(found));
  if (!found.test.failure.empty()) throw DataError("the self-test failed: " + found.test.failure);
  if (!found.temporary_failure.empty()) {
    throw DataError(found.temporary + " cannot be written: " + found.temporary_failure +
                    "; set TMPDIR to a folder that can");
  }
}

}  // namespace lober::cli
