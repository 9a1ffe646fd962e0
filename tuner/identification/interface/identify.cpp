#include "armtune/identify.hpp"

#include "tuner/identification/session/identify_session.hpp"
#include "tuner/interface/observing.hpp"

namespace armtune {
namespace {

template <class Vector>
std::vector<double> numbers_of(const Vector& values) {
  return {values.data(), values.data() + values.size()};
}

Residuals residuals_of(const internal::Unexplained& rows) {
  return {numbers_of(rows.torque), numbers_of(rows.by_theta), numbers_of(rows.by_file)};
}

}  // namespace

Identified identify(const Robot& robot, const std::vector<std::string>& logs,
                    const IdentifyOptions& options) {
  internal::IdentifySettings settings;
  settings.folder = options.folder;
  settings.model = robot.model();
  settings.logs = logs;
  settings.columns_path = options.columns;
  settings.columns = options.columns.empty() ? internal::default_log_columns(*settings.model)
                                             : internal::load_log_columns(options.columns, *settings.model);
  settings.accept = options.accept;
  settings.options.robust = options.robust;
  const std::atomic<bool> never{false};
  Observing<internal::SessionObserver> observer(options.watch);
  internal::IdentifySession session(settings, {options.watch.stop != nullptr ? *options.watch.stop : never},
                                    observer);
  const internal::IdentifyOutcome outcome = session.run();

  Identified identified;
  identified.interrupted = outcome.ending == internal::Ending::kInterrupted;
  identified.theta = numbers_of(outcome.found.theta);
  identified.fitted = residuals_of(outcome.found.fitted);
  identified.held_out = residuals_of(outcome.found.held_out);
  identified.doubts = outcome.doubts;
  identified.files = outcome.files;
  return identified;
}

}  // namespace armtune
