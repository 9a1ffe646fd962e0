// armtune controllers: which there are, and the gains of each.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/controllers_page.hpp"

namespace armtune::cli {

void add_controllers_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("controllers", "List the controllers and the gains of each");
  auto markdown = std::make_shared<bool>(false);
  command->add_flag("--markdown", *markdown, "as a page, with every gain: docs/controllers.md");
  command->callback(
      [markdown] { fmt::print("{}", *markdown ? controllers_markdown() : controllers_text()); });
}

}  // namespace armtune::cli
