#pragma once
// Makes the sections of a report page, most of them from one file of a run folder each.

#include "sim/csv/csv_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"

namespace armtune::internal::report {

/// Reads evaluations.csv. The chosen evaluation is the one whose gains are the last values in `gains`, which
/// are those of gains.yaml; one that Simbody simulated is preferred. If none has these gains, it is the best
/// one.
Evaluations evaluations_of(const CsvTable& table, const std::vector<Gain>& gains);

/// Returns the trade-off of the objective against the largest joint velocity ratio, as the search saw it in
/// evaluations.csv. Returns nothing if no constraint of the study is on that ratio. Of more than a thousand
/// points it keeps the feasible ones that no other dominates, the start and the chosen one. limits: the
/// study's.
std::optional<Front> front_of_search(const CsvTable& table, const Evaluations& evaluations,
                                     const std::vector<StudyLimit>& limits);

/// Reads pareto.csv. criteria: names of its columns, as in run.yaml; shown: number in pareto.csv of the point
/// that was simulated for the report, empty if none was.
Front front_of(const CsvTable& table, const std::vector<std::string>& criteria, const std::string& shown,
               std::optional<double> hypervolume);

/// Reads samples.csv. limits: text in run.yaml, such as "METRIC <= VALUE; METRIC >= VALUE", or empty; tables:
/// those of the nominal arm, may be empty.
Robustness robustness_of(const CsvTable& samples, const std::string& limits,
                         const std::vector<Table>& tables);

/// Returns the gains that a study tunes, with their bounds and with their value in each set's gains.yaml. The
/// value is NaN if there is no such file. paths: one per set.
std::vector<Gain> gains_of(const std::vector<StudyGain>& tuned, const std::vector<std::string>& joints,
                           const std::vector<std::optional<std::string>>& paths);

/// Reads sensitivity.csv.
std::vector<Sensitivity> sensitivity_of(const CsvTable& table);

/// Reads margins.csv of each set; nothing for a set without the file.
std::vector<MarginRow> margins_of(const std::vector<std::optional<CsvTable>>& sets);

}  // namespace armtune::internal::report
