#include "bench/harness/memory.hpp"

#include <malloc.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "bench/harness/measure.hpp"

namespace lober::bench {
namespace {

// A line such as "VmHWM:   1234 kB" of the status of this process, in bytes.
double status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(key + ":", 0) == 0) return 1024 * std::stod(line.substr(key.size() + 1));
  }
  throw std::runtime_error("this system does not report " + key);
}

}  // namespace

double measure_memory(const SceneKind& kind, std::size_t points) {
  {
    // Threads, their stacks and other one-time costs are not the job's.
    const Scene small = find_scene("lens")->make(1000);
    (void)overlay_once(small, 1, {});
  }
  const Scene scene = kind.make(points);
  malloc_trim(0);  // what making the scene left behind would be used again and hide as much of the job's
  std::ofstream("/proc/self/clear_refs") << 5;  // sets the peak back to what is held now
  const double before = status_bytes("VmRSS");
  if (status_bytes("VmHWM") > before + 0x1p20) throw std::runtime_error("the peak of memory cannot be set back");
  (void)overlay_once(scene, 1, {});
  return (status_bytes("VmHWM") - before) / static_cast<double>(scene.first.size() + scene.second.size());
}

}  // namespace lober::bench
