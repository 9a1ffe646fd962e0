#include "tuner/cli/xacro_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/common/message_text.hpp"
#include "core/robot/xacro.hpp"
#include "tuner/ranks/transport.hpp"

namespace armtune::internal::cli {
namespace {

constexpr const char* kXacro = "--xacro";
constexpr const char* kXacroArgument = "--xacro-argument";
/// Commands that read no robot.
constexpr std::array<const char*, 7> kWithoutRobot = {"logs",       "report", "controllers", "metrics",
                                                      "algorithms", "man",    "completion"};

void announce_xacro(const std::string& command) {
  if (rank_place().rank == 0) fmt::print(stderr, "running: {}\n", one_line(command));
}

void add_to(CLI::App& command) {
  // Both live as long as the command, which reads robots when it runs.
  auto expansion = std::make_shared<std::unique_ptr<XacroExpansion>>();
  auto arguments = std::make_shared<std::vector<std::string>>();
  const auto allow = [&command, expansion, arguments] {
    XacroOptions options;
    // `arguments` may not have its values yet, as CLI11 converts options one after the other.
    options.arguments = command.get_option(kXacroArgument)->results();
    options.starting = announce_xacro;
    *expansion = std::make_unique<XacroExpansion>(std::move(options));
  };
  CLI::Option* xacro = command.add_flag_callback(
      kXacro, allow,
      "expand xacro files of robots with the program xacro, which must be installed. It runs the Python "
      "expressions in these files, so use this option only for files that you trust");
  command
      .add_option(kXacroArgument, *arguments,
                  "argument of the xacro files as NAME:=VALUE, such as ur_type:=ur5e; may be repeated")
      ->allow_extra_args(false)
      ->needs(xacro);
}

}  // namespace

void add_xacro_options(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    const auto is_named = [command](const char* name) { return command->get_name() == name; };
    if (std::none_of(kWithoutRobot.begin(), kWithoutRobot.end(), is_named)) add_to(*command);
  }
}

}  // namespace armtune::internal::cli
