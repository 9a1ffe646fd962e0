#include "sim/logs/builtin_definitions.hpp"

#include <algorithm>
#include <array>

namespace armtune::internal {
namespace {

struct BuiltinType {
  std::string_view name;
  std::span<const std::string_view> definitions;
};

template <std::size_t kCount>
using Texts = std::array<std::string_view, kCount>;

constexpr Texts<1> kSeconds = {"int32 sec\nuint32 nanosec\n"};
constexpr Texts<1> kHeader = {"builtin_interfaces/Time stamp\nstring frame_id\n"};
constexpr Texts<1> kBoolData = {"bool data\n"};
constexpr Texts<1> kInt32Data = {"int32 data\n"};
constexpr Texts<1> kFloat32Data = {"float32 data\n"};
constexpr Texts<1> kFloat64Data = {"float64 data\n"};
constexpr Texts<1> kStringData = {"string data\n"};
constexpr Texts<1> kFloat32Array = {"MultiArrayLayout layout\nfloat32[] data\n"};
constexpr Texts<1> kFloat64Array = {"MultiArrayLayout layout\nfloat64[] data\n"};
constexpr Texts<1> kArrayLayout = {"MultiArrayDimension[] dim\nuint32 data_offset\n"};
constexpr Texts<1> kArrayDimension = {"string label\nuint32 size\nuint32 stride\n"};

constexpr Texts<1> kXyz = {"float64 x\nfloat64 y\nfloat64 z\n"};
constexpr Texts<1> kXyzw = {"float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"};
constexpr Texts<1> kPose = {"Point position\nQuaternion orientation\n"};
constexpr Texts<1> kTransform = {"Vector3 translation\nQuaternion rotation\n"};
constexpr Texts<1> kLinearAngular = {"Vector3 linear\nVector3 angular\n"};
constexpr Texts<1> kWrench = {"Vector3 force\nVector3 torque\n"};
constexpr Texts<1> kPointStamped = {"std_msgs/Header header\nPoint point\n"};
constexpr Texts<1> kVector3Stamped = {"std_msgs/Header header\nVector3 vector\n"};
constexpr Texts<1> kPoseStamped = {"std_msgs/Header header\nPose pose\n"};
constexpr Texts<1> kTransformStamped = {
    "std_msgs/Header header\nstring child_frame_id\nTransform transform\n"};
constexpr Texts<1> kTwistStamped = {"std_msgs/Header header\nTwist twist\n"};
constexpr Texts<1> kAccelStamped = {"std_msgs/Header header\nAccel accel\n"};
constexpr Texts<1> kWrenchStamped = {"std_msgs/Header header\nWrench wrench\n"};
constexpr Texts<1> kTfMessage = {"geometry_msgs/TransformStamped[] transforms\n"};
constexpr Texts<1> kClock = {"builtin_interfaces/Time clock\n"};

constexpr Texts<1> kJointState = {
    "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n"};
constexpr Texts<1> kImu = {
    "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
    "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
    "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n"};
constexpr Texts<1> kTrajectory = {
    "std_msgs/Header header\nstring[] joint_names\nJointTrajectoryPoint[] points\n"};
constexpr Texts<1> kTrajectoryPoint = {
    "float64[] positions\nfloat64[] velocities\nfloat64[] accelerations\nfloat64[] effort\n"
    "builtin_interfaces/Duration time_from_start\n"};
constexpr Texts<1> kMultiDofPoint = {
    "geometry_msgs/Transform[] transforms\ngeometry_msgs/Twist[] velocities\n"
    "geometry_msgs/Twist[] accelerations\nbuiltin_interfaces/Duration time_from_start\n"};
constexpr Texts<1> kDynamicJointState = {
    "std_msgs/Header header\nstring[] joint_names\nInterfaceValue[] interface_values\n"};
constexpr Texts<1> kInterfaceValue = {"string[] interface_names\nfloat64[] values\n"};

// The layouts of control_msgs 5.3, 5.0, 4 (Humble), 3 (Galactic) and 2 (Foxy).
constexpr Texts<5> kControllerState = {
    R"(std_msgs/Header header
string[] joint_names
trajectory_msgs/JointTrajectoryPoint reference
trajectory_msgs/JointTrajectoryPoint feedback
trajectory_msgs/JointTrajectoryPoint error
trajectory_msgs/JointTrajectoryPoint output
string[] multi_dof_joint_names
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_reference
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_feedback
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_error
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_output
float64 speed_scaling_factor
)",
    R"(std_msgs/Header header
string[] joint_names
trajectory_msgs/JointTrajectoryPoint reference
trajectory_msgs/JointTrajectoryPoint feedback
trajectory_msgs/JointTrajectoryPoint error
trajectory_msgs/JointTrajectoryPoint output
string[] multi_dof_joint_names
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_reference
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_feedback
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_error
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_output
)",
    R"(std_msgs/Header header
string[] joint_names
trajectory_msgs/JointTrajectoryPoint reference
trajectory_msgs/JointTrajectoryPoint feedback
trajectory_msgs/JointTrajectoryPoint error
trajectory_msgs/JointTrajectoryPoint output
trajectory_msgs/JointTrajectoryPoint desired
trajectory_msgs/JointTrajectoryPoint actual
string[] multi_dof_joint_names
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_reference
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_feedback
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_error
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_output
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_desired
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_actual
)",
    R"(std_msgs/Header header
string[] joint_names
trajectory_msgs/JointTrajectoryPoint desired
trajectory_msgs/JointTrajectoryPoint actual
trajectory_msgs/JointTrajectoryPoint error
string[] multi_dof_joint_names
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_desired
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_actual
trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_error
)",
    R"(std_msgs/Header header
string[] joint_names
trajectory_msgs/JointTrajectoryPoint desired
trajectory_msgs/JointTrajectoryPoint actual
trajectory_msgs/JointTrajectoryPoint error
)"};

constexpr std::array<BuiltinType, 37> kTypes = {{
    {"builtin_interfaces/Duration", kSeconds},
    {"builtin_interfaces/Time", kSeconds},
    {"control_msgs/DynamicJointState", kDynamicJointState},
    {"control_msgs/InterfaceValue", kInterfaceValue},
    {"control_msgs/JointTrajectoryControllerState", kControllerState},
    {"geometry_msgs/Accel", kLinearAngular},
    {"geometry_msgs/AccelStamped", kAccelStamped},
    {"geometry_msgs/Point", kXyz},
    {"geometry_msgs/PointStamped", kPointStamped},
    {"geometry_msgs/Pose", kPose},
    {"geometry_msgs/PoseStamped", kPoseStamped},
    {"geometry_msgs/Quaternion", kXyzw},
    {"geometry_msgs/Transform", kTransform},
    {"geometry_msgs/TransformStamped", kTransformStamped},
    {"geometry_msgs/Twist", kLinearAngular},
    {"geometry_msgs/TwistStamped", kTwistStamped},
    {"geometry_msgs/Vector3", kXyz},
    {"geometry_msgs/Vector3Stamped", kVector3Stamped},
    {"geometry_msgs/Wrench", kWrench},
    {"geometry_msgs/WrenchStamped", kWrenchStamped},
    {"rosgraph_msgs/Clock", kClock},
    {"sensor_msgs/Imu", kImu},
    {"sensor_msgs/JointState", kJointState},
    {"std_msgs/Bool", kBoolData},
    {"std_msgs/Float32", kFloat32Data},
    {"std_msgs/Float32MultiArray", kFloat32Array},
    {"std_msgs/Float64", kFloat64Data},
    {"std_msgs/Float64MultiArray", kFloat64Array},
    {"std_msgs/Header", kHeader},
    {"std_msgs/Int32", kInt32Data},
    {"std_msgs/MultiArrayDimension", kArrayDimension},
    {"std_msgs/MultiArrayLayout", kArrayLayout},
    {"std_msgs/String", kStringData},
    {"tf2_msgs/TFMessage", kTfMessage},
    {"trajectory_msgs/JointTrajectory", kTrajectory},
    {"trajectory_msgs/JointTrajectoryPoint", kTrajectoryPoint},
    {"trajectory_msgs/MultiDOFJointTrajectoryPoint", kMultiDofPoint},
}};

}  // namespace

std::span<const std::string_view> builtin_definitions(std::string_view type) {
  const auto known =
      std::find_if(kTypes.begin(), kTypes.end(), [type](const BuiltinType& one) { return one.name == type; });
  return known == kTypes.end() ? std::span<const std::string_view>() : known->definitions;
}

}  // namespace armtune::internal
