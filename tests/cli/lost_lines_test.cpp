// Recordings whose counters jump: few bytes that claim many lost lines. What they cost is bounded, whatever they claim.
#include "tests/support/folders.h"
#include "tests/support/live_lines.h"
#include "tests/support/run_program.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>

namespace edgescan {
namespace {

/// Runs edgescan-cli with at most so much memory of its own (code and libraries do not count).
test::ProgramRun runWithin(int megabytes, const std::string& arguments) {
    const test::TemporaryFolder folder;
    const std::string out = (folder / "out").string(), err = (folder / "err").string();
    const std::string limit = "ulimit -d " + std::to_string(megabytes * 1024) + "; ";
    const int status =
        std::system((limit + test::programFolder() + "/edgescan-cli " + arguments + " >" + out + " 2>" + err + " </dev/null").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), test::fileText(out), test::fileText(err)};
}

struct Claim {
    int telegrams, beams, apart;
};

/// Telegrams with beams of 0.01 degrees, `apart` lines from one to the next.
void writeRecording(const std::filesystem::path& path, const Claim& claim) {
    std::vector<files::RecordingMessagePtr> messages;
    for (int n = 0; n < claim.telegrams; ++n)
        messages.push_back(test::lineMessage(n * claim.apart, {.beams = claim.beams, .startAngle = -50000, .step = 100}));
    ASSERT_TRUE(files::saveMessages(path, {}, messages));
}

// Each command needs a fixed amount, and so much per byte of the file; `why` no more than `detect`.
TEST(LostLines, CostMemoryInProportionToTheFile) {
    const test::TemporaryFolder folder;
    const std::vector<Claim> claims{{21, 100, 997}, {21, 1141, 997}, {3, 1141, 1999}, {6, 1400, 1999}, {60, 571, 500}, {400, 30, 1999}};
    for (const Claim& claim : claims) {
        const std::string recording = (folder / (std::to_string(claim.telegrams) + "x" + std::to_string(claim.beams) + ".mcap")).string();
        ASSERT_NO_FATAL_FAILURE(writeRecording(recording, claim));
        const auto perFile = static_cast<int>(std::filesystem::file_size(recording) * 100 / 1'000'000);
        for (const auto& [command, megabytes] : {std::pair{"info", 110}, {"detect", 160}, {"why --cell 0,10", 160}, {"thumbnail", 110}}) {
            const bool picture = std::string(command) == "thumbnail";
            const std::string asked = std::string(command) + ' ' + recording + (picture ? ' ' + (folder / "small.png").string() : "");
            const auto run = runWithin(megabytes + perFile, asked);
            EXPECT_EQ(run.code, 0) << asked << ": " << run.err;
        }
    }
}

TEST(LostLines, TheFilesOfTheSharedFolder) {
    EDGESCAN_NEEDS_SHARED("data/hostile");
    const std::filesystem::path hostile = test::sharedFolder() / "data/hostile";
    for (const char* name : {"lost_lines_100.mcap", "lost_lines_1141.mcap"}) {
        for (const char* command : {"detect ", "why --cell 0,10 "}) {
            const auto run = runWithin(170, command + (hostile / name).string());
            EXPECT_EQ(run.code, 0) << name << ": " << run.err;
        }
    }
}

} // namespace
} // namespace edgescan
