// Evaluates the network for several questions at once: each neuron adds its inputs in order.
#include "core/rocks/segmentation/border_network.h"

#include <algorithm>

namespace edgescan::rocks {
namespace {

constexpr float kMostInput = 4.0F;
constexpr std::size_t kNeuronsAtOnce = 8; // their sums fit in registers

// Of kNeuronsAtOnce neurons of a layer with kOut neurons, for the questions of one vector. The values of one input, and those of one
// neuron, are kCellsAtOnce apart from the next ones.
template <class Vector, std::size_t kIn, std::size_t kOut>
EDGESCAN_INLINE void addInputs(const float* in, const float* weights, const float* bias, float* out) {
    std::array<Vector, kNeuronsAtOnce> sums;
#pragma GCC unroll 8
    for (std::size_t n = 0; n < kNeuronsAtOnce; ++n) sums[n] = Vector{} + bias[n];
    for (std::size_t i = 0; i < kIn; ++i) {
        Vector x;
        load(x, in + i * kCellsAtOnce);
#pragma GCC unroll 8
        for (std::size_t n = 0; n < kNeuronsAtOnce; ++n) sums[n] += x * weights[i * kOut + n];
    }
#pragma GCC unroll 8
    for (std::size_t n = 0; n < kNeuronsAtOnce; ++n) store(out + n * kCellsAtOnce, sums[n] < 0.0F ? Vector{} : sums[n]);
}

template <class Vector, std::size_t kIn, std::size_t kOut>
EDGESCAN_INLINE void addLayer(const float* in, const float* weights, const float* bias, float* out) {
    static_assert(kOut % kNeuronsAtOnce == 0);
    for (std::size_t lane = 0; lane < kCellsAtOnce; lane += kLanes<Vector>) {
        for (std::size_t j = 0; j < kOut; j += kNeuronsAtOnce)
            addInputs<Vector, kIn, kOut>(in + lane, weights + j, bias + j, out + j * kCellsAtOnce + lane);
    }
}

template <class Vector>
EDGESCAN_INLINE void sayAll(const BorderNetwork& network, const BorderFeatureLanes& features, Lanes<float>& said) {
    BorderFeatureLanes in;
    for (std::size_t i = 0; i < kBorderFeatures; ++i) {
        for (std::size_t n = 0; n < kCellsAtOnce; ++n)
            in[i][n] = std::min(std::max((features[i][n] - network.middle[i]) * network.scale[i], -kMostInput), kMostInput);
    }
    std::array<Lanes<float>, kBorderFirst> first;
    std::array<Lanes<float>, kBorderSecond> second;
    addLayer<Vector, kBorderFeatures, kBorderFirst>(in[0].data(), network.first.data(), network.firstBias.data(), first[0].data());
    addLayer<Vector, kBorderFirst, kBorderSecond>(first[0].data(), network.second.data(), network.secondBias.data(), second[0].data());
    said.fill(network.thirdBias);
    for (std::size_t j = 0; j < kBorderSecond; ++j) {
        for (std::size_t n = 0; n < kCellsAtOnce; ++n) said[n] += second[j][n] * network.third[j];
    }
}

} // namespace

Lanes<float> BorderNetwork::says(const BorderFeatureLanes& features) const {
    Lanes<float> said;
    vectorised<sayAll<FourLanes>, sayAll<EightLanes>, sayAll<SixteenLanes>>(*this, features, said);
    return said;
}

const BorderNetwork& learnedBorders() {
    static const BorderNetwork network{
#include "core/rocks/segmentation/border_weights.inc"
    };
    return network;
}

} // namespace edgescan::rocks
