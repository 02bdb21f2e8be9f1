// Evaluates the network: each neuron adds its inputs in order.
#include "core/rocks/segmentation/border_network.h"

#include "core/base/simd.h"

#include <algorithm>

namespace edgescan::rocks {
namespace {

constexpr float kMostInput = 4.0F;

template <std::size_t kIn, std::size_t kOut>
EDGESCAN_INLINE void addLayer(const float* in, const float* __restrict weights, float* __restrict out) {
    for (std::size_t i = 0; i < kIn; ++i) {
        const float x = in[i];
        for (std::size_t j = 0; j < kOut; ++j) out[j] += x * weights[i * kOut + j];
    }
}

EDGESCAN_INLINE float sayOf(const BorderNetwork& network, const float* features) {
    std::array<float, kBorderFeatures> in;
    for (std::size_t i = 0; i < in.size(); ++i)
        in[i] = std::min(std::max((features[i] - network.middle[i]) * network.scale[i], -kMostInput), kMostInput);
    std::array<float, kBorderFirst> first = network.firstBias;
    addLayer<kBorderFeatures, kBorderFirst>(in.data(), network.first.data(), first.data());
    for (float& x : first) x = std::max(x, 0.0F);
    std::array<float, kBorderSecond> second = network.secondBias;
    addLayer<kBorderFirst, kBorderSecond>(first.data(), network.second.data(), second.data());
    float sum = network.thirdBias;
    for (std::size_t j = 0; j < second.size(); ++j) sum += std::max(second[j], 0.0F) * network.third[j];
    return sum;
}

} // namespace

float BorderNetwork::says(const std::array<float, kBorderFeatures>& features) const { return vectorised<sayOf>(*this, features.data()); }

const BorderNetwork& learnedBorders() {
    static const BorderNetwork network{
#include "core/rocks/segmentation/border_weights.inc"
    };
    return network;
}

} // namespace edgescan::rocks
