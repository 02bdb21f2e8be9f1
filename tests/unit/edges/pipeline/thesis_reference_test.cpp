// The presets `thesis` and `window` against results computed independently with OpenCV, on a scan of the project's own and on two real
// ones.
#include "core/base/sha256.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "core/files/open_save/open_scan.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <span>

namespace edgescan::edges {
namespace {

void expectReference(const std::filesystem::path& file, const std::filesystem::path& referenceFile) {
    const Result<Scan> scan = files::openScan(file);
    ASSERT_TRUE(scan) << scan.error().sentence();
    const auto reference = nlohmann::json::parse(std::ifstream(referenceFile));
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

TEST(Reference, EveryMaskOfTheProjectsOwnScanIsIdentical) {
    const std::filesystem::path thesis = test::ownData() / "thesis";
    expectReference(thesis / "steps.json", thesis / "reference.json");
}

TEST(Reference, EveryMaskOfTwoRealScansIsIdentical) {
    EDGESCAN_NEEDS_SHARED("reference/thesis");
    for (const std::string stem : {"scan000", "scan001"}) {
        for (const char* extension : {".json", ".3d"})
            expectReference(test::sharedFolder() / "data/lms200_corridor" / (stem + extension),
                            test::sharedFolder() / "reference/thesis" / (stem + ".json"));
    }
}

} // namespace
} // namespace edgescan::edges
