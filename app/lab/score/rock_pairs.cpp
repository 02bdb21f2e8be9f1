// Finds and scores pairs of rocks.
#include "app/lab/score/rock_pairs.h"

#include <algorithm>
#include <map>
#include <utility>

namespace edgescan::lab {
namespace {

constexpr int kTornMm = 50; // as for an occluding edge
constexpr std::size_t kFewestTorn = 3;
constexpr double kOneWay = 0.8;
constexpr std::size_t kFewestTouching = 5;

using Key = std::pair<std::uint32_t, std::uint32_t>;

struct Cracks {
    std::size_t frontA = 0, frontB = 0, whole = 0;
};

RockPair pairOf(const Key& key, const Cracks& cracks) {
    RockPair pair{key.first, key.second, 0, cracks.whole >= kFewestTouching};
    const std::size_t torn = cracks.frontA + cracks.frontB;
    const auto most = static_cast<double>(std::max(cracks.frontA, cracks.frontB));
    if (torn >= kFewestTorn && most >= kOneWay * static_cast<double>(torn)) pair.front = cracks.frontA > cracks.frontB ? pair.a : pair.b;
    return pair;
}

/// One kind of statement about pairs, by the two numbers of the pair.
using PairStatements = std::map<Key, std::uint32_t>;

PairCounts compared(const PairStatements& truth, const PairStatements& reported, const std::map<std::uint32_t, std::uint32_t>& regionOf) {
    PairCounts counts{.reported = reported.size(), .known = truth.size(), .rocks = regionOf.size()};
    std::map<std::uint32_t, std::pair<int, int>> ofRock; // true and reported neighbours
    for (const auto& [key, front] : reported) {
        ++ofRock[key.first].second;
        ++ofRock[key.second].second;
        const auto known = truth.find(key);
        if (known == truth.end()) continue;
        ++counts.reportedKnown;
        counts.right += known->second == front ? 1 : 0;
    }
    for (const auto& [key, front] : truth) {
        ++ofRock[key.first].first;
        ++ofRock[key.second].first;
    }
    for (const auto& [rock, region] : regionOf) {
        const auto both = ofRock.find(rock);
        if (both == ofRock.end() || std::abs(both->second.first - both->second.second) <= 1) ++counts.rocksClose;
    }
    return counts;
}

} // namespace

PairCounts& PairCounts::operator+=(const PairCounts& other) {
    for (auto member : {&PairCounts::reported, &PairCounts::known, &PairCounts::reportedKnown, &PairCounts::right, &PairCounts::rocks,
                        &PairCounts::rocksClose})
        this->*member += other.*member;
    return *this;
}

PairScore& PairScore::operator+=(const PairScore& other) {
    order += other.order;
    contacts += other.contacts;
    return *this;
}

std::vector<RockPair> truePairs(const TrueRocks& truth) {
    if (truth.tearToBeamMm.size() == 0) return {};
    std::map<Key, Cracks> cracks;
    const auto judge = [&](std::size_t k, std::size_t next, int tearMm) {
        const std::uint32_t a = truth.rock[k];
        const std::uint32_t b = truth.rock[next];
        if (a == 0 || b == 0 || a == b) return;
        Cracks& between = cracks[{std::min(a, b), std::max(a, b)}];
        const std::uint32_t front = truth.cleanMm[k] <= truth.cleanMm[next] ? a : b;
        ++(tearMm <= kTornMm ? between.whole : front == std::min(a, b) ? between.frontA : between.frontB);
    };
    for (int i = 0; i < truth.rock.lines; ++i) {
        for (int j = 0; j < truth.rock.beams; ++j) {
            const std::size_t k = truth.rock.index(i, j);
            if (j + 1 < truth.rock.beams) judge(k, k + 1, truth.tearToBeamMm[k]);
            if (i + 1 < truth.rock.lines) judge(k, truth.rock.index(i + 1, j), truth.tearToLineMm[k]);
        }
    }
    std::vector<RockPair> pairs;
    for (const auto& [key, between] : cracks) pairs.push_back(pairOf(key, between));
    return pairs;
}

PairScore scorePairs(const std::vector<RockPair>& truth, const std::vector<RockPair>& reported, const RockMatch& match) {
    std::map<std::uint32_t, std::uint32_t> regionOf, rockOf;
    for (const RockVerdict& rock : match.rocks) {
        if (!rock.found) continue;
        regionOf[rock.rock] = rock.region;
        rockOf[rock.region] = rock.rock;
    }
    PairStatements trueFront, trueContact, reportedFront, reportedContact;
    for (const RockPair& pair : truth) {
        if (!regionOf.contains(pair.a) || !regionOf.contains(pair.b)) continue;
        const Key key{std::min(pair.a, pair.b), std::max(pair.a, pair.b)};
        if (pair.front != 0) trueFront[key] = pair.front;
        if (pair.contact) trueContact[key] = 1;
    }
    for (const RockPair& pair : reported) {
        const auto a = rockOf.find(pair.a);
        const auto b = rockOf.find(pair.b);
        if (a == rockOf.end() || b == rockOf.end()) continue;
        const Key key{std::min(a->second, b->second), std::max(a->second, b->second)};
        if (pair.front != 0) reportedFront[key] = pair.front == pair.a ? a->second : b->second;
        if (pair.contact) reportedContact[key] = 1;
    }
    return {compared(trueFront, reportedFront, regionOf), compared(trueContact, reportedContact, regionOf)};
}

} // namespace edgescan::lab
