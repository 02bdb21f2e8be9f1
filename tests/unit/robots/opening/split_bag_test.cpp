// Bags that rosbag2 split into several files are one scan; what is missing or damaged is named.
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/topics_of_file.h"
#include "core/robots/sweeps/bag_folder.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <fstream>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::robots;
using namespace edgescan::test;

namespace {

constexpr int kParts = 12; // more than ten: "bell_10" is behind "bell_9"
constexpr int kLines = 120, kBeams = 60;

Scan sentScan() {
    Scan scan = boxesScan(kLines, kBeams, 3, 0.05);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.axis = Axis::Sweep;
    for (int i = 0; i < kLines; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = 0.5 * i;
    return scan;
}

void write(const std::filesystem::path& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// The messages of one of the parts, by their time; every part has all topics.
RosMessages partOf(const RosMessages& all, int part) {
    const std::int64_t first = kRosStartNs - 4 * kRosLineNs, whole = (kLines + 8) * kRosLineNs;
    RosMessages some;
    some.topics = all.topics;
    for (const RosMessages::Message& message : all.messages) {
        if ((message.ns - first) * kParts / whole == part) some.messages.push_back(message);
    }
    return some;
}

std::string nameOf(int part, const std::string& extension) { return "bell_" + std::to_string(part) + extension; }

/// A folder of a bag; old ones list their files with the folder's name.
void writeBag(const std::filesystem::path& folder, const std::string& extension, bool old) {
    const RosMessages all = rosMessagesOf(sentScan(), {.wire = Wire::CdrLittle});
    std::filesystem::create_directories(folder);
    std::string listed;
    for (int part = 0; part < kParts; ++part) {
        const RosMessages some = partOf(all, part);
#ifdef EDGESCAN_TESTS_SQLITE
        write(folder / nameOf(part, extension), extension == ".mcap" ? mcapOf(some) : databaseOf(some));
#else
        write(folder / nameOf(part, extension), mcapOf(some));
#endif
        listed += (old ? "    - " + folder.filename().string() + "/" : "    - ") + nameOf(part, extension) + "\n";
    }
    std::ofstream(folder / "metadata.yaml") << "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n"
                                               "  relative_file_paths:\n"
                                            << listed << "  duration:\n    nanoseconds: 1\n  files:\n    - path: other.mcap\n";
}

bool warns(const std::vector<std::string>& warnings, std::string_view words) {
    return std::ranges::any_of(warnings, [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

std::vector<std::string> extensions() {
#ifdef EDGESCAN_TESTS_SQLITE
    return {".mcap", ".db3"};
#else
    return {".mcap"};
#endif
}

} // namespace

TEST(SplitBag, IsOneScanHoweverItIsOpened) {
    const Scan sent = sentScan();
    for (const std::string& extension : extensions()) {
        const TemporaryFolder folder;
        const std::filesystem::path bag = folder / "bell";
        writeBag(bag, extension, extension == ".db3");
        std::string sha256;
        for (const std::filesystem::path& asked : {bag, bag / "metadata.yaml"}) {
            const auto scan = openScan(asked);
            ASSERT_TRUE(scan) << scan.error().sentence();
            EXPECT_EQ(scan->rangeMm, sent.rangeMm);
            EXPECT_EQ(scan->state, sent.state);
            EXPECT_EQ(scan->name, "bell");
            EXPECT_EQ(scan->path, (bag / "metadata.yaml").string());
            EXPECT_FALSE(warns(scan->warnings, "part"));
            sha256 = scan->sha256;
        }
        const auto listing = topicsOfFile(bag);
        ASSERT_TRUE(listing && *listing);
        EXPECT_EQ((*listing)->topics.at(0).messages, static_cast<std::size_t>(kLines));
        const auto part = openScan(bag / nameOf(3, extension));
        ASSERT_TRUE(part) << part.error().sentence();
        EXPECT_TRUE(warns(part->warnings, "This file is part 4 of 12 of a bag. Open " + (bag / "metadata.yaml").string()));
        std::filesystem::remove(bag / "metadata.yaml"); // as a recorder leaves it that was killed
        const auto scan = openScan(bag);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, sent.rangeMm);
        EXPECT_EQ(scan->sha256, sha256);
    }
}

TEST(SplitBag, MissingAndDamagedPartsAreNamedAndTheRestIsThere) {
    for (const std::string& extension : extensions()) {
        const TemporaryFolder folder;
        const std::filesystem::path bag = folder / "bell";
        writeBag(bag, extension, false);
        std::filesystem::remove(bag / nameOf(4, extension));
        write(bag / nameOf(7, extension), Bytes(3000, 'x'));
        write(bag / nameOf(8, extension), {});
        const auto scan = openScan(bag);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_TRUE(warns(scan->warnings, "The part " + nameOf(4, extension) + " of the bag is missing"));
        EXPECT_TRUE(warns(scan->warnings, "The part " + nameOf(7, extension) + " of the bag could not be read"));
        EXPECT_TRUE(warns(scan->warnings, "The part " + nameOf(8, extension) + " of the bag could not be read (the file is empty"));
        ASSERT_EQ(scan->lines(), kLines);
        const auto cells = countCells(*scan);
        const auto lost = static_cast<int>(cells[static_cast<std::size_t>(CellState::Lost)]) / kBeams;
        EXPECT_NEAR(lost, 3 * kLines / kParts, 4);
        for (int part = 0; part < kParts; ++part) write(bag / nameOf(part, extension), Bytes(3000, 'x'));
        EXPECT_NE(openScan(bag).error().sentence().find("bell"), std::string::npos);
    }
}

TEST(SplitBag, EntriesThatAreNoFilesOfMessagesAreNamed) {
    const TemporaryFolder folder;
    const std::filesystem::path bag = folder / "bell";
    writeBag(bag, ".mcap", false);
    std::string list;
    std::getline(std::ifstream(bag / "metadata.yaml"), list, '\0');
    const std::string key = "relative_file_paths:\n";
    std::ofstream(bag / "metadata.yaml") << list.insert(list.find(key) + key.size(), "    - notes.txt\n");
    const auto scan = openScan(bag);
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(warns(scan->warnings, "metadata.yaml names notes.txt"));
    std::ofstream(folder / "metadata.yaml") << key << "    - notes.txt\n    - gone_0.mcap\n";
    const auto none = openScan(folder.path());
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().sentence().find("no file of messages that metadata.yaml names"), std::string::npos) << none.error().sentence();
}

TEST(SplitBag, APipeInPlaceOfTheListHangsNothing) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "metadata.yaml").c_str(), 0600), 0);
    const auto bag = robots::filesOfBag(folder.path());
    ASSERT_TRUE(bag) << bag.error().sentence();
    EXPECT_EQ(bag->path, folder.path());
}

TEST(SplitBag, FilesOfSeveralBagsAreNotOne) {
    const TemporaryFolder folder;
    const RosMessages all = rosMessagesOf(sentScan());
    write(folder / "monday.bag", bag1Of(all));
    write(folder / "tuesday.bag", bag1Of(all));
    const auto refused = openScan(folder.path());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("monday.bag"), std::string::npos) << refused.error().sentence();
}
