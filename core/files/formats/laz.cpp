// LAZ points, read from memory through LASzip's own interface.
#include "core/files/formats/laz.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#ifdef EDGESCAN_WITH_LASZIP
#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/files/formats/las_layout.h"

#include <laszip/laszip_api.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <istream>
#include <limits>
#include <streambuf>
#endif

namespace edgescan::files {

#ifdef EDGESCAN_WITH_LASZIP
namespace {

/// The bytes of a file as a stream that can be positioned.
class MemoryBuffer : public std::streambuf {
public:
    explicit MemoryBuffer(std::span<const std::byte> bytes) {
        auto* first = reinterpret_cast<char*>(const_cast<std::byte*>(bytes.data())); // read only: without a put area
        setg(first, first, first + bytes.size());
        from_ = readTo_ = first;
    }
    /// Offset behind the last byte that was read.
    [[nodiscard]] std::uint64_t readTo() const {
        return static_cast<std::uint64_t>(std::max(readTo_, gptr() > from_ ? gptr() : eback()) - eback());
    }

protected:
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override {
        const off_type base = from == std::ios_base::beg ? 0 : from == std::ios_base::cur ? gptr() - eback() : egptr() - eback();
        const off_type to = base + offset;
        if (to < 0 || to > egptr() - eback()) return pos_type(off_type(-1));
        if (gptr() > from_) readTo_ = std::max(readTo_, gptr()); // a change of place alone reads nothing
        from_ = eback() + to;
        setg(eback(), from_, egptr());
        return pos_type(to);
    }
    pos_type seekpos(pos_type place, std::ios_base::openmode which) override { return seekoff(off_type(place), std::ios_base::beg, which); }

private:
    char* from_ = nullptr;   ///< where reading went on after the last change of place
    char* readTo_ = nullptr; ///< the furthest place that reading reached before it
};

template <class T>
T valueAt(std::span<const std::byte> bytes, std::uint64_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// LASzip trusts what it reads, so that a file which was cut off or damaged must not reach it: its own record, the size of its items
/// and the table of its chunks have to be there. False: they are not, or of a kind that is too old to have a table.
bool isWhole(std::span<const std::byte> bytes) {
    constexpr std::uint64_t kFixed = 34; // bytes of the record before the items
    const std::uint64_t pointsAt = valueAt<std::uint32_t>(bytes, las::kPointsAt);
    std::uint64_t at = valueAt<std::uint16_t>(bytes, las::kHeaderSize);
    if (pointsAt + 8 > bytes.size() || at > pointsAt) return false;
    bool found = false;
    for (auto left = valueAt<std::uint32_t>(bytes, las::kRecordCount); left > 0; --left) {
        if (at + las::kRecordHeader > pointsAt) return false;
        const std::uint64_t length = valueAt<std::uint16_t>(bytes, at + las::kRecordLength);
        const std::uint64_t from = at + las::kRecordHeader;
        if (from + length > pointsAt) return false;
        const std::string_view user(reinterpret_cast<const char*>(bytes.data()) + at + las::kRecordUser, 14);
        if (user == "laszip encoded" && valueAt<std::uint16_t>(bytes, at + las::kRecordId) == 22204) {
            if (length < kFixed) return false;
            const auto compressor = valueAt<std::uint16_t>(bytes, from);
            const std::uint64_t items = valueAt<std::uint16_t>(bytes, from + kFixed - 2);
            if ((compressor != 2 && compressor != 3) || items == 0 || length != kFixed + 6 * items) return false;
            std::uint64_t size = 0;
            for (std::uint64_t item = 0; item < items; ++item) size += valueAt<std::uint16_t>(bytes, from + kFixed + 6 * item + 2);
            if (size != valueAt<std::uint16_t>(bytes, las::kPointBytes)) return false;
            found = true;
        }
        at = from + length;
    }
    const auto tableAt = valueAt<std::int64_t>(bytes, pointsAt);
    if (!found || tableAt < static_cast<std::int64_t>(pointsAt) + 8) return false;
    const auto table = static_cast<std::uint64_t>(tableAt);
    return table + 8 <= bytes.size() && valueAt<std::uint32_t>(bytes, table) == 0 &&
           valueAt<std::uint32_t>(bytes, table + 4) <= bytes.size() - table;
}

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

Result<LasPoints> unpack(Unpacker& unpacker, std::istream& stream, const Source& source) {
    const auto damaged = [&] {
        return source.refused(withValues("this LAZ file cannot be unpacked: %1", {unpacker.problem()}), "copy it again");
    };
    laszip_BOOL compressed = 0;
    if (unpacker.laszip == nullptr || laszip_open_reader_stream(unpacker.laszip, stream, &compressed) != 0) return damaged();
    unpacker.open = true;
    laszip_header* header = nullptr;
    if (laszip_get_header_pointer(unpacker.laszip, &header) != 0) return damaged();
    const std::uint64_t count =
        header->number_of_point_records != 0 ? header->number_of_point_records : header->extended_number_of_point_records;
    if (count == 0) return source.refused("the file holds no points", "choose another file");
    if (productOf({count, header->point_data_record_length}) > mostUnpackedBytes(source.bytes.size()))
        return source.refused(withValues("the header promises %1, more than a file of %2 holds of a scan",
                                         {counted(count, "point"), sizeText(source.bytes.size())}),
                              "copy it again, or save it as .las");
    if (auto enough = checkMemory(productOf({count, sizeof(Eigen::Vector3d) + header->point_data_record_length}), source.path.string());
        !enough)
        return enough.error();
    laszip_point* point = nullptr;
    if (laszip_get_point_pointer(unpacker.laszip, &point) != 0) return damaged();
    LasPoints read;
    for (std::uint64_t n = 0; n < count; ++n) {
        Eigen::Vector3d p;
        if (laszip_read_point(unpacker.laszip) != 0 || laszip_get_coordinates(unpacker.laszip, p.data()) != 0) {
            return source.refused(
                withValues("the header promises %1 and the file ends after %2 (%3)", {counted(count, "point"), n, unpacker.problem()}),
                "copy it again");
        }
        const bool withheld = point->withheld_flag != 0 || (point->extended_classification_flags & las::kWithheldFlag) != 0;
        if (withheld) p.setConstant(std::numeric_limits<double>::quiet_NaN());
        read.withheld += withheld ? 1 : 0;
        read.points.push_back(p);
        read.intensity.push_back(point->intensity);
        read.returnNumber.push_back(point->extended_point_type != 0 ? point->extended_return_number : point->return_number);
        if (point->num_extra_bytes > 0) {
            const auto extra = std::as_bytes(std::span(point->extra_bytes, static_cast<std::size_t>(point->num_extra_bytes)));
            read.extra.insert(read.extra.end(), extra.begin(), extra.end());
        }
        if (n % 65536 == 0 && !source.goOn("reading points", 0.5 * static_cast<double>(n) / static_cast<double>(count)))
            return source.cancelled();
    }
    return read;
}

} // namespace

Result<LasPoints> readLazPoints(const Source& source) {
    if (!isWhole(source.bytes)) return source.refused("this LAZ file is damaged or cut off", "copy it again, or save it as .las");
    MemoryBuffer buffer(source.bytes);
    std::istream stream(&buffer);
    Unpacker unpacker;
    try {
        auto read = unpack(unpacker, stream, source);
        if (read) read->end = buffer.readTo();
        return read;
    } catch (const std::bad_alloc&) {
        throw; // openScan() makes the error of it
    } catch (const std::exception& problem) {
        return source.refused(std::string("this LAZ file cannot be unpacked: ") + problem.what(), "copy it again");
    } catch (...) { // LASzip throws numbers at the end of a stream
        return source.refused("this LAZ file cannot be unpacked: it ends too early", "copy it again");
    }
}

#else

Result<LasPoints> readLazPoints(const Source& source) {
    return source.refused("this LAS file is compressed (LAZ), and this build of the program was made without LASzip",
                          "save it uncompressed as .las, with CloudCompare or \"laszip -i IN.laz -o OUT.las\"");
}

#endif

} // namespace edgescan::files
