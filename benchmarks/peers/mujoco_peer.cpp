// Measures MuJoCo. Contacts, limits and everything else outside rigid body dynamics are switched off. This
// version of MuJoCo has no derivative of the Jacobian, so that `jacobian` is J alone.

#include <mujoco/mujoco.h>

#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "peer.hpp"

namespace {

constexpr int kN = peers::kJoints;
constexpr const char* kFile = "arm.urdf";

struct DeleteVfs {
  void operator()(mjVFS* vfs) const {
    mj_deleteVFS(vfs);
    delete vfs;
  }
};

/// Loads the robot with an additional element `mujoco`, which is MuJoCo's extension of URDF.
mjModel* load_with(const std::string& urdf, const std::string& compiler) {
  std::ifstream file(urdf);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t end = text.rfind("</robot>");
  if (end == std::string::npos) throw std::runtime_error("cannot read " + urdf);
  text.insert(end, "<mujoco><compiler discardvisual=\"true\" " + compiler + "/></mujoco>\n");
  const std::unique_ptr<mjVFS, DeleteVfs> vfs(new mjVFS);
  mj_defaultVFS(vfs.get());
  if (mj_makeEmptyFileVFS(vfs.get(), kFile, static_cast<int>(text.size())) != 0) {
    throw std::runtime_error("no room for the robot");
  }
  std::memcpy(vfs->filedata[mj_findFileVFS(vfs.get(), kFile)], text.data(), text.size());
  std::array<char, 1000> error{};
  mjModel* model = mj_loadXML(kFile, vfs.get(), error.data(), static_cast<int>(error.size()));
  if (model == nullptr) throw std::runtime_error(error.data());
  model->opt.disableflags |= mjDSBL_CONSTRAINT | mjDSBL_CONTACT | mjDSBL_LIMIT | mjDSBL_EQUALITY |
                             mjDSBL_FRICTIONLOSS | mjDSBL_PASSIVE | mjDSBL_ACTUATION | mjDSBL_SENSOR;
  model->opt.timestep = peers::kStep;
  model->opt.integrator = mjINT_EULER;
  return model;
}

struct Arm {
  mjModel* model;
  mjData* data;
  int last;  ///< body that carries the tool
  std::array<double, 3> p_BT{};
  std::array<double, 9> R_BT{};
  std::array<double, 3> p{};
  std::array<double, 9> R{};
  std::array<double, std::size_t{3} * kN> linear{}, angular{};
  std::array<double, kN> tau{};
  std::array<double, std::size_t{kN} * kN> M{};

  explicit Arm(const std::string& urdf) : model(load_with(urdf, "")), data(mj_makeData(model)) {
    if (model->nv != kN) throw std::runtime_error("not six joints: " + urdf);
    last = mj_name2id(model, mjOBJ_BODY, "wrist_3_link");
    // MuJoCo merges links without joints into the links that carry them. The pose of the tool is therefore
    // read from a second model, in which they are not merged.
    mjModel* whole = load_with(urdf, "fusestatic=\"false\"");
    const int tool = mj_name2id(whole, mjOBJ_BODY, "tool0");
    if (last < 0 || tool < 0) throw std::runtime_error("no wrist_3_link and tool0");
    std::memcpy(p_BT.data(), whole->body_pos + std::ptrdiff_t{3} * tool, sizeof p_BT);
    mju_quat2Mat(R_BT.data(), whole->body_quat + std::ptrdiff_t{4} * tool);
    mj_deleteModel(whole);
  }
  Arm(const Arm&) = delete;
  Arm& operator=(const Arm&) = delete;
  ~Arm() {
    mj_deleteData(data);
    mj_deleteModel(model);
  }

  void position(const peers::State& s) {
    std::memcpy(data->qpos, s.q.data(), sizeof s.q);
    mj_kinematics(model, data);
  }
  void find_tool() {
    mju_rotVecMat(p.data(), p_BT.data(), data->xmat + std::ptrdiff_t{9} * last);
    mju_addTo3(p.data(), data->xpos + std::ptrdiff_t{3} * last);
  }
  void force(const peers::State& s) {
    std::memcpy(data->qpos, s.q.data(), sizeof s.q);
    std::memcpy(data->qvel, s.qd.data(), sizeof s.qd);
    std::memcpy(data->qfrc_applied, s.tau.data(), sizeof s.tau);
  }
};

void add(const double* numbers, std::size_t count, std::vector<double>& out) {
  out.insert(out.end(), numbers, numbers + count);
}

peers::Peer load(const std::string& urdf) {
  const auto arm = std::make_shared<Arm>(urdf);
  Arm& a = *arm;
  return {"MuJoCo",
          mj_versionString(),
          {{"forward_kinematics",
            [arm, &a](const peers::State& s) {
              a.position(s);
              a.find_tool();
              mju_mulMatMat(a.R.data(), a.data->xmat + std::ptrdiff_t{9} * a.last, a.R_BT.data(), 3, 3, 3);
            },
            [&a](std::vector<double>& out) {
              add(a.p.data(), a.p.size(), out);
              add(a.R.data(), a.R.size(), out);
            }},
           {"jacobian",
            [&a](const peers::State& s) {
              a.position(s);
              mj_comPos(a.model, a.data);
              a.find_tool();
              mj_jac(a.model, a.data, a.linear.data(), a.angular.data(), a.p.data(), a.last);
            },
            [&a](std::vector<double>& out) {
              add(a.linear.data(), a.linear.size(), out);
              add(a.angular.data(), a.angular.size(), out);
            }},
           {"inverse_dynamics",
            [&a](const peers::State& s) {
              std::memcpy(a.data->qvel, s.qd.data(), sizeof s.qd);
              std::memcpy(a.data->qacc, s.qdd.data(), sizeof s.qdd);
              a.position(s);
              mj_comPos(a.model, a.data);
              mj_comVel(a.model, a.data);
              mj_rne(a.model, a.data, 1, a.tau.data());
            },
            [&a](std::vector<double>& out) { add(a.tau.data(), a.tau.size(), out); }},
           {"mass_matrix",
            [&a](const peers::State& s) {
              a.position(s);
              mj_comPos(a.model, a.data);
              mj_crb(a.model, a.data);
              mj_fullM(a.model, a.M.data(), a.data->qM);
            },
            [&a](std::vector<double>& out) { add(a.M.data(), a.M.size(), out); }},
           {"forward_dynamics",
            [&a](const peers::State& s) {
              a.force(s);
              mj_forward(a.model, a.data);
            },
            [&a](std::vector<double>& out) { add(a.data->qacc, kN, out); }},
           {"step",
            [&a](const peers::State& s) {
              a.force(s);
              mj_step(a.model, a.data);
            },
            [&a](std::vector<double>& out) {
              add(a.data->qpos, kN, out);
              add(a.data->qvel, kN, out);
            }}}};
}

}  // namespace

int main(int argc, char** argv) {
  return peers::peer_main(argc, argv, load);
}
