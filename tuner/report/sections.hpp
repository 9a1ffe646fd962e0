#pragma once
// Makes the data for the sections of a report page. Most sections show one CSV file of the run folder.

#include "sim/csv/csv_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"
#include "tuner/robustness/limits.hpp"

namespace armtune::internal::report {

/// Returns the evaluations of evaluations.csv. The chosen evaluation is the one with the gains of gains.yaml,
/// which are the last values in `gains`. If several have these gains, one that Simbody simulated is
/// preferred. If none has them, the best evaluation is the chosen one.
Evaluations evaluations_of(const CsvTable& table, const std::vector<Gain>& gains);

/// Returns the trade-off between the objective and the largest joint velocity ratio, with one point for each
/// evaluation in evaluations.csv. Returns nothing if no constraint of the study is on that ratio. If there
/// are more than a thousand points, it keeps only the point of the start gains, the chosen point, and the
/// feasible points that no other feasible point dominates. limits: the limits of the study.
std::optional<Front> front_of_search(const CsvTable& table, const Evaluations& evaluations,
                                     const std::vector<StudyLimit>& limits);

/// Returns the Pareto front of pareto.csv. criteria: names of the columns with criteria, as in run.json;
/// shown: number in pareto.csv of the point that was simulated for the report, empty if there is none.
Front front_of(const CsvTable& table, const std::vector<std::string>& criteria, const std::string& shown,
               std::optional<double> hypervolume);

/// Returns the results of samples.csv. limits: limits that the arms had to keep; tables: the tables of the
/// nominal arm, may be empty.
Robustness robustness_of(const CsvTable& samples, const std::vector<MetricLimit>& limits,
                         const std::vector<Table>& tables);

/// Returns the gains that a study tunes, with their bounds and with their value in each set's gains.yaml. The
/// value is NaN if there is no such file. paths: paths of these files, one per set.
std::vector<Gain> gains_of(const std::vector<StudyGain>& tuned, const std::vector<std::string>& joints,
                           const std::vector<std::optional<std::string>>& paths);

/// Returns the rows of sensitivity.csv.
std::vector<Sensitivity> sensitivity_of(const CsvTable& table);

/// Returns the margins of every gain set. sets: the table margins.csv of each set, or nothing if it has none.
std::vector<MarginRow> margins_of(const std::vector<std::optional<CsvTable>>& sets);

}  // namespace armtune::internal::report
