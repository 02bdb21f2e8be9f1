// Computes the one range that the scanner reports from the hits of a beam's sub-rays.
#pragma once

#include "app/lab/sim/rays.h"
#include "app/lab/sim/scene.h"
#include "app/lab/sim/simulate.h"

namespace edgescan::sim {

/// The strongest echo; signal 0 if there is no echo.
struct Echo {
    double rangeM = 0.0;
    double cosine = 1.0;       ///< of the angle between beam and surface normal
    double signal = 0.0;       ///< received power; 1 is a white plate at 10 m that faces the scanner
    std::size_t strongest = 0; ///< sub-ray that contributed most
};

[[nodiscard]] Echo echoOf(const RayBundle& bundle, const BundleHits& hits, const Scene& scene, const SimulationSettings& settings);

/// Cosine between a sub-ray and the surface it hit (surfaceOf).
[[nodiscard]] double cosineOf(const Scene& scene, const Surface& surface, const RayBundle& bundle, const BundleHits& hits,
                              std::size_t lane);

/// Standard deviation of a range in metres (docs/method/edges.md, "Simulator"), without the factor of the settings.
[[nodiscard]] double rangeSigmaM(double rangeM, double cosine);

/// The range of cell k in whole steps, mm; 0 for no return.
[[nodiscard]] double measuredMm(const Echo& echo, std::size_t k, const SimulationSettings& settings);

} // namespace edgescan::sim
