// Unpacks by content; most files are not packed and stay where they are.
#include "core/files/open_save/unpack.h"

#include "core/containers/compression/gunzip.h"

namespace edgescan::files {

Error UnpackedSource::refused(const Error& error) const {
    const std::string path = source.path.string();
    if (bytes == nullptr || !error.where.starts_with(path)) return error;
    return {error.what, path + " (unpacked)" + error.where.substr(path.size()), error.hint};
}

Result<UnpackedSource> unpack(const Source& packed) {
    UnpackedSource plain{packed, nullptr};
    if (containers::isGzip(packed.bytes)) {
        auto bytes = containers::gunzip(packed.bytes, packed.path.string(), [&](double done) { return packed.goOn("unpacking", done); });
        if (!bytes) return bytes.error();
        plain.bytes = std::make_shared<const std::vector<std::byte>>(std::move(*bytes));
        plain.source.bytes = *plain.bytes;
    }
    if (plain.source.bytes.empty()) return plain.refused(packed.refused("the file is empty", "copy it again or choose another"));
    return plain;
}

} // namespace edgescan::files
