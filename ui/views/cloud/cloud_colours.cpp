// Colours by range, height, line and intensity.
#include "ui/views/cloud/cloud_colours.h"

#include "core/scan/georef/placed_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>

namespace edgescan::ui {
namespace {

constexpr std::array<std::array<double, 3>, 5> kScale{{{70, 110, 200}, {140, 90, 190}, {195, 75, 110}, {185, 95, 40}, {140, 118, 30}}};
constexpr std::size_t kSteps = 256;
constexpr double kLeftOut = 0.01; // of the points at each end
constexpr std::size_t kSampled = 20'000;
constexpr std::uint32_t kWithoutValue = 0xff797979U; // gray

constexpr std::array<std::pair<ColourBy, const char*>, 5> kKeys{{{ColourBy::Nothing, "gray"},
                                                                 {ColourBy::Range, "range"},
                                                                 {ColourBy::Height, "height"},
                                                                 {ColourBy::Line, "line"},
                                                                 {ColourBy::Intensity, "intensity"}}};

/// The range of the middle 98 % of the values, from an evenly spread sample.
std::pair<double, double> endsOf(const std::vector<float>& values) {
    const std::size_t step = std::max<std::size_t>(1, values.size() / kSampled);
    std::vector<float> sample;
    for (std::size_t k = 0; k < values.size(); k += step) {
        if (std::isfinite(values[k])) sample.push_back(values[k]);
    }
    if (sample.empty()) return {0.0, 1.0};
    std::ranges::sort(sample);
    const auto out = static_cast<std::size_t>(kLeftOut * static_cast<double>(sample.size()));
    const double low = sample[out], high = sample[sample.size() - 1 - out];
    return {low, high > low ? high : low + 1.0};
}

std::function<double(std::size_t)> valueOf(const Scan& scan, const CloudGeometry& cloud, const PlacedPoints* placed, ColourBy by) {
    const auto beams = static_cast<std::size_t>(scan.beams());
    if (by == ColourBy::Line) return [beams](std::size_t k) { return static_cast<double>(k / beams); };
    if (by == ColourBy::Range) return [&scan](std::size_t k) { return static_cast<double>(scan.rangeMm[k]) / 1000.0; };
    if (by == ColourBy::Intensity) return [&scan](std::size_t k) { return static_cast<double>(scan.intensity[k]); };
    const auto pointM = [&cloud](std::size_t k) { return Eigen::Vector3d(cloud.point(k).cast<double>() + cloud.originM); };
    if (placed != nullptr)
        return [=](std::size_t k) { return placed->mine(static_cast<int>(k / beams), static_cast<int>(k % beams), pointM(k)).z(); };
    const Eigen::Vector3d up = cloud.axes.up, scanner = cloud.sensor.cast<double>() + cloud.originM;
    return [=](std::size_t k) { return up.dot(pointM(k) - scanner); };
}

} // namespace

const char* colourKey(ColourBy by) { return std::ranges::find(kKeys, by, &std::pair<ColourBy, const char*>::first)->second; }

std::optional<ColourBy> colourOfKey(std::string_view key) {
    for (const auto& [by, name] : kKeys) {
        if (key == name) return by;
    }
    return std::nullopt;
}

QRgb colourAt(double share) {
    const double at = std::clamp(share, 0.0, 1.0) * (kScale.size() - 1);
    const auto from = std::min(static_cast<std::size_t>(at), kScale.size() - 2);
    const double part = at - static_cast<double>(from);
    std::array<int, 3> mixed{};
    for (std::size_t c = 0; c < 3; ++c)
        mixed[c] = static_cast<int>(std::lround(kScale[from][c] * (1.0 - part) + kScale[from + 1][c] * part));
    return qRgb(mixed[0], mixed[1], mixed[2]);
}

CloudColours cloudColours(const Scan& scan, const std::shared_ptr<const CloudGeometry>& cloud, ColourBy by) {
    CloudColours colours{by, cloud, nullptr};
    if (by == ColourBy::Nothing || !cloud || cloud->validCount == 0 || cloud->cells() != scan.cells()) return colours;
    if (by == ColourBy::Intensity && scan.intensity.size() != scan.cells()) return colours;
    std::optional<PlacedPoints> placed;
    if (by == ColourBy::Height && scan.placement) placed.emplace(scan);
    colours.mine = placed.has_value();
    const auto value = valueOf(scan, *cloud, placed ? &*placed : nullptr, by);
    std::vector<float> values(scan.cells(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (cloud->valid[k] != 0) values[k] = static_cast<float>(value(k));
    }
    std::tie(colours.low, colours.high) =
        by == ColourBy::Line ? std::pair(0.0, static_cast<double>(std::max(1, scan.lines() - 1))) : endsOf(values);
    std::array<std::uint32_t, kSteps> table{};
    for (std::size_t n = 0; n < kSteps; ++n) {
        const QRgb colour = colourAt(static_cast<double>(n) / (kSteps - 1));
        const std::array<std::uint8_t, 4> bytes{static_cast<std::uint8_t>(qRed(colour)), static_cast<std::uint8_t>(qGreen(colour)),
                                                static_cast<std::uint8_t>(qBlue(colour)), 255};
        table[n] = std::bit_cast<std::uint32_t>(bytes);
    }
    std::vector<std::uint32_t> points(values.size(), kWithoutValue);
    const double perStep = (kSteps - 1) / (colours.high - colours.low);
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (std::isnan(values[k])) continue;
        points[k] =
            table[static_cast<std::size_t>(std::clamp((static_cast<double>(values[k]) - colours.low) * perStep, 0.0, kSteps - 1.0))];
    }
    colours.points = std::make_shared<const std::vector<std::uint32_t>>(std::move(points));
    return colours;
}

} // namespace edgescan::ui
