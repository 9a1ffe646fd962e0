#include "tuner/report/validation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armtune/error.hpp"
#include "tuner/report/buckets.hpp"
#include "tuner/report/joint_columns.hpp"
#include "tuner/report/record_entries.hpp"
#include "tuner/report/recording.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/report/shorten.hpp"
#include "tuner/report/title.hpp"
#include "tuner/report/words.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {
namespace {

constexpr std::size_t kMostDetails = 30;     ///< of each kind in the details
constexpr std::size_t kMostHorizons = 1000;  ///< rows of horizons.csv that are shown

class ValidationAssembly {
 public:
  ValidationAssembly(std::string folder, std::size_t bytes) : folder_(std::move(folder)), bytes_(bytes) {
    data_.kind = RunKind::kValidate;
    data_.validation.emplace();
  }

  ReportData make() {
    part([this] { read_record(); });
    part([this] { read_motion(); });
    shorten(data_);
    part([this] { read_torques(); });
    data_.title = page_title(name(data_.kind), facts_ ? facts_->robot : "", folder_);
    data_.verdict = verdict();
    add_notes(data_);
    return std::move(data_);
  }

 private:
  /// Reads one part. If its file cannot be used, only this part is left out, and the reason is listed.
  template <typename Read>
  void part(Read read) {
    try {
      read();
    } catch (const InputError& error) {
      data_.left_out.emplace_back(error.what());
    }
  }

  std::optional<NumberTable> table(const std::string& name) const {
    const auto path = find_run_file(folder_, name);
    if (!path) return std::nullopt;
    return NumberTable::read(*path, [](std::string_view) { return true; });
  }

  void read_record() {
    const auto record = find_run_record(folder_);
    if (!record) throw InputError(InputPlace{folder_ + "/" + kRunRecord}, "there is no such file");
    data_.provenance = provenance_of(*record);
    facts_ = record->validation;
    if (!facts_) return;
    data_.validation->commands = facts_->commands;
    for (const ThresholdFact& one : facts_->thresholds)
      data_.validation->thresholds.emplace_back(one.name, fmt::format("{:.6g}", one.value));
  }

  const JointMatchFact* fact_of(const std::string& joint) const {
    if (!facts_) return nullptr;
    const auto found = std::find_if(facts_->joints.begin(), facts_->joints.end(),
                                    [&](const JointMatchFact& one) { return one.joint == joint; });
    return found == facts_->joints.end() ? nullptr : &*found;
  }

  void read_torques() {
    const auto residuals = table("residuals.csv");
    if (!residuals) return;
    const auto& time = residuals->numbers(residuals->column("time"));
    for (std::size_t i = 0; i < time.size(); ++i) {
      if (std::isfinite(time[i]) && (i == 0 || time[i] >= time[i - 1])) continue;
      throw InputError(InputPlace{residuals->name(), static_cast<long>(i) + 2, "time"},
                       "the time is missing, or below the one before");
    }
    const std::vector<std::string> joints = joints_with(*residuals, "/measured");
    const std::size_t used = report_json(data_).size();
    const Resolution resolution =
        resolution_for(bytes_ - std::min(bytes_, used), 3 * joints.size() + 1, 0, 0.0);
    const Buckets buckets(time.size(), resolution.buckets);
    data_.validation->time = quantize(buckets.times(time));
    for (const std::string& joint : joints) {
      const auto series = [&](const char* what) {
        return quantize(
            buckets.extremes(residuals->numbers(residuals->column(fmt::format("joint/{}/{}", joint, what)))));
      };
      ValidatedTorque torque;
      torque.joint = joint;
      if (const JointMatchFact* fact = fact_of(joint)) {
        torque.explained = fact->explained;
        torque.residual_rms = fact->residual_rms;
        torque.torque_rms = fact->torque_rms;
      }
      torque.measured = series("measured");
      torque.predicted = series("predicted");
      torque.residual = series("residual");
      data_.validation->torques.push_back(std::move(torque));
    }
  }

  void read_motion() {
    const auto horizons = table("horizons.csv");
    if (!horizons) return;
    const auto numbers = [&](const std::string& column) {
      std::vector<double> all = horizons->numbers(horizons->column(column));
      all.resize(std::min(all.size(), kMostHorizons));
      return all;
    };
    ValidationData& shown = *data_.validation;
    shown.horizons = numbers("horizon");
    for (const std::string& joint : joints_with(*horizons, "/rms")) {
      const std::string begin = fmt::format("joint/{}/", joint);
      shown.motion.push_back({joint, numbers(begin + "rms"), numbers(begin + "low"), numbers(begin + "high"),
                              numbers(begin + "yardstick")});
    }
  }

  Verdict verdict() const {
    Verdict verdict;
    if (!facts_) return {"The numbers of this run could not be read.", {}};
    verdict.sentence = facts_->headline + ".";
    std::vector<std::string> findings;
    for (const LogFindingFact& finding : facts_->findings) findings.push_back(finding.text);
    for (const auto* lines :
         {&std::as_const(findings), &facts_->causes, &facts_->not_compared, &facts_->notes})
      add(verdict.details, *lines, kMostDetails);
    return verdict;
  }

  std::string folder_;
  std::size_t bytes_;
  std::optional<ValidationFacts> facts_;  ///< none if they are unknown
  ReportData data_;
};

}  // namespace

ReportData validation_report_of(const std::string& folder, std::size_t bytes) {
  return ValidationAssembly(folder, bytes).make();
}

}  // namespace armtune::internal::report
