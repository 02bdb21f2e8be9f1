// The name of each method and the settings that it reads. The functions of the methods are in core/edges/pipeline/methods.h, in the same
// order.
#pragma once

#include "core/edges/settings/settings.h"

#include <span>

namespace edgescan::edges {

/// The settings that a method reads, in addition to `method` itself: bits of MethodTraits::reads.
enum Reads : unsigned {
    kReadsSurface = 1,        ///< the surface in inverse range: settings of jumps
    kReadsCreases = 2,        ///< its folds
    kReadsClasses = 4,        ///< the requested classes of edges
    kReadsGray = 8,           ///< gray levels, and a threshold for them
    kReadsRangeStep = 16,     ///< a threshold in percent of the range
    kReadsTwoThresholds = 32, ///< the ratio of upper and lower threshold, and the aperture of the Sobel operator
    kReadsKernel = 64,        ///< the kernel of the Gaussian for smoothing, and its sigma
    kReadsSigma = 128,        ///< the sigma of the method's own Gaussian, without a kernel size
    kReadsNorm = 256,         ///< how two components are combined to a magnitude
    kReadsLaplacianMask = 512,
};

struct MethodTraits {
    Method method;
    const char* key;   ///< value of --method
    const char* label; ///< name in the window
    unsigned reads;    ///< Reads
    int classes;       ///< the requested EdgeClassBits if the method does not read Settings::classes
};

/// All methods, in the order of the enumeration.
[[nodiscard]] std::span<const MethodTraits> methodTraits();

[[nodiscard]] const MethodTraits& traitsOf(Method method);

/// Whether the method reads all of these bits of Reads.
[[nodiscard]] inline bool reads(Method method, unsigned what) { return (traitsOf(method).reads & what) == what; }

/// Whether edges of this class (EdgeClassBits) are asked for.
[[nodiscard]] bool wants(const Settings& settings, int edgeClass);

/// True if an edge is a cell whose response to gray levels is larger than settings.lower.
[[nodiscard]] inline bool hasOneThreshold(Method method) { return reads(method, kReadsGray) && !reads(method, kReadsTwoThresholds); }

/// Automatic sigma of the Gaussian, cells: from the kernel size, or the default of a method without a kernel size.
[[nodiscard]] double automaticSigma(const Settings& settings);

} // namespace edgescan::edges
