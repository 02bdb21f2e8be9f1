// Missing cells.
#include "core/edges/holes.h"

#include "core/edges/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <cmath>

namespace edgescan {
namespace {

constexpr int kNeighboursWanted = 2;
constexpr float kAgreeShare = 0.08F;
constexpr float kAgreeMm = 60.0F;

bool standsAlone(const Scan& scan, int line, int beam) {
    const float range = scan.rangeMm.at(line, beam);
    const float allowed = kAgreeShare * range + kAgreeMm;
    int agreeing = 0;
    for (int i = line - 1; i <= line + 1; ++i) {
        for (int j = beam - 1; j <= beam + 1; ++j) {
            if ((i == line && j == beam) || !scan.rangeMm.contains(i, j) || scan.state.at(i, j) != CellState::Valid) continue;
            if (std::abs(scan.rangeMm.at(i, j) - range) <= allowed && ++agreeing >= kNeighboursWanted) return false;
        }
    }
    return true;
}

} // namespace

Grid<std::uint8_t> missingCells(const Scan& scan) {
    Grid<std::uint8_t> missing(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < scan.cells(); ++k) missing[k] = scan.state[k] == CellState::Valid ? 0 : 255;
    return missing;
}

Grid<std::uint8_t> isolatedCells(const Scan& scan) {
    Grid<std::uint8_t> isolated(scan.lines(), scan.beams());
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            if (scan.state.at(i, j) == CellState::Valid && standsAlone(scan, i, j)) isolated.at(i, j) = 255;
        }
    }
    return isolated;
}

Grid<std::uint8_t> maskedCells(const Scan& scan, const Settings& settings) {
    if (!settings.maskMissing) return {};
    Grid<std::uint8_t> masked = missingCells(scan);
    if (!settings.maskIsolated) return masked;
    const Grid<std::uint8_t> isolated = isolatedCells(scan);
    for (std::size_t k = 0; k < masked.size(); ++k) masked[k] |= isolated[k];
    return masked;
}

Grid<std::uint8_t> nearMissing(const Grid<std::uint8_t>& missing, int reach) {
    Grid<std::uint8_t> near(missing.lines, missing.beams);
    if (near.size() == 0) return near;
    const cv::Mat box = cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U);
    cv::Mat result = asMat(near);
    cv::dilate(asMat(missing), result, box, {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    return near;
}

} // namespace edgescan
