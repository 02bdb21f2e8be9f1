// Every instruction set and every number of threads gives the same bytes: masks, classes, labels of rocks, text that is read, exports. Also
// with the narrowest loops of the libraries that choose theirs by the processor (OpenCV, the C library's mathematics).
#include "core/base/instruction_set.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <regex>
#include <sstream>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using test::fileText;

// The C library's functions without the instructions of newer processors: they round differently.
constexpr const char* kPlainMathematics = "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX,-AVX512F,-SSE4_1,-SSE4_2";

// An environment variable of the programs that a test starts.
class Variable {
public:
    Variable(const char* name, const std::string& value) : name_(name) { ::setenv(name, value.c_str(), 1); }
    ~Variable() { ::unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
};

std::vector<InstructionSet> setsHere() {
    std::vector<InstructionSet> sets;
    std::copy_if(kInstructionSets.begin(), kInstructionSets.end(), std::back_inserter(sets), isHere);
    return sets;
}

// What differs in the first line that is not the same.
std::string firstDifference(const std::string& a, const std::string& b) {
    std::istringstream one(a), other(b);
    std::string line, otherLine;
    while (std::getline(one, line)) {
        if (!std::getline(other, otherLine) || line != otherLine) return line + "\n" + otherLine;
    }
    return "one is longer";
}

std::string realScan(const std::string& name) {
    const fs::path path = test::sharedFolder() / "data" / name;
    return fs::exists(path) ? path.string() : "";
}

TEST(InstructionSets, GiveTheSameHashesAndSoDoOneTwoAndFourThreads) {
    const std::string arguments = "--quick " + realScan("lms200_corridor/scan000.json");
    const auto hashes = [&] {
        const Variable loops("EDGESCAN_LOOPS", "plain");
        const Variable mathematics("GLIBC_TUNABLES", kPlainMathematics);
        return test::runProgram("edgescan_edge_hashes", arguments);
    };
    const std::string expected = hashes().out;
    for (const InstructionSet set : setsHere()) {
        const Variable loops("EDGESCAN_LOOPS", nameOf(set));
        const auto run = test::runProgram("edgescan_edge_hashes", arguments);
        ASSERT_EQ(run.code, 0) << nameOf(set) << "\n" << run.err;
        EXPECT_EQ(run.out, expected) << nameOf(set) << "\n" << firstDifference(expected, run.out);
    }
    std::map<std::string, std::string> ofScan; // the hashes of a scan with any number of threads
    static const std::regex withThreads("(.*), ([124]) threads: (.*)");
    std::size_t compared = 0;
    std::istringstream lines(expected);
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (!std::regex_match(line, found, withThreads)) continue;
        const auto [first, isNew] = ofScan.emplace(found[1], found[3]);
        EXPECT_EQ(first->second, found[3]) << line;
        compared += isNew ? 0 : 1;
    }
    EXPECT_GE(compared, 2 * 20U);
}

// Organised points of a depth camera whose depth comes in steps: a ball before a wall, and a hole.
std::string cameraCloud() {
    constexpr int kLines = 90, kBeams = 120;
    std::ostringstream text;
    text << "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << kBeams << "\nHEIGHT " << kLines
         << "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << kLines * kBeams << "\nDATA ascii\n";
    for (int i = 0; i < kLines; ++i) {
        for (int j = 0; j < kBeams; ++j) {
            const double x = (j - 60) / 110.0, y = (i - 45) / 110.0;
            const double off = std::hypot(x - 0.1, y + 0.05);
            const double depth = off < 0.2 ? 2.0 - 2 * std::sqrt(0.04 - off * off) : 3.0 + 0.4 * x;
            const double z = 1 / (std::round(1 / depth * 700) / 700);
            if (i > 60 && i < 70 && j > 80 && j < 95)
                text << "nan nan nan\n";
            else
                text << x * z << ' ' << y * z << ' ' << z << '\n';
        }
    }
    return text.str();
}

Scan noise() {
    std::mt19937 random(3);
    return test::makeScan(70, 131, [&](int, int) { return random() % 9 == 0 ? 0.0 : 1000.0 + static_cast<double>(random() % 3000U); });
}

class EveryOutput : public testing::Test {
protected:
    // The scans are made once, by the widest loops.
    void SetUp() override {
        const auto simulate = [&](const std::string& name, const std::string& how) {
            const std::string path = (folder_ / name).string();
            ASSERT_EQ(test::runLab("simulate -o " + path + " " + how).code, 0);
            scans_.push_back(path);
        };
        simulate("sweep.json", "--seed 3 --lines 150 --beams 201 --slips 0.03 --dropouts 0.02");
        simulate("spin.csv", "--seed 4 --lines 120 --beams 171 --axis spin --scene pile --noise 3");
        simulate("interlaced.pcd", "--seed 5 --lines 110 --beams 163 --interlace 0.4 --status-codes 0.01");
        std::ofstream(folder_ / "camera.pcd") << cameraCloud();
        scans_.push_back((folder_ / "camera.pcd").string());
        ASSERT_TRUE(files::saveScan(noise(), folder_ / "noise.json"));
        scans_.push_back((folder_ / "noise.json").string());
        for (const char* real : {"lms200_corridor/scan000.json", "mosd_kinect/test16.pcd"}) {
            if (const std::string path = realScan(real); !path.empty()) scans_.push_back(path);
        }
    }

    // All outputs of these scans by name. Times and dates are the only bytes that may differ between two runs.
    std::map<std::string, std::string> outputs(const std::string& name, const std::vector<std::size_t>& scans) const {
        const fs::path to = folder_ / name;
        for (const std::size_t n : scans) {
            const std::string out = (to / std::to_string(n)).string(), scan = scans_[n] + " ";
            for (const std::string& line : {"detect " + scan + "-o " + out + "/plus --fill 6 --with-confidence --ascii",
                                            "detect " + scan + "-o " + out + "/thesis --preset thesis",
                                            "detect " + scan + "-o " + out + "/window --preset window --kernel 7",
                                            "detect " + scan + "-o " + out + "/log --method marr-hildreth",
                                            "detect " + scan + "--cloud " + out + "/all.csv --edges " + out + "/edges.las",
                                            "rocks " + scan + "-o " + out + "/rocks", "detect " + out + "/all.csv -o " + out + "/again"}) {
                const auto run = test::runCli(line);
                EXPECT_EQ(run.code, 0) << name << ": " << line << "\n" << run.err;
            }
        }
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(to)) {
            const std::string path = fs::relative(entry.path(), to).string();
            if (entry.is_directory() || path.ends_with(".provenance.json")) continue;
            files[path] = fileText(entry.path());
            if (!path.ends_with("_edges.json")) continue;
            auto report = nlohmann::json::parse(files[path]);
            report.erase("timings_ms");
            report.erase("input"); // of all.csv
            files[path] = report.dump();
        }
        return files;
    }

    test::TemporaryFolder folder_;
    std::vector<std::string> scans_;
};

// The widest set with every scan. The others with those that are read from text: GiveTheSameHashes compares what they compute.
TEST_F(EveryOutput, IsTheSameByEveryInstructionSetAndByPlainLibraries) {
    std::vector<std::size_t> every(scans_.size());
    std::iota(every.begin(), every.end(), 0U);
    const std::vector<std::size_t> ofText{1, 3};
    const auto expected = [&] {
        const Variable loops("EDGESCAN_LOOPS", "plain");
        const Variable mathematics("GLIBC_TUNABLES", kPlainMathematics);
        return outputs("libraries", every);
    }();
    EXPECT_GE(expected.size(), 30 * 5U);
    const std::vector<InstructionSet> sets = setsHere();
    for (const InstructionSet set : sets) {
        const Variable loops("EDGESCAN_LOOPS", nameOf(set));
        const bool isWidest = set == sets.back();
        const auto found = outputs(nameOf(set), isWidest ? every : ofText);
        EXPECT_TRUE(isWidest ? found.size() == expected.size() : found.size() >= 30 * ofText.size()) << nameOf(set) << found.size();
        for (const auto& [path, bytes] : found) {
            const auto same = expected.find(path);
            ASSERT_NE(same, expected.end()) << nameOf(set) << ": " << path;
            EXPECT_TRUE(same->second == bytes) << nameOf(set) << ": " << path;
        }
    }
}

TEST(InstructionSets, AnUnknownNameOrOneThatTheProcessorLacksIsAnError) {
    const test::TemporaryFolder folder;
    const Scan scan = test::boxesScan(20, 30, 3);
    ASSERT_TRUE(files::saveScan(scan, folder / "a.json"));
    const std::string detect = "detect " + (folder / "a.json").string();
    for (const std::string value : {"avx3", "AVX2", "plain ", "all", "1"}) {
        const Variable loops("EDGESCAN_LOOPS", value);
        for (const auto& run : {test::runCli(detect), test::runLab("--version"), test::runProgram("edgescan_edge_hashes", "--quick")}) {
            EXPECT_EQ(run.code, 2) << value;
            EXPECT_NE(run.err.find("EDGESCAN_LOOPS: this is not the name of an instruction set"), std::string::npos) << run.err;
            EXPECT_NE(run.err.find("set it to one of plain"), std::string::npos) << run.err;
            EXPECT_EQ(run.out, "");
        }
    }
    for (const InstructionSet set : kInstructionSets) {
        const Variable loops("EDGESCAN_LOOPS", nameOf(set));
        const auto run = test::runCli(detect);
        EXPECT_EQ(run.code, isHere(set) ? 0 : 2) << nameOf(set) << run.err;
        EXPECT_EQ(run.err.find("EDGESCAN_LOOPS: this processor has no") == std::string::npos, isHere(set)) << run.err;
    }
    const Variable loops("EDGESCAN_LOOPS", "");
    EXPECT_EQ(test::runCli(detect).code, 0);
}

} // namespace
} // namespace edgescan
