// The commands `armtune controllers`, `armtune metrics` and `armtune algorithms`, which list the names that a
// study can use.

#include <CLI/CLI.hpp>
#include <string>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/controllers_page.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/study_lists.hpp"

namespace armtune::internal::cli {
namespace {

void add_list_command(CLI::App& app, const char* name, const char* meaning, std::string (*text)()) {
  app.add_subcommand(name, meaning)->callback([text] { say(text()); });
}

}  // namespace

void add_controllers_command(CLI::App& app, int&) {
  add_list_command(app, "controllers", "List the controllers and every gain", controllers_text);
}

void add_metrics_command(CLI::App& app, int&) {
  add_list_command(app, "metrics", "List the metrics: name, meaning, unit, and which direction is better",
                   metrics_text);
}

void add_algorithms_command(CLI::App& app, int&) {
  add_list_command(app, "algorithms", "List the search algorithms and when to use each", algorithms_text);
}

}  // namespace armtune::internal::cli
