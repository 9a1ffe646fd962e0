#include "armtune/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/interface/kept_inputs.hpp"

namespace armtune {
namespace {

constexpr double kMostPeriods = 1e8;  ///< same limit as in a scenario file

template <class Change>
std::shared_ptr<const internal::Scenario> changed(const internal::Scenario& scenario, Change change) {
  internal::Scenario copy = scenario;
  change(copy);
  return std::make_shared<const internal::Scenario>(std::move(copy));
}

}  // namespace

Scenario::Scenario(internal::Scenario inside, std::shared_ptr<const InputFiles> files)
    : inside_(std::make_shared<const internal::Scenario>(std::move(inside))), files_(std::move(files)) {}

Scenario Scenario::load(const std::string& name_or_path) {
  internal::Scenario scenario = internal::load_scenario(name_or_path);
  auto files = std::make_shared<const InputFiles>(input_files(scenario.inputs));
  return {std::move(scenario), std::move(files)};
}

const std::string& Scenario::name() const {
  return inside_->name;
}
Robot Scenario::robot() const {
  return Robot(inside_->robot);
}
double Scenario::duration() const {
  return inside_->duration;
}
double Scenario::control_period() const {
  return inside_->control_period;
}

void Scenario::set_name(const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  });
  if (name.empty() || !plain || internal::is_formula(name) || name[0] == '.') {
    throw InputError(
        fmt::format("name: {}; use letters, digits, '_', '-' and '.', and do not start with '-' or '.'",
                    internal::shown(name)));
  }
  if (name == internal::kAllScenarios)
    throw InputError(fmt::format("name: in results, '{}' means all scenarios; give another name", name));
  inside_ = changed(*inside_, [&](internal::Scenario& s) { s.name = name; });
  files_.reset();
}

void Scenario::set_duration(double seconds) {
  const double period = inside_->control_period;
  if (!(seconds >= period && seconds <= kMostPeriods * period)) {
    throw InputError(fmt::format("duration: {} s; it must have 1 to {:.0e} control periods of {} s", seconds,
                                 kMostPeriods, period));
  }
  inside_ = changed(*inside_, [&](internal::Scenario& s) { s.duration = seconds; });
  files_.reset();
}

}  // namespace armtune
