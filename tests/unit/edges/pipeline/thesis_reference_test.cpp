// The presets `thesis` and `window` against results computed independently with OpenCV on two real scans.
#include "core/base/sha256.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "core/files/open_save/open_scan.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <span>

namespace edgescan::edges {
namespace {

class Reference : public ::testing::TestWithParam<const char*> {};

TEST_P(Reference, EveryMaskIsIdentical) {
    const std::filesystem::path shared = EDGESCAN_SHARED_DIR;
    if (!std::filesystem::exists(shared)) GTEST_SKIP() << "../shared is absent: the reference masks cannot be compared";
    const std::string file = GetParam();
    const std::string stem = std::filesystem::path(file).stem();
    const Result<Scan> scan = files::openScan(shared / "data/lms200_corridor" / file);
    ASSERT_TRUE(scan) << scan.error().sentence();
    const auto reference = nlohmann::json::parse(std::ifstream(shared / "reference/thesis" / (stem + ".json")));
    EXPECT_EQ(countCells(*scan)[0], reference["valid"].get<std::size_t>());
    EXPECT_EQ(rangeLimits(*scan).minMm, reference["s_min_mm"].get<float>());
    EXPECT_EQ(rangeLimits(*scan).maxMm, reference["s_max_mm"].get<float>());

    Pipeline pipeline;
    const auto shareable = std::make_shared<const Scan>(*scan);
    ASSERT_EQ(reference["cases"].size(), 16U);
    for (const auto& expected : reference["cases"]) {
        Settings settings = findPreset(expected["gray"].get<std::string>())->settings;
        settings.kernel = expected["kernel"];
        settings.lower = expected["lower"];
        const auto detection = pipeline.run(shareable, settings);
        EXPECT_EQ(detection->edges->size(), expected["edges"].get<std::size_t>()) << expected;
        EXPECT_EQ(sha256Hex(std::as_bytes(std::span(detection->mask->cells))), expected["mask_sha256"].get<std::string>()) << expected;
    }
}

INSTANTIATE_TEST_SUITE_P(Corridor, Reference, ::testing::Values("scan000.json", "scan001.json", "scan000.3d", "scan001.3d"));

} // namespace
} // namespace edgescan::edges
