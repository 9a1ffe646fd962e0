#pragma once
// Parts of a page, each from one file of a run folder.

#include "sim/csv/csv_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"

namespace armtune::internal::report {

/// From evaluations.csv. chosen: the gains that were written to gains.yaml, by the columns of `gains`, whose
/// last values they are, as Simbody judged them; unless any evaluation has them, the best one.
Evaluations evaluations_of(const CsvTable& table, const std::vector<Gain>& gains);

/// What a search has seen of the objective against the largest joint velocity ratio: from evaluations.csv, if
/// the study's constraints hold that ratio. Of more than a thousand only those that no other dominates.
/// limits: the study's.
std::optional<Front> front_of_search(const CsvTable& table, const Evaluations& evaluations,
                                     const std::vector<StudyLimit>& limits);

/// From pareto.csv. criteria: names of its columns, as run.yaml has them. shown: number of the point that
/// was simulated for the report, as pareto.csv has it; empty if none was.
Front front_of(const CsvTable& table, const std::vector<std::string>& criteria, const std::string& shown,
               std::optional<double> hypervolume);

/// From samples.csv. limits: as run.yaml has them, "METRIC <= VALUE; METRIC >= VALUE"; empty if it does not.
/// tables: the nominal arm's, may be empty.
Robustness robustness_of(const CsvTable& samples, const std::string& limits,
                         const std::vector<Table>& tables);

/// The gains that a study tunes, between their bounds, as each set's gains.yaml has them; NaN where there is
/// no such file. paths: one per set.
std::vector<Gain> gains_of(const std::vector<StudyGain>& tuned, const std::vector<std::string>& joints,
                           const std::vector<std::optional<std::string>>& paths);

/// From sensitivity.csv.
std::vector<Sensitivity> sensitivity_of(const CsvTable& table);

/// From margins.csv of each set; none where there is no file.
std::vector<MarginRow> margins_of(const std::vector<std::optional<CsvTable>>& sets);

}  // namespace armtune::internal::report
