// Gaussian smoothing.
#include "core/edges/gray/smooth.h"

#include "core/scan/grid/missing_cells.h"
#include "core/scan/grid/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <cmath>

namespace edgescan::edges {
namespace {

constexpr int kOne = 256;                     // 1 as a fixed-point weight
constexpr int kHalfSquared = kOne * kOne / 2; // rounds the product of two weights

double openCvSigma(double sigma) { return std::isnan(sigma) ? 0.0 : sigma; }

// Mirrors an index at the border without repeating the border cell, as cv::BORDER_REFLECT_101.
int reflected(int i, int count) { return cv::borderInterpolate(i, count, cv::BORDER_REFLECT_101); }

std::uint8_t smoothedCell(const Grid<std::uint8_t>& gray, const Grid<std::uint8_t>& missing, const std::vector<int>& weights, int line,
                          int beam) {
    const int reach = static_cast<int>(weights.size()) / 2;
    const int centre = gray.at(line, beam);
    int sum = 0;
    for (int di = -reach; di <= reach; ++di) {
        const int i = reflected(line + di, gray.lines);
        int lineSum = 0;
        for (int dj = -reach; dj <= reach; ++dj) {
            const std::size_t k = gray.index(i, reflected(beam + dj, gray.beams));
            lineSum += weights[static_cast<std::size_t>(dj + reach)] * (missing[k] != 0 ? centre : gray[k]);
        }
        sum += weights[static_cast<std::size_t>(di + reach)] * lineSum;
    }
    return static_cast<std::uint8_t>((sum + kHalfSquared) / (kOne * kOne));
}

} // namespace

std::vector<int> gaussianWeights(int size, double sigma) {
    const cv::Mat exact = cv::getGaussianKernel(size, openCvSigma(sigma), CV_64F);
    // OpenCV rounds from the outside to the inside, carries the rounding error along, and gives the rest to the centre.
    std::vector<int> weights(static_cast<std::size_t>(size));
    double carried = 0.0;
    int sum = 0;
    for (int i = 0; i < size / 2; ++i) {
        const double wanted = exact.at<double>(i) * kOne + carried;
        const int weight = cvRound(wanted);
        carried = wanted - weight;
        weights[static_cast<std::size_t>(i)] = weights[static_cast<std::size_t>(size - 1 - i)] = weight;
        sum += 2 * weight;
    }
    weights[static_cast<std::size_t>(size / 2)] = kOne - sum;
    return weights;
}

Grid<std::uint8_t> smoothBy(InstructionSet set, const Grid<std::uint8_t>& gray, const Settings& settings) {
    if (settings.kernel <= 1 || gray.size() == 0) return gray;
    Grid<std::uint8_t> result(gray.lines, gray.beams);
    blurBy(set, gray, gaussianWeights(settings.kernel, settings.sigma), result);
    return result;
}

Grid<std::uint8_t> smooth(const Grid<std::uint8_t>& gray, const Settings& settings) {
    if (settings.kernel <= 1 || gray.size() == 0) return gray;
    const InstructionSet set = instructionSet();
    // From 7 cells on the sums need 32 bits; then OpenCV's own loops are faster on processors without AVX2.
    if (settings.kernel < 7 || set >= InstructionSet::Avx2) return smoothBy(set, gray, settings);
    Grid<std::uint8_t> result(gray.lines, gray.beams);
    cv::Mat output = asMat(result);
    cv::GaussianBlur(asMat(gray), output, {settings.kernel, settings.kernel}, openCvSigma(settings.sigma));
    return result;
}

Grid<std::uint8_t> smoothAroundHoles(const Grid<std::uint8_t>& gray, const Grid<std::uint8_t>& missing, const Settings& settings) {
    if (settings.kernel <= 1 || gray.size() == 0) return gray;
    Grid<std::uint8_t> result = smooth(gray, settings);
    const std::vector<int> weights = gaussianWeights(settings.kernel, settings.sigma);
    const Grid<std::uint8_t> near = nearMissing(missing, settings.kernel / 2);
    for (int i = 0; i < gray.lines; ++i) {
        for (int j = 0; j < gray.beams; ++j) {
            const std::size_t k = gray.index(i, j);
            if (missing[k] != 0)
                result[k] = 0;
            else if (near[k] != 0)
                result[k] = smoothedCell(gray, missing, weights, i, j);
        }
    }
    return result;
}

} // namespace edgescan::edges
