// armtune robot: what was loaded.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/common/path_state.hpp"
#include "core/robot/urdf_reader.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/urdf_keys.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/task_files.hpp"

namespace armtune::internal::cli {
namespace {

void show(const RobotModel& model) {
  double mass = 0.0;
  for (int i = 0; i < model.n(); ++i) mass += model.chain.link[static_cast<std::size_t>(i)].mass;
  say(fmt::format(
      "{} from {}\n{} joints, base {}, tool frame on {}, moving mass {:.4g} kg, reach {:.4g} m\n\n",
      model.name, model.source, model.n(), model.base_link, model.tip_link, mass, reach(model)));
  say(fmt::format("{:<24}{:<10}{:>10}{:>10}{:>11}{:>9}{:>9}{:>9}{:>9}  {}\n", "joint", "type", "lower",
                  "upper", "velocity", "effort", "rotor", "viscous", "coulomb", "link, mass [kg]"));
  for (int i = 0; i < model.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const JointInfo& joint = model.joints[k];
    const auto bound = [&](double v) { return joint.limits.has_position ? fmt::format("{:.4g}", v) : "-"; };
    say(fmt::format("{:<24}{:<10}{:>10}{:>10}{:>11.4g}{:>9.4g}{:>9.3g}{:>9.3g}{:>9.3g}  {}, {:.4g}\n",
                    joint.name,
                    model.chain.motion[k] == JointMotion::kPrismatic
                        ? "prismatic"
                        : (joint.limits.has_position ? "revolute" : "continuous"),
                    bound(joint.limits.lower), bound(joint.limits.upper), joint.limits.velocity,
                    joint.limits.effort, model.chain.rotor_inertia[i], model.chain.viscous_friction[i],
                    model.chain.coulomb_friction[i], joint.link, model.chain.link[k].mass));
  }
  say(fmt::format("\nSI units: rad, m, rad/s, m/s, N m, N, kg m^2.\n"));
  if (model.chain.rotor_inertia.isZero(0.0)) {
    say(fmt::format(
        "No rotor inertia is given. Geared joints have some, and without it light wrists do not bear the\n"
        "gains that the real arm does: write a robot YAML with 'urdf:' and 'rotor_inertia:'.\n"));
  }
}

/// "velocity limit of a, b; inertia of c"
std::string named(const MissingData& missing) {
  std::vector<std::string> lacks;
  const auto add = [&lacks](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) lacks.push_back(fmt::format("{} of {}", what, fmt::join(names, ", ")));
  };
  add("position limits", missing.position);
  add("velocity limit", missing.velocity);
  add("effort limit", missing.effort);
  add("inertia", missing.inertia);
  return fmt::format("{}", fmt::join(lacks, "; "));
}

void write_sidecar(const RobotFile& file, const MissingData& missing, const std::string& path) {
  if (missing.empty()) {
    say(fmt::format("{} lacks nothing; {} is not written\n", file.path, path));
    return;
  }
  refuse_existing(path);
  const std::string urdf = file.root ? "" : absolute_path(file.urdf);
  write_text_file(path, missing_yaml(urdf, missing));
  say(fmt::format("{}: fill in {}{}\n", path, named(missing),
                  file.root ? fmt::format(", and add it to {}", file.path) : "; then give it as the robot"));
}

/// Loads and shows it, or says all that it lacks.
void look_at(const std::string& name_or_path, const std::string& sidecar, const std::string& task) {
  const RobotFile file = read_robot_file(name_or_path);
  const MissingData missing = missing_data(file.urdf, file.options);
  if (!sidecar.empty()) return write_sidecar(file, missing, sidecar);
  if (missing.empty()) {
    const auto robot = load_robot(name_or_path);
    show(*robot);
    if (!task.empty()) write_task_files(robot, file.path, task);
    return;
  }
  throw InputError(
      fmt::format("{}: missing: {}; --sidecar arm.yaml writes the robot YAML that gives it, to be filled in",
                  file.path, named(missing)));
}

}  // namespace

void add_robot_command(CLI::App& app, int&) {
  auto file = std::make_shared<std::string>("ur10");
  CLI::App* command = app.add_subcommand(
      "robot", "Show the joints, limits, masses and reach of a robot file, and what the file lacks");
  command->add_option("ROBOT", *file, "a bundled robot, a robot YAML, or an expanded URDF")
      ->capture_default_str();
  auto sidecar = std::make_shared<std::string>();
  command->add_option("--sidecar", *sidecar,
                      "write what the URDF lacks (limits, inertia) as a robot YAML to fill in");
  auto task = std::make_shared<std::string>();
  command
      ->add_option("--task", *task,
                   "new folder for a first task: a circle where the arm moves well, gains from its inertia, "
                   "a study that tunes "
                   "them")
      ->excludes("--sidecar");
  command->footer([] { return std::string("Example:\n  armtune robot panda --task runs/first\n"); });
  command->callback([file, sidecar, task] { look_at(*file, *sidecar, *task); });
}

}  // namespace armtune::internal::cli
