// edgescan-cli compare A B: how many edges of one scan another of the same place has too.
#pragma once

#include "app/shared/options.h"
#include "core/lab/peers/comparison.h"

#include <string>
#include <vector>

namespace edgescan::cli {

struct CompareTwo {
    std::vector<std::string> files; ///< two
    std::vector<std::string> poses; ///< two of 3DTK, or none: then both scans need a place in the mine
    std::string json;               ///< file, "-" or empty
    bool refine = false;
    double radiusM = 0.1;
    lab::ComparisonSettings settings;
    ReadFlags read;
};

Result<Done> compareTwo(const CompareTwo& asked, const lab::ComparisonProgress& progress);

} // namespace edgescan::cli
