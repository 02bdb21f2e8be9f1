// From what a beam's sub-rays hit to the one range that the scanner reports.
#pragma once

#include "core/sim/rays.h"
#include "core/sim/scene.h"
#include "core/sim/simulate.h"

namespace edgescan::sim {

/// The echo that wins; signal 0 when there is none.
struct Echo {
    double rangeM = 0.0;
    double cosine = 1.0;       ///< of the angle between beam and surface normal
    double signal = 0.0;       ///< received power; 1 is a white plate facing the scanner at 10 m
    std::size_t strongest = 0; ///< sub-ray that contributed most
};

[[nodiscard]] Echo echoOf(const RayBundle& bundle, const BundleHits& hits, const Scene& scene, const SimulationSettings& settings);

/// Cosine between a sub-ray and the surface it hit.
[[nodiscard]] double cosineOf(const Scene& scene, const RayBundle& bundle, const BundleHits& hits, std::size_t lane);

/// Standard deviation of a range in metres (docs/method.md, "Simulator"), without the settings' factor.
[[nodiscard]] double rangeSigmaM(double rangeM, double cosine);

/// Range of cell k in whole steps, mm; 0 for no return.
[[nodiscard]] double measuredMm(const Echo& echo, std::size_t k, const SimulationSettings& settings);

} // namespace edgescan::sim
