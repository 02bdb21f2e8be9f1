// Tables of settings: a row describes one number of a struct. Flags, JSON, help, Python and sliders read the rows.
#pragma once

#include "core/base/physical_limits.h"

#include <cmath>
#include <concepts>

namespace edgescan {

template <class T>
struct TableRow {
    const char* key;   ///< flag name without "--", key in presets and records
    const char* label; ///< label of the slider
    const char* unit;  ///< "" if it has none
    const char* help;  ///< one sentence
    double minimum;
    double maximum;
    double step;  ///< of the slider
    int decimals; ///< 0: whole numbers
    double (*get)(const T&);
    void (*set)(T&, double);

    [[nodiscard]] constexpr NumberLimits limits() const { return {minimum, maximum}; }
};

template <class Member>
void assignNumber(Member& member, double value) {
    if constexpr (std::same_as<Member, int>)
        member = static_cast<int>(std::lround(value));
    else
        member = static_cast<Member>(value);
}

// The functions get and set of a row: of any expression, or of one member of T.
#define EDGESCAN_NUMBER_OF(T, expression, member)                                                                                          \
    [](const T& s) { return static_cast<double>(expression); }, [](T& s, double value) { assignNumber(s.member, value); }
#define EDGESCAN_NUMBER(T, member) EDGESCAN_NUMBER_OF(T, s.member, member)

} // namespace edgescan
