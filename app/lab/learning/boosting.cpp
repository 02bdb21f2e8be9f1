// Grows trees level by level on histograms of the features.
#include "app/lab/learning/boosting.h"

#include "core/base/bands.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace edgescan::lab {
namespace {

constexpr int kMostBins = 256;
constexpr double kLeastGain = 1e-6;

// A float that is read back to the last bit.
std::string roundTrip(float value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 8).ptr;
    return std::string(text.data(), end) + "F";
}

double probability(double logOdds) { return 1.0 / (1.0 + std::exp(-logOdds)); }

// The limits between the bins of one feature, ascending: a value is in the first bin whose limit it does not exceed.
std::vector<float> limitsOf(const TreeSamples& samples, int feature) {
    std::vector<float> values;
    const std::size_t every = std::max<std::size_t>(1, samples.count() / 200000);
    for (std::size_t n = 0; n < samples.count(); n += every) values.push_back(samples.of(n)[feature]);
    std::ranges::sort(values);
    std::vector<float> limits;
    for (std::size_t bin = 0; bin + 1 < kMostBins && !values.empty(); ++bin) {
        const float value = values[bin * values.size() / (kMostBins - 1)];
        const auto next = std::ranges::upper_bound(values, value);
        if (next == values.end()) break;
        const float limit = value + (*next - value) / 2;
        if (limit < *next && (limits.empty() || limit > limits.back())) limits.push_back(limit);
    }
    return limits;
}

struct Sums {
    double slope = 0, curvature = 0, weight = 0;
    void add(const Sums& other) {
        slope += other.slope;
        curvature += other.curvature;
        weight += other.weight;
    }
    [[nodiscard]] Sums without(const Sums& other) const {
        return {slope - other.slope, curvature - other.curvature, weight - other.weight};
    }
};

struct Split {
    double gain = kLeastGain;
    int feature = -1;
    int bin = 0; ///< the last one on the low side
};

class Grower {
public:
    Grower(const TreeSamples& samples, const BoostingChoices& choices, int threads)
        : samples_(samples), choices_(choices), threads_(threads),
          limits_(static_cast<std::size_t>(choices.features > 0 ? choices.features : samples.features)),
          bins_(limits_.size(), std::vector<std::uint8_t>(samples.count())), said_(samples.count()), place_(samples.count()),
          sums_(samples.count()) {
        eachFeature([&](std::size_t f) {
            limits_[f] = limitsOf(samples_, static_cast<int>(f));
            for (std::size_t n = 0; n < samples_.count(); ++n) {
                const auto at = std::ranges::lower_bound(limits_[f], samples_.of(n)[f]);
                bins_[f][n] = static_cast<std::uint8_t>(at - limits_[f].begin());
            }
        });
    }

    LearntTrees grow() {
        double yes = 0, all = 0;
        for (std::size_t n = 0; n < samples_.count(); ++n) {
            all += static_cast<double>(samples_.weight[n]);
            yes += samples_.yes[n] != 0 ? static_cast<double>(samples_.weight[n]) : 0.0;
        }
        LearntTrees learnt;
        const double share = std::clamp(yes / std::max(all, 1e-9), 1e-3, 1 - 1e-3);
        if (samples_.before.empty()) learnt.start = static_cast<std::int32_t>(std::lround(std::log(share / (1 - share)) * kLogOddsUnit));
        said_ = samples_.before.empty() ? std::vector<std::int32_t>(samples_.count(), learnt.start) : samples_.before;
        for (int n = 0; n < choices_.trees; ++n) learnt.trees.push_back(nextTree());
        return learnt;
    }

private:
    template <class Work>
    void eachFeature(Work work) {
        runInBands(static_cast<int>(limits_.size()), threads_, [&](int first, int last) {
            for (int f = first; f < last; ++f) work(static_cast<std::size_t>(f));
        });
    }

    BoostedTree nextTree() {
        for (std::size_t n = 0; n < samples_.count(); ++n) {
            const double p = probability(static_cast<double>(said_[n]) / kLogOddsUnit), w = static_cast<double>(samples_.weight[n]);
            sums_[n] = {w * ((samples_.yes[n] != 0 ? 1.0 : 0.0) - p), w * std::max(p * (1 - p), 1e-6), w};
        }
        std::ranges::fill(place_, std::uint8_t{0});
        BoostedTree tree;
        tree.limit.fill(std::numeric_limits<float>::infinity());
        for (int level = 0; level < BoostedTree::kDepth; ++level) {
            const std::size_t first = (std::size_t{1} << level) - 1, count = std::size_t{1} << level;
            const std::vector<Split> splits = bestSplits(first, count);
            for (std::size_t n = 0; n < count; ++n) {
                if (splits[n].feature < 0) continue;
                tree.feature[first + n] = static_cast<std::uint8_t>(splits[n].feature);
                tree.limit[first + n] = limits_[static_cast<std::size_t>(splits[n].feature)][static_cast<std::size_t>(splits[n].bin)];
            }
            for (std::size_t n = 0; n < samples_.count(); ++n) {
                const std::size_t at = place_[n];
                place_[n] = static_cast<std::uint8_t>(2 * at + 1 + (samples_.of(n)[tree.feature[at]] > tree.limit[at] ? 1 : 0));
            }
        }
        fillLeaves(tree);
        return tree;
    }

    // Of the questions `first` and the `count` - 1 after it.
    std::vector<Split> bestSplits(std::size_t first, std::size_t count) {
        std::vector<std::vector<Split>> ofFeature(limits_.size(), std::vector<Split>(count));
        eachFeature([&](std::size_t f) {
            std::vector<std::array<Sums, kMostBins>> histograms(count);
            for (std::size_t n = 0; n < samples_.count(); ++n) histograms[place_[n] - first][bins_[f][n]].add(sums_[n]);
            for (std::size_t at = 0; at < count; ++at) ofFeature[f][at] = bestOf(histograms[at], f);
        });
        std::vector<Split> best(count);
        for (const std::vector<Split>& splits : ofFeature) {
            for (std::size_t at = 0; at < count; ++at) {
                if (splits[at].gain > best[at].gain) best[at] = splits[at];
            }
        }
        return best;
    }

    [[nodiscard]] Split bestOf(const std::array<Sums, kMostBins>& histogram, std::size_t feature) const {
        const auto worth = [&](const Sums& sums) { return sums.slope * sums.slope / (sums.curvature + choices_.ridge); };
        Sums all, low;
        for (const Sums& sums : histogram) all.add(sums);
        Split best;
        for (std::size_t bin = 0; bin < limits_[feature].size(); ++bin) {
            low.add(histogram[bin]);
            const Sums high = all.without(low);
            if (low.weight < choices_.least || high.weight < choices_.least) continue;
            const double gain = worth(low) + worth(high) - worth(all);
            if (gain > best.gain) best = {gain, static_cast<int>(feature), static_cast<int>(bin)};
        }
        return best;
    }

    // A side on which no sample is gets the value of the other one, so that a question that was not asked counts nothing.
    void fillLeaves(BoostedTree& tree) {
        std::array<Sums, BoostedTree::kQuestions + BoostedTree::kLeaves> below{};
        for (std::size_t n = 0; n < samples_.count(); ++n) below[place_[n]].add(sums_[n]);
        for (std::size_t at = BoostedTree::kQuestions; at-- > 0;) {
            below[at] = below[2 * at + 1];
            below[at].add(below[2 * at + 2]);
        }
        for (std::size_t leaf = 0; leaf < BoostedTree::kLeaves; ++leaf) {
            std::size_t at = leaf + BoostedTree::kQuestions;
            while (at > 0 && below[at].weight <= 0) at = (at - 1) / 2;
            const double step = choices_.rate * below[at].slope / (below[at].curvature + choices_.ridge);
            tree.leaf[leaf] = static_cast<std::int32_t>(std::lround(step * kLogOddsUnit));
        }
        for (std::size_t n = 0; n < samples_.count(); ++n) said_[n] += tree.leaf[place_[n] - BoostedTree::kQuestions];
    }

    const TreeSamples& samples_;
    BoostingChoices choices_;
    int threads_;
    std::vector<std::vector<float>> limits_;
    std::vector<std::vector<std::uint8_t>> bins_; // by feature, the bin of each sample
    std::vector<std::int32_t> said_;
    std::vector<std::uint8_t> place_; // the question at which a sample is, or its leaf
    std::vector<Sums> sums_;
};

} // namespace

void TreeSamples::add(std::span<const float> measured, bool answer, float itsWeight) {
    features = static_cast<int>(measured.size());
    values.insert(values.end(), measured.begin(), measured.end());
    yes.push_back(answer ? 1 : 0);
    weight.push_back(itsWeight);
}

void TreeSamples::add(const TreeSamples& others) {
    if (others.count() == 0) return;
    features = others.features;
    values.insert(values.end(), others.values.begin(), others.values.end());
    yes.insert(yes.end(), others.yes.begin(), others.yes.end());
    weight.insert(weight.end(), others.weight.begin(), others.weight.end());
}

LearntTrees learntTrees(const TreeSamples& samples, const BoostingChoices& choices, int threads) {
    return samples.count() == 0 ? LearntTrees{} : Grower(samples, choices, threads).grow();
}

AnswerQuality qualityOf(const TreeSamples& samples, const LearntTrees& trees) {
    struct Answer {
        std::int32_t odds;
        double yes, no;
    };
    std::vector<Answer> answers;
    std::array<double, 10> said{}, was{}, weight{};
    double yes = 0, no = 0;
    for (std::size_t n = 0; n < samples.count(); ++n) {
        const std::int32_t odds = trees.logOddsOf(samples.of(n)) + (samples.before.empty() ? 0 : samples.before[n]);
        const auto w = static_cast<double>(samples.weight[n]);
        answers.push_back({odds, samples.yes[n] != 0 ? w : 0.0, samples.yes[n] != 0 ? 0.0 : w});
        yes += answers.back().yes;
        no += answers.back().no;
        const double p = probability(static_cast<double>(odds) / kLogOddsUnit);
        const auto bin = static_cast<std::size_t>(std::min(9.0, 10 * p));
        said[bin] += w * p;
        was[bin] += answers.back().yes;
        weight[bin] += w;
    }
    AnswerQuality quality;
    if (yes <= 0 || no <= 0) return quality;
    std::ranges::sort(answers, std::greater<>{}, &Answer::odds);
    double found = 0, wrong = 0;
    for (std::size_t n = 0; n < answers.size();) {
        double yesHere = 0, noHere = 0;
        for (const std::int32_t odds = answers[n].odds; n < answers.size() && answers[n].odds == odds; ++n) {
            yesHere += answers[n].yes;
            noHere += answers[n].no;
        }
        quality.auc += noHere * (found + 0.5 * yesHere) / (yes * no);
        found += yesHere;
        wrong += noHere;
        if (quality.precisionAt90 == 0 && found >= 0.9 * yes) quality.precisionAt90 = found / (found + wrong);
    }
    for (std::size_t bin = 0; bin < said.size(); ++bin) quality.calibration += std::abs(said[bin] - was[bin]) / (yes + no);
    return quality;
}

std::string qualityText(const AnswerQuality& quality) {
    return "AUC " + fixedText(quality.auc, 3) + ", precision " + fixedText(quality.precisionAt90, 3) + " at recall .9, calibration error " +
           fixedText(quality.calibration, 3);
}

std::string treesText(const LearntTrees& trees, const std::string& madeBy) {
    const auto list = [](const auto& values, auto textOf) {
        std::string text = "{";
        for (const auto& value : values) text += (text.size() > 1 ? ", " : "") + textOf(value);
        return text + "}";
    };
    const auto whole = [](auto value) { return std::to_string(static_cast<long>(value)); };
    const auto limit = [](float value) {
        return std::isinf(value) ? std::string("std::numeric_limits<float>::infinity()") : roundTrip(value);
    };
    std::string text = "// Made by `" + madeBy + "`; do not edit.\nconstexpr std::int32_t kStart = " + std::to_string(trees.start) +
                       ";\nconstexpr std::array<BoostedTree, " + std::to_string(trees.trees.size()) + "> kTrees{{\n";
    for (const BoostedTree& tree : trees.trees)
        text += "    {" + list(tree.feature, whole) + ",\n     " + list(tree.limit, limit) + ",\n     " + list(tree.leaf, whole) + "},\n";
    return text + "}};\n";
}

} // namespace edgescan::lab
