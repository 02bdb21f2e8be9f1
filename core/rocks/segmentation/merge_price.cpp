// Measures pairs of bodies and asks the trees about them.
#include "core/rocks/segmentation/merge_price.h"

#include "core/base/boosted_trees.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::rocks {
namespace {

#include "core/rocks/segmentation/merge_trees.inc" // kStart and kTrees

constexpr double kMostZ = 6.0;
constexpr double kLeastLengthM = 1e-6;

class FeatureWriter {
public:
    explicit FeatureWriter(PairFeatures& features) : features_(features) {}
    void put(double value) { features_[count_++] = static_cast<float>(value); }
    [[nodiscard]] std::size_t count() const { return count_; }

private:
    PairFeatures& features_;
    std::size_t count_ = 0;
};

double share(std::int64_t part, std::int64_t whole) { return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0; }

void putBorder(const BodyBorder& border, bool reversed, FeatureWriter& to) {
    const SegmentBorder& sums = border.sums;
    const OutlineSums& outline = border.outline;
    for (const std::int64_t sum : {sums.sumZ, sums.sumE1, sums.sumE2, sums.sumValley, sums.sumWide}) to.put(sums.mean(sum));
    to.put(static_cast<double>(outline.length) * kLengthStep);
    to.put(share(reversed ? sums.jumpsB : sums.jumpsA, sums.cracks));
    to.put(share(reversed ? sums.jumpsA : sums.jumpsB, sums.cracks));
    to.put(share(sums.valleys, sums.cracks));
    for (const std::int64_t length : outline.byEdge) to.put(outline.mean(length));
    to.put(outline.mean(outline.step));
    for (const std::int64_t turn : outline.turn) to.put(outline.mean(turn));
    to.put(outline.mean(outline.fold));
}

std::int64_t outlineLength(const Body& body) {
    std::int64_t length = body.sums.outerLength;
    for (const Body::Side& side : body.sides) length += side.length;
    return length;
}

// The mean z of the other borders, and the share of the outline whose border costs less.
void putRest(const Body& body, const BodyBorder& border, FeatureWriter& to) {
    const double z = border.sums.meanZ();
    double sum = 0, length = 0, lower = 0;
    for (const Body::Side& side : body.sides) {
        const auto its = static_cast<double>(side.length);
        length += its;
        if (side.z < z) lower += its;
        sum += std::min(side.z, kMostZ) * its;
    }
    const auto own = static_cast<double>(border.outline.length);
    to.put(length > own ? (sum - std::min(z, kMostZ) * own) / (length - own) : 0.0);
    to.put(length > 0 ? lower / length : 0.0);
}

double solidAngle(const Body& body) {
    const double rangeM = body.shape.centreM.norm();
    return rangeM > 0 ? body.sums.points.areaM2 / (rangeM * rangeM) : 0.0;
}

} // namespace

PairFeatures pairFeatures(const Body& a, const Body& b, const BodyBorder& border, const RangeNoise& noise) {
    PairFeatures features{};
    FeatureWriter to(features);
    const bool reversed = a.sums.points.cells > b.sums.points.cells;
    const Body& lesser = reversed ? b : a;
    const Body& larger = reversed ? a : b;
    const BodyShape both = shapeOfBoth(lesser.sums, larger.sums, noise);
    putBorder(border, reversed, to);
    for (const Body* body : {&lesser, &larger}) to.put(solidAngle(*body));
    for (const Body* body : {&lesser, &larger}) to.put(share(border.outline.length, outlineLength(*body)));
    for (double BodyShape::*number :
         {&BodyShape::longM, &BodyShape::depthRatio, &BodyShape::middleRatio, &BodyShape::roughness, &BodyShape::fill, &BodyShape::bulge}) {
        for (const BodyShape* shape : {&lesser.shape, &larger.shape, &both}) to.put(shape->*number);
    }
    to.put(both.fill - std::max(lesser.shape.fill, larger.shape.fill));
    const double cells = lesser.sums.points.cells, others = larger.sums.points.cells;
    const double apart = (lesser.shape.roughness * cells + larger.shape.roughness * others) / std::max(1.0, cells + others);
    to.put((both.roughness + 0.1) / (apart + 0.1));
    to.put(both.longM - larger.shape.longM);
    for (const Body* body : {&lesser, &larger}) putRest(*body, border, to);
    to.put(lesser.shape.centreM.norm());
    const Eigen::Vector3d across = lesser.shape.centreM - larger.shape.centreM;
    const double distance = std::max(kLeastLengthM, across.norm());
    to.put(lesser.shape.normal.dot(larger.shape.normal));
    to.put((lesser.shape.normal - larger.shape.normal).dot(across) / distance);
    to.put(std::max(std::abs(across.dot(larger.shape.normal)), std::abs(across.dot(lesser.shape.normal))) / distance);
    return features;
}

double mergePrice(const PairFeatures& features) { return static_cast<double>(logOdds(kTrees, kStart, features.data())) / kLogOddsUnit; }

} // namespace edgescan::rocks
