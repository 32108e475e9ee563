// Jobs on curves that come from a system: tangles of manifolds, images of boundaries, transport over a grid.
#include <map>

#include "engine/batch/batch.hpp"
#include "engine/batch/export/export.hpp"
#include "engine/batch/plan_runner.hpp"
#include "lober/curve/files.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/tangle/tangle.hpp"
#include "lober/transport/transport.hpp"
#include "tests/engine/batch/scratch_folder.hpp"
#include "tests/engine/geometry/tangle/tangle_scenes.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

// The parts of a result that are the same in every run.
struct RecordNumbers {
  Buffer<double> values;
  std::vector<std::vector<double>> lists;
  friend bool operator==(const RecordNumbers&, const RecordNumbers&) = default;
};

class SystemJobs : public ScratchFolder {
 protected:
  Manifest manifest(const std::string& text) {
    write("job.toml", text);
    return read_manifest(path("job.toml"));
  }
  // Results by job; messages of failures are their own check.
  std::map<std::size_t, RecordNumbers> results(const std::string& text, int threads = 2) {
    const Plan plan = make_plan(manifest(text));
    const std::vector<std::uint32_t> jobs = jobs_of(plan, {});
    PlanRunner runner(plan, path("job.toml"), jobs, {.threads = threads});
    std::map<std::size_t, RecordNumbers> found;
    messages.clear();
    runner.run(jobs, [&](const Result& result) {
      if (result.failed()) messages[result.job] = result.error;
      if (!result.failed()) found[result.job] = {result.values, result.lists};
    });
    return found;
  }
  // The number of results that a second run on the same store finds.
  std::size_t found_again(const std::string& first, const std::string& second) {
    BatchOptions options;
    options.store = path("store");
    EXPECT_EQ(run_batch(manifest(first), options).queue.failed, 0U);
    return run_batch(manifest(second), options).finished_before;
  }
  std::string refusal(const std::string& text) {
    try {
      (void)make_plan(manifest(text));
    } catch (const UsageError& error) {
      return std::string(error.what()).substr(path("").size());
    }
    return "";
  }
  std::map<std::size_t, std::string> messages;
};

TEST_F(SystemJobs, TangleOfFilesIsTheTangle) {
  oracle::Random random(5);
  std::vector<ManifoldPair> pairs;
  std::string list;
  for (int k = 0; k < 6; ++k) {
    pairs.push_back(k == 0 ? leaning_fingers(6, 50, 2.5) : random_manifolds(random, 400, 3));
    const std::string number = std::to_string(k);
    write_npy(path("u" + number + ".npy"), pairs.back().u);
    write_npy(path("s" + number + ".npy"), pairs.back().s);
    list += "[\"u" + number + ".npy\", \"s" + number + ".npy\"],";
  }
  const auto found =
      results("operation = \"tangle\"\noptions = { overlaps = true, check_simple = false }\npairs = [" + list + "]\n");
  ASSERT_EQ(found.size(), pairs.size());
  std::size_t lobes = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Tangle direct = tangle(open(pairs[k].u), open(pairs[k].s), {.check_simple = false});
    const RecordNumbers& record = found.at(k);
    EXPECT_EQ(record.values[0], static_cast<double>(direct.nodes.crossings()));
    EXPECT_EQ(record.values[3], static_cast<double>(direct.pips.size()));
    EXPECT_EQ(record.values[6], direct.images.period);
    ASSERT_EQ(record.lists[0].size(), direct.lobes.size());
    for (std::size_t i = 0; i < direct.lobes.size(); ++i) {
      EXPECT_EQ(record.lists[0][i], direct.lobes[i].area);
      EXPECT_EQ(record.lists[1][i], direct.lobes[i].inside);
    }
    std::array<std::vector<double>, 3> both_lobes;
    for (const LobeOverlap& both : overlaps(direct)) {
      both_lobes[0].push_back(both.i);
      both_lobes[1].push_back(both.j);
      both_lobes[2].push_back(both.area);
    }
    for (std::size_t column = 0; column < 3; ++column) EXPECT_EQ(record.lists[3 + column], both_lobes[column]);
    lobes += direct.lobes.size();
  }
  EXPECT_GT(found.at(0).lists[3].size(), 1U);
  EXPECT_GT(lobes, 10U);
}

TEST_F(SystemJobs, TangleOfManifoldsGrownOnTheFly) {
  const std::string text = R"(operation = "tangle"
options = { smooth = true }
curves = [{ system = "standard", parameters = { K = 1.2 }, manifold = "unstable", iterates = 5, tolerance = 1e-5 },
          { system = "standard", parameters = { K = 1.2 }, manifold = "stable", iterates = 5, tolerance = 1e-5 }]
)";
  const auto found = results(text);
  ASSERT_EQ(messages, (std::map<std::size_t, std::string>{}));
  const System system = make_system("standard", {{"K", 1.2}});
  const auto branch = [&](ManifoldSide side, Point saddle, Point direction) {
    const LocalManifold local = local_manifold(*system.map, saddle, side);
    return grow(*system.map, local, branch_towards(local, direction), {.tolerance = 1e-5, .iterates = 5});
  };
  const Connection& connection = *system.connection;
  const GrownManifold u = branch(ManifoldSide::unstable, connection.from, connection.u_direction);
  const GrownManifold s = branch(ManifoldSide::stable, connection.to, connection.s_direction);
  const Tangle direct = tangle(u, s, {.smooth = true});
  ASSERT_GT(direct.lobes.size(), 2U);
  for (std::size_t k = 0; k < direct.lobes.size(); ++k) EXPECT_EQ(found.at(0).lists[0].at(k), direct.lobes[k].area);
  EXPECT_EQ(found.at(0).values[8], direct.boundary->area);

  EXPECT_EQ(found_again(text, text), 1U);
  std::string finer = text;
  finer.replace(finer.rfind("1e-5"), 4, "1e-6");
  EXPECT_EQ(found_again(text, finer), 0U);
}

TEST_F(SystemJobs, AllOverlapsOfTheIteratesOfABoundary) {
  std::vector<Point> circle = wavy(500, 0);
  for (Point& p : circle) p = {3 + 0.5 * p.x, 0.5 * p.y};
  write_npy(path("boundary.npy"), circle);
  const std::string text =
      "operation = \"overlay\"\ncurves = { system = \"standard\", parameters = { K = 0.6 }, "
      "image_of = \"boundary.npy\", iterates = \"0:4\", tolerance = 1e-5 }\n";
  const Plan plan = make_plan(manifest(text));
  ASSERT_EQ(plan.curves.size(), 5U);
  EXPECT_EQ(plan.name(0), "boundary.npy");
  EXPECT_EQ(plan.name(3), "image(boundary.npy, standard, K=0.6, iterates=3, tolerance=1e-05)");
  EXPECT_EQ(Plan::decoded(plan.encoded()).encoded(), plan.encoded());
  const auto found = results(text);
  ASSERT_EQ(found.size(), 10U);
  const System system = make_system("standard", {{"K", 0.6}});
  const auto at = [&](int n) { return image_of(*system.map, n, CurveView{circle}, {.tolerance = 1e-5}); };
  std::size_t job = 0;
  for (int i = 0; i < 5; ++i) {
    for (int k = i + 1; k < 5; ++k, ++job) {
      const CurveImage first = at(i), second = at(k);
      const Overlay direct = overlay(i == 0 ? CurveView{circle} : CurveView(first), second);
      EXPECT_EQ(found.at(job).values[2], direct.areas.intersection);
      EXPECT_NEAR(direct.areas.c1, direct.areas.c2, 1e-4);  // the map preserves areas
    }
  }
  EXPECT_EQ(results(text, 1), found);
  EXPECT_EQ(found_again(text, text), 10U);
  circle[7].x += 1e-3;  // an edited boundary changes all of its images
  write_npy(path("boundary.npy"), circle);
  EXPECT_EQ(found_again(text, text), 10U);
  BatchOptions options;
  options.store = path("store");
  circle[8].x += 1e-3;
  write_npy(path("boundary.npy"), circle);
  EXPECT_EQ(run_batch(manifest(text), options).finished_before, 0U);
}

TEST_F(SystemJobs, TransportOverAGridOfParameters) {
  const std::string text = R"(operation = "transport"
options = { system = "standard", iterates = 3 }
grid = { parameters.K = [0.9, 1.2] }
)";
  const auto found = results(text);
  ASSERT_EQ(found.size(), 2U);
  const System system = make_system("standard", {{"K", 1.2}});
  TransportOptions how;
  how.iterates = 3;
  how.lattice = system.lattice;
  how.further = system.further;
  const Transport direct = transport(*system.map, *system.connection, how);
  EXPECT_EQ(found.at(1).values[0], direct.regions[0].area.value);
  EXPECT_EQ(found.at(1).values[5], direct.boundaries[0].lobe_area12_by_action);
  ASSERT_EQ(found.at(1).lists[0].size(), 3U);
  EXPECT_EQ(found.at(1).lists[1][2], direct.steps[2].total(1, 0).value);
  EXPECT_NE(found.at(0).values[0], found.at(1).values[0]);
  EXPECT_EQ(found_again(text, text), 2U);
  const Store store = Store::open(path("store"));
  const ExportCounts counts = export_results(store, path("out.csv"), ExportFormat::csv);
  EXPECT_EQ(counts.done, 2U);
}

TEST_F(SystemJobs, WhatCannotBeMadeIsAFailureOfItsJobs) {
  write_npy(path("good.npy"), wavy(100, 0));
  const auto found = results(R"(operation = "overlay"
curves = ["good.npy", { system = "standard", image_of = "good.npy", iterates = 1, tolerance = 1e-3 },
          { system = "standard", manifold = "stable", iterates = 2, tolerance = 1e-3 }]
)");
  EXPECT_EQ(found.size(), 1U);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_NE(messages[1].find("is open, a closed curve is needed"), std::string::npos) << messages[1];
}

TEST_F(SystemJobs, RefusalsNameLineAndKey) {
  const auto curve = [&](const std::string& inside) {
    return refusal("operation = \"densify\"\ncurves = { " + inside + " }\noptions.max_length = 1");
  };
  const std::string good = "system = \"standard\", tolerance = 1e-3, ";
  EXPECT_EQ(curve(good + "manifold = \"stable\", iterates = 3"), "");
  EXPECT_EQ(curve(good + "iterates = 3"), "job.toml:2: curves: has to have either manifold or image_of");
  EXPECT_EQ(curve(good + "manifold = \"stable\""), "job.toml:2: curves: a manifold needs iterates or length");
  EXPECT_EQ(curve(good + "manifold = \"stable\", iterates = \"3:1\""),
            "job.toml:2: curves: iterates has to be a whole number or \"a:b\" with a <= b, from -10000 to 10000");
  EXPECT_EQ(curve(good + "manifold = \"stable\", iterates = 1, from = [0, 0], branch = \"+\""), "");
  EXPECT_EQ(curve(good + "manifold = \"stable\", iterates = 1, from = 0"), "job.toml:2: curves: from has to be [x, y]");
  EXPECT_EQ(curve(good + "manifold = \"stable\", iterates = 1, parameters = { q = 1 }").substr(0, 55),
            "job.toml:2: curves: system standard has no parameter 'q");
  EXPECT_EQ(curve("system = \"standard\", manifold = \"stable\", iterates = 1"),
            "job.toml:2: curves: tolerance has to be given and positive");
  EXPECT_EQ(curve("system = \"./a.so\", tolerance = 1, manifold = \"stable\", iterates = 1"),
            "job.toml:2: curves: a manifest cannot use systems from shared libraries");
  EXPECT_EQ(curve(good + "image_of = \"nothing\", iterates = 1"), "job.toml:2: curves: there is no file nothing");
  EXPECT_EQ(refusal("operation = \"transport\""), "job.toml:1: options.system: the name of a system is missing");
  EXPECT_EQ(refusal("operation = \"transport\"\ncurves = \"a\"\noptions.system = \"standard\""),
            "job.toml:2: curves: transport has no curves");
  EXPECT_EQ(refusal("operation = \"transport\"\noptions = { system = \"standard\", parameters = { K = true } }"),
            "job.toml:2: options.parameters.K: has to be a number");
}

}  // namespace
}  // namespace lober::detail
