// Groups of a DXF file: a code and a value, a line each.
#include "core/files/formats/dxf_text.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"

#include <array>
#include <charconv>

namespace edgescan::files {
namespace {

constexpr int kDecimals = 4; // tenths of a millimetre
constexpr std::size_t kSeedDigits = 16;
constexpr const char* kRoot = "C";         // the handle that the dictionary of dictionaries has everywhere
constexpr std::size_t kLongestWords = 255; // bytes of a text, by the reference

std::string fourHexDigits(std::uint32_t number) {
    std::string digits;
    for (const unsigned shift : {12U, 8U, 4U, 0U}) digits += "0123456789ABCDEF"[number >> shift & 15U];
    return digits;
}

/// Letters by their numbers, and no line break, which would end the group.
std::string asciiWords(const std::string& text) {
    std::string words;
    for (const std::uint32_t point : charactersOf(text)) {
        std::string next(1, static_cast<char>(point));
        if (point < 0x20 || point == 0x7F) next = " ";
        if (point > 0x7F) next = point > 0xFFFF ? "?" : "\\U+" + fourHexDigits(point);
        if (words.size() + next.size() > kLongestWords) break;
        words += next;
    }
    return words;
}

} // namespace

void DxfText::pair(const char* code, const std::string& value) {
    text_ += code;
    text_ += '\n';
    text_ += value;
    text_ += '\n';
}

void DxfText::at(const Eigen::Vector3d& point, int place) {
    for (int axis = 0; axis < 3; ++axis) {
        text_ += std::to_string(10 * (axis + 1) + place) + '\n';
        appendFixed(text_, point[axis], kDecimals);
        text_ += '\n';
    }
}

std::string DxfText::newHandle() {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), handles_++, 16).ptr;
    std::string handle(digits.data(), end);
    for (char& digit : handle) digit = digit >= 'a' ? static_cast<char>(digit - 'a' + 'A') : digit;
    return handle;
}

void DxfText::header(const Eigen::AlignedBox3d& box) {
    text_ += "9\n$ACADVER\n1\n";
    text_ += release2000_ ? "AC1015\n" : "AC1009\n";
    if (release2000_) {
        text_ += "9\n$HANDSEED\n5\n";
        seedAt_ = text_.size();
        text_ += std::string(kSeedDigits, '0') + "\n";
    }
    text_ += "9\n$INSUNITS\n70\n6\n9\n$MEASUREMENT\n70\n1\n"; // metres; metric
    if (!box.isEmpty()) {
        text_ += "9\n$EXTMIN\n";
        at(box.min());
        text_ += "9\n$EXTMAX\n";
        at(box.max());
    }
    text_ += "0\nENDSEC\n";
}

std::string DxfText::beginTable(const char* name, std::size_t entries) {
    text_ += "0\nTABLE\n";
    pair("2", name);
    std::string handle;
    if (release2000_) {
        handle = newHandle();
        pair("5", handle);
        text_ += "330\n0\n100\nAcDbSymbolTable\n";
    }
    pair("70", std::to_string(entries));
    return handle;
}

std::string DxfText::record(const char* kind, const std::string& owner, const char* subclass, const char* name, const char* flags) {
    pair("0", kind);
    std::string handle;
    if (release2000_) {
        handle = newHandle();
        pair(std::string_view(kind) == "DIMSTYLE" ? "105" : "5", handle);
        pair("330", owner);
        pair("100", "AcDbSymbolTableRecord");
        pair("100", subclass);
    }
    pair("2", name);
    if (flags != nullptr) pair("70", flags);
    return handle;
}

void DxfText::tables(std::span<const DxfLayer> layers) {
    text_ += "0\nSECTION\n2\nTABLES\n";
    const auto lineType = [&](const std::string& owner, const char* name, const char* words) {
        record("LTYPE", owner, "AcDbLinetypeTableRecord", name);
        pair("3", words);
        text_ += "72\n65\n73\n0\n40\n0.0\n";
    };
    if (release2000_) {
        beginTable("VPORT", 0);
        endTable();
    }
    std::string owner = beginTable("LTYPE", release2000_ ? 3 : 1);
    if (release2000_) {
        lineType(owner, "ByBlock", "");
        lineType(owner, "ByLayer", "");
    }
    lineType(owner, "CONTINUOUS", "Solid line");
    endTable();
    owner = beginTable("LAYER", layers.size() + (release2000_ ? 1 : 0));
    const auto layer = [&](const char* name, const char* colour) {
        record("LAYER", owner, "AcDbLayerTableRecord", name);
        pair("62", colour);
        pair("6", "CONTINUOUS");
    };
    if (release2000_) layer("0", "7");
    for (const DxfLayer& one : layers) layer(one.name, one.colour);
    endTable();
    if (release2000_) {
        owner = beginTable("STYLE", 1);
        record("STYLE", owner, "AcDbTextStyleTableRecord", "Standard");
        text_ += "40\n0.0\n41\n1.0\n50\n0.0\n71\n0\n42\n0.2\n3\ntxt\n4\n\n";
        endTable();
        for (const char* empty : {"VIEW", "UCS"}) {
            beginTable(empty, 0);
            endTable();
        }
        owner = beginTable("APPID", 1);
        record("APPID", owner, "AcDbRegAppTableRecord", "ACAD");
        endTable();
        owner = beginTable("DIMSTYLE", 1);
        text_ += "100\nAcDbDimStyleTable\n";
        record("DIMSTYLE", owner, "AcDbDimStyleTableRecord", "Standard");
        endTable();
        owner = beginTable("BLOCK_RECORD", 2);
        model_ = record("BLOCK_RECORD", owner, "AcDbBlockTableRecord", "*Model_Space", nullptr);
        paper_ = record("BLOCK_RECORD", owner, "AcDbBlockTableRecord", "*Paper_Space", nullptr);
        endTable();
    }
    text_ += "0\nENDSEC\n";
}

void DxfText::blocks() {
    text_ += "0\nSECTION\n2\nBLOCKS\n";
    for (const bool paper : {false, true}) {
        const std::string& owner = paper ? paper_ : model_;
        const char* name = paper ? "*Paper_Space" : "*Model_Space";
        const auto common = [&](const char* kind, const char* subclass) {
            pair("0", kind);
            pair("5", newHandle());
            pair("330", owner);
            pair("100", "AcDbEntity");
            if (paper) pair("67", "1");
            pair("8", "0");
            pair("100", subclass);
        };
        common("BLOCK", "AcDbBlockBegin");
        pair("2", name);
        pair("70", "0");
        at(Eigen::Vector3d::Zero());
        pair("3", name);
        pair("1", "");
        common("ENDBLK", "AcDbBlockEnd");
    }
    text_ += "0\nENDSEC\n";
}

void DxfText::begin(const Eigen::AlignedBox3d& box, std::span<const DxfLayer> layers) {
    header(box);
    if (release2000_) text_ += "0\nSECTION\n2\nCLASSES\n0\nENDSEC\n";
    tables(layers);
    if (release2000_) blocks();
    text_ += "0\nSECTION\n2\nENTITIES\n";
}

std::string DxfText::entity(const char* kind, const char* layer, const std::string& owner, const char* subclass) {
    pair("0", kind);
    std::string handle;
    if (release2000_) {
        handle = newHandle();
        pair("5", handle);
        pair("330", owner);
        text_ += "100\nAcDbEntity\n";
    }
    pair("8", layer);
    if (release2000_ && subclass != nullptr) pair("100", subclass);
    return handle;
}

void DxfText::point(const char* layer, const Eigen::Vector3d& position) {
    entity("POINT", layer, model_, "AcDbPoint");
    at(position);
}

void DxfText::beginLine(const char* layer, bool closed) {
    line_ = entity("POLYLINE", layer, model_, "AcDb3dPolyline");
    text_ += "66\n1\n";
    if (release2000_) at(Eigen::Vector3d::Zero());
    text_ += closed ? "70\n9\n" : "70\n8\n"; // 8: 3D polyline, 1: closed
    if (!release2000_) at(Eigen::Vector3d::Zero());
}

void DxfText::vertex(const char* layer, const Eigen::Vector3d& position) {
    entity("VERTEX", layer, line_, "AcDbVertex");
    if (release2000_) text_ += "100\nAcDb3dPolylineVertex\n";
    at(position);
    text_ += "70\n32\n";
}

void DxfText::endLine(const char* layer) { entity("SEQEND", layer, line_, nullptr); }

void DxfText::text(const char* layer, const Eigen::Vector3d& position, double heightM, const std::string& words) {
    entity("TEXT", layer, model_, "AcDbText");
    at(position);
    text_ += "40\n";
    appendFixed(text_, heightM, kDecimals);
    text_ += '\n';
    pair("1", asciiWords(words));
    text_ += "72\n1\n"; // middle of the width
    at(position, 1);
    if (release2000_) text_ += "100\nAcDbText\n";
    text_ += "73\n2\n"; // middle of the height
}

std::string DxfText::end() {
    text_ += "0\nENDSEC\n";
    if (release2000_) {
        const std::string group = newHandle();
        text_ += std::string("0\nSECTION\n2\nOBJECTS\n0\nDICTIONARY\n5\n") + kRoot +
                 "\n330\n0\n100\nAcDbDictionary\n281\n1\n3\nACAD_GROUP\n350\n" + group + "\n0\nDICTIONARY\n5\n" + group + "\n330\n" +
                 kRoot + "\n100\nAcDbDictionary\n281\n1\n0\nENDSEC\n";
        const std::string seed = newHandle();
        text_.replace(seedAt_ + kSeedDigits - seed.size(), seed.size(), seed);
    }
    text_ += "0\nEOF\n";
    return std::move(text_);
}

} // namespace edgescan::files
