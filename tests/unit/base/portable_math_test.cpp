// The portable functions compared with Boost's numbers of 113 bits.
#include "core/base/portable_math.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace edgescan;

namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

double rounded(const Quad& value) { return value.convert_to<double>(); }

} // namespace

TEST(PortableMath, IsTheDoubleNextToTheTrueValue) {
    std::mt19937_64 random(3);
    const auto between = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
    for (int n = 0; n < 3000; ++n) {
        const double angle = std::ldexp(between(-1000, 1000), n % 3 == 0 ? -(n % 60) : 0);
        EXPECT_EQ(portable::sin(angle), rounded(sin(Quad(angle)))) << angle;
        EXPECT_EQ(portable::cos(angle), rounded(cos(Quad(angle)))) << angle;
        const double x = between(-50, 50);
        EXPECT_EQ(portable::exp(x), rounded(exp(Quad(x)))) << x;
        const double y = std::exp(between(-30, 30));
        EXPECT_EQ(portable::log(y), rounded(log(Quad(y)))) << y;
        const double base = between(0.01, 10), exponent = between(0.1, 3);
        EXPECT_EQ(portable::pow(base, exponent), rounded(pow(Quad(base), Quad(exponent)))) << base << " ^ " << exponent;
    }
}

TEST(PortableMath, IsExactWhereTheResultIs) {
    EXPECT_EQ(portable::sin(0), 0);
    EXPECT_EQ(portable::cos(0), 1);
    EXPECT_EQ(portable::exp(0), 1);
    EXPECT_EQ(portable::log(1), 0);
    EXPECT_EQ(portable::pow(1, 0.7), 1);
    EXPECT_EQ(portable::pow(0, 0.7), 0);
    EXPECT_EQ(portable::exp(-1000), 0);
    EXPECT_EQ(portable::exp(1000), std::numeric_limits<double>::infinity());
    for (const double none : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_TRUE(std::isnan(portable::sin(none)));
        EXPECT_TRUE(std::isnan(portable::cos(none)));
    }
    EXPECT_TRUE(std::isnan(portable::exp(std::numeric_limits<double>::quiet_NaN())));
}
