// A store of results whose bytes are not what was written. The input is a list of edits of a sound store, each a place
// (three bytes), a byte that is xored into it; the first byte of the input says whether it is that, or an encoded plan
// or encoded results.
#include <fstream>
#include <sstream>

#include "engine/batch/batch.hpp"
#include "engine/batch/export/export.hpp"
#include "fuzz_reader.hpp"

using namespace lober;
using namespace lober::detail;

namespace {

std::string bytes_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

// A folder of this process, with a store that was filled by a batch.
class Scene {
 public:
  Scene() : folder_(fuzz::scratch() + ".store") {
    std::filesystem::create_directory(folder_);
    write(path("a"), "0 0\n2 0\n2 2\n0 2\n");
    write(path("b"), "1 1\n3 1\n3 3\n1 3\n");
    write(path("c"), "0 0\n1 1\n1 0\n0 1\n");
    write(path("job.toml"), "operation = \"overlay\"\ncurves = [\"a\", \"b\", \"c\"]\noptions = { lobes = true }\n");
    static_cast<void>(run_batch(read_manifest(path("job.toml")), {path("store"), {}, {.threads = 1}, {}}));
    sound = bytes_of(path("store"));
    rows = exported("store");
  }
  ~Scene() { std::filesystem::remove_all(folder_); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }
  [[nodiscard]] std::string exported(const std::string& store) const {
    const Store opened = Store::open(path(store));
    export_results(opened, path("out.jsonl"), ExportFormat::json_lines);
    static_cast<void>(survey(opened));
    return bytes_of(path("out.jsonl"));
  }

  std::string sound, rows;

 private:
  std::string folder_;
};

template <typename Decode>
void decoded(std::string_view bytes, const Decode& decode) {
  try {
    decode(bytes);
  } catch (const Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 4 == 0) {
    decoded(rest, [](std::string_view bytes) {
      const Plan plan = Plan::decoded(bytes);
      fuzz::require(Plan::decoded(plan.encoded()).encoded() == plan.encoded(), "a plan is not read back");
    });
  } else if (data[0] % 4 == 1) {
    decoded(rest, [](std::string_view bytes) {
      const std::string again = encoded(decoded_results(bytes).results);
      fuzz::require(encoded(decoded_results(again).results) == again, "results are not read back");
    });
  } else {
    static const Scene scene;
    std::string bytes = scene.sound;
    for (std::size_t k = 1; k + 4 <= size; k += 4) {
      const std::size_t at = (data[k] | data[k + 1] << 8 | data[k + 2] << 16) % bytes.size();
      bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(data[k + 3]));
    }
    for (const char* const end : {"-wal", "-shm"}) std::filesystem::remove(scene.path("damaged") + end);
    write(scene.path("damaged"), bytes);
    try {
      std::istringstream lines(scene.exported("damaged"));
      for (std::string line; std::getline(lines, line);) {
        fuzz::require(scene.rows.find(line + "\n") != std::string::npos, "a damaged row is exported");
      }
    } catch (const Error&) {
    }
  }
  return 0;
}
