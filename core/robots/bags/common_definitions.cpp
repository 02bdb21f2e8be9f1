// Definitions of common message types for bags that hold none: rosbag2 wrote them into databases only from 2023 on. Field by field as the
// ROS 2 release of 2022 serializes them (docs.ros.org, common_interfaces).
#include "core/robots/bags/bag.h"

#include <array>
#include <utility>

namespace edgescan::robots {
namespace {

#define EDGESCAN_HEADER "===\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n"
#define EDGESCAN_VECTOR "===\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"
#define EDGESCAN_QUATERNION "===\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"
#define EDGESCAN_FAN                                                                                                                       \
    "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\n"   \
    "float32 range_min\nfloat32 range_max\n"

constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kCommon{
    {{"sensor_msgs/LaserScan", EDGESCAN_FAN "float32[] ranges\nfloat32[] intensities\n" EDGESCAN_HEADER},
     {"sensor_msgs/MultiEchoLaserScan",
      EDGESCAN_FAN "LaserEcho[] ranges\nLaserEcho[] intensities\n" EDGESCAN_HEADER "===\nMSG: sensor_msgs/LaserEcho\nfloat32[] echoes\n"},
     {"sensor_msgs/PointCloud2",
      "std_msgs/Header header\nuint32 height\nuint32 width\nPointField[] fields\nbool is_bigendian\nuint32 point_step\n"
      "uint32 row_step\nuint8[] data\nbool is_dense\n" EDGESCAN_HEADER
      "===\nMSG: sensor_msgs/PointField\nstring name\nuint32 offset\nuint8 datatype\nuint32 count\n"},
     {"sensor_msgs/JointState",
      "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n" EDGESCAN_HEADER},
     {"sensor_msgs/Imu",
      "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
      "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
      "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n" EDGESCAN_HEADER EDGESCAN_VECTOR
          EDGESCAN_QUATERNION},
     {"tf2_msgs/TFMessage",
      "geometry_msgs/TransformStamped[] transforms\n===\nMSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\n"
      "string child_frame_id\nTransform transform\n===\nMSG: geometry_msgs/Transform\nVector3 translation\n"
      "Quaternion rotation\n" EDGESCAN_HEADER EDGESCAN_VECTOR EDGESCAN_QUATERNION},
     {"geometry_msgs/PoseStamped",
      "std_msgs/Header header\nPose pose\n===\nMSG: geometry_msgs/Pose\nPoint position\nQuaternion orientation\n"
      "===\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n" EDGESCAN_HEADER EDGESCAN_QUATERNION}}};

} // namespace

std::string_view commonRosDefinition(std::string_view type) {
    for (const auto& [name, text] : kCommon) {
        if (name == type) return text;
    }
    return {};
}

} // namespace edgescan::robots
