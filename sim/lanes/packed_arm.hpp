#pragma once
// Implements ArmLanes (arm_lanes.hpp). It computes W arms at the same time in SIMD vectors of W numbers, one
// number per arm.
//
// Rule: each file that includes this header is compiled for one kind of processor, and no two of these files
// use the same W. Otherwise the linker could merge equal templates of two files, and one kind of processor
// would run code that was compiled for another. scripts/check-lanes checks the rule.

#include "core/common/pack.hpp"
#include "core/control/laws/make_arm_law.hpp"
#include "core/control/obstacle_distance.hpp"
#include "core/control/task_resolution.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/robot/physical_theta.hpp"
#include "sim/lanes/arm_lanes.hpp"
#include "sim/lanes/chain_numbers.hpp"

namespace armtune::internal {

template <int W>
class PackedArm final : public ArmLanes {
 public:
  explicit PackedArm(const LaneKind& kind)
      : period_(kind.control_period),
        steps_(kind.plant_steps),
        step_(kind.control_period / (kind.drive_steps * kind.plant_steps)),
        stepper_(kind.stepper),
        mask_(kind.mask),
        law_(make_arm_law<T>(kind.law, kind.n)),
        planned_(kind.n) {
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
          &centering_.middle, &centering_.rate, &Kd_, &commanded_, &torque_, &weight_}) {
      joints->setZero(kind.n);
    }
    theta_true_ = law_->theta();
    obstacle_count_ = kind.most_obstacles;
    obstacles_ = std::make_unique<ObstacleT<T>[]>(obstacle_count_);
  }

  int lanes() const override { return W; }

  void start(int lane, const LaneStart& arm) override {
    const double* control = arm.control_chain;
    const double* plant = arm.plant_chain;
    for_each_number(chain_, [&](T& x) { x.set(lane, *control++); });
    for_each_number(plant_, [&](T& x) { x.set(lane, *plant++); });
    damping_.threshold.set(lane, arm.damping.threshold);
    damping_.psi.set(lane, arm.damping.psi);
    damping_.growing.set(lane, arm.damping.growing);
    law_->start(lane, arm.law);
    put(lane, arm.centering_middle, centering_.middle);
    put(lane, arm.centering_rate, centering_.rate);
    put(lane, arm.theta_true, theta_true_);
    place(lane, arm.q, arm.qd);
  }
  void place(int lane, const double* q, const double* qd) override {
    put(lane, q, q_);
    put(lane, qd, qd_);
  }

  void sense(int lane, const LaneSensed& sensed) override {
    put(lane, sensed.q, measured_q_);
    put(lane, sensed.qd, measured_qd_);
    const std::size_t count = sensed.obstacle_count;
    for (std::size_t i = 0; i < count; ++i) put_obstacle(lane, sensed.obstacles + 4 * i, obstacles_[i]);
    // Other lanes may have more obstacles. The ones that this lane lacks are infinitely far away.
    for (std::size_t i = count; i < obstacle_count_; ++i) put_obstacle(lane, kNowhere, obstacles_[i]);
  }
  void measure() override {
    arm_.measure(chain_, measured_q_, measured_qd_, damping_, mask_);
    obstacle_distance_ = obstacle_distance<T>(chain_, arm_.poses, {obstacles_.get(), obstacle_count_});
    tasks_ = typename T::Mask{};
    yields_ = typename T::Mask{};
    planned_.active = typename T::Mask{};
  }
  void seen(int lane, const LaneSeen& seen) const override {
    get_tool(lane, arm_.poses, arm_.twist, seen.tool);
    *seen.manipulability = arm_.inverse.manipulability()[lane];
    *seen.damped = arm_.inverse.damped()[lane] != 0;
    *seen.obstacle_distance = obstacle_distance_[lane];
  }

  void follow_task(int lane, const LaneTask& task, const double* Kd) override {
    put(lane, task.reference.velocity, task_.rate);
    put(lane, task.reference.acceleration, task_.acceleration);
    put(lane, task.pose_error, pose_error_);
    put(lane, Kd, Kd_);
    tasks_[lane] = -1;
    yields_[lane] = task.yields ? -1 : 0;
  }
  void follow_joints(int lane, const LaneReference& joints, const double* Kd) override {
    replace_reference(lane, joints);
    put(lane, Kd, Kd_);
  }
  void follow_plan(int lane, const LanePlan& plan) override {
    put(lane, plan.position, planned_.position);
    put(lane, plan.velocity, planned_.velocity);
    put(lane, plan.fed_velocity, planned_.fed_velocity);
    planned_.active[lane] = -1;
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
  void reference(int lane, double* velocity, double* acceleration) const override {
    get(lane, reference_.velocity, velocity);
    get(lane, reference_.acceleration, acceleration);
  }
  void replace_reference(int lane, const LaneReference& joints) override {
    put(lane, joints.velocity, reference_.velocity);
    put(lane, joints.acceleration, reference_.acceleration);
  }

  void torque() override {
    S_ = measured_qd_ - reference_.velocity;
    law_->torque(period(), commanded_);
  }
  void commanded(int lane, double* torque) const override { get(lane, commanded_, torque); }
  void weigh() override { law_->weigh(period(), weight_); }
  void weight(int lane, double* torque) const override { get(lane, weight_, torque); }

  void adapt(const bool* adapting) override {
    typename T::Mask where{};
    for (int lane = 0; lane < W; ++lane) where[lane] = adapting[lane] ? -1 : 0;
    law_->conclude(period(), where);
  }
  void project(const bool* projecting, std::uint32_t* invalid) override {
    typename T::Mask where{};
    for (int lane = 0; lane < W; ++lane) {
      where[lane] = projecting[lane] ? -1 : 0;
      invalid[lane] = 0;
    }
    ParameterVectorT<T>& theta = law_->theta();
    for (int link = 0; link < chain_.n; ++link) {
      const LinkParametersT<T> parameters = theta.template segment<kLinkParameters>(link * kLinkParameters);
      const typename T::Mask valid = positive_definite(pseudo_inertia(parameters));
      for (int lane = 0; lane < W; ++lane) {
        if (projecting[lane] && valid[lane] == 0) invalid[lane] |= std::uint32_t{1} << link;
      }
    }
    for (Eigen::Index i = chain_.n * kLinkParameters; i < theta.size(); ++i)
      theta[i] = select(where, not_negative(theta[i]), theta[i]);
  }
  void link_theta(int lane, int link, double* parameters) const override {
    const T* from = law_->theta().data() + link * kLinkParameters;
    for (int i = 0; i < kLinkParameters; ++i) parameters[i] = from[i][lane];
  }
  void replace_link_theta(int lane, int link, const double* parameters) override {
    T* to = law_->theta().data() + link * kLinkParameters;
    for (int i = 0; i < kLinkParameters; ++i) to[i].set(lane, parameters[i]);
  }

  void observe(bool exact) override {
    exact_ = exact;
    begins_ = true;
    const PosesT<T>& poses = exact ? arm_.poses : true_poses_;
    const std::span<const ObstacleT<T>> obstacles{obstacles_.get(), obstacle_count_};
    if (!exact) {
      forward_kinematics(chain_, q_, true_poses_);
      tool_jacobian(chain_, true_poses_, true_J_);
      true_twist_ = times(true_J_, qd_);
    }
    const SlotineLiT<T>* motion = exact ? law_->references_motion() : nullptr;
    if (motion == nullptr) {
      slotine_li_forward(chain_, poses, qd_, reference_.velocity, reference_.acceleration, true_motion_);
      motion = &true_motion_;
    }
    theta_error_ = law_->theta() - theta_true_;
    slotine_li_torque(chain_, poses, *motion, theta_error_, torque_error_);
    compensation_error_ = norm(torque_error_);
    const T of_joints = exact ? obstacle_distance_ : obstacle_distance<T>(chain_, poses, obstacles);
    clearance_ = clearance<T>(chain_, poses, obstacles, of_joints);
  }
  void observed(int lane, const LaneObserved& observed) const override {
    if (!exact_) get_tool(lane, true_poses_, true_twist_, observed.tool);
    *observed.clearance = clearance_[lane];
    *observed.compensation_error = compensation_error_[lane];
  }

  void push(int lane, const double* torque) override { put(lane, torque, torque_); }
  void step() override {
    const PosesT<T>* poses = !begins_ ? nullptr : exact_ ? &arm_.poses : &true_poses_;
    begins_ = false;
    for (int k = 0; k < steps_; ++k) {
      const FrictionStep<T> friction(T(step_), qd_);  // integrate() writes qd_ after the last evaluation
      integrate(
          stepper_, T(step_),
          [&](const Joints& q, const Joints& qd, Joints& qdd) {
            if (poses == nullptr) body_poses(plant_, q, stage_poses_);
            forward_dynamics(plant_, poses == nullptr ? stage_poses_ : *poses, qd, torque_, friction,
                             dynamics_, qdd);
            poses = nullptr;  // these poses are valid only at the start of the control period
          },
          q_, qd_, work_);
    }
  }
  void moved(int lane, double* q, double* qd) const override {
    get(lane, q_, q);
    get(lane, qd_, qd);
  }

 private:
  using T = Pack<W>;
  using Joints = JointVectorT<T>;
  LawPeriodT<T> period() const {
    return {chain_, arm_,        measured_q_, measured_qd_, reference_, S_,
            Kd_,    pose_error_, planned_,    ~tasks_,      yields_,    T(period_)};
  }
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
  int steps_;    ///< of the plant in a call of step()
  double step_;  ///< of the plant [s]
  Stepper stepper_;
  ChainT<T> chain_, plant_;
  TaskMask mask_;
  InverseDampingT<T> damping_;
  JointCenteringT<T> centering_;
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
  std::unique_ptr<ArmLawT<T>> law_;
  PlannedJointsT<T> planned_;
  Joints S_;
  Vec6T<T> pose_error_ = Vec6T<T>::Zero();
  typename T::Mask yields_{};
  bool exact_ = true;
  bool begins_ = true;  ///< the plant is where observe() computed the poses
  SlotineLiT<T> true_motion_;
  PosesT<T> true_poses_;
  JacobianT<T> true_J_;
  Vec6T<T> true_twist_;
  T clearance_{0.0}, compensation_error_{0.0};
  ParameterVectorT<T> theta_true_, theta_error_;
  Joints torque_error_, torque_, weight_;
  PosesT<T> stage_poses_;
  ForwardDynamicsT<T> dynamics_;
  StepWorkspaceT<T> work_;
};

}  // namespace armtune::internal
