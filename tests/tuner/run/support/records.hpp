#pragma once
// Records of runs for tests.

#include <gtest/gtest.h>

#include <string>

#include "tuner/run/run_record.hpp"

namespace armtune::internal::test {

/// Returns the input with this path; fails the test if there is none.
inline InputFact input_in(const RunRecord& run, const std::string& path) {
  for (const InputFact& input : run.inputs) {
    if (input.path == path) return input;
  }
  ADD_FAILURE() << "no input " << path;
  return {};
}

/// Returns a record in which every member has a value that is not its default, whatever its kind.
inline RunRecord whole_record() {
  RunRecord run;
  run.kind = RunKind::kPareto;
  run.command = "armtune pareto 'it''s <b>'";
  run.date = "2026-11-26T05:27:03Z";
  run.wall_seconds = 564.201;
  run.seed = 9007199254740993;  // more than a double can hold
  run.workers = 3;
  run.simulation = {Stepper::kRungeKutta4, Engine::kNative, "fnv1a-1"};
  run.compare = {{"published", "a \"set\""}};
  run.search = {"a study.yaml",  "published", "COBYLA",         Stepper::kReference,
                Engine::kNative, 297,         SearchEnd::kTime, "time used up after 297 evaluations"};
  run.tuned = {true, 0.35829592509754743, "fnv1a-2"};
  run.front = {{"objective", "gaze/rms"}, 49, true, 1.0 / 3.0};
  run.robustness = {
      1000, Stepper::kSemiImplicitEuler, Engine::kNative, {{"gaze/rms", true, 1e-300}, {"a", false, -0.5}}};
  run.distribution = {"a/uncertainty.yaml", {"delay", "payload/mass"}, {"elbow/torque_factor"}, {"delay"}};
  run.margins = {4, Stepper::kRungeKutta4};
  run.plan = {"switch",
              "target_switch",
              "0.1 s is the least time",
              0.1,
              {{"acquire", 0.06}, {"hold", 0.04}},
              60,
              1e-9,
              0.12,
              0.5,
              2e-7,
              3e-8,
              71,
              {{"tool_path", "tool path", "y", 1.25, 8.05}, {"gaze", "gaze", "", {}, 8.1}}};
  run.identification = {10001,
                        52,
                        12.5,
                        true,
                        {{"elbow", 3.0, 0.1, 0.2, 0.3}, {"wrist", {}, 0.5, {}, {}}},
                        {"the sign is wrong"}};
  run.validation = {false,
                    "the elbow differs",
                    "ur10",
                    2000,
                    20.0,
                    "position",
                    {{"elbow", true, 0.97, 1.5, 9.0, 0.4}, {"wrist", false, {}, 0.5, {}, {}}},
                    {"wrist: 61 % explained"},
                    {{"coulomb_friction", "wrist", 1.25, 0.75}},
                    {{"torques_exchanged", "elbow", "wrist", 0.5, 2.5, "the torques are exchanged"}},
                    {"no motion"},
                    {"positions: q1"},
                    {{"explained", 0.9}}};
  run.calibration = {
      true, "the error fell by 80 %",         "ur10",          "torque",         4000, 40.0, 2.0, 4, 0.2,
      31,   {{"delay", "changing_commands"}}, {"few windows"}, {"positions: q1"}};
  run.excitation = {true, 8.486};
  run.yardstick = {5, 0.9, 0.8, 120};
  run.versions = {{"armtune", "0.1.0"}, {"eigen", "3.4.0"}};
  run.machine = {"a processor", 2};
  run.arithmetic = {"baseline x86-64", "fnv1a-3"};
  run.inputs = {{"bundled robots/ur10.urdf", "fnv1a-4", "", true},
                {"b/c.yaml", "fnv1a-5", "inputs/01_c.yaml"}};
  return run;
}

}  // namespace armtune::internal::test
