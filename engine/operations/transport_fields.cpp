#include "engine/operations/transport_fields.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

// Entries of matrices for the first two regions.
Measured entry(const RegionMatrix& matrix, std::size_t i, std::size_t j) {
  return matrix(i, j);
}

}  // namespace

Schema<TransportStep> step_schema() {
  using Step = TransportStep;
  const auto overlap = [](std::size_t i, std::size_t j) {
    return [i, j](const Step& s) { return s.overlaps[i][j].value; };
  };
  Schema<Step> overlaps;
  overlaps.field("L12_L12", "area", "common area of L12(1) and f^(n-1) L12(1)", overlap(0, 0))
      .field("L12_L21", "area", "common area of L12(1) and f^(n-1) L21(1)", overlap(0, 1))
      .field("L21_L12", "area", "common area of L21(1) and f^(n-1) L12(1)", overlap(1, 0))
      .field("L21_L21", "area", "common area of L21(1) and f^(n-1) L21(1)", overlap(1, 1));
  Schema<Step> made;
  made.field("n", "", "iterates", &Step::n)
      .field(
          "a", "area", "a21(n)", [](const Step& s) { return entry(s.flux, 1, 0); }, "a_error")
      .field(
          "T", "area", "T21(n) by lobes", [](const Step& s) { return entry(s.total, 1, 0); }, "discretisation")
      .field("overlap", "area", "common area of L12(1) and f^(n-1) L21(1)", overlap(0, 1))
      .field(
          "T_by_boundaries", "area", "T21(n) by boundaries", [](const Step& s) { return entry(s.by_boundaries, 1, 0); },
          "boundary_error")
      .field("consistency", "area", "|T21(n) by lobes - by boundaries|",
             [](const Step& s) { return std::fabs(s.total(1, 0).value - s.by_boundaries(1, 0).value); })
      .field("a12", "area", "a12(n) = T12(n) - T12(n - 1)", [](const Step& s) { return entry(s.flux, 0, 1); })
      .field("a21", "area", "a21(n) = T21(n) - T21(n - 1)", [](const Step& s) { return entry(s.flux, 1, 0); })
      .field("T12", "area", "area of the fluid from R1 that is in R2 after n iterates, by lobes",
             [](const Step& s) { return entry(s.total, 0, 1); })
      .field("T21", "area", "area of the fluid from R2 that is in R1 after n iterates, by lobes",
             [](const Step& s) { return entry(s.total, 1, 0); })
      .object("overlaps", "common areas of the lobes of the first turnstile with images of its lobes", overlaps,
              [](const Step& s) { return &s; })
      .field(
          "T_by_particles", "area", "T21(n) counted, with one standard deviation",
          [](const Step& s) { return s.by_particles.size() == 0 ? std::nullopt : std::optional(s.by_particles(1, 0)); },
          "particle_error")
      .field("a_ij", "area", "a_ij(n) of all regions, by lobes", &Step::flux)
      .field("T_ij", "area", "T_ij(n) of all regions, by lobes", &Step::total)
      .field("T_ij_by_boundaries", "area", "T_ij(n) of all regions, by boundaries", &Step::by_boundaries)
      .field("T_ij_by_particles", "area", "T_ij(n) counted, with one standard deviation", &Step::by_particles);
  return made;
}

Schema<Region> regions_schema() {
  Schema<Region> made;
  made.field("bounded", "", "whether it is", &Region::bounded)
      .field("area", "area", "not known where it is not bounded", &Region::area, "error");
  return made;
}

}  // namespace lober::detail::table
