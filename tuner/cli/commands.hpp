#pragma once
// Declares the commands of the program armtune, such as `armtune tune`. Each function adds one command to the
// command line parser. When the command runs, it writes its exit code into `exit_code`.

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Exit codes of the program.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kBadInput = 2;
/// The command is complete, but a simulation check failed, or a search found nothing feasible.
inline constexpr int kChecksFailed = 3;
inline constexpr int kInterrupted = 130;

void add_robot_command(CLI::App& app, int& exit_code);
void add_logs_command(CLI::App& app, int& exit_code);
void add_init_command(CLI::App& app, int& exit_code);
void add_simulate_command(CLI::App& app, int& exit_code);
void add_tune_command(CLI::App& app, int& exit_code);
void add_pareto_command(CLI::App& app, int& exit_code);
void add_sensitivity_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_export_command(CLI::App& app, int& exit_code);
void add_robustness_command(CLI::App& app, int& exit_code);
void add_margins_command(CLI::App& app, int& exit_code);
void add_report_command(CLI::App& app, int& exit_code);
void add_controllers_command(CLI::App& app, int& exit_code);
void add_metrics_command(CLI::App& app, int& exit_code);
void add_algorithms_command(CLI::App& app, int& exit_code);
void add_man_command(CLI::App& app, int& exit_code);
void add_completion_command(CLI::App& app, int& exit_code);
void add_excite_command(CLI::App& app, int& exit_code);
void add_identify_command(CLI::App& app, int& exit_code);
void add_validate_command(CLI::App& app, int& exit_code);
void add_calibrate_command(CLI::App& app, int& exit_code);
void add_plan_command(CLI::App& app, int& exit_code);
void add_yardstick_command(CLI::App& app, int& exit_code);

}  // namespace armtune::internal::cli
