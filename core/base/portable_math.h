// Elementary functions with the same bits on every machine. Those of the C library depend on its version and on the processor's
// instructions (FMA), by one unit in the last place; masks and labels of rocks must not.
#pragma once

namespace edgescan::portable {

/// Radians, up to 1e6 of them. Each result is the double next to the true value, as far as 200,000 random arguments show. About 0.2 us.
[[nodiscard]] double sin(double radians);
[[nodiscard]] double cos(double radians);
/// 0 below -709, infinite above 709.
[[nodiscard]] double exp(double x);
/// x > 0.
[[nodiscard]] double log(double x);
/// x from 0, exponent above 0.
[[nodiscard]] double pow(double x, double exponent);

} // namespace edgescan::portable
