// One row per format. A new format is a file of this folder, a declaration and an entry here.
#include "core/files/formats/formats.h"

#include "core/files/addons/addon.h"

#include <algorithm>
#include <vector>

namespace edgescan::files {

Format rawGridFormat();
Format numpyFormat();
Format fileThatIsNoScan();
Format pcdFormat();
Format plyFormat();
Format pointListFormat();
Format rangeTableFormat();
Format pointTableFormat();
Format lasFormat();
Format e57Format();
Format dxfFormat();
Format ptxFormat();
Format objFormat();
Format surpacFormat();
Format rangePictureFormat();
Format scan3dFormat();
Format recordingFormat();
Format bagWithoutRobots();
Format packetCaptureFormat();
Format colaCaptureFormat();
Format fileOfAnotherProgram();

namespace {

/// In this order they are asked whether they recognise a content, and are listed in dialogs.
const std::vector<Format>& rows() {
    static const std::vector<Format> all = [] {
        std::vector<Format> formats{rawGridFormat(),   numpyFormat(),         fileThatIsNoScan(),   pcdFormat(),
                                    plyFormat(),       pointListFormat(),     rangeTableFormat(),   pointTableFormat(),
                                    lasFormat(),       e57Format(),           dxfFormat(),          ptxFormat(),
                                    objFormat(),       surpacFormat(),        rangePictureFormat(), scan3dFormat(),
                                    recordingFormat(), packetCaptureFormat(), colaCaptureFormat(),  fileOfAnotherProgram()};
        const std::vector<Format> added = addon().formats != nullptr ? addon().formats() : std::vector{bagWithoutRobots()};
        const auto before = std::ranges::find(formats, std::string_view("Network capture"), &Format::title);
        formats.insert(before, added.begin(), added.end());
        return formats;
    }();
    return all;
}

} // namespace

std::span<const Format> formats() { return rows(); }

const Format& formatOfContent(const Source& source) {
    for (const Format& format : rows()) {
        if (format.recognises != nullptr && format.recognises(source)) return format;
    }
    // The list of points recognises nothing: it is what is left.
    return *std::ranges::find_if(rows(), [](const Format& format) { return format.recognises == nullptr && !format.reads.empty(); });
}

const Format* writtenFormat(const std::filesystem::path& path) {
    // Standard output has no name; nothing is written packed.
    const std::string name = path == "-" ? ".pcd" : Source::lowerCase(path.filename());
    for (const Format& format : rows()) {
        for (const std::string_view extension : format.writes) {
            // A name that is only an extension is that of a hidden file.
            if (name.ends_with(extension) && (name.size() > extension.size() || path == "-")) return &format;
        }
    }
    return nullptr;
}

std::string writtenExtensions(bool wholeScans) {
    std::vector<std::string> names;
    for (const Format& format : rows()) {
        if (format.write != nullptr || (wholeScans && format.writeScan != nullptr)) names.emplace_back(format.writes.front());
    }
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
    return text;
}

} // namespace edgescan::files
