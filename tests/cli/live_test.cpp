// serve, record and replay from outside: what is served, recorded and played again has the edges of the file.
#include "core/files/save_scan.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <sstream>
#include <thread>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;

// An emulated scanner in a process of its own, gone with the object.
class Served {
public:
    Served(const std::filesystem::path& folder, const std::string& arguments) : out_(folder / "serve.out") {
        const std::string command =
            "exec " + std::string(EDGESCAN_BIN_DIR) + "/edgescan-cli serve " + arguments + " --seconds 60 >" + out_.string() + " 2>&1";
        process_ = fork();
        if (process_ == 0) {
            execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            _exit(127);
        }
        for (int wait = 0; wait < 200 && test::fileText(out_).find('\n') == std::string::npos; ++wait)
            std::this_thread::sleep_for(std::chrono::milliseconds(25));
    }
    ~Served() {
        kill(process_, SIGTERM);
        waitpid(process_, nullptr, 0);
    }
    Served(const Served&) = delete;
    Served& operator=(const Served&) = delete;
    [[nodiscard]] std::string address() const {
        return "127.0.0.1:" + std::to_string(json::parse(test::fileText(out_))["port"].get<int>());
    }

private:
    std::filesystem::path out_;
    pid_t process_ = 0;
};

struct Live : public ::testing::Test {
    test::TemporaryFolder folder;
    std::string scan = (folder / "bell.json").string();

    void SetUp() override { ASSERT_EQ(runCli("simulate -o " + scan + " --lines 90 --beams 191 --axis spin").code, 0); }

    static std::string hashOf(const std::string& arguments) {
        const auto run = runCli("detect " + arguments + " --json -");
        EXPECT_EQ(run.code, 0) << run.err;
        return json::parse(run.out)["edge_mask_sha256"];
    }
};

TEST_F(Live, ServedRecordedAndPlayedAgainGivesTheMaskOfTheFile) {
    const std::string recording = (folder / "bell.mcap").string();
    {
        const Served served(folder.path(), scan + " --port 0 --rate 0");
        const auto record =
            runCli("record " + served.address() + " -o " + recording + " --line-step 2 --lines 90 --expected-lines 90 --seconds 30");
        ASSERT_EQ(record.code, 0) << record.err;
        const json summary = json::parse(record.out);
        EXPECT_EQ(summary["lines"], 90);
        EXPECT_TRUE(summary["lost_lines"].empty());
    }
    const std::string expected = hashOf(scan);
    EXPECT_EQ(hashOf(recording), expected);
    const auto replay = runCli("replay " + recording);
    ASSERT_EQ(replay.code, 0) << replay.err;
    std::istringstream lines(replay.out);
    int count = 0;
    json last;
    for (std::string line; std::getline(lines, line); ++count) last = json::parse(line);
    EXPECT_EQ(count, 91); // a line each, and the result
    EXPECT_EQ(last["result"]["edge_mask_sha256"], expected);
}

TEST_F(Live, LostLinesAreTold) {
    const std::string recording = (folder / "lossy.mcap").string();
    const Served served(folder.path(), scan + " --port 0 --rate 0 --lose-every 20 --split --merge --garbage-every 7");
    const auto record = runCli("record " + served.address() + " -o " + recording + " --lines 80 --expected-lines 90 --seconds 30");
    ASSERT_EQ(record.code, 0) << record.err;
    const json summary = json::parse(record.out);
    EXPECT_GE(summary["lost_lines"].size(), 3U);
    const json report = json::parse(runCli("info " + recording).out);
    EXPECT_GE(report["cells"]["lost"].get<int>(), 3 * 191);
    EXPECT_NE(report["warnings"].dump().find("INCOMPLETE"), std::string::npos) << report["warnings"];
}

TEST_F(Live, ARecordingOfASimulationOpensAsTheSameScan) {
    const std::string recording = (folder / "direct.mcap").string();
    ASSERT_EQ(runCli("simulate -o " + recording + " --lines 90 --beams 191 --axis spin").code, 0);
    EXPECT_EQ(hashOf(recording), hashOf(scan));
    ASSERT_EQ(runCli("convert " + scan + " " + (folder / "converted.mcap").string()).code, 0);
    EXPECT_EQ(hashOf((folder / "converted.mcap").string()), hashOf(scan));
}

TEST_F(Live, NobodyThereIsSaid) {
    const auto record = runCli("record 127.0.0.1:9 -o " + (folder / "none.mcap").string() + " --seconds 1");
    EXPECT_EQ(record.code, 1);
    EXPECT_NE(record.err.find("127.0.0.1:9"), std::string::npos) << record.err;
    EXPECT_EQ(runCli("record host:99999 -o " + (folder / "x.mcap").string()).code, 2);
    EXPECT_EQ(runCli("replay " + scan).code, 1);
}

} // namespace
} // namespace edgescan
