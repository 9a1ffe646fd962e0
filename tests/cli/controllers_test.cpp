// One declaration of a controller's gain reaches everything that is made from it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "core/control/laws/controller_kind.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/cli/controllers_page.hpp"
#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/report/sections.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace controllers_test {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

/// A study whose arm is known: most controllers learn nothing.
struct KnownArm : test::ShortStudy {
  explicit KnownArm(const std::string& search = test::kShortSearch)
      : ShortStudy(test::kShortParameters, test::kShortObjective, test::kShortConstraints, search) {
    write("short.yaml", "base: moving_target\nduration: 8\ntheta_start: {model_scale: 1}\n");
  }
};

/// evaluations.csv without its last column, the time that has passed.
std::string evaluations_of(const std::string& run) {
  std::istringstream lines(test::read_text(run + "/evaluations.csv"));
  std::string kept;
  for (std::string line; std::getline(lines, line);) kept += line.substr(0, line.rfind(',')) + '\n';
  return kept;
}

class Damper final : public TorqueLaw {
 public:
  explicit Damper(const LawSetup& setup) : TorqueLaw(setup), damping_(own(setup.gains, "declared_here")[0]) {}
  void torque(const LawInput& in, JointVector& tau) override {
    const JointReference& reference = in.control.reference;
    model_torque(in.arm, in.measured.qd, reference.velocity, reference.acceleration, tau);
    tau -= damping_ * in.control.S;
  }

 private:
  double damping_;
};

TEST(OneDeclaration, OfAGainReachesFilesHelpDocsSearchSpaceReportAndJournal) {
  ControllerKind damper;
  damper.name = "damper";
  damper.meaning = "the model and a damper";
  damper.uses = {"task_space_gains_p", "task_space_gains_i"};
  // The line:
  damper.own = {own_gain(GainShape::kScalar, "declared_here", "N m s", "damping of all joints alike", 42.5)};
  damper.make = [](const LawSetup& setup) { return std::make_unique<Damper>(setup); };
  register_controller(damper);

  const KnownArm files;
  const Study study = load_study(files.path(), "damper");
  const Gains& gains = study.space.start;
  EXPECT_THAT(gains_yaml(gains, {}),
              AllOf(HasSubstr("controller: damper"), HasSubstr("# damping of all joints alike [N m s]"),
                    HasSubstr("declared_here: 42.5")));
  EXPECT_EQ(own(load_gains(files.write("damper.yaml", gains_yaml(gains, {})),
                           joint_names(*study.scenarios[0].robot)),
                "declared_here")[0],
            42.5);

  EXPECT_THAT(
      cli::controllers_text(),
      ContainsRegex(
          "\\* declared_here +number +0.2 to 5 times the start +damping of all joints alike \\[N m s\\]"));

  const auto found = std::find_if(study.space.free.begin(), study.space.free.end(),
                                  [](const Parameter& p) { return p.entry.name == "declared_here"; });
  ASSERT_NE(found, study.space.free.end());
  EXPECT_NEAR(found->lower, 0.2 * 42.5, 1e-12);
  EXPECT_NEAR(found->upper, 5.0 * 42.5, 1e-12);

  bool in_file = false;
  for (const Column& column : evaluation_columns(study)) in_file = in_file || column.name == "declared_here";
  EXPECT_TRUE(in_file) << "evaluations.csv";
  EXPECT_THAT(study_yaml(study, "gains.yaml"), HasSubstr("declared_here"))
      << "study.yaml and the journal's head";

  const auto shown = report::gains_of({{"declared_here", 42.5, 8.5, 212.5, "log"}},
                                      joint_names(*study.scenarios[0].robot), {files / "damper.yaml"});
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_STREQ(shown[0].unit.c_str(), "N m s");
  EXPECT_EQ(shown[0].values, std::vector<double>{42.5});

  const RolloutResult result = Rollout(study.scenarios[0], Stepper::kMidpoint, Engine::kNative).run(gains);
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
}

TEST(ControllersCommand, ListsThemWithEveryGain) {
  const Finished list = run_program({"controllers"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.out, AllOf(HasSubstr("\nadaptive\n"), HasSubstr("\nimpedance\n")));
  const std::string text = cli::controllers_text();  // with those that other tests have registered
  for (const ControllerKind* kind : controller_kinds()) {
    EXPECT_THAT(text, HasSubstr("\n" + kind->name + "\n"));
    for (const GainField& field : fields_of(*kind))
      EXPECT_THAT(text, HasSubstr(" " + std::string(field.name) + " ")) << kind->name;
  }
}

TEST(Controllers, ThatLearnNothingAreNotLeftWithNothingSilently) {
  const test::TemporaryFolder folder;
  const auto warned = [&](const char* controller, const char* scale) {
    const Scenario moving = test::scenario_of("moving_target");
    const Gains gains = convert_gains(controller_kind(controller), test::quick_gains(moving), *moving.robot,
                                      in_si(*moving.robot, test::quick_gains(moving).joint_space_goal));
    folder.write("gains.yaml", gains_yaml(gains, {}));
    folder.write("task.yaml", std::string("base: moving_target\nduration: 1\ntheta_start: {model_scale: ") +
                                  scale + "}\n");
    return run_program({"simulate", folder / "task.yaml", "--gains", folder / "gains.yaml"}).err;
  };
  EXPECT_THAT(warned("impedance", "0"),
              AllOf(HasSubstr("impedance does not adapt"), HasSubstr("model_scale: 1")));
  EXPECT_THAT(warned("impedance", "1"), testing::Not(HasSubstr("does not adapt")));
  EXPECT_THAT(warned("adaptive", "0"), testing::Not(HasSubstr("does not adapt")));
}

TEST(Controllers, AreTunedAndResumedAndReportedByName) {
  const KnownArm files;
  const Finished tuned =
      run_program({"tune", files.path(), "--controller", "computed_torque", "--max-evaluations", "10",
                   "--out", files / "run", "--workers", "2", "--no-analysis"});
  ASSERT_THAT(tuned.exit_code, testing::AnyOf(0, 3)) << tuned.err << tuned.out;
  EXPECT_THAT(test::read_text(files / "run/gains.yaml"), HasSubstr("controller: computed_torque"));
  EXPECT_THAT(test::read_text(files / "run/start/gains.yaml"), HasSubstr("computed_torque_d: [60.0, 60.0"));
  const test::Csv evaluations(test::read_text(files / "run/evaluations.csv"));
  EXPECT_EQ(std::stod(evaluations.at(0, "computed_torque_d/rx")), 60.0);
  const Finished again = run_program({"tune", "--resume", files / "run"});
  EXPECT_THAT(again.out, HasSubstr("is finished"));
  // Cut off after five evaluations, as one that was killed, it ends the same.
  std::filesystem::copy(files / "run", files / "cut", std::filesystem::copy_options::recursive);
  std::istringstream journal(test::read_text(files / "run/journal.txt"));
  std::string kept, line;
  for (int records = -1; records < 4 && std::getline(journal, line); kept += line + '\n') {
    if (records >= 0 || line.find("records") != std::string::npos) ++records;
  }
  files.write("cut/journal.txt", kept);
  const Finished resumed = run_program({"tune", "--resume", files / "cut", "--workers", "1"});
  ASSERT_EQ(resumed.exit_code, tuned.exit_code) << resumed.err;
  EXPECT_TRUE(evaluations_of(files / "cut") == evaluations_of(files / "run"));
  for (const char* file : {"/gains.yaml", "/errors.csv"})
    EXPECT_TRUE(test::read_text(files / "cut" + file) == test::read_text(files / "run" + file)) << file;
  // Gains of one controller are no start for another.
  const Finished warm = run_program({"tune", files.path(), "--warm-start", files / "run"});
  EXPECT_EQ(warm.exit_code, 2);
  EXPECT_THAT(warm.err, AllOf(HasSubstr("gains of the controller computed_torque"), HasSubstr("adaptive")));
  const Finished wrong = run_program({"tune", files.path(), "--controller", "pid"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, AllOf(HasSubstr("'pid' is not a controller"), HasSubstr("impedance")));
}

// Those without lanes are simulated alone, in the native engine too, by any number of workers.
TEST(Controllers, AreSearchedInTheNativeEngineByAnyNumberOfWorkers) {
  const KnownArm files(
      "search: {algorithm: CRS2, max_evaluations: 14, seed: 1, engine: native, verify_share: 0.2}\n");
  for (const char* workers : {"1", "2"}) {
    const Finished done =
        run_program({"tune", files.path(), "--controller", "impedance", "--out",
                     files / (std::string("run") + workers), "--workers", workers, "--no-analysis"});
    ASSERT_THAT(done.exit_code, testing::AnyOf(0, 3)) << done.err;
    EXPECT_THAT(done.out, ContainsRegex("note: impedance_k [^\n]*--max-stiffness[^\n]*\n"));
  }
  EXPECT_TRUE(evaluations_of(files / "run1") == evaluations_of(files / "run2"));
  EXPECT_EQ(test::read_text(files / "run1/gains.yaml"), test::read_text(files / "run2/gains.yaml"));
}

// Bounds for the stiffness by an option, which a resumed run keeps.
TEST(Controllers, TheStiffnessIsTunedUpToTheGivenBound) {
  const KnownArm files("search: {algorithm: CRS2, max_evaluations: 6, seed: 1, engine: native}\n");
  const Finished done =
      run_program({"tune", files.path(), "--controller", "impedance", "--max-stiffness", "30000", "9000",
                   "--out", files / "run", "--workers", "1", "--no-analysis"});
  ASSERT_THAT(done.exit_code, testing::AnyOf(0, 3)) << done.err;
  EXPECT_THAT(done.out, AllOf(HasSubstr("\nimpedance_k/rz "), testing::Not(HasSubstr("note: impedance_k"))));
  EXPECT_THAT(test::read_text(files / "run/study.yaml"), HasSubstr("upper: 30000"));
  const Finished resumed = run_program({"tune", "--resume", files / "run", "--workers", "1"});
  EXPECT_THAT(resumed.exit_code, testing::AnyOf(0, 3)) << resumed.err;
  const Finished front =
      run_program({"pareto", files.path(), "--controller", "impedance", "--max-stiffness", "30000", "9000",
                   "--max-evaluations", "8", "--levels", "2", "--workers", "1", "--out", files / "front"});
  ASSERT_THAT(front.exit_code, testing::AnyOf(0, 3)) << front.err;
  EXPECT_THAT(test::read_text(files / "front/study.yaml"), HasSubstr("upper: 30000"));
  EXPECT_THAT(front.out, testing::Not(HasSubstr("note: impedance_k")));
  for (const char* command : {"tune", "pareto"}) {
    const Finished wrong = run_program({command, files.path(), "--max-stiffness", "5"});
    EXPECT_EQ(wrong.exit_code, 2) << command;
    EXPECT_THAT(wrong.err, AllOf(HasSubstr("--max-stiffness"), HasSubstr("adaptive"))) << command;
  }
}

}  // namespace controllers_test
}  // namespace armtune::internal
