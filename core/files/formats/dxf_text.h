// The groups of a DXF file of release 12 or 2000 (Autodesk DXF reference, AC1009 and AC1015).
#pragma once

#include <Eigen/Geometry>

#include <cstdint>
#include <span>
#include <string>

namespace edgescan::files {

struct DxfLayer {
    const char* name;
    const char* colour; ///< number of the AutoCAD colour index
};

/// Writes from the first comment to the end of the file, in the order of the functions. Release 12 takes the least; 2000 wants a handle and
/// an owner for everything.
class DxfText {
public:
    explicit DxfText(bool release2000) : release2000_(release2000) {}

    void comment(const std::string& line) { pair("999", line); }
    /// Header, tables and blocks; lengths are metres. An empty box is left out.
    void begin(const Eigen::AlignedBox3d& box, std::span<const DxfLayer> layers);
    void point(const char* layer, const Eigen::Vector3d& at);
    /// A 3D polyline: begin, vertices, end.
    void beginLine(const char* layer, bool closed);
    void vertex(const char* layer, const Eigen::Vector3d& at);
    void endLine(const char* layer);
    /// Text in the plane of x and y, its middle at the point. Release 12 has ASCII only: other letters are written as "\U+00E9", which
    /// readers of DXF show as letters. What is longer than a line of a drawing may be is cut off.
    void text(const char* layer, const Eigen::Vector3d& at, double heightM, const std::string& words);
    /// The whole file.
    [[nodiscard]] std::string end();

private:
    void pair(const char* code, const std::string& value);
    void at(const Eigen::Vector3d& point, int place = 0); // 0: groups 10, 20, 30; 1: 11, 21, 31
    [[nodiscard]] std::string newHandle();
    void header(const Eigen::AlignedBox3d& box);
    std::string beginTable(const char* name, std::size_t entries);
    std::string record(const char* kind, const std::string& owner, const char* subclass, const char* name, const char* flags = "0");
    void endTable() { text_ += "0\nENDTAB\n"; }
    void tables(std::span<const DxfLayer> layers);
    void blocks();
    std::string entity(const char* kind, const char* layer, const std::string& owner, const char* subclass);

    bool release2000_;
    std::string text_ = "0\nSECTION\n2\nHEADER\n"; ///< before the comments: LibreOffice knows a drawing by it
    std::uint64_t handles_ = 0x20;
    std::size_t seedAt_ = 0;    ///< where the first free handle is to be written
    std::string model_, paper_; ///< handles of the block records
    std::string line_;          ///< of the polyline that is being written
};

} // namespace edgescan::files
