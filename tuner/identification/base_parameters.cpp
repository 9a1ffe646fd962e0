#include "tuner/identification/base_parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "core/robot/slotine_li.hpp"
#include "tuner/identification/sparse_qr.hpp"

namespace armtune::internal {
namespace {

/// A column of unit length counts as dependent if its part that is orthogonal to the columns before it is
/// shorter than this. Rounding leaves 1e-14; the smallest independent part seen on serial arms is 1e-3.
constexpr double kDependent = 1e-8;
/// A column shorter than this share of the longest column holds nothing but rounding errors.
constexpr double kNothing = 1e-12;
/// Coefficients below this are rounding errors.
constexpr double kNoCoefficient = 1e-9;
constexpr int kStatesPerParameter = 4;
constexpr double kLightest = 1e-3;   ///< [kg]
constexpr double kNarrowest = 0.02;  ///< [m]

std::string group_name(const std::vector<std::string>& names, const Eigen::RowVectorXd& row, int leader) {
  std::string text = names[static_cast<std::size_t>(leader)];
  for (Eigen::Index i = 0; i < row.size(); ++i) {
    if (i == leader || row[i] == 0.0) continue;
    const double size = std::abs(row[i]);
    text += row[i] < 0.0 ? " - " : " + ";
    if (std::abs(size - 1.0) > kNoCoefficient) text += fmt::format("{:.6g} ", size);
    text += names[static_cast<std::size_t>(i)];
  }
  return text;
}

}  // namespace

Eigen::VectorXd parameter_sizes(const RobotModel& model) {
  const int n = model.n();
  const ParameterVector theta = theta_of(model.chain);
  Eigen::VectorXd size(theta.size());
  for (int i = 0; i < n; ++i) {
    const auto link = theta.segment<kLinkParameters>(i * kLinkParameters);
    const double mass = std::max(kLightest, link[0]);
    const double inertia = link[kFirstInertia] + link[kFirstInertia + 3] + link[kFirstInertia + 5];
    const double width = std::max(kNarrowest, std::sqrt(std::max(0.0, inertia) / mass));
    auto sizes = size.segment<kLinkParameters>(i * kLinkParameters);
    sizes.setConstant(mass * width * width);
    sizes.segment<3>(1).setConstant(mass * width);
    sizes[0] = mass;
    const JointLimits& limits = model.joints[static_cast<std::size_t>(i)].limits;
    const int joint = joint_parameter_index(n, i);
    size[joint] = std::max(theta[joint], 0.01 * limits.effort);
    size[joint + 1] = std::max(theta[joint + 1], 0.02 * limits.effort / limits.velocity);
    size[joint + 2] = std::max(theta[joint + 2], 0.02 * limits.effort);
  }
  return size;
}

Eigen::VectorXd group_sizes(const BaseParameters& base, const Eigen::VectorXd& theta) {
  return base.map.cwiseAbs() * theta.cwiseAbs() + Eigen::VectorXd::Constant(base.rank(), 1e-6);
}

Eigen::MatrixXd random_regressor(const RobotModel& model, int states, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const int n = model.n();
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(states) * n, parameter_count(model.chain));
  Poses poses;
  SlotineLi motion;
  Regressor Y;
  JointVector q(n), qd(n), qdd(n);
  for (int state = 0; state < states; ++state) {
    for (int i = 0; i < n; ++i) {
      const JointLimits& limits = model.joints[static_cast<std::size_t>(i)].limits;
      const double middle = limits.has_position ? 0.5 * (limits.lower + limits.upper) : 0.0;
      const double half = limits.has_position ? 0.5 * (limits.upper - limits.lower) : M_PI;
      q[i] = middle + half * uniform(generator);
      qd[i] = 2.0 * uniform(generator);
      qdd[i] = 5.0 * uniform(generator);
    }
    forward_kinematics(model.chain, q, poses);
    slotine_li_forward(model.chain, poses, qd, qd, qdd, motion);
    slotine_li_regressor(model.chain, poses, motion, Y);
    rows.middleRows(static_cast<Eigen::Index>(state) * n, n) = Y;
  }
  return rows;
}

BaseParameters base_parameters(const RobotModel& model) {
  const int p = parameter_count(model.chain);
  Eigen::MatrixXd Y = random_regressor(model, kStatesPerParameter * p, 1);
  Eigen::VectorXd length = Y.colwise().norm();
  // The column of a parameter without effect holds zeros or rounding errors. Scaled to unit length, it would
  // look like the column of a parameter with an effect.
  length = (length.array() > kNothing * length.maxCoeff()).select(length, HUGE_VAL);
  Y *= length.cwiseInverse().asDiagonal();
  const SparseMatrix sparse = Y.sparseView().cast<double>();
  const RankRevealed revealed = rank_revealing_factor(sparse, kDependent);

  BaseParameters base;
  base.independent = revealed.live;
  const auto rank = static_cast<Eigen::Index>(revealed.live.size());
  // The dead columns as combinations of the live ones: R_live^-1 R_dead. The loop below undoes the scaling to
  // unit length.
  const Eigen::MatrixXd combination = revealed.R.leftCols(rank).triangularView<Eigen::Upper>().solve(
      revealed.R.rightCols(static_cast<Eigen::Index>(revealed.dead.size())));
  base.map = Eigen::MatrixXd::Zero(rank, p);
  for (Eigen::Index b = 0; b < rank; ++b) {
    const int leader = revealed.live[static_cast<std::size_t>(b)];
    base.map(b, leader) = 1.0;
    for (std::size_t d = 0; d < revealed.dead.size(); ++d) {
      const int dead = revealed.dead[d];
      const double coefficient = std::isinf(length[dead]) ? 0.0
                                                          : combination(b, static_cast<Eigen::Index>(d)) *
                                                                length[dead] / length[leader];
      if (std::abs(coefficient) > kNoCoefficient) base.map(b, dead) = coefficient;
    }
  }
  const auto names = theta_names(model);
  base.names.reserve(static_cast<std::size_t>(rank));
  for (Eigen::Index b = 0; b < rank; ++b) {
    base.names.push_back(group_name(names, base.map.row(b), base.independent[static_cast<std::size_t>(b)]));
  }
  return base;
}

}  // namespace armtune::internal
