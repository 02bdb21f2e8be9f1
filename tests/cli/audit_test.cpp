// edgescan-cli audit from outside: it names the altered line, in words and as JSON.
#include "core/base/audit_log/audit_log.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;

TEST(CliAudit, NamesTheLineThatWasAltered) {
    const test::TemporaryFolder folder;
    const std::string path = (folder / "audit.jsonl").string();
    const AuditLog log(path);
    for (int n = 0; n < 4; ++n) ASSERT_TRUE(log.append("opened", {{"scan", "bell" + std::to_string(n)}}));
    const auto whole = runCli("audit " + path + " --json -");
    ASSERT_EQ(whole.code, 0) << whole.err;
    const json report = json::parse(whole.out);
    EXPECT_EQ(report["schema"], "edgescan-audit/1");
    EXPECT_EQ(report["lines"], 4);
    EXPECT_EQ(runCli("audit " + path + " --last " + report["last_sha256"].get<std::string>()).code, 0);
    EXPECT_EQ(runCli("audit " + path + " --last " + std::string(64, '0')).code, 3);
    std::string text = test::fileText(path);
    text.replace(text.find("bell2"), 5, "bell9");
    std::ofstream(path, std::ios::binary) << text;
    const auto altered = runCli("audit " + path);
    EXPECT_EQ(altered.code, 3);
    EXPECT_NE(altered.out.find("altered: line 3"), std::string::npos) << altered.out;
    EXPECT_EQ(json::parse(runCli("audit " + path + " --json -").out)["faults"][0]["line"], 3);
    EXPECT_EQ(runCli("audit " + (folder / "none").string()).code, 1);
}

} // namespace
} // namespace edgescan
