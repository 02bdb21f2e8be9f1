// Smoothing, gradient and non-maximum suppression row by row.
#include "core/live/live_rows.h"

#include "core/gray/smooth.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace edgescan {
namespace {

using Floats = std::vector<float>;

/// Mirrors an index at the border without repeating the border cell.
int mirrored(int i, int count) {
    if (count == 1) return 0;
    while (i < 0 || i >= count) i = i < 0 ? -i : 2 * count - 2 - i;
    return i;
}

/// acc[j] += weight * values[j].
void add(float* __restrict acc, const float* __restrict values, float weight, int count) {
    for (int j = 0; j < count; ++j) acc[j] += weight * values[j];
}

/// Cells that take part with their value, the others as 0, with `reach` cells of border on either side.
template <class IndexOutside>
void padded(Floats& out, const std::uint8_t* cells, const std::uint8_t* masked, int beams, int reach, IndexOutside indexOutside) {
    out.resize(static_cast<std::size_t>(beams + 2 * reach));
    float* inner = out.data() + reach;
    if (masked != nullptr) {
        for (int j = 0; j < beams; ++j) inner[j] = static_cast<float>(static_cast<int>(cells[j]) & (masked[j] - 1) & ~masked[j]);
    } else {
        for (int j = 0; j < beams; ++j) inner[j] = cells[j];
    }
    for (int j = 1; j <= reach; ++j) {
        inner[-j] = inner[indexOutside(-j, beams)];
        inner[beams - 1 + j] = inner[indexOutside(beams - 1 + j, beams)];
    }
}

/// 1 where a cell takes no part.
template <class IndexOutside>
void paddedMask(Floats& out, const std::uint8_t* masked, int beams, int reach, IndexOutside indexOutside) {
    out.resize(static_cast<std::size_t>(beams + 2 * reach));
    float* inner = out.data() + reach;
    for (int j = 0; j < beams; ++j) inner[j] = static_cast<float>(masked[j] & 1);
    for (int j = 1; j <= reach; ++j) {
        inner[-j] = inner[indexOutside(-j, beams)];
        inner[beams - 1 + j] = inner[indexOutside(beams - 1 + j, beams)];
    }
}

int replicated(int i, int count) { return std::clamp(i, 0, count - 1); }

/// Rows [lo, lines) filtered along the beams: the cells and the mask.
struct FilteredRows {
    FilteredRows(const Grid<std::uint8_t>& gray, const Grid<std::uint8_t>* masked, std::span<const int> weights, int lo)
        : lo_(lo), beams_(gray.beams), cells_(size(gray)), mask_(masked != nullptr ? size(gray) : 0) {
        const int reach = static_cast<int>(weights.size()) / 2;
        Floats row;
        for (int i = lo; i < gray.lines; ++i) {
            const std::uint8_t* hidden = masked != nullptr ? masked->line(i) : nullptr;
            padded(row, gray.line(i), hidden, beams_, reach, mirrored);
            for (std::size_t t = 0; t < weights.size(); ++t) add(cell(i), row.data() + t, static_cast<float>(weights[t]), beams_);
            if (hidden == nullptr) continue;
            paddedMask(row, hidden, beams_, reach, mirrored);
            for (std::size_t t = 0; t < weights.size(); ++t) add(mask(i), row.data() + t, static_cast<float>(weights[t]), beams_);
        }
    }
    [[nodiscard]] float* cell(int row) { return cells_.data() + offset(row); }
    [[nodiscard]] float* mask(int row) { return mask_.data() + offset(row); }

private:
    [[nodiscard]] std::size_t size(const Grid<std::uint8_t>& gray) const {
        return static_cast<std::size_t>(gray.lines - lo_) * static_cast<std::size_t>(gray.beams);
    }
    [[nodiscard]] std::size_t offset(int row) const { return static_cast<std::size_t>(row - lo_) * static_cast<std::size_t>(beams_); }

    int lo_, beams_;
    Floats cells_, mask_;
};

/// Both Sobel kernels as factors: across the edge and along it.
struct SobelRows {
    std::vector<int> derivative, smoothing;
};

SobelRows sobelRows(int aperture) {
    // Pascal's triangle, as cv::getDerivKernels: smoothing (1 1)^n, derivative (1 1)^(n-2) * (-1 0 1).
    const auto widened = [](const std::vector<int>& row, int difference) {
        std::vector<int> next(row.size() + 1, 0);
        for (std::size_t i = 0; i < row.size(); ++i) {
            next[i] += difference * row[i];
            next[i + 1] += row[i];
        }
        return next;
    };
    std::vector<int> smoothing{1};
    for (int i = 1; i < aperture; ++i) smoothing = widened(smoothing, 1);
    std::vector<int> derivative{1};
    for (int i = 2; i < aperture; ++i) derivative = widened(derivative, 1);
    return {widened(derivative, -1), smoothing};
}

/// Both derivatives of a row's cells, or of its mask.
struct SobelSums {
    SobelSums(int aperture, int beams)
        : dx(static_cast<std::size_t>(beams)), dy(dx), sobel_(sobelRows(aperture)), along_(dx.size() + 2 * (sobel_.smoothing.size() / 2)),
          across_(along_) {}

    /// `rows`: padded, the border above and below is that of the image.
    void take(const std::vector<Floats>& rows, int row) {
        for (Floats* each : {&dx, &dy, &along_, &across_}) std::fill(each->begin(), each->end(), 0.0F);
        const auto taps = static_cast<int>(sobel_.smoothing.size());
        const auto wide = static_cast<int>(along_.size());
        for (int t = 0; t < taps; ++t) {
            const Floats& values = rows[static_cast<std::size_t>(replicated(row + t - taps / 2, static_cast<int>(rows.size())))];
            add(along_.data(), values.data(), smoothing(t), wide);
            add(across_.data(), values.data(), derivative(t), wide);
        }
        const auto beams = static_cast<int>(dx.size());
        for (int t = 0; t < taps; ++t) {
            add(dx.data(), along_.data() + t, derivative(t), beams);
            add(dy.data(), across_.data() + t, smoothing(t), beams);
        }
    }

    Floats dx, dy; ///< d / d beam, d / d line

private:
    [[nodiscard]] float smoothing(int tap) const { return static_cast<float>(sobel_.smoothing[static_cast<std::size_t>(tap)]); }
    [[nodiscard]] float derivative(int tap) const { return static_cast<float>(sobel_.derivative[static_cast<std::size_t>(tap)]); }

    SobelRows sobel_;
    Floats along_, across_;
};

/// Magnitudes that are beyond the thresholds are greater than these (cv::Canny).
struct CannyLimits {
    int low = 0, high = 0;
};

CannyLimits cannyLimits(const Settings& settings) {
    const auto limit = [&](double threshold) {
        if (settings.aperture == 7) threshold /= 16.0;
        if (settings.norm == Norm::L2) {
            threshold = std::min(32767.0, threshold);
            threshold *= threshold;
        }
        return static_cast<int>(std::floor(std::min(threshold, 2147483647.0)));
    };
    return {limit(std::min(settings.lower, settings.upper())), limit(std::max(settings.lower, settings.upper()))};
}

/// Half to even, as cv::saturate_cast does; for |x| < 2^22.
float rounded(float x) {
    constexpr float kMagic = 12582912.0F; // 1.5 x 2^23
    return (x + kMagic) - kMagic;
}

} // namespace

void smoothRows(Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>& gray, const Grid<std::uint8_t>* masked, const Settings& settings,
                int first) {
    smoothed.lines = gray.lines;
    smoothed.cells.resize(gray.size());
    if (settings.kernel <= 1) {
        const auto from = static_cast<std::ptrdiff_t>(gray.index(first, 0));
        std::copy(gray.cells.begin() + from, gray.cells.end(), smoothed.cells.begin() + from);
        return;
    }
    const std::vector<int> weights = gaussianWeights(settings.kernel, settings.sigma);
    const int reach = settings.kernel / 2;
    const int beams = gray.beams;
    FilteredRows rows(gray, masked, weights, std::max(0, first - reach));
    Floats sum(static_cast<std::size_t>(beams));
    Floats hidden(static_cast<std::size_t>(beams));
    for (int i = first; i < gray.lines; ++i) {
        std::fill(sum.begin(), sum.end(), 32768.0F); // half of what the weights multiply to: rounds
        std::fill(hidden.begin(), hidden.end(), 0.0F);
        for (int t = -reach; t <= reach; ++t) {
            const int row = mirrored(i + t, gray.lines);
            const auto weight = static_cast<float>(weights[static_cast<std::size_t>(t + reach)]);
            add(sum.data(), rows.cell(row), weight, beams);
            if (masked != nullptr) add(hidden.data(), rows.mask(row), weight, beams);
        }
        const std::uint8_t* centre = gray.line(i);
        std::uint8_t* out = smoothed.line(i);
        for (int j = 0; j < beams; ++j) {
            const float level = (sum[static_cast<std::size_t>(j)] + static_cast<float>(centre[j]) * hidden[static_cast<std::size_t>(j)]) *
                                (1.0F / 65536.0F);
            out[j] = static_cast<std::uint8_t>(static_cast<int>(level));
        }
        if (masked == nullptr) continue;
        const std::uint8_t* gone = masked->line(i);
        for (int j = 0; j < beams; ++j) out[j] = static_cast<std::uint8_t>(out[j] & ~gone[j]);
    }
}

void GradientRows::update(const Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>* masked, const Settings& settings, int first,
                          int kept) {
    // Rows that are not needed any more go, the changed ones come anew.
    const int drop = std::clamp(kept - firstRow_, 0, static_cast<int>(rows_.size()));
    rows_.erase(rows_.begin(), rows_.begin() + drop);
    firstRow_ += drop;
    if (rows_.empty()) firstRow_ = first;
    rows_.resize(static_cast<std::size_t>(smoothed.lines - firstRow_));
    beyond_.assign(static_cast<std::size_t>(beams_) + 2, 0);

    const int reach = settings.aperture / 2;
    const int lo = std::max(0, first - reach); // the first row that is read
    std::vector<Floats> cells(static_cast<std::size_t>(smoothed.lines - lo)), masks(masked != nullptr ? cells.size() : 0);
    for (int i = lo; i < smoothed.lines; ++i) {
        const std::uint8_t* hidden = masked != nullptr ? masked->line(i) : nullptr;
        padded(cells[static_cast<std::size_t>(i - lo)], smoothed.line(i), hidden, beams_, reach, replicated);
        if (hidden != nullptr) paddedMask(masks[static_cast<std::size_t>(i - lo)], hidden, beams_, reach, replicated);
    }
    SobelSums ofCells(settings.aperture, beams_), ofMasks(settings.aperture, beams_);
    for (int i = first; i < smoothed.lines; ++i) {
        ofCells.take(cells, i - lo);
        if (masked != nullptr) ofMasks.take(masks, i - lo);
        // Where the mask has gradient, the cells under it count as the centre.
        const float scale = settings.aperture == 7 ? 1.0F / 16.0F : 1.0F; // as cv::Canny, to keep the gradient within 16 bits
        const std::uint8_t* centre = smoothed.line(i);
        const std::uint8_t* gone = masked != nullptr ? masked->line(i) : nullptr;
        for (std::size_t j = 0; j < ofCells.dx.size(); ++j) {
            const auto level = static_cast<float>(centre[j]);
            const float takesPart = gone != nullptr ? static_cast<float>(1 - (gone[j] & 1)) : 1.0F;
            ofCells.dx[j] = rounded((ofCells.dx[j] + level * ofMasks.dx[j]) * scale) * takesPart;
            ofCells.dy[j] = rounded((ofCells.dy[j] + level * ofMasks.dy[j]) * scale) * takesPart;
        }
        rows_[static_cast<std::size_t>(i - firstRow_)].take(ofCells.dx, ofCells.dy, settings.norm);
    }
}

void GradientRows::Row::take(const std::vector<float>& dx, const std::vector<float>& dy, Norm norm) {
    alongBeams.resize(dx.size());
    alongLines.resize(dx.size());
    magnitude.assign(dx.size() + 2, 0);
    for (std::size_t j = 0; j < dx.size(); ++j) {
        const int x = static_cast<int>(dx[j]);
        const int y = static_cast<int>(dy[j]);
        alongBeams[j] = static_cast<std::int16_t>(x);
        alongLines[j] = static_cast<std::int16_t>(y);
        magnitude[j + 1] = norm == Norm::L2 ? x * x + y * y : std::abs(x) + std::abs(y);
    }
}

const std::vector<std::int32_t>& GradientRows::magnitudeOf(int row) const {
    const int place = row - firstRow_;
    return place < 0 || place >= static_cast<int>(rows_.size()) ? beyond_ : rows_[static_cast<std::size_t>(place)].magnitude;
}

/// As cv::Canny: the direction by the tangents of 22.5 and 67.5 degrees in fixed point, ties to the first of two.
Grid<EdgeClass> GradientRows::classes(const Settings& settings, int first) const {
    const CannyLimits limits = cannyLimits(settings);
    const int end = firstRow_ + static_cast<int>(rows_.size());
    Grid<EdgeClass> classes(end - first, beams_, EdgeClass::None);
    constexpr int kShift = 15;
    constexpr int kTangent = 13573; // of 22.5 degrees x 2^15
    for (int i = first; i < end; ++i) {
        const Row& row = rows_[static_cast<std::size_t>(i - firstRow_)];
        const std::int32_t* here = row.magnitude.data() + 1;
        const std::int32_t* above = magnitudeOf(i - 1).data() + 1;
        const std::int32_t* below = magnitudeOf(i + 1).data() + 1;
        EdgeClass* out = classes.line(i - first);
        for (int j = 0; j < beams_; ++j) {
            const int m = here[j];
            if (m <= limits.low) continue;
            const int dx = row.alongBeams[static_cast<std::size_t>(j)];
            const int dy = row.alongLines[static_cast<std::size_t>(j)];
            const int x = std::abs(dx);
            const int y = std::abs(dy) << kShift;
            const int lower = x * kTangent;
            bool greatest = false;
            if (y < lower) {
                greatest = m > here[j - 1] && m >= here[j + 1];
            } else if (y > lower + (x << (kShift + 1))) {
                greatest = m > above[j] && m >= below[j];
            } else {
                const int s = (dx ^ dy) < 0 ? -1 : 1;
                greatest = m > above[j - s] && m > below[j + s];
            }
            if (greatest) out[j] = m > limits.high ? EdgeClass::Strong : EdgeClass::Weak;
        }
    }
    return classes;
}

} // namespace edgescan
