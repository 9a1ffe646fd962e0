#include "tuner/report/calibration_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "armtune/error.hpp"
#include "tuner/report/joint_columns.hpp"
#include "tuner/report/record_entries.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/report/shorten.hpp"
#include "tuner/report/title.hpp"
#include "tuner/report/words.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {
namespace {

constexpr std::size_t kMostCautions = 30;      ///< of each kind in the details
constexpr std::size_t kMostParameters = 1000;  ///< rows of parameters.csv that are shown
constexpr std::size_t kMostErrors = 100;       ///< rows of held_out.csv that are shown

class CalibrationAssembly {
 public:
  explicit CalibrationAssembly(std::string folder) : folder_(std::move(folder)) {
    data_.kind = RunKind::kCalibrate;
    data_.calibration.emplace();
  }

  ReportData make() {
    part([this] { read_record(); });
    part([this] { read_parameters(); });
    part([this] { read_held_out(); });
    shorten(data_);
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

  void read_record() {
    const auto record = find_run_record(folder_);
    if (!record) throw InputError(InputPlace{folder_ + "/" + kRunRecord}, "there is no such file");
    data_.provenance = provenance_of(*record);
    facts_ = record->calibration;
  }

  void read_parameters() {
    const auto path = find_run_file(folder_, "parameters.csv");
    if (!path) return;
    const CsvTable table = CsvTable::read(*path);
    std::vector<CalibratedParameterRow> rows;
    for (std::size_t i = 0; i < std::min(table.rows(), kMostParameters); ++i) {
      const auto text = [&](const char* column) { return table.text(i, table.column(column)); };
      const auto number = [&](const char* column) { return table.number(i, table.column(column)); };
      rows.push_back({text("parameter"), text("unit"), number("before"), number("after"), number("low"),
                      number("high"), number("told") == 1.0, number("kept") == 1.0, text("motion")});
    }
    data_.calibration->parameters = std::move(rows);
    if (table.rows() > kMostParameters)
      data_.thinned.push_back(
          fmt::format("{} of {} parameters", table.rows() - kMostParameters, table.rows()));
  }

  void read_held_out() {
    const auto path = find_run_file(folder_, "held_out.csv");
    if (!path) return;
    const NumberTable table = NumberTable::read(*path, [](std::string_view) { return true; });
    const auto numbers = [&](const std::string& column) {
      std::vector<double> all = table.numbers(table.column(column));
      all.resize(std::min(all.size(), kMostErrors));
      return all;
    };
    CalibrationData& shown = *data_.calibration;
    const std::vector<double> horizons = numbers("horizon");
    const std::vector<double> windows = numbers("windows");
    std::vector<HeldOutJoint> joints;
    for (const std::string& joint : joints_with(table, "/before")) {
      const std::string begin = fmt::format("joint/{}/", joint);
      joints.push_back({joint, numbers(begin + "before"), numbers(begin + "after")});
    }
    shown.horizons = horizons;
    shown.windows = windows;
    shown.joints = std::move(joints);
  }

  Verdict verdict() const {
    Verdict verdict;
    if (!facts_) return {"The numbers of this run could not be read.", {}};
    verdict.sentence = facts_->headline + ".";
    for (const auto* lines : {&facts_->cautions, &facts_->notes}) add(verdict.details, *lines, kMostCautions);
    return verdict;
  }

  std::string folder_;
  std::optional<CalibrationFacts> facts_;  ///< none if they are unknown
  ReportData data_;
};

}  // namespace

ReportData calibration_report_of(const std::string& folder) {
  return CalibrationAssembly(folder).make();
}

}  // namespace armtune::internal::report
