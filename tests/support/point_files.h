// Point files written without the program's own writers: text, CSV, LAS, PCD and PLY of rounded coordinates.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace edgescan::test {

using Points = std::vector<Eigen::Vector3d>;

/// An additional column of integers, one per point.
struct WholeColumn {
    std::string name;
    std::vector<std::uint32_t> values;
};

template <class T>
void appendValue(std::string& bytes, T value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof value);
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

inline std::string pointText(const Points& points, int decimals, char separator = ' ', const std::string& header = "",
                             const std::vector<WholeColumn>& columns = {}) {
    std::string text = header;
    std::array<char, 400> number{};
    for (std::size_t n = 0; n < points.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) {
            if (axis > 0) text += separator;
            text.append(number.data(),
                        static_cast<std::size_t>(std::snprintf(number.data(), number.size(), "%.*f", decimals, points[n][axis])));
        }
        for (const WholeColumn& column : columns) (text += separator) += std::to_string(column.values[n]);
        text += '\n';
    }
    return text;
}

/// LAS 1.2, point format 0, `scale` metres.
inline std::string pointLas(const Points& points, double scale) {
    std::string bytes(227, '\0');
    const auto put = [&](std::size_t at, auto value) { std::memcpy(bytes.data() + at, &value, sizeof value); };
    std::memcpy(bytes.data(), "LASF", 4);
    bytes[24] = 1;
    bytes[25] = 2;
    put(94, std::uint16_t{227});
    put(96, std::uint32_t{227});
    put(105, std::uint16_t{20});
    put(107, static_cast<std::uint32_t>(points.size()));
    Eigen::Vector3d least = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d most = -least;
    for (const Eigen::Vector3d& p : points) {
        least = least.cwiseMin(p);
        most = most.cwiseMax(p);
    }
    const Eigen::Vector3d offset = least.array().floor();
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        put(131 + 8 * a, scale);
        put(155 + 8 * a, offset[axis]);
        put(179 + 16 * a, most[axis]);
        put(187 + 16 * a, least[axis]);
    }
    for (const Eigen::Vector3d& p : points) {
        for (int axis = 0; axis < 3; ++axis) appendValue(bytes, static_cast<std::int32_t>(std::llround((p[axis] - offset[axis]) / scale)));
        bytes.append(8, '\0');
    }
    return bytes;
}

/// Binary PCD of 4-byte floats.
inline std::string pointPcd(const Points& points, const std::vector<WholeColumn>& columns = {}) {
    std::string names, sizes, types, counts;
    for (const WholeColumn& column : columns) {
        names += " " + column.name;
        sizes += " 4";
        types += " U";
        counts += " 1";
    }
    std::string bytes = "VERSION .7\nFIELDS x y z" + names + "\nSIZE 4 4 4" + sizes + "\nTYPE F F F" + types + "\nCOUNT 1 1 1" + counts +
                        "\nWIDTH " + std::to_string(points.size()) + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
                        std::to_string(points.size()) + "\nDATA binary\n";
    for (std::size_t n = 0; n < points.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) appendValue(bytes, static_cast<float>(points[n][axis]));
        for (const WholeColumn& column : columns) appendValue(bytes, column.values[n]);
    }
    return bytes;
}

/// Binary PLY of 8-byte floats.
inline std::string pointPly(const Points& points, const std::vector<WholeColumn>& columns = {}) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points.size()) +
                        "\nproperty double x\nproperty double y\nproperty double z\n";
    for (const WholeColumn& column : columns) bytes += "property uint " + column.name + "\n";
    bytes += "end_header\n";
    for (std::size_t n = 0; n < points.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) appendValue(bytes, points[n][axis]);
        for (const WholeColumn& column : columns) appendValue(bytes, column.values[n]);
    }
    return bytes;
}

} // namespace edgescan::test
