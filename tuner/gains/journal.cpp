#include "tuner/gains/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "core/common/error.hpp"

namespace armtune {
namespace {

std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  return '"' + text + '"';
}

std::string cell(double value) {
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

}  // namespace

Journal::Journal(const std::string& path, const Study& study, const Objective& objective)
    : path_(path), study_(study), objective_(objective) {
  file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
  if (file_ < 0) throw InputError(fmt::format("{}: cannot make it: {}", path, std::strerror(errno)));
  std::string header = "evaluation,phase,objective,feasible,violation,status";
  for (const Parameter& p : study.space.free) header += "," + p.entry.name;
  for (const ObjectiveTerm& term : objective.terms()) {
    for (const std::size_t s : term.scenarios) {
      header += fmt::format(",{}/{}", study.scenarios[s].name,
                            metric_fields()[static_cast<std::size_t>(term.metric)].name);
    }
  }
  for (const Constraint& c : objective.constraints()) {
    for (const std::size_t s : c.scenarios) {
      header += fmt::format(",constraint/{}/{}", study.scenarios[s].name,
                            metric_fields()[static_cast<std::size_t>(c.metric)].name);
    }
  }
  write(header + ",time/wall\n");
}

Journal::~Journal() {
  if (file_ >= 0) ::close(file_);
}

void Journal::append(const std::string& phase, const Evaluation& e, double seconds) {
  std::string row = fmt::format("{},{},{},{},{},{}", count_++, phase, e.objective, e.feasible ? 1 : 0,
                                e.violation, quoted(e.status));
  for (const Parameter& p : study_.space.free) row += fmt::format(",{}", value(e.gains, p.entry));
  for (const ObjectiveTerm& term : objective_.terms()) {
    for (const std::size_t s : term.scenarios) row += "," + cell(e.results[s].metrics[term.metric]);
  }
  for (const Constraint& c : objective_.constraints()) {
    for (const std::size_t s : c.scenarios) row += "," + cell(e.results[s].metrics[c.metric]);
  }
  write(row + fmt::format(",{:.3f}\n", seconds));
}

void Journal::write(const std::string& text) {
  const char* data = text.data();
  std::size_t left = text.size();
  while (left > 0) {
    const ssize_t written = ::write(file_, data, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      throw InputError(fmt::format("{}: cannot append to it: {}; what was finished before is in it", path_,
                                   std::strerror(errno)));
    }
    data += written;
    left -= static_cast<std::size_t>(written);
  }
  ::fdatasync(file_);
}

}  // namespace armtune
