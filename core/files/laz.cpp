// LAZ points, read from memory through LASzip's own interface.
#include "core/files/laz.h"

#ifdef EDGESCAN_WITH_LASZIP
#include "core/base/memory.h"

#include <laszip/laszip_api.h>

#include <cmath>
#include <exception>
#include <istream>
#include <streambuf>
#endif

namespace edgescan {

#ifdef EDGESCAN_WITH_LASZIP
namespace {

/// The bytes of a file as a stream that can be positioned.
class MemoryBuffer : public std::streambuf {
public:
    explicit MemoryBuffer(std::span<const std::byte> bytes) {
        auto* first = reinterpret_cast<char*>(const_cast<std::byte*>(bytes.data())); // read only: there is no put area
        setg(first, first, first + bytes.size());
    }

protected:
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override {
        const off_type base = from == std::ios_base::beg ? 0 : from == std::ios_base::cur ? gptr() - eback() : egptr() - eback();
        const off_type to = base + offset;
        if (to < 0 || to > egptr() - eback()) return pos_type(off_type(-1));
        setg(eback(), eback() + to, egptr());
        return pos_type(to);
    }
    pos_type seekpos(pos_type place, std::ios_base::openmode which) override { return seekoff(off_type(place), std::ios_base::beg, which); }
};

struct Unpacker {
    laszip_POINTER laszip = nullptr;
    bool open = false;
    Unpacker() {
        if (laszip_create(&laszip) != 0) laszip = nullptr;
    }
    Unpacker(const Unpacker&) = delete;
    Unpacker& operator=(const Unpacker&) = delete;
    ~Unpacker() {
        if (laszip == nullptr) return;
        if (open) laszip_close_reader(laszip);
        laszip_destroy(laszip);
    }
    [[nodiscard]] std::string problem() const {
        laszip_CHAR* text = nullptr;
        if (laszip == nullptr || laszip_get_error(laszip, &text) != 0 || text == nullptr) return "LASzip gives no reason";
        return text;
    }
};

Result<std::vector<Eigen::Vector3d>> unpack(Unpacker& unpacker, std::istream& stream, const Source& source) {
    const auto damaged = [&] { return source.refused("this LAZ file cannot be unpacked: " + unpacker.problem(), "copy it again"); };
    laszip_BOOL compressed = 0;
    if (unpacker.laszip == nullptr || laszip_open_reader_stream(unpacker.laszip, stream, &compressed) != 0) return damaged();
    unpacker.open = true;
    laszip_I64 count = 0;
    if (laszip_get_number_of_point(unpacker.laszip, &count) != 0) return damaged();
    if (count <= 0) return source.refused("the file holds no points", "choose another file");
    if (auto enough = checkMemory(static_cast<std::uint64_t>(count) * sizeof(Eigen::Vector3d), source.path.string()); !enough)
        return enough.error();
    std::vector<Eigen::Vector3d> points;
    for (laszip_I64 n = 0; n < count; ++n) {
        Eigen::Vector3d p;
        if (laszip_read_point(unpacker.laszip) != 0 || laszip_get_coordinates(unpacker.laszip, p.data()) != 0) {
            return source.refused("the header promises " + std::to_string(count) + " points and the file ends after " + std::to_string(n) +
                                      " (" + unpacker.problem() + ")",
                                  "copy it again");
        }
        points.push_back(p);
        if (n % 65536 == 0 && !source.goOn("reading points", 0.5 * static_cast<double>(n) / static_cast<double>(count)))
            return source.cancelled();
    }
    return points;
}

} // namespace

Result<std::vector<Eigen::Vector3d>> readLazPoints(const Source& source) {
    MemoryBuffer buffer(source.bytes);
    std::istream stream(&buffer);
    Unpacker unpacker;
    try {
        return unpack(unpacker, stream, source);
    } catch (const std::bad_alloc&) {
        throw; // told as such by whoever opens
    } catch (const std::exception& problem) {
        return source.refused(std::string("this LAZ file cannot be unpacked: ") + problem.what(), "copy it again");
    } catch (...) { // LASzip throws numbers at the end of a stream
        return source.refused("this LAZ file cannot be unpacked: it ends too early", "copy it again");
    }
}

#else

Result<std::vector<Eigen::Vector3d>> readLazPoints(const Source& source) {
    return source.refused("this LAS file is compressed (LAZ), and this build of the program was made without LASzip",
                          "save it uncompressed as .las");
}

#endif

} // namespace edgescan
