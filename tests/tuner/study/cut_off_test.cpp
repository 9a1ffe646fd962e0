// The bundled study, cut off anywhere. YAML itself takes what is left of a block mapping for a whole one.

#include <gtest/gtest.h>

#include <cmath>

#include "sim/scenario/data_files.hpp"
#include "tests/sim/support/cut_off.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace study_cut_off_test {

void expect_valid(const Study& study) {
  ASSERT_FALSE(study.scenarios.empty());
  EXPECT_FALSE(study.space.free.empty());
  EXPECT_NO_THROW(validate(study.space, "the beginning"));
  for (const double x : study.space.start_point()) EXPECT_TRUE(x >= 0.0 && x <= 1.0) << x;
  ASSERT_FALSE(study.terms.empty());
  double weights = 0.0;
  for (const ObjectiveTerm& term : study.terms) {
    weights += term.weight;
    EXPECT_FALSE(term.scenarios.empty());
  }
  EXPECT_TRUE(std::isfinite(weights) && weights > 0.0) << weights;
  for (const Constraint& constraint : study.constraints) {
    EXPECT_FALSE(constraint.scenarios.empty());
    if (constraint.limit) {
      EXPECT_TRUE(std::isfinite(*constraint.limit));
    }
  }
  for (const SweepAxis& axis : study.sweep) {
    EXPECT_FALSE(axis.parameters.empty());
    EXPECT_FALSE(axis.factors.empty());
  }
  EXPECT_GE(study.max_evaluations, 1);
  EXPECT_NO_THROW(algorithm_for(study.solver.algorithm, study.space.free.size()));
}

TEST(CutOff, AStudyIsRefusedOrWhole) {
  const test::TemporaryFolder folder;
  const std::string text = test::read_text(find_data_file("studies", "ur10_gaze"));
  const std::size_t required = test::up_to_key(text, "objective");
  ASSERT_GT(required, test::up_to_key(text, "scenarios"));
  ASSERT_GT(required, test::up_to_key(text, "gains"));
  // Each loads four scenarios: not at every byte.
  const test::Cuts cuts = test::cut_off(text, required, 5, [&](const std::string& beginning) {
    expect_valid(load_study(folder.write("cut.yaml", beginning)));
  });
  EXPECT_GT(cuts.refused_before, required / 5);
  EXPECT_GT(cuts.refused_after, 0U) << "in the middle of a term";
  EXPECT_GT(cuts.loaded, 0U) << "between two terms";
}

}  // namespace study_cut_off_test
}  // namespace armtune::internal
