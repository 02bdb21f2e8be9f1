// Elementary functions from sums and products of pairs of doubles (Dekker 1971): plain arithmetic, which IEEE 754 fixes to the last bit.
#include "core/base/portable_math.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace edgescan::portable {
namespace {

/// high + low, about 106 bits; |low| is at most half a unit in the last place of high.
struct Pair {
    double high = 0, low = 0;
};

Pair sumOf(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

// |a| >= |b|.
Pair ordered(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

Pair productOf(double a, double b) {
    constexpr double kSplit = 134217729.0; // 2^27 + 1: halves of 26 bits
    const double a1 = (kSplit * a) - (kSplit * a - a), a2 = a - a1;
    const double b1 = (kSplit * b) - (kSplit * b - b), b2 = b - b1;
    const double product = a * b;
    return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

Pair operator+(Pair a, Pair b) {
    const Pair sum = sumOf(a.high, b.high);
    return ordered(sum.high, sum.low + (a.low + b.low));
}
Pair operator*(Pair a, Pair b) {
    const Pair product = productOf(a.high, b.high);
    return ordered(product.high, product.low + (a.high * b.low + a.low * b.high));
}
Pair operator-(Pair a) { return {-a.high, -a.low}; }

// a / b by long division.
Pair quotientOf(double a, double b) {
    const double high = a / b;
    const Pair back = productOf(high, b);
    return ordered(high, ((a - back.high) - back.low) / b);
}

constexpr std::size_t kTerms = 28;

// 1 / n!
const std::array<Pair, kTerms>& inverseFactorials() {
    static const std::array<Pair, kTerms> all = [] {
        std::array<Pair, kTerms> made{};
        Pair value{1, 0};
        for (std::size_t n = 0; n < kTerms; ++n) {
            if (n > 0) value = value * quotientOf(1, static_cast<double>(n));
            made[n] = value;
        }
        return made;
    }();
    return all;
}

// x^first / first! -+ x^(first + 2) / (first + 2)! ..., for |x| <= pi / 4.
Pair alternating(Pair x, std::size_t first) {
    const Pair square = -(x * x);
    Pair sum{};
    std::size_t n = first;
    while (n + 2 < kTerms) n += 2;
    for (;; n -= 2) {
        sum = sum * square + inverseFactorials()[n];
        if (n == first) break;
    }
    return first == 1 ? sum * x : sum;
}

// pi / 2 in 159 bits, ln 2 in 106.
constexpr double kHalfPi1 = 0x1.921fb54442d18p+0, kHalfPi2 = 0x1.1a62633145c07p-54, kHalfPi3 = -0x1.f1976b7ed8fbcp-110;
constexpr Pair kLn2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

// The sine of a quarter's rest, `quarters` quarters of a turn further.
double sineAt(Pair rest, double quarters) {
    const double of = quarters - 4 * std::floor(quarters / 4);
    const Pair value = alternating(rest, of == 1 || of == 3 ? 0 : 1);
    return (of >= 2 ? -value.high : value.high) + 0.0; // no -0
}

Pair restOf(double radians, double quarters) {
    const Pair first = productOf(quarters, kHalfPi1), second = productOf(quarters, kHalfPi2);
    return sumOf(radians, -first.high) + Pair{-first.low, -quarters * kHalfPi3} + -second;
}

// e^x for |x| up to half of ln 2, from e^(x / 256).
Pair expOfSmall(Pair x) {
    constexpr int kHalvings = 8;
    const double scale = 1.0 / (1 << kHalvings);
    const Pair part{x.high * scale, x.low * scale};
    Pair sum{};
    for (std::size_t n = 12; n > 0; --n) sum = (sum + inverseFactorials()[n]) * part; // e^part - 1
    for (int i = 0; i < kHalvings; ++i) sum = sum * sum + Pair{2 * sum.high, 2 * sum.low};
    return sum + Pair{1, 0};
}

double expOf(Pair x) {
    constexpr double kMost = 709;
    if (std::isnan(x.high)) return x.high;
    if (x.high > kMost) return std::numeric_limits<double>::infinity();
    if (x.high < -kMost) return 0;
    const double twos = std::nearbyint(x.high / kLn2.high);
    const Pair rest = x + -(Pair{twos, 0} * kLn2);
    return std::ldexp(expOfSmall(rest).high, static_cast<int>(twos));
}

Pair logOf(double x) {
    int twos = 0;
    double rest = std::frexp(x, &twos); // .5 to 1
    if (rest < 0x1.6a09e667f3bcdp-1) {
        rest *= 2;
        --twos;
    }
    // From the 53 bits of the C library, one step of Newton's method gives twice as many: where they differ, the step does.
    const double near = std::log(rest);
    const Pair back = Pair{rest, 0} * expOfSmall({-near, 0}) + Pair{-1, 0};
    const Pair half = back * back * Pair{-0.5, 0};
    return Pair{static_cast<double>(twos), 0} * kLn2 + (Pair{near, 0} + (back + half));
}

} // namespace

double sin(double radians) {
    const double quarters = std::nearbyint(radians / kHalfPi1);
    return sineAt(restOf(radians, quarters), quarters);
}

double cos(double radians) {
    const double quarters = std::nearbyint(radians / kHalfPi1);
    return sineAt(restOf(radians, quarters), quarters + 1);
}

double exp(double x) { return expOf({x, 0}); }

double log(double x) { return logOf(x).high; }

double pow(double x, double exponent) { return x == 0 ? 0 : expOf(Pair{exponent, 0} * logOf(x)); }

} // namespace edgescan::portable
