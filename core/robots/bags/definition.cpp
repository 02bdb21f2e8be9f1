// Parses the text of message definitions.
#include "core/robots/bags/definition.h"
#include "core/base/translated_text.h"

#include "core/robots/bags/bag.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
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

constexpr std::size_t kMostText = 1 << 20;
constexpr std::size_t kMostTypes = 1000;
constexpr std::size_t kDeepest = 32;

constexpr std::array<std::pair<std::string_view, RosScalar>, 17> kScalars{{{"bool", RosScalar::Bool},
                                                                           {"int8", RosScalar::Int8},
                                                                           {"uint8", RosScalar::Uint8},
                                                                           {"byte", RosScalar::Uint8},
                                                                           {"char", RosScalar::Uint8},
                                                                           {"int16", RosScalar::Int16},
                                                                           {"uint16", RosScalar::Uint16},
                                                                           {"int32", RosScalar::Int32},
                                                                           {"uint32", RosScalar::Uint32},
                                                                           {"int64", RosScalar::Int64},
                                                                           {"uint64", RosScalar::Uint64},
                                                                           {"float32", RosScalar::Float32},
                                                                           {"float64", RosScalar::Float64},
                                                                           {"string", RosScalar::String},
                                                                           {"wstring", RosScalar::String},
                                                                           {"time", RosScalar::Time},
                                                                           {"duration", RosScalar::Time}}};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t from = text.find_first_not_of(kBlank);
    return from == std::string_view::npos ? std::string_view{} : text.substr(from, text.find_last_not_of(kBlank) - from + 1);
}

std::string_view lineOff(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// The name of another type as a field of a type of `package` names it.
std::string fullName(std::string_view name, std::string_view package) {
    if (name == "Header") return "std_msgs/Header";
    if (name.find('/') != std::string_view::npos) return rosTypeName(name);
    return std::string(package) + '/' + std::string(name);
}

class Parser {
public:
    Parser(std::string name, const std::string& where) : where_(where) { names_.push_back(std::move(name)); }

    Result<RosDefinition> parse(std::string_view text) {
        if (text.size() > kMostText) return refused("it is longer than a megabyte");
        definition_.types.push_back({names_.front(), {}});
        index_[names_.front()] = 0;
        given_.push_back(true);
        std::size_t type = 0;
        while (!text.empty()) {
            std::string_view line = lineOff(text);
            if (isRule(line)) {
                line = lineOff(text);
                if (!line.starts_with("MSG:")) return refused("a line of \"=\" is not followed by \"MSG:\"");
                type = typeNamed(rosTypeName(trimmed(line.substr(4))));
                given_[type] = true;
                definition_.types[type].fields.clear();
                continue;
            }
            if (definition_.types.size() > kMostTypes) return refused("it names more than 1000 types");
            if (auto taken = field(type, line); !taken) return taken.error();
        }
        for (std::size_t n = 0; n < given_.size(); ++n) {
            if (!given_[n]) return refused(withValues("the type %1 is not defined", {definition_.types[n].name}));
        }
        if (!endsEverywhere()) return refused("a type contains itself, or types are nested more than 32 deep");
        return std::move(definition_);
    }

private:
    [[nodiscard]] Error refused(const std::string& why) const {
        return {withValues("the definition of the message type %1 cannot be read: %2", {names_.front(), why}), where_,
                "record the bag again, or convert it with the program that wrote it"};
    }

    static bool isRule(std::string_view line) {
        return line.size() >= 3 && std::ranges::all_of(line, [](char c) { return c == '='; });
    }

    std::size_t typeNamed(const std::string& name) {
        const auto [place, isNew] = index_.try_emplace(name, definition_.types.size());
        if (isNew) {
            definition_.types.push_back({name, {}});
            given_.push_back(isStamp(name));
            if (isStamp(name)) definition_.types.back().fields = stampFields(name);
        }
        return place->second;
    }

    // ROS 2 leaves these out of some bags, because each program knows them.
    static bool isStamp(const std::string& name) { return name == "builtin_interfaces/Time" || name == "builtin_interfaces/Duration"; }
    static std::vector<RosField> stampFields(const std::string&) {
        return {{"sec", RosScalar::Int32, 0, RosLength::One, 1}, {"nanosec", RosScalar::Uint32, 0, RosLength::One, 1}};
    }

    /// "float32[] ranges", "string<=20 name \"default\"", "uint8 MAXIMUM=3" (a constant: no field), or a comment.
    Result<Done> field(std::size_t type, std::string_view line) {
        line = trimmed(line.substr(0, commentIn(line)));
        if (line.empty()) return Done{};
        const std::size_t gap = line.find_first_of(" \t");
        if (gap == std::string_view::npos)
            return refused(withValues("a line has a type and no name: \"%1\"", {std::string(line.substr(0, 40))}));
        std::string_view kind = line.substr(0, gap);
        const std::string_view rest = trimmed(line.substr(gap));
        const std::string_view name = rest.substr(0, rest.find_first_of(" \t=\"'"));
        if (name.empty()) return refused(withValues("a field has no name: \"%1\"", {std::string(line.substr(0, 40))}));
        if (trimmed(rest.substr(name.size())).starts_with('=')) return Done{};
        RosField field;
        field.name = name;
        if (const std::size_t bracket = kind.find('['); bracket != std::string_view::npos) {
            const std::string_view inside = kind.substr(bracket + 1, kind.find(']', bracket) - bracket - 1);
            field.length = inside.empty() || inside.starts_with('<') ? RosLength::Counted : RosLength::Fixed;
            if (field.length == RosLength::Fixed) {
                const auto [end, problem] = std::from_chars(inside.data(), inside.data() + inside.size(), field.count);
                if (problem != std::errc{} || end != inside.data() + inside.size())
                    return refused(withValues("the length of \"%1\" is not a number", {field.name}));
            }
            kind = kind.substr(0, bracket);
        }
        kind = kind.substr(0, kind.find("<="));
        const auto scalar = std::ranges::find(kScalars, kind, &std::pair<std::string_view, RosScalar>::first);
        if (scalar != kScalars.end()) {
            field.scalar = scalar->second;
        } else {
            const std::string owner = definition_.types[type].name;
            field.type = typeNamed(fullName(kind, std::string_view(owner).substr(0, owner.find('/'))));
        }
        definition_.types[type].fields.push_back(std::move(field));
        return Done{};
    }

    /// Where a comment begins: "#" outside of quotation marks.
    static std::size_t commentIn(std::string_view line) {
        char quote = 0;
        for (std::size_t n = 0; n < line.size(); ++n) {
            if (quote != 0)
                quote = line[n] == quote ? '\0' : quote;
            else if (line[n] == '"' || line[n] == '\'')
                quote = line[n];
            else if (line[n] == '#')
                return n;
        }
        const std::size_t plain = line.find('#');
        return quote != 0 ? plain : std::string_view::npos; // a constant's text may hold one mark
    }

    /// Whether no type contains itself: each type's depth is one more than the deepest of its fields.
    [[nodiscard]] bool endsEverywhere() const {
        std::vector<std::size_t> depth(definition_.types.size(), 0);
        for (std::size_t round = 0; round <= kDeepest; ++round) {
            bool changed = false;
            for (std::size_t n = 0; n < depth.size(); ++n) {
                for (const RosField& field : definition_.types[n].fields) {
                    if (field.scalar != RosScalar::Message || depth[n] > depth[field.type]) continue;
                    depth[n] = depth[field.type] + 1;
                    changed = true;
                }
            }
            if (!changed) return true;
        }
        return false;
    }

    const std::string& where_;
    std::vector<std::string> names_;
    RosDefinition definition_;
    std::vector<bool> given_; // by type: its lines were there
    std::map<std::string, std::size_t> index_;
};

} // namespace

// Definitions of common message types for bags that hold none: rosbag2 wrote them into databases only from 2023 on. Field by field as the
// ROS 2 release of 2022 serializes them (docs.ros.org, common_interfaces).

std::string_view commonRosDefinition(std::string_view type) {
    for (const auto& [name, text] : kCommon) {
        if (name == type) return text;
    }
    return {};
}

std::size_t bytesOf(RosScalar scalar) {
    constexpr std::array<std::size_t, 14> kBytes{1, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 0, 8, 0};
    return kBytes[static_cast<std::size_t>(scalar)];
}

std::string rosTypeName(std::string_view name) {
    std::string plain(name);
    if (const std::size_t at = plain.find("/msg/"); at != std::string::npos) plain.erase(at, 4);
    return plain;
}

Result<RosDefinition> rosDefinition(const std::string& typeName, std::string_view text, const std::string& where) {
    return Parser(rosTypeName(typeName), where).parse(text);
}

} // namespace edgescan::robots
