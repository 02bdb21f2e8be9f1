// What each method is called and which settings it reads. What it does with them: core/edges/pipeline/methods.h, in the same order.
#pragma once

#include "core/edges/settings/settings.h"

#include <span>

namespace edgescan::edges {

/// What a method reads, beside `method` itself: bits of MethodTraits::reads.
enum Reads : unsigned {
    kReadsSurface = 1,        ///< the surface in inverse range: jumps and what belongs to them
    kReadsCreases = 2,        ///< its folds
    kReadsClasses = 4,        ///< which classes of edges count
    kReadsGray = 8,           ///< gray levels, and a threshold of them
    kReadsRangeStep = 16,     ///< a threshold in percent of the range
    kReadsTwoThresholds = 32, ///< the ratio of upper and lower threshold, and Sobel's aperture
    kReadsKernel = 64,        ///< the Gaussian kernel that smooths first, and its sigma
    kReadsSigma = 128,        ///< the sigma of a Gaussian of its own, without a kernel size
    kReadsNorm = 256,         ///< how two components become one magnitude
    kReadsLaplacianMask = 512,
};

struct MethodTraits {
    Method method;
    const char* key;   ///< value of --method
    const char* label; ///< as shown
    unsigned reads;    ///< Reads
    int classes;       ///< EdgeClassBits that count where the method does not read Settings::classes
};

/// Every method, in the order of the enumeration.
[[nodiscard]] std::span<const MethodTraits> methodTraits();

[[nodiscard]] const MethodTraits& traitsOf(Method method);

/// All of these bits of Reads.
[[nodiscard]] inline bool reads(Method method, unsigned what) { return (traitsOf(method).reads & what) == what; }

/// An edge is where the response to gray levels is larger than settings.lower.
[[nodiscard]] inline bool hasOneThreshold(Method method) { return reads(method, kReadsGray) && !reads(method, kReadsTwoThresholds); }

/// Sigma of the Gaussian, cells, where nobody typed one: from the kernel size, or the one of a method without a kernel size.
[[nodiscard]] double automaticSigma(const Settings& settings);

} // namespace edgescan::edges
