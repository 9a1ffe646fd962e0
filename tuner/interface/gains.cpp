#include "armtune/gains.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/gains/gains_formats.hpp"

namespace armtune {
namespace {

const internal::GainField& field_of(const internal::Gains& gains, const std::string& name, bool numeric) {
  for (const internal::GainField& field : internal::fields_of(gains)) {
    if (field.name != name) continue;
    if (field.is_number() == numeric) return field;
    throw InputError(fmt::format("{}: {}", name,
                                 numeric ? "is a switch or a word, not numbers" : "has numbers, not a word"));
  }
  throw InputError(
      fmt::format("{}: the controller {} has no such gain", internal::shown(name), gains.controller));
}

}  // namespace

Gains::Gains(const internal::Gains& gains, std::vector<std::string> joints)
    : inside_(std::make_unique<internal::Gains>(gains)), joints_(std::move(joints)) {}
Gains::Gains(const Gains& other) : Gains(*other.inside_, other.joints_) {}
Gains& Gains::operator=(const Gains& other) {
  *this = Gains(other);
  return *this;
}
Gains::Gains(Gains&&) noexcept = default;
Gains& Gains::operator=(Gains&&) noexcept = default;
Gains::~Gains() = default;

Gains Gains::load(const std::string& name_or_path, const Robot& robot) {
  const std::vector<std::string> joints = robot.joints();
  return {internal::load_gains(name_or_path, joints), joints};
}

const std::string& Gains::controller() const {
  return inside_->controller;
}

std::vector<std::string> Gains::names() const {
  std::vector<std::string> all;
  for (const internal::GainField& field : internal::fields_of(*inside_)) all.emplace_back(field.name);
  return all;
}

std::span<double> Gains::numbers(const std::string& name) {
  return internal::numbers(*inside_, field_of(*inside_, name, true));
}
std::span<const double> Gains::numbers(const std::string& name) const {
  return internal::numbers(std::as_const(*inside_), field_of(*inside_, name, true));
}

void Gains::set(const std::string& name, const std::vector<double>& values) {
  const std::span<double> target = numbers(name);
  if (values.size() == 1) {
    std::fill(target.begin(), target.end(), values.front());
  } else if (values.size() == target.size()) {
    std::copy(values.begin(), values.end(), target.begin());
  } else {
    throw InputError(InputPlace{.key = name},
                     fmt::format("{} numbers are given, but the gain has {}", values.size(), target.size()))
        .with_value(std::to_string(values.size()), fmt::format("{} numbers", target.size()));
  }
}

std::string Gains::word(const std::string& name) const {
  return internal::field_text(*inside_, field_of(*inside_, name, false));
}

void Gains::set_word(const std::string& name, const std::string& word) {
  const internal::GainField& field = field_of(*inside_, name, false);
  const auto* flag = std::get_if<bool internal::Gains::*>(&field.member);
  const std::vector<std::string> words = flag != nullptr ? std::vector<std::string>{"false", "true"}
                                                         : std::vector<std::string>{"start", "current"};
  if (word != words[0] && word != words[1]) {
    const std::string limit = fmt::format("{} or {}", words[0], words[1]);
    throw InputError(InputPlace{.key = name},
                     fmt::format("{} is given; it must be {}", internal::shown(word), limit))
        .with_value(word, limit);
  }
  if (flag != nullptr) {
    (*inside_).** flag = word == "true";
  } else {
    (*inside_).*std::get<internal::SlerpReference internal::Gains::*>(field.member) =
        word == "start" ? internal::SlerpReference::kStart : internal::SlerpReference::kCurrent;
  }
}

std::string Gains::text(GainsFormat format) const {
  internal::validate(*inside_, joints_, "gains");
  internal::GainsFile file;
  file.gains = *inside_;
  file.joints = joints_;
  switch (format) {
    case GainsFormat::kYaml:
      return internal::gains_text(file, internal::GainsFormat::kYaml);
    case GainsFormat::kRos1:
      return internal::gains_text(file, internal::GainsFormat::kRos1);
    case GainsFormat::kRos2:
      break;
  }
  return internal::gains_text(file, internal::GainsFormat::kRos2);
}

void Gains::save(const std::string& path, GainsFormat format) const {
  internal::write_text_file(path, text(format));
}

}  // namespace armtune
