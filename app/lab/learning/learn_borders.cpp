// Collects samples where the truth knows the answer, and trains on them.
#include "app/lab/learning/learn_borders.h"

#include "core/base/portable_math.h"
#include "core/edges/pipeline/pipeline.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace edgescan::lab {
namespace {

using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr Eigen::Index kIn = rocks::kBorderFeatures, kFirst = rocks::kBorderFirst, kSecond = rocks::kBorderSecond;
constexpr Eigen::Index kBatch = 2048;
constexpr float kMostInput = 4;
constexpr double kRate = 3e-3, kKept1 = 0.9, kKept2 = 0.999, kTiny = 1e-8;

// By segment: the object of most of its cells.
std::vector<std::uint16_t> objectsOf(const Grid<std::uint32_t>& segment, std::uint32_t count, const Grid<std::uint16_t>& object) {
    std::vector<std::map<std::uint16_t, std::size_t>> cells(static_cast<std::size_t>(count) + 1);
    for (std::size_t k = 0; k < segment.size(); ++k) ++cells[segment[k]][object[k]];
    std::vector<std::uint16_t> result;
    for (const auto& objects : cells) {
        const auto most = std::ranges::max_element(objects, {}, [](const auto& one) { return one.second; });
        result.push_back(most == objects.end() ? std::uint16_t{0} : most->first);
    }
    return result;
}

// Weights with their running means.
struct Layer {
    Matrix weights, mean, square;

    Layer(Eigen::Index in, Eigen::Index out, std::mt19937& random) : weights(in + 1, out), mean(Matrix::Zero(in + 1, out)), square(mean) {
        for (Eigen::Index i = 0; i < weights.size(); ++i) {
            // The sum of four uniform numbers is nearly normal, and the same everywhere.
            double sum = -2;
            for (int n = 0; n < 4; ++n) sum += static_cast<double>(random()) / 4294967296.0;
            weights.data()[i] = static_cast<float>(sum * std::sqrt(3.0) * std::sqrt(2.0 / static_cast<double>(in)));
        }
        weights.row(in).setZero(); // the biases
    }
    [[nodiscard]] Matrix of(const Matrix& in) const { return (in * weights.topRows(in.cols())).rowwise() + weights.row(in.cols()); }
    // `gradient`: of the outputs.
    void learn(const Matrix& in, const Matrix& gradient, double rate, int step) {
        Matrix slope(weights.rows(), weights.cols());
        slope.topRows(in.cols()).noalias() = in.transpose() * gradient;
        slope.row(in.cols()) = gradient.colwise().sum();
        mean = static_cast<float>(kKept1) * mean + static_cast<float>(1 - kKept1) * slope;
        square = static_cast<float>(kKept2) * square + static_cast<float>(1 - kKept2) * slope.cwiseProduct(slope);
        const double right1 = 1 - std::pow(kKept1, step), right2 = 1 - std::pow(kKept2, step);
        const Eigen::ArrayXXf root = (square.array() / static_cast<float>(right2)).sqrt() + static_cast<float>(kTiny);
        weights.array() -= static_cast<float>(rate / right1) * mean.array() / root;
    }
};

void setScales(const BorderSamples& samples, rocks::BorderNetwork& network) {
    std::vector<float> values(samples.count());
    for (std::size_t f = 0; f < rocks::kBorderFeatures; ++f) {
        double sum = 0, squares = 0;
        for (std::size_t n = 0; n < values.size(); ++n) {
            values[n] = samples.features[n * rocks::kBorderFeatures + f];
            sum += static_cast<double>(values[n]);
            squares += static_cast<double>(values[n]) * static_cast<double>(values[n]);
        }
        const double mean = sum / static_cast<double>(values.size());
        const double spread = std::sqrt(std::max(0.0, squares / static_cast<double>(values.size()) - mean * mean));
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        network.middle[f] = *middle;
        network.scale[f] = spread > 1e-6 ? static_cast<float>(1 / spread) : 1.0F;
    }
}

template <std::size_t kSize>
void copyTo(std::array<float, kSize>& array, const Matrix& from) {
    std::copy_n(from.data(), kSize, array.begin());
}

template <std::size_t kSize>
std::string listOf(const std::array<float, kSize>& numbers) {
    constexpr std::size_t kLine = 138;
    std::string text = "{\n   ";
    std::size_t length = 3;
    for (const float number : numbers) {
        std::array<char, 32> digits;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::scientific, 5).ptr;
        const std::string word = " " + std::string(digits.data(), end) + "F,";
        if (length + word.size() > kLine) {
            text += "\n   ";
            length = 3;
        }
        text += word;
        length += word.size();
    }
    return text + "\n},\n";
}

} // namespace

BorderLesson::BorderLesson(const std::shared_ptr<const Scan>& scan, Grid<std::uint16_t> object) : object_(std::move(object)) {
    inputs_ = rocks::rockInputs(*edges::detectEdges(scan, edges::Settings{}, edges::KeepFor::Rocks));
    fitted_ = rocks::fittedSegments(inputs_);
    groups_ = rocks::settledGroups(fitted_.borders, fitted_.count);
    objectOf_ = objectsOf(fitted_.segment, fitted_.count, object_);
}

void BorderLesson::ask(const rocks::BorderNetwork& network, int every, BorderSamples& samples) const {
    Grid<std::uint32_t> segment = fitted_.segment;
    rocks::chooseBorders(inputs_, groups_, network, rocks::kBorderPasses, segment);
    int next = 0;
    // A network without weights moves nothing.
    rocks::chooseBorders(inputs_, groups_, rocks::BorderNetwork{}, 1, segment, 1, [&](const rocks::BorderQuestion& question) {
        const std::uint16_t own = objectOf_[question.own], other = objectOf_[question.other], is = object_[question.cell];
        if (own == other || (is != own && is != other) || next++ % every != 0) return;
        samples.features.insert(samples.features.end(), question.features.begin(), question.features.end());
        samples.belongs.push_back(is == other ? 1.0F : 0.0F);
    });
}

rocks::BorderNetwork trainedBorders(const BorderSamples& samples, const BorderTraining& training) {
    rocks::BorderNetwork network;
    setScales(samples, network);
    const auto count = static_cast<Eigen::Index>(samples.count());
    Matrix all = Eigen::Map<const Matrix>(samples.features.data(), count, kIn);
    const Eigen::Map<const Eigen::RowVectorXf> middle(network.middle.data(), kIn), scale(network.scale.data(), kIn);
    all.rowwise() -= middle;
    all.array().rowwise() *= scale.array();
    all = all.cwiseMax(-kMostInput).cwiseMin(kMostInput).eval();
    std::mt19937 random(training.seed);
    std::array<Layer, 3> layers{Layer(kIn, kFirst, random), Layer(kFirst, kSecond, random), Layer(kSecond, 1, random)};
    std::vector<Eigen::Index> order(samples.count());
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const int batches = static_cast<int>((count + kBatch - 1) / kBatch), steps = training.epochs * batches;
    for (int step = 0; step < steps; ++step) {
        if (step % batches == 0) {
            for (std::size_t n = order.size(); n > 1; --n) std::swap(order[n - 1], order[random() % n]);
        }
        const Eigen::Index from = (step % batches) * kBatch, rows = std::min(kBatch, count - from);
        Matrix in(rows, kIn), wanted(rows, 1);
        for (Eigen::Index n = 0; n < rows; ++n) {
            const Eigen::Index at = order[static_cast<std::size_t>(from + n)];
            in.row(n) = all.row(at);
            wanted(n, 0) = samples.belongs[static_cast<std::size_t>(at)];
        }
        const Matrix first = layers[0].of(in).cwiseMax(0.0F), second = layers[1].of(first).cwiseMax(0.0F);
        const Matrix said = layers[2].of(second);
        const Matrix off =
            (said.unaryExpr([](float x) { return static_cast<float>(1 / (1 + portable::exp(-static_cast<double>(x)))); }) - wanted) /
            static_cast<float>(rows);
        const Matrix offSecond =
            (off * layers[2].weights.topRows(kSecond).transpose()).cwiseProduct((second.array() > 0).cast<float>().matrix());
        const Matrix offFirst =
            (offSecond * layers[1].weights.topRows(kFirst).transpose()).cwiseProduct((first.array() > 0).cast<float>().matrix());
        const double rate = kRate * 0.5 * (1 + portable::cos(3.14159265358979 * step / steps));
        layers[2].learn(second, off, rate, step + 1);
        layers[1].learn(first, offSecond, rate, step + 1);
        layers[0].learn(in, offFirst, rate, step + 1);
    }
    copyTo(network.first, layers[0].weights.topRows(kIn));
    copyTo(network.firstBias, layers[0].weights.row(kIn));
    copyTo(network.second, layers[1].weights.topRows(kFirst));
    copyTo(network.secondBias, layers[1].weights.row(kFirst));
    copyTo(network.third, layers[2].weights.topRows(kSecond));
    network.thirdBias = layers[2].weights(kSecond, 0);
    return network;
}

double rightShare(const rocks::BorderNetwork& network, const BorderSamples& samples) {
    std::size_t right = 0;
    rocks::BorderFeatureLanes features{};
    for (std::size_t first = 0; first < samples.count(); first += rocks::kCellsAtOnce) {
        const std::size_t lanes = std::min(rocks::kCellsAtOnce, samples.count() - first);
        for (std::size_t n = 0; n < lanes; ++n) {
            for (std::size_t f = 0; f < features.size(); ++f) features[f][n] = samples.features[(first + n) * features.size() + f];
        }
        const rocks::Lanes<float> said = network.says(features);
        for (std::size_t n = 0; n < lanes; ++n) right += (said[n] > 0) == (samples.belongs[first + n] > 0) ? 1 : 0;
    }
    return samples.count() == 0 ? 0 : static_cast<double>(right) / static_cast<double>(samples.count());
}

std::string borderWeightsText(const rocks::BorderNetwork& network, const std::string& madeBy) {
    std::string text = "// Made by `" + madeBy + "`; do not edit.\n";
    text += listOf(network.middle) + listOf(network.scale) + listOf(network.first) + listOf(network.firstBias) + listOf(network.second) +
            listOf(network.secondBias) + listOf(network.third);
    const std::string last = listOf(std::array<float, 1>{network.thirdBias});
    return text + last.substr(6, last.find(',') - 6) + "\n";
}

} // namespace edgescan::lab
