// Calipers of points in a plane.
#pragma once

#include <vector>

namespace edgescan::rocks {

/// Points of a plane: point n is at (x[n], y[n]).
struct PlanePoints {
    std::vector<double> x, y;

    void add(double pointX, double pointY) {
        x.push_back(pointX);
        y.push_back(pointY);
    }
};

/// Largest and smallest distance of two parallel lines that enclose all the points; 0 without points.
struct Calipers {
    double longest = 0.0, shortest = 0.0;
};
[[nodiscard]] Calipers calipersOf(const PlanePoints& points);

} // namespace edgescan::rocks
