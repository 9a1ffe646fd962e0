#include "core/robot/physical_theta.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/common/pack.hpp"
#include "tests/core/support/allocation_counter.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace physical_theta_test {

using test::random_number;
using test::random_vec3;
using test::random_vector;
using test::WorstError;

using Link = Eigen::Matrix<double, kLinkParameters, 1>;

double smallest_eigenvalue(const PseudoInertia& P) {
  return Eigen::SelfAdjointEigenSolver<PseudoInertia>(P).eigenvalues()[0];
}

PseudoInertia link_of(const ParameterVector& theta, int link) {
  return pseudo_inertia(theta.segment<kLinkParameters>(link * kLinkParameters));
}

int links_of(const ParameterVector& theta) {
  return static_cast<int>(theta.size()) / (kLinkParameters + kJointParameters);
}

/// Point masses: with fewer than four P loses rank, since each adds one dimension.
struct Masses {
  std::vector<double> mass;
  std::vector<Vec3> place;

  Masses(std::mt19937& generator, int count) {
    for (int i = 0; i < count; ++i) {
      mass.push_back(random_number(generator, 0.1, 2.0));
      place.push_back(random_vec3(generator, 0.5));
    }
  }
  /// The ten parameters by their definitions: sums over m, m x and m (|x|^2 1 - x x^T).
  Link parameters() const {
    double m = 0.0;
    Vec3 h = Vec3::Zero();
    Mat3 I = Mat3::Zero();
    for (std::size_t i = 0; i < mass.size(); ++i) {
      m += mass[i];
      h += mass[i] * place[i];
      I += mass[i] * (place[i].squaredNorm() * Mat3::Identity() - place[i] * place[i].transpose());
    }
    Link link;
    link << m, h, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2);
    return link;
  }
};

/// A theta of two links that some distribution of mass has.
ParameterVector random_valid(std::mt19937& generator, int masses) {
  ParameterVector theta(2 * (kLinkParameters + kJointParameters));
  for (int link = 0; link < 2; ++link) {
    theta.segment<kLinkParameters>(link * kLinkParameters) = Masses(generator, masses).parameters();
  }
  theta.tail<2 * kJointParameters>() = random_vector(generator, 2 * kJointParameters, 1.0).cwiseAbs();
  return theta;
}

/// Any theta of two links: P of both signs.
ParameterVector random_any(std::mt19937& generator) {
  ParameterVector theta(2 * (kLinkParameters + kJointParameters));
  for (Eigen::Index i = 0; i < theta.size(); ++i) theta[i] = random_number(generator, -1.0, 1.0);
  return theta;
}

ParameterVector projected(ParameterVector theta) {
  project_to_physical(theta);
  return theta;
}

/// Sum over links of the Frobenius product of two differences of P.
double product(const ParameterVector& a, const ParameterVector& b, const ParameterVector& c,
               const ParameterVector& d) {
  double sum = 0.0;
  for (int link = 0; link < links_of(a); ++link) {
    sum += ((link_of(a, link) - link_of(b, link)).cwiseProduct(link_of(c, link) - link_of(d, link))).sum();
  }
  const Eigen::Index joints = links_of(a) * kJointParameters;
  return sum + (a - b).tail(joints).dot((c - d).tail(joints));
}

TEST(PseudoInertia, OfPointMassesIsTheSumOfTheirOuterProducts) {
  std::mt19937 generator(751);
  WorstError worst("P = sum m (x, 1) (x, 1)^T", 1e-14);  // rounding
  for (int count = 1; count < 8; ++count) {
    const Masses masses(generator, count);
    PseudoInertia sum = PseudoInertia::Zero();
    for (std::size_t i = 0; i < masses.mass.size(); ++i) {
      const Eigen::Vector4d x = masses.place[i].homogeneous();
      sum += masses.mass[i] * x * x.transpose();
    }
    worst.compare(pseudo_inertia(masses.parameters()), sum, std::to_string(count));
  }
}

TEST(PseudoInertia, GoesBackToTheSameTenParameters) {
  std::mt19937 generator(752);
  WorstError worst("round trip", 1e-15);  // rounding
  for (int sample = 0; sample < 100; ++sample) {
    const Link link = random_vector(generator, kLinkParameters, 3.0);
    worst.compare(Link(link_parameters(pseudo_inertia(link))), link, "random");
  }
}

TEST(PseudoInertia, OfEveryTestedArmIsPositive) {
  for (const RobotModel& arm : test::all_arms()) {
    const ParameterVector theta = theta_of(arm.chain);
    for (int link = 0; link < arm.n(); ++link) {
      EXPECT_GT(smallest_eigenvalue(link_of(theta, link)), 0.0) << arm.name << ", link " << link;
    }
  }
}

TEST(ProjectToPhysical, LeavesTheThetaOfEveryTestedArmToTheBit) {
  std::mt19937 generator(753);
  for (const RobotModel& arm : test::all_arms()) {
    const ParameterVector theta = theta_of(arm.chain);
    EXPECT_EQ(projected(theta), theta) << arm.name;
  }
  for (int sample = 0; sample < 100; ++sample) {
    const ParameterVector theta = random_valid(generator, 6);
    EXPECT_EQ(projected(theta), theta);
  }
}

TEST(ProjectToPhysical, LeavesABodyWithoutExtentAndNothingAtAll) {
  std::mt19937 generator(754);
  WorstError worst("singular P", 1e-14);  // rounding of an eigendecomposition
  for (int masses = 1; masses < 4; ++masses) {
    const ParameterVector theta = random_valid(generator, masses);
    worst.compare(projected(theta), theta, std::to_string(masses));
  }
  const ParameterVector zero = ParameterVector::Zero(2 * (kLinkParameters + kJointParameters));
  EXPECT_EQ(projected(zero), zero);
}

TEST(ProjectToPhysical, GivesAPhysicalTheta) {
  std::mt19937 generator(755);
  int moved = 0;
  for (int sample = 0; sample < 200; ++sample) {
    const ParameterVector theta = random_any(generator);
    const ParameterVector valid = projected(theta);
    moved += valid != theta ? 1 : 0;
    for (int link = 0; link < 2; ++link) {
      EXPECT_GT(smallest_eigenvalue(link_of(valid, link)), -1e-15);  // rounding of entries of 1
    }
    EXPECT_GE(valid.tail<2 * kJointParameters>().minCoeff(), 0.0);
  }
  EXPECT_GT(moved, 150);
}

TEST(ProjectToPhysical, ChangesNothingTheSecondTime) {
  std::mt19937 generator(756);
  WorstError worst("idempotent", 1e-14);  // rounding of an eigendecomposition
  for (int sample = 0; sample < 200; ++sample) {
    const ParameterVector once = projected(random_any(generator));
    worst.compare(projected(once), once, "random", 1.0);
  }
}

TEST(ProjectToPhysical, TreatsLinksAndJointsEachForItself) {
  std::mt19937 generator(757);
  const ParameterVector valid = random_valid(generator, 6);
  ParameterVector theta = valid;
  theta.head<kLinkParameters>() = random_any(generator).head<kLinkParameters>();
  theta[0] = -1.0;
  theta[2 * kLinkParameters + 1] = -0.3;
  ParameterVector expected = projected(theta);
  EXPECT_NE(Link(expected.head<kLinkParameters>()), Link(theta.head<kLinkParameters>()));
  EXPECT_EQ(expected[2 * kLinkParameters + 1], 0.0);
  expected.head<kLinkParameters>() = valid.head<kLinkParameters>();
  expected[2 * kLinkParameters + 1] = valid[2 * kLinkParameters + 1];
  EXPECT_EQ(expected, valid);
}

TEST(ProjectToPhysical, IsNearerThanAnyOtherPhysicalTheta) {
  std::mt19937 generator(758);
  WorstError optimal("(theta - Pi, v - Pi) <= 0", 1e-13);  // rounding of sums of 32 products of some 1
  for (int sample = 0; sample < 100; ++sample) {
    const ParameterVector theta = random_any(generator);
    const ParameterVector nearest = projected(theta);
    for (int other = 0; other < 20; ++other) {
      // Far from it and, towards such a one, near it.
      const ParameterVector far = random_valid(generator, 1 + other % 6);
      const ParameterVector near = nearest + 1e-3 * (far - nearest);
      for (const ParameterVector& v : {far, near}) {
        optimal.add(std::max(0.0, product(theta, nearest, v, nearest)), "random");
        EXPECT_LE(product(theta, nearest, theta, nearest), product(theta, v, theta, v) + 1e-13);
      }
    }
  }
}

/// P's projection by an eigendecomposition.
PseudoInertia by_decomposition(const PseudoInertia& P) {
  const Eigen::SelfAdjointEigenSolver<PseudoInertia> eigen(P);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

TEST(ProjectToPhysical, IsThatOfAnEigendecompositionHoweverManyAndSmallTheNegativeOnes) {
  std::mt19937 generator(760);
  WorstError worst("projection", 1e-13);  // of the size of P: rounding, and the gap between eigenvalues
  for (int sample = 0; sample < 4000; ++sample) {
    const Eigen::Matrix4d basis = Eigen::HouseholderQR<Eigen::Matrix4d>(Eigen::Matrix4d::NullaryExpr([&] {
                                    return random_number(generator, -1.0, 1.0);
                                  })).householderQ();
    Eigen::Vector4d eigenvalues;
    for (double& value : eigenvalues) value = std::pow(10.0, random_number(generator, -6.0, 1.0));
    // One, two, three or four below zero; the smallest and the largest of them far apart or close.
    for (int k = 0; k <= sample % 4; ++k)
      eigenvalues[k] = -std::pow(10.0, random_number(generator, -14.0, 1.0));
    if (sample % 5 == 0) eigenvalues[0] = -eigenvalues[3];  // nearest to zero with a positive one beside it
    const PseudoInertia P = basis * eigenvalues.asDiagonal() * basis.transpose();
    ParameterVector theta = ParameterVector::Zero(kLinkParameters + kJointParameters);
    theta.head<kLinkParameters>() = link_parameters(0.5 * (P + P.transpose()));
    const PseudoInertia expected = by_decomposition(link_of(theta, 0));
    worst.compare(link_of(projected(theta), 0), expected, std::to_string(sample), P.norm());
  }
}

TEST(PositiveDefinite, IsDecidedForEachOfSeveralArmsAsForOneAlone) {
  std::mt19937 generator(761);
  int positive = 0;
  for (int sample = 0; sample < 400; ++sample) {
    LinkParametersT<Pack<4>> packed;
    std::array<LinkParameters, 4> alone;
    for (int lane = 0; lane < 4; ++lane) {
      // Barely valid and barely invalid ones among them.
      LinkParameters link = random_valid(generator, 6).head<kLinkParameters>();
      link[4] += random_number(generator, -1.0, 0.5) * link[4];
      if (sample % 7 == lane) link[0] = std::numeric_limits<double>::quiet_NaN();
      alone[static_cast<std::size_t>(lane)] = link;
      for (int i = 0; i < kLinkParameters; ++i) packed[i].set(lane, link[i]);
    }
    const auto found = positive_definite(pseudo_inertia(packed));
    for (int lane = 0; lane < 4; ++lane) {
      const PseudoInertia P = pseudo_inertia(alone[static_cast<std::size_t>(lane)]);
      const bool expected = P.allFinite() && smallest_eigenvalue(P) > 0.0;
      EXPECT_EQ(found[lane] != 0, expected);
      EXPECT_EQ(positive_definite(P), expected);
      positive += expected ? 1 : 0;
    }
  }
  EXPECT_GT(positive, 300);
  EXPECT_LT(positive, 1300);
}

TEST(ProjectToPhysical, AllocatesNothing) {
  if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  std::mt19937 generator(759);
  ParameterVector theta = random_any(generator);
  const long before = test::allocations();
  project_to_physical(theta);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace physical_theta_test
}  // namespace armtune::internal
