// Compares methods that keep the adaptation bounded under measurement noise, and their cost: leakage, a dead
// zone on S, filtered references, and the regressor along the desired motion. For each it prints the errors
// in the bundled realistic scenarios with unknown payloads, relative to those of the law without any bound,
// and the result of a long run.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "armtune/error.hpp"
#include "core/control/adaptation.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/task_resolution.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/limit_watch.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/endurance/error_windows.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/workers/parallel.hpp"

namespace {

using namespace armtune::internal;

/// How a compared law forms Y and S of its adaptation; the torque is that of the adaptive law.
enum class Bound { kDeadZone, kDesired };

/// The adaptive law with a bound that armtune's own law does not offer: a dead zone on S, or Y along the
/// desired motion, with references without feedback (Sadegh and Horowitz 1990). In states that track joints,
/// Y uses the measured motion.
class ComparedLaw final : public TorqueLaw {
 public:
  ComparedLaw(const LawSetup& setup, Bound bound, double size)
      : TorqueLaw(setup),
        gains_(setup.gains),
        period_(setup.period),
        bound_(bound),
        size_(size),
        adaptation_(setup.theta),
        centering_(joint_centering(setup.model, setup.gains.joint_centering_gain)) {}

  void torque(const LawInput& in, JointVector& tau) override {
    const JointReference& reference = in.control.reference;
    const JointVector& qd = in.measured.qd;
    slotine_li_forward(chain_, in.arm.poses, qd, reference.velocity, reference.acceleration, motion_);
    slotine_li_torque(chain_, in.arm.poses, motion_, adaptation_.theta(), tau);
    tau -= in.Kd.cwiseProduct(in.control.S);
    if (bound_ == Bound::kDeadZone) {
      const JointVector kept = in.control.S - in.control.S.cwiseMax(-size_).cwiseMin(size_);
      slotine_li_forward(chain_, in.arm.poses, JointVector(reference.velocity + kept), reference.velocity,
                         reference.acceleration, error_);
      return;
    }
    error_ = motion_;
    along_ = motion_;
    if (tracks_joints(in.control.state)) return;
    const CartesianErrors& x = in.control.errors;
    Vec6 L = resolve_velocity(x.desired_rate, in.arm, centering_, in.measured.q, desired_.velocity);
    resolve_acceleration({x.desired_rate, x.desired_accel}, in.arm, centering_, desired_.velocity, L,
                         desired_);
    slotine_li_forward(chain_, in.arm.poses, desired_.velocity, desired_.velocity, desired_.acceleration,
                       along_);
  }

  void conclude(bool learning) override {
    if (!learning) return;
    adaptation_.step(bound_ == Bound::kDesired ? along_ : motion_, error_, gains_.adaptation_gain, period_);
    if (gains_.adaptation_leakage > 0.0)
      adaptation_.leak(gains_.adaptation_leakage, gains_.adaptation_inertia_leakage, period_);
    if (gains_.adaptation_projection) adaptation_.project();
  }

  const ParameterVector& theta() const override { return adaptation_.theta(); }

 private:
  const Gains& gains_;
  double period_;
  Bound bound_;
  double size_;  ///< half-width of the dead zone [rad/s]
  Adaptation adaptation_;
  SlotineLi along_, error_;
  JointReference desired_;
  JointCentering centering_;
};

ControllerKind compared(const std::string& name, Bound bound, double size) {
  ControllerKind kind;
  kind.name = name;
  kind.meaning = "the adaptive law with another bound of its adaptation";
  kind.uses = controller_kind("adaptive").uses;
  kind.make = [bound, size](const LawSetup& setup) {
    return std::make_unique<ComparedLaw>(setup, bound, size);
  };
  kind.learns = true;
  return kind;
}

struct Variant {
  std::string name;
  Gains gains;
};

std::vector<Variant> variants(Gains gains) {
  gains.adaptation_filter = 0.0;
  gains.adaptation_leakage = 0.0;
  gains.adaptation_inertia_leakage = 0.0;
  gains.roll_centering_gain = 0.1;  // otherwise the last joint winds up before theta has drifted far
  std::vector<Variant> all = {{"no bound (projection alone)", gains}};
  Gains still = gains;
  still.adaptation_gain = 0.0;
  all.push_back({"no adaptation", still});
  for (const double leakage : {0.001, 0.002, 0.005, 0.01}) {
    Gains g = gains;
    g.adaptation_leakage = leakage;
    all.push_back({fmt::format("leakage {} /s", leakage), g});
  }
  for (const double sigmas : {1.0, 3.0}) {
    Gains g = gains;
    g.controller = fmt::format("dead_zone_{}", sigmas);
    all.push_back({fmt::format("dead zone of {} sigma", sigmas), g});
  }
  for (const double corner : {1.0, 5.0}) {
    Gains g = gains;
    g.adaptation_filter = corner;
    all.push_back({fmt::format("references filtered at {} Hz", corner), g});
    for (const double leakage : {0.001, 0.005}) {
      g.adaptation_leakage = leakage;
      all.push_back({fmt::format("filtered at {} Hz, leakage {} /s", corner, leakage), g});
    }
    g.adaptation_leakage = 0.001;
    g.adaptation_inertia_leakage = 0.02;
    all.push_back({fmt::format("the same, {} and {} /s of inertias", 0.001, 0.02), g});
  }
  for (const double leakage : {0.0, 0.001}) {
    Gains g = gains;
    g.controller = "desired_motion";
    g.adaptation_leakage = leakage;
    all.push_back(
        {leakage > 0.0 ? fmt::format("desired motion, leakage {} /s", leakage) : "desired motion", g});
  }
  return all;
}

struct LongRun {
  std::string broken;
  double effort = 0.0;
  double rms_growth = 0.0;
  double peak_growth = 0.0;
};

LongRun endure(Scenario scenario, const Gains& gains, double seconds) {
  scenario.duration = seconds;
  LimitWatch limits(*scenario.robot);
  ErrorWindows errors(0.0, seconds, scenario.control_period);
  const RolloutResult result =
      Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains, [&](const Observation& o) {
        limits.look(o);
        errors.look(o);
        return !limits.any();
      });
  LongRun run;
  if (limits.any()) {
    run.broken = to_string(limits.broken().front());
  } else if (result.status != RolloutStatus::kCompleted) {
    run.broken = result.reason;
  }
  run.effort = result.metrics[Metric::kJointEffortMaxRatio];
  run.rms_growth = errors.rms_growth();
  run.peak_growth = errors.peak_growth();
  return run;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares what keeps the adaptation bounded under measurement noise");
  double seconds = 2000.0;
  std::string gains_name = "extended_tuned";
  std::string folder;
  std::vector<std::string> names = {"identified_realistic_moving_target",
                                    "identified_realistic_target_switch",
                                    "identified_realistic_obstacle_pass"};
  int workers = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  app.add_option("--seconds", seconds, "of the long run")->capture_default_str();
  app.add_option("--gains", gains_name, "bundled gains or a YAML file")->capture_default_str();
  app.add_option("--scenarios", names, "bundled scenarios or YAML files");
  app.add_option("--out", folder, "folder for adaptation.csv and run.json");
  app.add_option("--workers", workers, "threads")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    constexpr double kNoise = 0.01;  // velocity noise of the realistic scenarios [rad/s]
    for (const double sigmas : {1.0, 3.0}) {
      register_controller(compared(fmt::format("dead_zone_{}", sigmas), Bound::kDeadZone, sigmas * kNoise));
    }
    register_controller(compared("desired_motion", Bound::kDesired, 0.0));
    std::vector<Scenario> scenarios;
    for (const std::string& name : names) scenarios.push_back(load_scenario(name));
    const auto all = variants(load_gains(gains_name, joint_names(*scenarios.front().robot)));
    const std::vector<double> payloads = {0.0, 1.0, 2.0, 3.0};
    const std::size_t columns = scenarios.size() * payloads.size();
    std::vector<std::vector<RolloutResult>> shorts(all.size(), std::vector<RolloutResult>(columns));
    std::vector<std::vector<LongRun>> longs(all.size(), std::vector<LongRun>(scenarios.size()));
    const std::atomic<bool> never{false};
    parallel_for(all.size() * columns, workers, never, [&](std::size_t, std::size_t job) {
      const std::size_t v = job / columns;
      const std::size_t c = job % columns;
      Scenario scenario = scenarios[c / payloads.size()];
      scenario.plant.payload.mass = payloads[c % payloads.size()];
      shorts[v][c] = Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(all[v].gains);
    });
    parallel_for(all.size() * scenarios.size(), workers, never, [&](std::size_t, std::size_t job) {
      const std::size_t v = job / scenarios.size();
      const std::size_t s = job % scenarios.size();
      longs[v][s] = endure(scenarios[s], all[v].gains, seconds);
    });
    std::string csv =
        "variant,scenario,worst_position_rms_ratio,worst_orientation_rms_ratio,worst_position_max_ratio,"
        "worst_orientation_max_ratio,long_run,long_effort_ratio,long_rms_growth,long_peak_growth\n";
    for (std::size_t s = 0; s < scenarios.size(); ++s) {
      fmt::print("{}, payloads 0 to 3 kg, {:.0f} s\n", scenarios[s].name, seconds);
      fmt::print("  {:<34}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}  {}\n", "errors over those without a bound",
                 "pos rms", "ori rms", "pos max", "ori max", "effort", "growth", "peak", "long run");
      for (std::size_t v = 0; v < all.size(); ++v) {
        const auto worst = [&](Metric metric) {
          double ratio = 0.0;
          for (std::size_t p = 0; p < payloads.size(); ++p) {
            const std::size_t c = s * payloads.size() + p;
            ratio = std::max(ratio, shorts[v][c].metrics[metric] / shorts[0][c].metrics[metric]);
          }
          return ratio;
        };
        const LongRun& run = longs[v][s];
        const double ratios[] = {worst(Metric::kPositionRms), worst(Metric::kOrientationRms),
                                 worst(Metric::kPositionMax), worst(Metric::kOrientationMax)};
        fmt::print("  {:<34}{:>9.4f}{:>9.4f}{:>9.4f}{:>9.4f}{:>9.3f}{:>9.3f}{:>9.3f}  {}\n", all[v].name,
                   ratios[0], ratios[1], ratios[2], ratios[3], run.effort, run.rms_growth, run.peak_growth,
                   run.broken.empty() ? "held" : run.broken);
        csv += fmt::format("{},{},{},{},{},{},\"{}\",{},{},{}\n", all[v].name, scenarios[s].name, ratios[0],
                           ratios[1], ratios[2], ratios[3], run.broken.empty() ? "held" : run.broken,
                           run.effort, run.rms_growth, run.peak_growth);
      }
    }
    if (!folder.empty()) {
      make_folder(folder);
      write_text_file(folder + "/adaptation.csv", csv);
      RunRecord record;
      record.kind = RunKind::kBenchmark;
      FilesRead files;
      record.command =
          fmt::format("benchmark_adaptation_bounds --seconds {} --gains {}", seconds, gains_name);
      add_inputs(scenarios, files.inputs);
      record.workers = workers;
      write_text_file(folder + "/" + kRunRecord, run_record_json(with_circumstances(record, files)));
    }
  } catch (const armtune::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
