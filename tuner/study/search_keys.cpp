#include "tuner/study/search_keys.hpp"

#include <fmt/format.h>

#include <limits>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Each search has a thread of its own.
constexpr long kMostStarts = 256;

/// Reads one of several names. Refuses any other name, with its line.
template <typename FromName>
auto read_name(yaml::MapReader& map, const char* key, const std::string& otherwise, FromName from_name) {
  try {
    return from_name(map.string(key, otherwise));
  } catch (const InputError& e) {
    if (!map.has(key)) throw;
    map.required(key).fail(e.what(), e.limit());
  }
}

std::string read_algorithm(yaml::MapReader& map, const char* key, const std::string& otherwise,
                           std::size_t parameters) {
  std::string algorithm = map.string(key, otherwise);
  if (!map.has(key)) return algorithm;
  try {
    algorithm_for(algorithm, parameters);
  } catch (const InputError& e) {
    map.required(key).fail(e.what(), e.limit());
  }
  return algorithm;
}

ConstraintHandling read_constraint_handling(const yaml::Node& node) {
  const std::string text = node.as_string();
  if (text == "auto") return ConstraintHandling::kAuto;
  if (text == "lagrangian") return ConstraintHandling::kLagrangian;
  if (text != "penalty") node.fail_choice({"auto", "lagrangian", "penalty"});
  return ConstraintHandling::kPenalty;
}

/// Returns the item of the list with this text, or the list if there is none.
const yaml::Node& find_item(const yaml::Node& list, const std::string& text) {
  for (const yaml::Node& item : list.items()) {
    if (item.is_word(text)) return item;
  }
  return list;
}

void read_engine(yaml::MapReader& map, Study& study) {
  study.stepper = read_name(map, "stepper", name(study.stepper), stepper_from_name);
  study.engine = read_name(map, "engine", name(study.engine), engine_from_name);
  study.verify_share = map.number_in("verify_share", study.verify_share, 0.0, 1.0);
  if (study.engine == Engine::kSimbody && map.has("verify_share")) {
    map.required("verify_share")
        .fail("has no effect, because Simbody does the search; leave it out, or give engine: native");
  }
  if (study.engine == Engine::kNative && study.stepper == Stepper::kReference) {
    map.required("stepper").fail(
        "the stepper 'reference' exists in Simbody only; give another stepper, or set engine: simbody");
  }
}

void read_final_phase(yaml::MapReader& map, Study& study) {
  const std::string phase = map.string("final_phase", "none");
  if (phase != "none" && phase != "minimax") map.required("final_phase").fail_choice({"none", "minimax"});
  study.final_phase = phase == "minimax";
  if (study.final_phase && study.own_objective) {
    map.required("final_phase")
        .fail(
            "the final phase models the metrics of the terms, but the study has an objective of your own; "
            "leave the key out",
            "none");
  }
  if (study.final_phase && study.stepper == Stepper::kReference) {
    map.required("final_phase")
        .fail(
            "the final phase needs derivatives from the native engine, which does not have the stepper "
            "'reference'; give another stepper, or leave the key out",
            "none");
  }
  study.final_share = map.number_in("final_share", study.final_share, 0.0, 1.0);
  if (map.has("final_share") && !study.final_phase) {
    map.required("final_share")
        .fail("the study has no final phase; give final_phase: minimax, or leave this key out");
  }
}

void read_differences(yaml::MapReader& map, SolverOptions& solver) {
  const std::string differences = map.string("differences", "forward");
  if (differences != "forward" && differences != "central") {
    map.required("differences").fail_choice({"forward", "central"});
  }
  solver.differences = differences == "forward" ? Differences::kForward : Differences::kCentral;
  solver.difference_step = map.number_in("difference_step", solver.difference_step, 1e-6, 0.5);
}

}  // namespace

void default_search(Study& study) {
  study.global_algorithm = "DIRECT_L";
  study.global_by_default = true;
  study.solver.algorithm = "COBYLA";
  study.solver.constraints = ConstraintHandling::kPenalty;
}

void read_search(const yaml::Node& node, Study& study) {
  yaml::MapReader map(node);
  if (!map.has("algorithm")) default_search(study);
  study.solver.algorithm = read_algorithm(map, "algorithm", study.solver.algorithm, study.space.free.size());
  if (map.has("constraints"))
    study.solver.constraints = read_constraint_handling(map.required("constraints"));
  study.solver.penalty = map.number_in("penalty", study.solver.penalty, 1e-6, 1e6);
  study.max_evaluations = map.integer("max_evaluations", study.max_evaluations);
  if (study.max_evaluations < 1)
    map.required("max_evaluations")
        .fail(fmt::format("is {}; it must be at least 1", study.max_evaluations), "at least 1");
  study.max_minutes = map.number_in("max_minutes", 0.0, 0.0, kInfinity);
  study.solver.initial_step = map.number_in("initial_step", study.solver.initial_step, 1e-6, 0.5);
  study.solver.x_tolerance = map.number_in("x_tolerance", study.solver.x_tolerance, 0.0, 1.0);
  study.solver.objective_tolerance =
      map.number_in("objective_tolerance", study.solver.objective_tolerance, 0.0, 1.0);
  const long seed = map.integer("seed", 1);
  if (seed < 0)
    map.required("seed").fail(fmt::format("is {}; it must not be negative", seed), "not negative");
  study.solver.seed = static_cast<std::uint64_t>(seed);
  read_engine(map, study);
  read_differences(map, study.solver);
  const long starts = map.integer("starts", 1);
  if (starts < 1 || starts > kMostStarts) {
    map.required("starts").fail(
        fmt::format("{} searches at once are not possible; give 1 .. {}", starts, kMostStarts),
        fmt::format("1 .. {}", kMostStarts));
  }
  study.starts = static_cast<std::size_t>(starts);
  if (map.has("global")) study.global_by_default = false;
  study.global_algorithm = read_algorithm(map, "global", study.global_algorithm, study.space.free.size());
  study.global_share = map.number_in("global_share", study.global_share, 0.0, 1.0);
  if (map.has("global_share") && study.global_algorithm.empty()) {
    map.required("global_share")
        .fail("the study has no global search; name one with 'global', or leave this key out");
  }
  read_final_phase(map, study);
  // Studies and run folders of earlier versions have this key. It changed no result, so it is ignored.
  map.boolean("end_outdone", true);
  map.finish();
}

void read_warm_start(const yaml::Node& node, Study& study) {
  yaml::MapReader map(node);
  WarmStart warm;
  const yaml::Node& from = map.required("from");
  const yaml::Node* names = map.optional("parameters");
  if (names != nullptr) {
    warm.parameters = names->as_strings();
    if (warm.parameters.empty()) names->fail("the list is empty; leave the key out to use all parameters");
  }
  warm.box = map.number_in("box", warm.box, 0.0, 1.0);
  if (warm.box <= 0.0)
    map.required("box").fail("must be above 0; it is a share of each parameter's range", "above 0");
  if (map.has("step")) warm.step = map.number_in("step", 0.0, 1e-6, 0.5);
  map.finish();
  try {
    load_warm_gains(warm, from.as_string(), study.space, joint_names(*study.scenarios.front().robot),
                    folder_of(study.source));
  } catch (const InputError& e) {
    from.fail(e.what(), e.limit());
  }
  try {
    warm_point(study.space, warm);
  } catch (const InputError& e) {
    (names == nullptr ? from : find_item(*names, e.value())).fail(e.what(), e.limit());
  }
  study.warm = std::move(warm);
}

}  // namespace armtune::internal
