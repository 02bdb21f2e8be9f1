// Finds the name with the fewest letters that differ.
#include "core/base/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <string_view>

namespace edgescan {
namespace {

/// The smallest number of letters to insert, delete or replace.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0U : 1U);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::string nearestName(const std::string& typed, const std::vector<std::string>& known) {
    constexpr std::size_t kLongestName = 40;
    if (typed.size() > kLongestName) return {};
    std::string best;
    std::size_t least = 1 + std::max<std::size_t>(1, typed.size() / 3);
    for (const std::string& name : known) {
        const std::size_t distance = name.starts_with(typed) ? 1 : editDistance(typed, name);
        if (distance >= least) continue;
        least = distance;
        best = name;
    }
    return best;
}

} // namespace edgescan
