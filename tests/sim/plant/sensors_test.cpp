#include "sim/plant/sensors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armtune::internal {
namespace sensors_test {

const JointVector kQ = JointVector::LinSpaced(6, -1.0, 1.0);
const JointVector kQd = JointVector::LinSpaced(6, 2.0, -2.0);

TEST(Sensors, TheSameSeedMeasuresTheSame) {
  Sensors a(1e-3, 1e-2, 7);
  Sensors b(1e-3, 1e-2, 7);
  Sensors c(1e-3, 1e-2, 8);
  JointState of_a, of_b, of_c;
  for (int k = 0; k < 100; ++k) {
    a.measure(kQ, kQd, of_a);
    b.measure(kQ, kQd, of_b);
    c.measure(kQ, kQd, of_c);
    EXPECT_EQ(of_a.q, of_b.q);
    EXPECT_EQ(of_a.qd, of_b.qd);
    EXPECT_NE(of_a.q, of_c.q);
    EXPECT_NE(of_a.qd, of_c.qd);
  }
}

TEST(Sensors, NoiseIsWhiteWithTheGivenDeviation) {
  constexpr double kPosition = 1e-4;
  constexpr double kVelocity = 0.01;
  constexpr int kPeriods = 20000;
  constexpr double kCount = 6.0 * kPeriods;
  Sensors sensors(kPosition, kVelocity, 3);
  JointState measured;
  double sum = 0.0, squares = 0.0, velocity_squares = 0.0, neighbours = 0.0;
  JointVector last = JointVector::Zero(6);
  for (int k = 0; k < kPeriods; ++k) {
    sensors.measure(kQ, kQd, measured);
    const JointVector e = (measured.q - kQ) / kPosition;
    sum += e.sum();
    squares += e.squaredNorm();
    neighbours += e.dot(last);
    velocity_squares += ((measured.qd - kQd) / kVelocity).squaredNorm();
    last = e;
  }
  // Five standard errors of each statistic of a standard normal sample.
  const double five = 5.0 / std::sqrt(kCount);
  EXPECT_NEAR(sum / kCount, 0.0, five);
  EXPECT_NEAR(squares / kCount, 1.0, five * std::sqrt(2.0));
  EXPECT_NEAR(velocity_squares / kCount, 1.0, five * std::sqrt(2.0));
  EXPECT_NEAR(neighbours / kCount, 0.0, five) << "one period's noise says nothing of the next";
}

TEST(Sensors, WithoutNoiseTheyTellTheTruth) {
  Sensors sensors(0.0, 0.0, 1);
  JointState measured;
  sensors.measure(kQ, kQd, measured);
  EXPECT_EQ(measured.q, kQ);
  EXPECT_EQ(measured.qd, kQd);
}

TEST(Sensors, AreExactWhereWhatTheyMeasureIsWhatIs) {
  for (const double position : {0.0, 1e-4}) {
    for (const double velocity : {0.0, 1e-2}) {
      Sensors sensors(position, velocity, 1);
      const bool exact = sensors.exact();
      JointState measured;
      sensors.measure(kQ, kQd, measured);
      EXPECT_EQ(exact, measured.q == kQ && measured.qd == kQd) << position << " " << velocity;
    }
  }
}

TEST(Sensors, WithOffsetsTheyMeasurePositionsThatAreLess) {
  const JointVector offset = JointVector::LinSpaced(6, 0.0, 0.5);
  Sensors sensors(0.0, 0.0, 1, offset);
  JointState measured;
  sensors.measure(kQ, kQd, measured);
  EXPECT_EQ(measured.q, kQ - offset);
  EXPECT_EQ(measured.qd, kQd);
  EXPECT_FALSE(sensors.exact());
}

TEST(Sensors, ZeroNoiseDrawsNothing) {
  // Were position noise drawn and multiplied by zero, the velocities' draws would come later in the sequence.
  Sensors quiet(0.0, 1e-2, 5);
  JointState a;
  quiet.measure(kQ, kQd, a);
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 6; ++i) EXPECT_EQ(a.qd[i], kQd[i] + 1e-2 * normal(generator));
}

}  // namespace sensors_test
}  // namespace armtune::internal
