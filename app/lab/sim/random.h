// Random numbers that depend only on (seed, purpose, index): the same bytes for any number of threads and on every machine.
#pragma once

#include <cstdint>

namespace edgescan::sim {

/// Bijective 64-bit mixer (the finaliser of splitmix64).
constexpr std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31U);
}

/// The purpose of a random number; numbers for different purposes are independent.
enum class Purpose : std::uint64_t {
    Noise = 1,
    Dropout,
    EchoLoss,
    Dust,
    DustRange,
    LineJitter,
    Patches,
    Bell,
    Sizes,
    Places,
    Shapes,
    Rubble,
    Slips,
    Status,
    Holes,
    Repeats,
    Blast,
    Walls
};

constexpr std::uint64_t hashOf(std::uint64_t seed, Purpose purpose, std::uint64_t index) {
    return mixed(mixed(seed ^ (static_cast<std::uint64_t>(purpose) << 56U)) ^ mixed(index));
}

/// In [0, 1), 53 bits.
constexpr double uniformOf(std::uint64_t hash) { return static_cast<double>(hash >> 11U) * 0x1.0p-53; }

/// Mean 0, standard deviation 1, never beyond 6. A sum of twelve uniform numbers instead of Box-Muller: it needs only integers, whereas log
/// and cos differ in the last bit between C libraries.
constexpr double normalOf(std::uint64_t hash) {
    std::uint64_t sum = 0;
    for (int word = 0; word < 3; ++word) {
        hash = mixed(hash);
        for (unsigned part = 0; part < 4; ++part) sum += (hash >> (16U * part)) & 0xFFFFU;
    }
    return (static_cast<double>(sum) + 6.0) / 65536.0 - 6.0;
}

/// A sequence of random numbers for building a scene, on one thread.
class RandomSequence {
public:
    RandomSequence(std::uint64_t seed, Purpose purpose, std::uint64_t stream = 0) : key_(hashOf(seed, purpose, stream)) {}

    double uniform() { return uniformOf(next()); }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    double normal() { return normalOf(next()); }
    /// In [low, high].
    int whole(int low, int high) { return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1)); }

private:
    std::uint64_t next() { return mixed(key_ ^ mixed(++count_)); }

    std::uint64_t key_;
    std::uint64_t count_ = 0;
};

} // namespace edgescan::sim
