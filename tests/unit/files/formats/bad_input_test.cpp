// Whatever is opened, the result is a scan or one sentence: never a crash, a hang, a huge allocation or half a scan.
#include "core/base/memory.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/text_refusals.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <random>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// Opens the file; if that works, every cell must be accounted for.
bool opensSoundly(const std::filesystem::path& path) {
    const auto scan = openScan(path);
    if (!scan) {
        const std::string sentence = scan.error().sentence();
        EXPECT_TRUE(sentence.ends_with(".")) << sentence;
        EXPECT_NE(sentence.find(path.stem().string()), std::string::npos) << sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
        return false;
    }
    EXPECT_EQ(scan->rangeMm.size(), scan->state.size());
    EXPECT_EQ(scan->rangeMm.size(), static_cast<std::size_t>(scan->lines()) * static_cast<std::size_t>(scan->beams()));
    const auto counts = countCells(*scan);
    std::size_t sum = 0;
    for (const std::size_t count : counts) sum += count;
    EXPECT_EQ(sum, scan->cells());
    if (const auto* polar = std::get_if<PolarGeometry>(&scan->geometry)) {
        EXPECT_EQ(polar->lineDeg.size(), static_cast<std::size_t>(scan->lines()));
        EXPECT_EQ(polar->beamDeg.size(), static_cast<std::size_t>(scan->beams()));
        for (const double angle : polar->lineDeg) EXPECT_TRUE(std::isfinite(angle));
        for (const double angle : polar->beamDeg) EXPECT_TRUE(std::isfinite(angle));
    }
    for (std::size_t k = 0; k < scan->cells(); ++k) {
        if (scan->state[k] == CellState::Valid) {
            EXPECT_TRUE(std::isfinite(scan->rangeMm[k]));
        }
    }
    return true;
}

std::string refusal(const std::filesystem::path& path) {
    const auto scan = openScan(path);
    return scan ? "opened" : scan.error().sentence();
}

void expectRefused(const std::filesystem::path& path, const std::string& expected) {
    const std::string sentence = refusal(path);
    EXPECT_NE(sentence.find(expected), std::string::npos) << sentence;
}

struct Small {
    std::string name, text;
};
std::vector<Small> corpus(const Folder& folder) {
    const Scan scan = makeScan({.lines = 5, .beams = 9});
    std::vector<Small> files;
    for (const char* name : {"a.pcd", "b.ply", "c.xyz", "d.csv", "e.json"}) {
        EXPECT_TRUE(saveScan(scan, folder / name));
        files.push_back({name, readText(folder / name)});
    }
    for (const char* name : {"f.pcd", "g.ply"}) {
        EXPECT_TRUE(saveScan(scan, folder / name, {true}));
        files.push_back({name, readText(folder / name)});
    }
    files.push_back({"h.xyz", textOf(listOf(scan, {}), {})});
    files.push_back({"i.3d", textOf(listOf(scan, {.perMetre = 100}), {})});
    std::string table;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 20; ++j) table += std::to_string(1000 + i + j) + (j < 19 ? "," : "\n");
    }
    files.push_back({"j.csv", table});
    return files;
}

} // namespace

TEST(BadInput, TruncatedAnywhere) {
    const Folder folder;
    for (const Small& file : corpus(folder)) {
        SCOPED_TRACE(file.name);
        const std::size_t stride = std::max<std::size_t>(1, file.text.size() / 300);
        for (std::size_t length = 0; length < file.text.size(); length += length < 400 ? 1 : stride) {
            writeText(folder / file.name, file.text.substr(0, length));
            opensSoundly(folder / file.name);
        }
    }
}

TEST(BadInput, RandomlyDamaged) {
    const Folder folder;
    std::mt19937 random(11);
    for (const Small& file : corpus(folder)) {
        SCOPED_TRACE(file.name);
        for (int round = 0; round < 400; ++round) {
            std::string text = file.text;
            for (auto flips = 1 + random() % 6; flips > 0; --flips) {
                const std::size_t at = random() % (round % 2 == 0 ? text.size() : std::min<std::size_t>(text.size(), 600));
                if (round % 3 == 0)
                    text[at] = static_cast<char>(random());
                else if (round % 3 == 1)
                    text[at] = "0123456789-e.{}[],\" \n"[random() % 21];
                else
                    text.erase(at, 1 + random() % 5);
                if (text.empty()) break;
            }
            writeText(folder / file.name, text);
            opensSoundly(folder / file.name);
        }
    }
}

TEST(BadInput, RandomBytesUnderEveryName) {
    const Folder folder;
    std::mt19937 random(5);
    for (const Format& format : formats()) {
        for (const std::string extension : format.reads) {
            for (int round = 0; round < 10; ++round) {
                std::string bytes(1 + random() % 3000, '\0');
                for (char& byte : bytes) byte = static_cast<char>(random());
                writeText(folder / ("noise" + extension), bytes);
                EXPECT_FALSE(opensSoundly(folder / ("noise" + extension)));
            }
        }
    }
}

TEST(BadInput, RawGridsThatLie) {
    const Folder folder;
    const std::string angles = R"("beam_deg":{"start":0,"step":1},"line_deg":{"start":0,"step":1},"axis":"spin"})";
    const auto with = [&](const std::string& json, const std::string& expected) {
        writeText(folder / "grid.json", json);
        expectRefused(folder / "grid.json", expected);
    };
    writeText(folder / "grid.u16", "123456");
    const std::string head = R"({"format":"edgescan-raw-grid/1","data":"grid.u16",)";
    with(head + R"("lines":1000000000,"beams":1000000000,)" + angles,
         "holds 6 bytes where 1000000000 lines x 1000000000 beams need 2000000000000000000");
    with(head + R"("lines":1e30,"beams":3,)" + angles, "a number out of all reason");
    with(head + R"("lines":1e999,"beams":3,)" + angles, "grid.json");
    with(head + R"("lines":-1,"beams":3,)" + angles, "\"lines\" must be a whole number from 1");
    with(head + R"("lines":1.5,"beams":3,)" + angles, "\"lines\" must be a whole number");
    with(head + R"("lines":"1","beams":3,)" + angles, "\"lines\" holds text where a number is needed");
    with(head + R"("beams":3,)" + angles, "\"lines\" is missing");
    with(head + R"("lines":1,"beams":3,"axis":"spin"})", "\"beam_deg\" is missing");
    with(head + R"("lines":1,"beams":3,"beam_deg":[1,2],"line_deg":[0],"axis":"spin"})", "\"beam_deg\" holds 2 angles, 3 are needed");
    with(head + R"("lines":1,"beams":3,"beam_deg":[1,2,"3"],"line_deg":[0],"axis":"spin"})",
         "\"beam_deg\" holds text where a number is needed");
    with(head + R"("lines":1,"beams":3,"beam_deg":{"start":1},"line_deg":[0],"axis":"spin"})", "needs start and step");
    with(head + R"("lines":1,"beams":3,"beam_deg":[1,2,3],"line_deg":[0],"axis":"roll"})", "must be \"spin\" or \"sweep\"");
    with(head + R"("lines":1,"beams":3,"unit_mm":0,)" + angles, "\"unit_mm\" must be greater than 0");
    with(head + R"("lines":1,"beams":3,"state_runs":[["lost",1,3]],)" + angles, "leaves the grid");
    with(head + R"("lines":1,"beams":3,"no_return":7,)" + angles, "must be a list");
    with(R"({"format":"edgescan-raw-grid/1","data":"../../../etc/passwd","lines":1,"beams":3,)" + angles,
         "must name a file in the same folder");
    with(R"({"format":"something-else/9","lines":1,"beams":3})", "not \"edgescan-raw-grid/1\"");
    with(R"({"lines":1,"beams":3})", "\"format\" is missing");
    with(R"({"lines":1,)", "damaged or cut off");
    with("{}", "\"format\" is missing");
    with(R"({"a":)" + std::string(200000, '[') + std::string(200000, ']') + "}", "nested too deep");
    with(head + R"("lines":1,"beams":3,)" + angles, "opened");
    writeText(folder / "grid.u16", "1234567");
    expectRefused(folder / "grid.json", "holds 7 bytes where 1 lines x 3 beams need 6");
    std::filesystem::remove(folder / "grid.u16");
    expectRefused(folder / "grid.json", "grid.u16: there is no such file");
    writeText(folder / "alone.u16", "123456");
    expectRefused(folder / "alone.u16", "need their description alone.json");
}

TEST(BadInput, WhatIsNoScanIsNamed) {
    const Folder folder;
    expectRefused(folder / "missing.pcd", "there is no such file");
    expectRefused(folder.path(), "this is a folder");
    writeText(folder / "empty.pcd", "");
    expectRefused(folder / "empty.pcd", "the file is empty");
    writeText(folder / "picture.xyz", std::string("\x89PNG\r\n\x1a\n\0\0\0", 11));
    expectRefused(folder / "picture.xyz", "a PNG picture");
    expectRefused("/bin/sh", "a program");
    expectRefused("/dev/zero", "a device or a pipe");
    writeText(folder / "drawing.dxf", "999\nfrom CAD\n  0\nSECTION\n  2\nENTITIES\n");
    expectRefused(folder / "drawing.dxf", "this is a drawing (DXF)");
    writeText(folder / "rocks.csv", "rock,line,beam,cells,x_m,y_m,z_m,in_front_of\n1,7,9,100,1.5,2.5,3.5,93 104\n");
    expectRefused(folder / "rocks.csv", "this is a table of rocks");
    writeText(folder / "wide.txt", std::string("\xFF\xFEx\0y\0z\0", 8));
    expectRefused(folder / "wide.txt", "UTF-16");
    std::filesystem::create_symlink("loop.pcd", folder / "loop.pcd");
    EXPECT_FALSE(openScan(folder / "loop.pcd"));
}

TEST(BadInput, AQuoteThatIsNotClosedEnds) {
    const Folder folder;
    for (const char* text : {"x,y,z,note\n1,2,3,\"open\n", "\"x,y,z\n1,2,3\n", "x,y,z,note\n1,2,3,\"a\"\"\n", "# {\"a\":\"b\n\"\n"}) {
        writeText(folder / "quote.csv", text);
        EXPECT_FALSE(openScan(folder / "quote.csv")) << text;
    }
}

TEST(BadInput, TheListOfWhatCanBeChosenNamesEveryFormat) {
    const std::string list = asciiLower(kChooseScan);
    for (const Format& format : formats()) {
        const auto isNamed = [&](std::string_view extension) { return list.find(extension.substr(1)) != std::string::npos; };
        if (format.read == nullptr || format.reads.empty()) continue;
        const std::string_view first = format.reads.front();
        EXPECT_TRUE(first == ".bin" || std::ranges::any_of(format.reads, isNamed)) << format.title;
    }
}

TEST(BadInput, MissingRightsAreSaid) {
    const Folder folder;
    const Scan scan = makeScan({});
    ASSERT_TRUE(saveScan(scan, folder / "locked.pcd"));
    std::filesystem::permissions(folder / "locked.pcd", std::filesystem::perms::none);
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
    const bool root = ::geteuid() == 0; // root may read everything, so another user tries
    if (root && ::seteuid(65534) != 0) GTEST_SKIP() << "cannot become another user";
    const std::string reading = refusal(folder / "locked.pcd");
    const auto written = saveScan(scan, folder / "new.pcd");
    if (root) {
        ASSERT_EQ(::seteuid(0), 0);
    }
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
    EXPECT_NE(reading.find("reading this file is not allowed"), std::string::npos) << reading;
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().sentence().find("writing here is not allowed"), std::string::npos) << written.error().sentence();
}

TEST(BadInput, NamesOfAnyLanguageWork) {
    const Folder folder;
    const Scan scan = makeScan({});
    for (const char* name : {"Döner 岩 scan.pcd", "Größe.json", "пик.csv", "with 'quotes' \"and\" blanks.ply"}) {
        const auto saved = saveScan(scan, folder / name);
        ASSERT_TRUE(saved) << saved.error().sentence();
        const auto opened = openScan(folder / name);
        ASSERT_TRUE(opened) << opened.error().sentence();
        EXPECT_EQ(opened->rangeMm, scan.rangeMm);
        EXPECT_EQ(opened->name, std::filesystem::path(name).stem().string());
    }
}

TEST(BadInput, ExtensionIsOnlyAHint) {
    const Folder folder;
    const Scan scan = makeScan({});
    ASSERT_TRUE(saveScan(scan, folder / "scan.pcd"));
    for (const char* name : {"scan.ply", "scan.xyz", "scan", "scan.json", "scan.PCD"}) {
        std::filesystem::copy_file(folder / "scan.pcd", folder / name);
        const auto opened = openScan(folder / name);
        ASSERT_TRUE(opened) << opened.error().sentence();
        EXPECT_EQ(opened->format, "PCD");
    }
}

TEST(BadInput, MemoryIsAskedBeforeItIsTaken) {
    EXPECT_GT(availableMemoryBytes(), 1U << 20U);
    const auto refused = checkMemory(std::uint64_t{1} << 60U, "x.pcd");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("x.pcd: needs 1.2 EB of memory, "), std::string::npos) << refused.error().sentence();
    EXPECT_EQ(sizeText(12), "12 bytes");
    EXPECT_EQ(sizeText(162720), "162.7 kB");
    EXPECT_EQ(sizeText(999999999), "1.0 GB");
    // A sparse file as large as a disk
    const Folder folder;
    writeText(folder / "huge.xyz", "1 2 3\n");
    std::filesystem::resize_file(folder / "huge.xyz", std::uintmax_t{1} << 42U);
    expectRefused(folder / "huge.xyz", "needs 4.4 TB of memory");
}
