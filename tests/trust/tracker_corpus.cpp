// Completes the files of tests/corpus/trackers: everything below the polygons is computed anew.
// usage: tracker_corpus FILE...
#include <exception>
#include <fstream>
#include <iostream>

#include "tests/trust/exact_case.hpp"

int main(int count, char** arguments) {
  using namespace lober::trust;
  try {
    for (int k = 1; k < count; ++k) {
      const TrackerCase given = read_tracker_case(arguments[k]);
      const std::string text = case_text(given, exact_case(given));
      if (text == given.text) continue;
      std::ofstream(arguments[k]) << text;
      std::cout << "wrote " << arguments[k] << "\n";
    }
  } catch (const std::exception& error) {
    std::cerr << "tracker_corpus: " << error.what() << "\n";
    return 1;
  }
  return count > 1 ? 0 : 2;
}
