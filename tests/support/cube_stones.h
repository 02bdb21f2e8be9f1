// Stones that are cubes, in files like those of scanned stones, for tests.
#pragma once

#include "tests/support/packed_files.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace edgescan::test {

inline std::string arrayOfThree(const std::vector<double>& values, const std::string& type) {
    const std::string shape = "(" + std::to_string(values.size() / 3) + ", 3)";
    return npyBytes(npyHeader("'" + type + "'", false, shape), npyData(values, type));
}

/// Corners of a cube of side 1 around the origin, x y z.
inline std::vector<double> cubeCorners() {
    std::vector<double> corners;
    for (int n = 0; n < 8; ++n) {
        for (int axis = 0; axis < 3; ++axis) corners.push_back((n >> axis & 1) != 0 ? 0.5 : -0.5);
    }
    return corners;
}

/// Its triangles: numbers of corners.
inline std::vector<double> cubeTriangles() {
    return {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
}

/// "cube" is of the set free, "epflcube" of the set lab.
inline void writeCubeStones(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "rocks.json") << R"([{"name": "cube", "edge": 0.01}, {"name": "epflcube", "edge": 0.01}])";
    const std::string corners = arrayOfThree(cubeCorners(), "<f4");
    for (const char* name : {"cube.npz", "epflcube.npz"})
        std::ofstream(folder / name, std::ios::binary)
            << zipBytes({{"V.npy", corners}, {"F.npy", arrayOfThree(cubeTriangles(), "<i4")}, {"hull.npy", corners}}, true);
}

/// A settled heap of two cubes on the floor of the bench.
inline void writeCubeHeap(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const auto stone = [](const char* place) {
        return std::string(R"({"stone": "cube", "size_m": 0.6, "place_m": )") + place +
               R"(, "turn_xyzw": [0, 0, 0.38268343236508977, 0.92387953251128674], "speed_mps": 0.0})";
    };
    std::ofstream(folder / "bench-free-1.json")
        << R"({"format": "edgescan-settled-stones/1", "stones": [)" + stone("[0.0, -1.2, -2.1]") + ", " + stone("[1.1, -1.0, -2.1]") + "]}";
}

} // namespace edgescan::test
