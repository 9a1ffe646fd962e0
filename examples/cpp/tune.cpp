// Tunes two gains of a UR10 and writes them where a robot can load them:   tune GAINS.yaml
#include <armtune/error.hpp>
#include <armtune/tune.hpp>
#include <iostream>

int main(int argc, char** argv) try {
  const auto study = armtune::Study::parse(R"(
scenarios: [moving_target]
gains: published
parameters: [{name: slerpDurationErrorGain, lower: 0.5, upper: 12}, {name: trajectoryDurationErrorGain, lower: 1, upper: 20}]
objective: [{metric: gaze/rms}]
constraints: [{metric: joint_velocity/max_ratio, at_most: 0.9}]
search: {algorithm: BOBYQA, max_evaluations: 15, engine: native}
)");
  armtune::TuneOptions options;
  options.analysis = false;  // true: also computes margins, sensitivity, yield and endurance
  options.watch.progress = [](const armtune::Progress& p) { std::cerr << p.done << " of " << p.all << "\n"; };
  const armtune::Tuned tuned = armtune::tune(study, options);
  tuned.best.save(argc > 1 ? argv[1] : "gains.yaml");
  std::cout << "objective " << tuned.objective << " (start 1)\n" << armtune::to_text(tuned.verdict);
  return tuned.verdict.passed() ? 0 : 3;
} catch (const armtune::Error& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
