// A changed log reports the changed line; a crash does not count as a change; a full disk is an error.
#include "core/base/audit_log/audit_check.h"
#include "core/base/whole_file.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <thread>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> linesOf(const fs::path& path) {
    std::vector<std::string> lines;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

void writeLines(const fs::path& path, const std::vector<std::string>& lines) {
    std::ofstream file(path, std::ios::binary);
    for (const std::string& line : lines) file << line << '\n';
}

class Audit : public ::testing::Test {
protected:
    void SetUp() override {
        for (int n = 1; n <= 6; ++n)
            ASSERT_TRUE(log.append(n % 2 == 0 ? "exported" : "opened", {{"path", "/a \"b\"\n" + std::to_string(n)}}));
        lines = linesOf(log.path());
        ASSERT_EQ(lines.size(), 6U);
    }
    // The faults of these lines as "kind place n".
    [[nodiscard]] std::vector<std::string> faultsOf(const std::vector<std::string>& changed) const {
        writeLines(folder / "changed.jsonl", changed);
        const auto check = checkAudit(folder / "changed.jsonl");
        std::vector<std::string> faults;
        if (!check) return {check.error().sentence()};
        for (const AuditFault& fault : check->faults)
            faults.push_back(std::string(auditFaultName(fault.kind)) + " " + std::to_string(fault.place) + " " + std::to_string(fault.n));
        return faults;
    }
    using Faults = std::vector<std::string>;

    test::TemporaryFolder folder;
    AuditLog log{folder / "log" / "audit.jsonl"};
    std::vector<std::string> lines;
};

TEST_F(Audit, ALogAsItWasWrittenHasNoFault) {
    const auto check = checkAudit(log.path());
    ASSERT_TRUE(check);
    EXPECT_TRUE(check->faults.empty());
    EXPECT_EQ(check->lines, 6U);
    const auto last = auditLine(lines.back(), "");
    ASSERT_TRUE(last) << last.error().sentence();
    EXPECT_EQ(check->last, last->sha256);
    EXPECT_EQ(last->n, 6U);
    EXPECT_EQ(last->details["path"], "/a \"b\"\n6");
    EXPECT_EQ(auditText(*last), lines.back());
    EXPECT_FALSE(checkAudit(folder / "none.jsonl"));
}

TEST_F(Audit, TheLineThatWasAlteredIsNamed) {
    for (std::size_t at = 0; at < lines.size(); ++at) {
        for (std::size_t byte = 0; byte < lines[at].size(); byte += 7) {
            std::vector<std::string> changed = lines;
            changed[at][byte] = changed[at][byte] == '0' ? '1' : '0';
            EXPECT_EQ(faultsOf(changed), (Faults{"altered " + std::to_string(at + 1) + " " + std::to_string(at + 1)})) << byte;
        }
    }
    // With a matching hash: the next line reveals the change.
    auto forged = auditLine(lines[2], "");
    forged->details["path"] = "/other";
    std::vector<std::string> changed = lines;
    changed[2] = auditText(*forged);
    EXPECT_EQ(faultsOf(changed), Faults{"altered 3 3"});
}

TEST_F(Audit, LinesThatWereDroppedAreNamed) {
    for (std::size_t at = 0; at + 1 < lines.size(); ++at) {
        std::vector<std::string> changed = lines;
        changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(at));
        EXPECT_EQ(faultsOf(changed), (Faults{"dropped " + std::to_string(at + 1) + " " + std::to_string(at + 1)}));
    }
    EXPECT_EQ(faultsOf({lines[0], lines[4], lines[5]}), Faults{"dropped 2 2"});
    // The last line: its loss is detected only with a hash noted elsewhere.
    writeLines(folder / "short.jsonl", {lines[0], lines[1]});
    EXPECT_TRUE(checkAudit(folder / "short.jsonl")->faults.empty());
    const auto check = checkAudit(folder / "short.jsonl", auditLine(lines[5], "")->sha256);
    ASSERT_EQ(check->faults.size(), 1U);
    EXPECT_EQ(check->faults[0].kind, AuditFaultKind::Dropped);
    EXPECT_TRUE(checkAudit(log.path(), auditLine(lines[3], "")->sha256)->faults.empty());
}

TEST_F(Audit, LinesThatWereMovedAreNamed) {
    EXPECT_EQ(faultsOf({lines[0], lines[2], lines[1], lines[3], lines[4], lines[5]}), Faults{"moved 3 2"});
    EXPECT_EQ(faultsOf({lines[1], lines[2], lines[3], lines[4], lines[5], lines[0]}), Faults{"moved 6 1"});
    EXPECT_EQ(faultsOf({lines[0], lines[1], lines[1], lines[2], lines[3], lines[4], lines[5]}), Faults{"moved 3 2"});
    // Altered and dropped at the same time.
    std::vector<std::string> changed{lines[0], lines[1], lines[4], lines[5]};
    changed[1][3] = '9';
    EXPECT_EQ(faultsOf(changed), (Faults{"altered 2 2", "dropped 3 3"}));
}

TEST_F(Audit, ATornLineIsNoFaultWhenTheLogOwnsUpToIt) {
    const std::string torn = lines[3].substr(0, 40);
    std::ofstream(log.path(), std::ios::binary | std::ios::app) << torn;
    EXPECT_EQ(checkAudit(log.path())->faults.size(), 1U);
    ASSERT_TRUE(log.append("opened", {{"path", "/again"}}));
    const auto check = checkAudit(log.path());
    EXPECT_TRUE(check->faults.empty()) << check->faults[0].sentence;
    EXPECT_EQ(check->recovered, 1U);
    EXPECT_EQ(check->lines, 8U);
    EXPECT_EQ(linesOf(log.path())[6], torn); // it is still there
}

TEST_F(Audit, SeveralWritersKeepOneChain) {
    std::vector<std::thread> writers;
    for (int w = 0; w < 4; ++w) {
        writers.emplace_back([this] {
            for (int n = 0; n < 10; ++n) EXPECT_TRUE(AuditLog(log.path()).append("opened", {{"n", n}}));
        });
    }
    for (std::thread& writer : writers) writer.join();
    const auto check = checkAudit(log.path());
    EXPECT_TRUE(check->faults.empty());
    EXPECT_EQ(check->lines, 46U);
}

TEST_F(Audit, WhatCannotBeWrittenIsSaid) {
    const auto full = AuditLog("/dev/full").append("opened", {});
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().sentence().find("not noted"), std::string::npos) << full.error().sentence();
    EXPECT_FALSE(AuditLog(folder.path()).append("opened", {}));
    // A file that is not a log is not written to.
    ASSERT_TRUE(writeWholeFile(folder / "other.txt", std::string("hello\n")));
    EXPECT_FALSE(AuditLog(folder / "other.txt").append("opened", {}));
    EXPECT_EQ(test::fileText(folder / "other.txt"), "hello\n");
}

} // namespace
} // namespace edgescan
