#include "tuner/report/arm_json.hpp"
#include "tuner/report/json_array.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/scenario_json.hpp"
#include "tuner/report/yardstick_json.hpp"

namespace armtune::report {
namespace {

void write_row(Json& json, const MetricRow& row) {
  const MetricField& f = field(row.metric);
  json.begin_object();
  json.text("metric", f.name);
  json.text("unit", f.unit);
  json.text("words", f.words);
  json.text("meaning", f.meaning);
  json.numbers("values", row.values);
  if (!row.text.empty()) json.texts("text", row.text);
  if (f.better != Better::kNeither) json.text("better", f.better == Better::kMore ? "higher" : "lower");
  json.end_object();
}

void write_table(Json& json, const Table& table) {
  json.begin_object();
  json.text("scenario", table.scenario);
  array(json, "rows", table.rows, write_row);
  json.texts("status", table.status);
  json.texts("reason", table.reason);
  json.end_object();
}

void write_judged(Json& json, const Judged& judged) {
  json.begin_object();
  json.text("measure", judged.measure);
  array(json, "tables", judged.tables, write_table);
  json.end_object();
}

void write_thinned(Json& json, const ThinnedEvaluations& thinned) {
  const auto count = [&json](const char* key, std::size_t n) { json.integer(key, static_cast<long>(n)); };
  json.begin_object();
  array(json, "number", thinned.number,
        [](Json& out, std::size_t number) { out.integer(static_cast<long>(number)); });
  count("total", thinned.total);
  count("feasible", thinned.feasible);
  count("native", thinned.native);
  count("without_objective", thinned.without_objective);
  array(json, "phase_runs", thinned.phase_runs, [](Json& out, const PhaseRun& run) {
    out.begin_array();
    for (const std::size_t n : {run.phase, run.from, run.to}) out.integer(static_cast<long>(n));
    out.end_array();
  });
  json.boolean("more_phase_runs", thinned.more_phase_runs);
  json.end_object();
}

void write_evaluations(Json& json, const Evaluations& e) {
  json.begin_object();
  json.texts("phase", e.phases);
  array(json, "of", e.of, [](Json& out, std::size_t phase) { out.integer(static_cast<long>(phase)); });
  json.numbers("objective", e.objective);
  array(json, "feasible", e.feasible, [](Json& out, bool feasible) { out.boolean(feasible); });
  json.numbers("violation", e.violation);
  array_if_any(json, "native", e.native, [](Json& out, bool native) { out.boolean(native); });
  json.integer("start", e.start);
  json.integer("chosen", e.chosen);
  value_if_any(json, "thinned", e.thinned, write_thinned);
  json.end_object();
}

void write_gain(Json& json, const Gain& gain) {
  json.begin_object();
  json.text("name", gain.name);
  json.text("unit", gain.unit);
  json.number("lower", gain.lower);
  json.number("upper", gain.upper);
  json.text("scale", gain.scale);
  json.numbers("values", gain.values);
  json.end_object();
}

void write_sensitivity(Json& json, const Sensitivity& s) {
  json.begin_object();
  json.text("gain", s.gain);
  json.number("importance", s.importance);
  json.number("local", s.local);
  json.number("elasticity", s.elasticity);
  json.number("rank_correlation", s.rank_correlation);
  json.end_object();
}

void write_margin(Json& json, const MarginRow& row) {
  json.begin_object();
  json.text("margin", row.margin);
  json.text("unit", row.unit);
  json.text("scenario", row.scenario);
  json.numbers("values", row.values);
  json.texts("text", row.text);
  json.texts("reason", row.reason);
  json.end_object();
}

void write_front(Json& json, const Front& front) {
  json.begin_object();
  array(json, "criteria", front.criteria,
        [](Json& out, const std::pair<std::string, std::string>& criterion) {
          out.begin_object();
          out.text("name", criterion.first);
          out.text("unit", criterion.second);
          out.end_object();
        });
  array(json, "points", front.points, [](Json& out, const FrontPoint& point) {
    out.begin_object();
    out.numbers("values", point.values);
    out.text("label", point.label);
    out.boolean("feasible", point.feasible);
    out.text("role", point.role);
    out.end_object();
  });
  array(json, "limits", front.limits, [](Json& out, const std::pair<std::size_t, double>& limit) {
    out.begin_object();
    out.integer("criterion", static_cast<long>(limit.first));
    out.number("value", limit.second);
    out.end_object();
  });
  json.number("hypervolume", front.hypervolume);
  json.end_object();
}

void write_histogram(Json& json, const Histogram& histogram) {
  json.begin_object();
  json.text("metric", field(histogram.metric).name);
  json.text("unit", field(histogram.metric).unit);
  json.text("scenario", histogram.scenario);
  json.number("limit", histogram.limit);
  array(json, "counts", histogram.counts,
        [](Json& out, std::size_t count) { out.integer(static_cast<long>(count)); });
  json.integer("failed", static_cast<long>(histogram.failed));
  json.numbers("edges", histogram.edges);
  json.number("nominal", histogram.nominal);
  json.end_object();
}

void write_robustness(Json& json, const Robustness& r) {
  json.begin_object();
  json.integer("samples", static_cast<long>(r.samples));
  json.number("yield", r.samples > 0 ? static_cast<double>(r.kept) / static_cast<double>(r.samples) : 0.0);
  json.numbers("interval", {r.interval.first, r.interval.second});
  array(json, "histograms", r.histograms, write_histogram);
  array(json, "worst", r.worst, [](Json& out, const WorstSample& worst) {
    out.begin_object();
    out.integer("sample", worst.sample);
    out.text("text", worst.text);
    out.end_object();
  });
  json.end_object();
}

void write_pairs(Json& json, const char* key, const std::vector<std::pair<std::string, std::string>>& pairs) {
  array(json, key, pairs, [](Json& out, const std::pair<std::string, std::string>& entry) {
    out.texts({entry.first, entry.second});
  });
}

void write_live(Json& json, const Live& live) {
  json.begin_object();
  json.integer("evaluations", live.evaluations);
  json.integer("most_evaluations", live.most_evaluations);
  json.number("seconds_left", live.seconds_left);
  json.number("every", live.every);
  json.integer("written", live.written);
  json.end_object();
}

void write_plan(Json& json, const Plan& plan) {
  json.begin_object();
  json.number("start", plan.start);
  json.text("scenario", plan.scenario);
  write_pairs(json, "figures", plan.figures);
  json.end_object();
}

}  // namespace

std::string report_json(const ReportData& data) {
  Json json;
  json.begin_object();
  json.integer("format", 1);
  json.text("kind", name(data.kind));
  json.text("title", data.title);
  json.key("verdict");
  json.begin_object();
  json.text("sentence", data.verdict.sentence);
  json.texts("details", data.verdict.details);
  json.end_object();
  value_if_any(json, "live", data.live, write_live);
  json.texts("sets", data.sets);
  array(json, "tables", data.tables, write_table);
  value_if_any(json, "judged", data.judged, write_judged);
  array(json, "robots", data.arms, write_arm);
  array(json, "scenarios", data.scenarios, write_scenario);
  value_if_any(json, "evaluations", data.evaluations, write_evaluations);
  array_if_any(json, "gains", data.gains, write_gain);
  array_if_any(json, "sensitivity", data.sensitivity, write_sensitivity);
  array_if_any(json, "margins", data.margins, write_margin);
  array_if_any(json, "yardstick", data.yardstick, write_yardstick);
  value_if_any(json, "front", data.front, write_front);
  value_if_any(json, "robustness", data.robustness, write_robustness);
  value_if_any(json, "plan", data.plan, write_plan);
  json.key("provenance");
  json.begin_object();
  json.text("command", data.command);
  write_pairs(json, "entries", data.provenance);
  json.end_object();
  json.end_object();
  return json.take();
}

}  // namespace armtune::report
