// Scans that come through standard input and pipes, compressed or not.
#include "tests/support/folders.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace edgescan {
namespace {

using test::TemporaryFolder;
using json = nlohmann::json;

/// A shell command with its output; $CLI is the path of the command line program.
test::ProgramRun runShell(const std::string& line) {
    const TemporaryFolder folder;
    const std::string command = "CLI=" + test::programFolder() + "/edgescan-cli; ( " + line + " ) >" + (folder / "out").string() + " 2>" +
                                (folder / "err").string();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), test::fileText(folder / "out"),
            test::fileText(folder / "err")};
}

TEST(Streams, AScanFromStandardInputIsTheScanOfTheFile) {
    const TemporaryFolder folder;
    const std::string scan = (folder / "scan.pcd").string();
    ASSERT_EQ(test::runLab("simulate --lines 40 --beams 60 -o " + scan).code, 0);
    const auto file = test::runCli("detect " + scan + " --json -");
    ASSERT_EQ(file.code, 0) << file.err;
    const json expected = json::parse(file.out);
    for (const std::string& line :
         {"cat " + scan + " | $CLI detect - --json -", "$CLI detect - --json - < " + scan, "gzip -c " + scan + " | $CLI detect - --json -",
          "cat " + scan + " | $CLI detect /dev/stdin --json -"}) {
        const auto piped = runShell(line);
        ASSERT_EQ(piped.code, 0) << line << ": " << piped.err;
        const json found = json::parse(piped.out);
        for (const char* key : {"lines", "beams", "cells", "edges", "edge_mask_sha256"}) EXPECT_EQ(found[key], expected[key]) << line;
    }
    const auto named = runShell("cat " + scan + " | $CLI detect - -o " + folder.path().string());
    EXPECT_EQ(named.code, 0) << named.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "stdin_edges.json"));
}

TEST(Streams, WhatIsNoScanIsRefusedWithASentence) {
    const auto none = runShell("$CLI info - < /dev/null");
    EXPECT_EQ(none.code, 1);
    EXPECT_NE(none.err.find("-: the file is empty"), std::string::npos) << none.err;
    const auto device = runShell("$CLI info - < /dev/zero");
    EXPECT_EQ(device.code, 1);
    EXPECT_NE(device.err.find("a device"), std::string::npos) << device.err;
    const auto wrong = runShell("printf 'hello world' | $CLI info -");
    EXPECT_EQ(wrong.code, 1);
    EXPECT_FALSE(wrong.err.empty());
    const auto endless = runShell("gzip -c /dev/zero | head -c 100000 | $CLI info -"); // a hundred megabytes of zeros
    EXPECT_EQ(endless.code, 1);
    EXPECT_NE(endless.err.find("far more than a scan of its size can be"), std::string::npos) << endless.err;
}

TEST(Streams, TwoScansOfOneNameAreRefusedBeforeAnythingIsWritten) {
    const TemporaryFolder folder;
    const std::string scan = (folder / "scan.pcd").string();
    ASSERT_EQ(test::runLab("simulate --lines 40 --beams 60 -o " + scan).code, 0);
    ASSERT_EQ(runShell("gzip -k " + scan).code, 0);
    EXPECT_EQ(test::runCli("detect " + scan + " " + scan + ".gz -o " + (folder / "out").string()).code, 2);
}

} // namespace
} // namespace edgescan
