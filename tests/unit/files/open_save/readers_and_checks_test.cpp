// Every reader of points against every check that they share: one small scan in each format, with one fault at a time.
#include "core/files/open_save/open_scan.h"
#include "tests/support/bytes.h"
#include "tests/support/e57_writer.h"
#include "tests/support/point_files.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <functional>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

constexpr std::size_t kGridLines = 24, kGridBeams = 28;

/// How the points are laid out: lines x beams of an organised cloud, by line.
struct Layout {
    std::size_t rows = kGridLines, columns = kGridBeams;
};

struct Reader {
    const char* name;
    const char* extension;
    std::string (*bytes)(const Points&, const Layout&);
    bool text = true;       ///< line ends and marks of byte order may be odd
    bool organised = false; ///< the file says how many rows and columns there are
    bool unit = false;      ///< the file says its unit
    bool several = false;   ///< a file may hold several scans
};

std::string rowsOf(const Points& points, const char* separator = " ", const char* before = "", const char* behind = "\n") {
    std::string text;
    for (const Eigen::Vector3d& p : points) text += before + textOf({p}, {.format = "%.7f", .separator = separator, .lineEnd = behind});
    return text;
}

std::string ptxOf(const Points& points, const Layout& layout) {
    return std::to_string(layout.rows) + "\n" + std::to_string(layout.columns) +
           "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n" + rowsOf(points, " ", "", " 0.5\n");
}

std::string pcdHead(const Layout& layout, const char* size, const char* data) {
    const std::string n = std::to_string(layout.rows * layout.columns);
    return std::string("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE ") + size + "\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
           std::to_string(layout.columns) + "\nHEIGHT " + std::to_string(layout.rows) + "\nPOINTS " + n + "\nDATA " + data + "\n";
}

std::string doublesOf(const Points& points) {
    std::string bytes;
    for (const Eigen::Vector3d& p : points)
        for (int axis = 0; axis < 3; ++axis) appendValue(bytes, p[axis]);
    return bytes;
}

std::string plyHead(const Points& points, const char* format) {
    return std::string("ply\nformat ") + format + " 1.0\nelement vertex " + std::to_string(points.size()) +
           "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
}

std::string surpacOf(const Points& points, const Layout&) {
    std::string text = "bell,21-Nov-26,,\n0, 0.000, 0.000, 0.000, 0.000, 0.000, 0.000\n";
    for (const Eigen::Vector3d& p : points) text += "1, " + rowsOf({{p.y(), p.x(), p.z()}}, ", ", "", ",\n");
    return text + "0, 0.000, 0.000, 0.000,\n0, 0.000, 0.000, 0.000, END\n";
}

std::string npyOf(const Points& points, const Layout& layout) {
    std::string head = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(layout.rows) + ", " +
                       std::to_string(layout.columns) + ", 3), }";
    head.resize(117, ' ');
    return std::string("\x93NUMPY\x01\0", 8) + "\x76" + std::string(1, '\0') + head + "\n" + doublesOf(points);
}

std::string e57Of(const Points& points, const Layout& layout) {
    auto columns = e57Cartesian(points);
    std::vector<double> lines, beams;
    for (std::size_t k = 0; k < points.size(); ++k) {
        lines.push_back(static_cast<double>(k / layout.columns));
        beams.push_back(static_cast<double>(k % layout.columns));
    }
    columns.push_back(e57Whole("columnIndex", lines));
    columns.push_back(e57Whole("rowIndex", beams));
    return e57Bytes({{columns, ""}});
}

const Reader kReaders[]{
    {"xyz", ".xyz", [](const Points& p, const Layout&) { return rowsOf(p); }},
    {"csv", ".csv", [](const Points& p, const Layout&) { return "x,y,z\n" + rowsOf(p, ","); }},
    {"csv in German", ".csv",
     [](const Points& p, const Layout&) {
         return "Hochwert;Rechtswert;H\xc3\xb6he\n" + [&] {
             Points turned;
             for (const auto& q : p) turned.emplace_back(q.y(), q.x(), q.z());
             return rowsOf(turned, ";");
         }();
     }},
    {"pts", ".pts", [](const Points& p, const Layout&) { return std::to_string(p.size()) + "\n" + rowsOf(p); }},
    {"surpac", ".str", surpacOf},
    {"obj", ".obj", [](const Points& p, const Layout&) { return "# points\n" + rowsOf(p, " ", "v "); }},
    {"ply", ".ply", [](const Points& p, const Layout&) { return plyHead(p, "ascii") + rowsOf(p); }},
    {"binary ply", ".ply", [](const Points& p, const Layout&) { return plyHead(p, "binary_little_endian") + doublesOf(p); }, false},
    {"pcd", ".pcd", [](const Points& p, const Layout& l) { return pcdHead(l, "4 4 4", "ascii") + rowsOf(p); }, true, true},
    {"binary pcd", ".pcd", [](const Points& p, const Layout& l) { return pcdHead(l, "8 8 8", "binary") + doublesOf(p); }, false, true},
    {"npy", ".npy", npyOf, false, true},
    {"ptx", ".ptx", ptxOf, true, true, true, true},
    {"e57", ".e57", e57Of, false, true, true, true},
    {"las", ".las", [](const Points& p, const Layout&) { return pointLas(p, 1e-6); }, false, false, true},
};

class ReadersAndChecks : public testing::Test {
protected:
    void expectSame(const Reader& reader, const std::string& bytes, std::string_view warning = {}, const ReadingOptions& options = {}) {
        SCOPED_TRACE(reader.name);
        const auto scan = readBytes(bytes, reader.extension, options);
        ASSERT_TRUE(scan) << scan.error().sentence();
        ASSERT_EQ(scan->state, scan_.state);
        for (std::size_t k = 0; k < scan_.cells(); ++k) ASSERT_NEAR(scan->rangeMm[k], scan_.rangeMm[k], 0.1) << k;
        EXPECT_TRUE(warning.empty() || std::ranges::any_of(scan->warnings, [&](const auto& w) { return w.find(warning) != w.npos; }))
            << warning;
    }
    [[nodiscard]] Points changed(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& change) const {
        Points all = points_;
        for (Eigen::Vector3d& p : all) p = change(p);
        return all;
    }

    const Scan scan_ = makeScan({.lines = kGridLines, .beams = kGridBeams, .noReturns = 0.02});
    const Points points_ = listOf(scan_, {});
};

TEST_F(ReadersAndChecks, WithoutAFault) {
    for (const Reader& reader : kReaders) expectSame(reader, reader.bytes(points_, {}));
}

TEST_F(ReadersAndChecks, OddBytesOfText) {
    for (const Reader& reader : kReaders) {
        if (!reader.text) continue;
        const std::string plain = reader.bytes(points_, {});
        std::string carriageReturns = plain;
        std::ranges::replace(carriageReturns, '\n', '\r');
        expectSame(reader, "\xEF\xBB\xBF" + plain);
        expectSame(reader, carriageReturns);
        expectSame(reader, plain + std::string(2000, '\0'), "zero");
    }
}

TEST_F(ReadersAndChecks, OnePointForNothingMeasured) {
    const Points marked = changed([](const auto& p) { return p.isZero(0.0) ? Eigen::Vector3d(-9999, -9999, -9999) : p; });
    for (const Reader& reader : kReaders)
        expectSame(reader, std::string_view(reader.name) == "las" ? pointLas(marked, 1e-5) : reader.bytes(marked, {}), "repeats exactly");
}

TEST_F(ReadersAndChecks, MillimetresForMetres) {
    const Points millimetres = changed([](const auto& p) { return Eigen::Vector3d(p * 1000); });
    for (const Reader& reader : kReaders) {
        if (!reader.unit) expectSame(reader, reader.bytes(millimetres, {}));
        ReadingOptions options;
        options.unitMm = 1.0;
        expectSame(reader, std::string_view(reader.name) == "las" ? pointLas(millimetres, 1e-4) : reader.bytes(millimetres, {}), {},
                   options);
    }
}

TEST_F(ReadersAndChecks, MovedAsAWhole) {
    const Points moved = changed([](const auto& p) { return p.isZero(0.0) ? p : Eigen::Vector3d(p + Eigen::Vector3d(0.4, 0, 1.2)); });
    for (const Reader& reader : kReaders) expectSame(reader, reader.bytes(moved, {}));
}

TEST_F(ReadersAndChecks, RowsForColumns) {
    Points turned(points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k) turned[k % kGridBeams * kGridLines + k / kGridBeams] = points_[k];
    for (const Reader& reader : kReaders) {
        if (!reader.organised) continue;
        expectSame(reader, reader.bytes(turned, {kGridBeams, kGridLines}));               // rows are beams
        if (std::string_view(reader.name) == "e57") continue;                             // each point names its own row and column
        expectSame(reader, reader.bytes(points_, {kGridBeams, kGridLines}), "exchanged"); // counts that are exchanged
    }
}

TEST_F(ReadersAndChecks, AnEmptyScanBeforeIt) {
    const Points none(4, Eigen::Vector3d::Zero());
    for (const Reader& reader : kReaders) {
        if (!reader.several) continue;
        const bool e57 = std::string_view(reader.name) == "e57";
        const std::string both =
            e57 ? e57Bytes({{e57Cartesian({}), ""}, {e57Cartesian(points_), ""}}) : reader.bytes(none, {2, 2}) + reader.bytes(points_, {});
        expectSame(reader, both, "no point");
        const E57Part empty{e57Cartesian({}), ""}, zeros{e57Cartesian(none), ""}, whole{e57Cartesian(points_), ""};
        const E57Part nines{e57Cartesian(Points(4, Eigen::Vector3d::Constant(-9999))), ""};
        if (e57) expectSame(reader, e57Bytes({empty, zeros, nines, whole}), "no point");
        ReadingOptions second, first;
        second.scanIndex = 1;
        first.scanIndex = 0;
        expectSame(reader, both, {}, second);
        EXPECT_FALSE(readBytes(both, reader.extension, first)) << reader.name;
    }
}

TEST_F(ReadersAndChecks, WithoutOneReturn) {
    const Points none(points_.size(), Eigen::Vector3d::Zero());
    for (const Reader& reader : kReaders) {
        const auto scan = readBytes(reader.bytes(none, {}), reader.extension);
        EXPECT_FALSE(scan) << reader.name;
    }
}

TEST_F(ReadersAndChecks, LaterReturnsOfAPulse) {
    Points all;
    std::vector<double> numbers;
    for (const Eigen::Vector3d& p : points_) {
        if (p.isZero(0.0)) continue;
        all.push_back(p);
        numbers.push_back(0);
        if (all.size() % 5 != 0) continue;
        all.emplace_back(p * 1.2);
        numbers.push_back(1);
    }
    std::string csv = "x,y,z,return_number\n", las = pointLas(all, 1e-6);
    auto e57 = e57Cartesian(all);
    e57.push_back(e57Whole("returnIndex", numbers));
    for (std::size_t n = 0; n < all.size(); ++n) {
        const int number = static_cast<int>(numbers[n]) + 1;
        csv += rowsOf({all[n]}, ",", "", ",") + std::to_string(number) + "\n";
        las[227 + 20 * n + 14] = static_cast<char>(number | 2 << 3); // of two returns
    }
    std::vector<std::pair<Reader, std::string>> files{
        {{"csv", ".csv", nullptr}, csv}, {{"las", ".las", nullptr}, las}, {{"e57", ".e57", nullptr}, e57Bytes({{e57, ""}})}};
    for (double& number : numbers) ++number;
    e57.back() = {"returnIndex", E57Column::As::Double, numbers};
    files.push_back({{"e57 from 1", ".e57", nullptr}, e57Bytes({{e57, ""}})});
    for (double& number : numbers) --number;
    const std::string rows = csv.substr(csv.find('\n') + 1), count = std::to_string(all.size());
    for (const char* name : {"Echo Nr", "pulse_return", "scalar_Return_Number", "target_index", "rtn", "rn", "return id"})
        files.push_back({{name, ".csv", nullptr}, std::string("x,y,z,") + name + "\n" + rows});
    std::string blanks = rows, fromZero = "x,y,z,return_number\n";
    std::ranges::replace(blanks, ',', ' ');
    for (std::size_t n = 0; n < all.size(); ++n)
        fromZero += rowsOf({all[n]}, ",", "", ",") + std::to_string(static_cast<int>(numbers[n])) + "\n";
    files.push_back({{"from 0", ".csv", nullptr}, fromZero});
    files.push_back({{"ply", ".ply", nullptr},
                     "ply\nformat ascii 1.0\nelement vertex " + count +
                         "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar ReturnNumber\nend_header\n" + blanks});
    files.push_back({{"pcd", ".pcd", nullptr},
                     "VERSION .7\nFIELDS x y z return_number\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH " + count +
                         "\nHEIGHT 1\nPOINTS " + count + "\nDATA ascii\n" + blanks});
    for (const auto& [reader, bytes] : files) {
        expectSame(reader, bytes, "later returns");
        const auto scan = readBytes(bytes, reader.extension);
        EXPECT_EQ(scan ? scan->attached.size() : 0U, static_cast<std::size_t>(std::ranges::count(numbers, 1.0))) << reader.name;
    }
}

} // namespace
