#pragma once
// W arms in packs of W numbers. Each file that includes this is compiled for one kind of processor and is the
// only one with its W, so that nothing compiled for that processor can be called on another
// (scripts/check-lanes).

#include "core/common/pack.hpp"
#include "core/control/adaptation.hpp"
#include "core/control/adaptation_filter.hpp"
#include "core/control/obstacle_distance.hpp"
#include "core/control/task_resolution.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "sim/lanes/arm_lanes.hpp"
#include "sim/lanes/chain_numbers.hpp"

namespace armtune::internal {

template <int W>
class PackedArm final : public ArmLanes {
 public:
  explicit PackedArm(const LaneKind& kind)
      : period_(kind.control_period), stepper_(kind.stepper), mask_(kind.mask) {
    for (ChainT<T>* chain : {&chain_, &plant_}) {
      chain->n = kind.n;
      chain->motion = kind.motion;
      chain->link_radius.setZero(kind.link_surfaces ? kind.n : 0);
      for (Joints* joints : {&chain->rotor_inertia, &chain->viscous_friction, &chain->coulomb_friction}) {
        joints->setZero(kind.n);
      }
    }
    for (Joints* joints :
         {&q_, &qd_, &measured_q_, &measured_qd_, &reference_.velocity, &reference_.acceleration,
          &centering_.middle, &centering_.rate, &Kd_, &commanded_, &torque_}) {
      joints->setZero(kind.n);
    }
    adaptation_ = AdaptationT<T>(ParameterVectorT<T>::Zero(parameter_count(chain_)));
    theta_true_ = adaptation_.theta();
    filter_.start(kind.n);
    obstacle_count_ = kind.most_obstacles;
    obstacles_ = std::make_unique<ObstacleT<T>[]>(obstacle_count_);
  }

  int lanes() const override { return W; }

  void put_chains(int lane, const double* control, const double* plant) override {
    for_each_number(chain_, [&](T& x) { x.set(lane, *control++); });
    for_each_number(plant_, [&](T& x) { x.set(lane, *plant++); });
  }
  void put_control(int lane, const LaneControl& control) override {
    damping_.threshold.set(lane, control.damping.threshold);
    damping_.psi.set(lane, control.damping.psi);
    damping_.growing.set(lane, control.damping.growing);
    gamma_.set(lane, control.adaptation_gain);
    leakage_.set(lane, control.adaptation_leakage);
    inertia_leakage_.set(lane, control.inertia_leakage);
    leaks_ = any(leakage_ + inertia_leakage_ > T(0));
    filter_share_.set(lane, control.filter_share);
    filters_ = filter_share_ > T(0);
    filter_.rest(lane);
  }
  void put_centering(int lane, const double* middle, const double* rate) override {
    put(lane, middle, centering_.middle);
    put(lane, rate, centering_.rate);
  }
  void put_theta(int lane, const double* start, const double* truth) override {
    put(lane, start, adaptation_.start());
    put(lane, start, adaptation_.theta());
    put(lane, truth, theta_true_);
  }
  void put_state(int lane, const double* q, const double* qd) override {
    put(lane, q, q_);
    put(lane, qd, qd_);
  }
  void get_state(int lane, double* q, double* qd) const override {
    get(lane, q_, q);
    get(lane, qd_, qd);
  }

  void put_measured(int lane, const double* q, const double* qd, const double* obstacles,
                    std::size_t count) override {
    put(lane, q, measured_q_);
    put(lane, qd, measured_qd_);
    for (std::size_t i = 0; i < count; ++i) put_obstacle(lane, obstacles + 4 * i, obstacles_[i]);
    // Those that only other arms have are infinitely far away.
    for (std::size_t i = count; i < obstacle_count_; ++i) put_obstacle(lane, kNowhere, obstacles_[i]);
  }
  void measure() override {
    arm_.measure(chain_, measured_q_, measured_qd_, damping_, mask_);
    obstacle_distance_ = obstacle_distance<T>(chain_, arm_.poses, {obstacles_.get(), obstacle_count_});
    tasks_ = typename T::Mask{};
  }
  void get_measured(int lane, const LaneTool& tool, double& manipulability, bool& damped,
                    double& distance) const override {
    get_tool(lane, arm_.poses, arm_.twist, tool);
    manipulability = arm_.inverse.manipulability()[lane];
    damped = arm_.inverse.damped()[lane] != 0;
    distance = obstacle_distance_[lane];
  }

  void put_task_reference(int lane, const double* rate, const double* acceleration) override {
    put(lane, rate, task_.rate);
    put(lane, acceleration, task_.acceleration);
    tasks_[lane] = -1;
  }
  void resolve() override {
    if (!any(tasks_)) return;
    arm_.differentiate(chain_, measured_qd_);
    armtune::internal::resolve(task_, arm_, centering_, measured_q_, measured_qd_, resolved_);
    for (Eigen::Index i = 0; i < chain_.n; ++i) {
      reference_.velocity[i] = select(tasks_, resolved_.velocity[i], reference_.velocity[i]);
      reference_.acceleration[i] = select(tasks_, resolved_.acceleration[i], reference_.acceleration[i]);
    }
  }
  void get_joint_reference(int lane, double* velocity, double* acceleration) const override {
    get(lane, reference_.velocity, velocity);
    get(lane, reference_.acceleration, acceleration);
  }
  void put_joint_reference(int lane, const double* velocity, const double* acceleration) override {
    put(lane, velocity, reference_.velocity);
    put(lane, acceleration, reference_.acceleration);
  }

  void put_Kd(int lane, const double* Kd) override { put(lane, Kd, Kd_); }
  void torque() override {
    slotine_li_forward(chain_, arm_.poses, measured_qd_, reference_.velocity, reference_.acceleration,
                       motion_);
    slotine_li_torque(chain_, arm_.poses, motion_, adaptation_.theta(), commanded_);
    for (Eigen::Index i = 0; i < chain_.n; ++i) {
      commanded_[i] -= Kd_[i] * (measured_qd_[i] - reference_.velocity[i]);
    }
    if (any(filters_)) {
      filter_.take(filter_share_, measured_qd_, reference_.velocity, reference_.acceleration);
    }
  }
  void get_commanded(int lane, double* torque) const override { get(lane, commanded_, torque); }

  void adapt(const bool* adapting) override {
    typename T::Mask where{};
    for (int lane = 0; lane < W; ++lane) where[lane] = adapting[lane] ? -1 : 0;
    if (!any(where)) return;
    const typename T::Mask filtered = where & filters_;
    if (any(filtered)) {
      filter_.motion(chain_, arm_.poses, smoothed_);
      adaptation_.step(smoothed_, motion_, gamma_, T(period_), filtered);
    }
    const typename T::Mask unfiltered = where & ~filters_;
    if (any(unfiltered)) adaptation_.step(motion_, motion_, gamma_, T(period_), unfiltered);
    if (leaks_) adaptation_.leak(leakage_, inertia_leakage_, T(period_), where);
  }
  void get_theta(int lane, double* theta) const override { get(lane, adaptation_.theta(), theta); }
  void replace_theta(int lane, const double* theta) override { put(lane, theta, adaptation_.theta()); }

  void observe(bool exact) override {
    exact_ = exact;
    const PosesT<T>& poses = exact ? arm_.poses : true_poses_;
    const std::span<const ObstacleT<T>> obstacles{obstacles_.get(), obstacle_count_};
    if (!exact) {
      forward_kinematics(chain_, q_, true_poses_);
      tool_jacobian(chain_, true_poses_, true_J_);
      true_twist_ = times(true_J_, qd_);
      slotine_li_forward(chain_, true_poses_, qd_, reference_.velocity, reference_.acceleration, motion_);
    }
    theta_error_ = adaptation_.theta() - theta_true_;
    slotine_li_torque(chain_, poses, motion_, theta_error_, torque_error_);
    compensation_error_ = norm(torque_error_);
    const T of_joints = exact ? obstacle_distance_ : obstacle_distance<T>(chain_, poses, obstacles);
    clearance_ = clearance<T>(chain_, poses, obstacles, of_joints);
  }
  void get_observed(int lane, const LaneTool& tool, double& clearance,
                    double& compensation_error) const override {
    if (!exact_) get_tool(lane, true_poses_, true_twist_, tool);
    clearance = clearance_[lane];
    compensation_error = compensation_error_[lane];
  }

  void put_torque(int lane, const double* torque) override { put(lane, torque, torque_); }
  void step() override {
    const PosesT<T>* poses = exact_ ? &arm_.poses : &true_poses_;
    const FrictionStep<T> friction(T(period_), qd_);  // integrate() writes qd_ after the last evaluation
    integrate(
        stepper_, T(period_),
        [&](const Joints& q, const Joints& qd, Joints& qdd) {
          if (poses == nullptr) body_poses(plant_, q, stage_poses_);
          forward_dynamics(plant_, poses == nullptr ? stage_poses_ : *poses, qd, torque_, friction, dynamics_,
                           qdd);
          poses = nullptr;  // only the first stage is where the step starts
        },
        q_, qd_, work_);
  }

 private:
  using T = Pack<W>;
  using Joints = JointVectorT<T>;
  static constexpr double kNowhere[4] = {HUGE_VAL, HUGE_VAL, HUGE_VAL, 0.0};

  template <typename Packs>
  static void put(int lane, const double* from, Packs& to) {
    for (Eigen::Index i = 0; i < to.size(); ++i) to.data()[i].set(lane, from[i]);
  }
  static void put_obstacle(int lane, const double* from, ObstacleT<T>& to) {
    put(lane, from, to.center);
    to.radius.set(lane, from[3]);
  }
  template <typename Packs>
  static void get(int lane, const Packs& from, double* to) {
    for (Eigen::Index i = 0; i < from.size(); ++i) to[i] = from.data()[i][lane];
  }
  static void get_tool(int lane, const PosesT<T>& poses, const Vec6T<T>& twist, const LaneTool& tool) {
    get(lane, poses.R_0T, tool.R_0T);
    get(lane, poses.p_0T, tool.p_0T);
    get(lane, twist, tool.twist);
  }

  double period_;
  Stepper stepper_;
  ChainT<T> chain_, plant_;
  TaskMask mask_;
  InverseDampingT<T> damping_;
  JointCenteringT<T> centering_;
  T gamma_{0.0}, leakage_{0.0}, inertia_leakage_{0.0};
  bool leaks_ = false;
  T filter_share_{0.0};
  typename T::Mask filters_{};
  AdaptationFilterT<T> filter_;
  Joints q_, qd_;
  Joints measured_q_, measured_qd_;
  std::unique_ptr<ObstacleT<T>[]> obstacles_;
  std::size_t obstacle_count_ = 0;
  MeasuredArmT<T> arm_;
  T obstacle_distance_{0.0};
  typename T::Mask tasks_{};
  TaskReferenceT<T> task_;
  JointReferenceT<T> reference_, resolved_;
  Joints Kd_, commanded_;
  SlotineLiT<T> motion_, smoothed_;
  AdaptationT<T> adaptation_;
  bool exact_ = true;
  PosesT<T> true_poses_;
  JacobianT<T> true_J_;
  Vec6T<T> true_twist_;
  T clearance_{0.0}, compensation_error_{0.0};
  ParameterVectorT<T> theta_true_, theta_error_;
  Joints torque_error_, torque_;
  PosesT<T> stage_poses_;
  ForwardDynamicsT<T> dynamics_;
  StepWorkspaceT<T> work_;
};

}  // namespace armtune::internal
