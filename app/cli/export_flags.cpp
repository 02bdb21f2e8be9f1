// Flags out of the table of exports.
#include "app/cli/export_flags.h"

#include "app/shared/exits.h"
#include "app/shared/outputs.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/files/formats/formats.h"

#include <algorithm>
#include <filesystem>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;

std::string helpOf(const exports::ExportKind& kind) {
    std::string help = kind.help;
    if (const std::size_t at = help.find("%1"); at != std::string::npos) help.replace(at, 2, files::writtenExtensions(false));
    return help;
}

} // namespace

std::vector<const exports::ExportKind*> kindsOf(exports::ExportKind::Needs needs) {
    std::vector<const exports::ExportKind*> kinds;
    for (const exports::ExportKind& kind : exports::exportKinds()) {
        if (kind.needs == needs && kind.flag != nullptr) kinds.push_back(&kind);
    }
    std::ranges::stable_sort(kinds, {}, &exports::ExportKind::holds);
    return kinds;
}

void addExportFlags(CLI::App& command, exports::ExportKind::Needs needs, ExportPaths& paths, const std::string& group) {
    for (const exports::ExportKind* kind : kindsOf(needs)) {
        CLI::Option* option = command.add_option(kind->flag, paths.of(*kind), helpOf(*kind))->type_name("FILE")->group(group);
        if (kind->content == exports::ExportContent::RockReport) option->check(replacesOnly({command.get_name()}));
    }
}

void addFolderFlag(CLI::App& command, ExportPaths& paths, const std::string& group) {
    command.add_option("-o,--output", paths.folder, "Folder for all of these, under the scan's name")->type_name("DIR")->group(group);
}

std::string flagsFor(const std::string& path) {
    std::string flags;
    for (const exports::ExportKind& kind : exports::exportKinds()) {
        const std::string extension = asciiLower(fs::path(path).extension().string());
        if (kind.flag == nullptr || std::ranges::find(kind.files, extension, &exports::ExportFile::extension) == kind.files.end()) continue;
        flags += (flags.empty() ? "" : ", ") + std::string(exports::isOfRocks(kind.content) ? "rocks " : "detect ") + kind.flag;
    }
    return flags;
}

bool writesFiles(const std::vector<std::string>& paths) {
    return std::ranges::any_of(paths, [](const std::string& path) { return !path.empty() && !isStreamOrDevice(path); });
}

Result<Done> checkFolder(const std::string& folder) {
    if (folder.empty() || fs::is_directory(folder)) return Done{};
    const std::string extension = asciiLower(fs::path(folder).extension().string());
    bool isFile = files::writtenFormat(folder) != nullptr || (fs::exists(folder) && !isStreamOrDevice(folder));
    for (const exports::ExportKind& kind : exports::exportKinds())
        isFile = isFile || std::ranges::find(kind.files, extension, &exports::ExportFile::extension) != kind.files.end();
    for (const files::Format& format : files::formats())
        isFile = isFile || (!extension.empty() && std::ranges::find(format.reads, extension) != format.reads.end());
    if (!isFile) return Done{};
    return Error{"this command writes several files into a folder, and this is the name of one file", "-o " + folder,
                 "give a folder, or a flag of a single file in place of -o"};
}

Result<Done> checkWriting(const WriteFlags& write, const std::vector<WantedExport>& wanted, const MethodFlags& method) {
    const auto settings = settingsOf(method);
    if (settings && write.choices.filled && settings->fillCells == 0)
        return Error{"no gap is filled", "--with-filled", "give --fill and how many cells, or leave this out"};
    const char* idle = idleWriting(write, wanted);
    if (idle == nullptr) return Done{};
    return Error{"this flag changes no file that is written", std::string("--") + idle, "leave it out, or write a file that it changes"};
}

Result<Done> checkExtensions(const ExportPaths& paths) {
    if (auto folder = checkFolder(paths.folder); !folder) return folder;
    for (const exports::ExportKind& kind : exports::exportKinds()) {
        const std::string& path = paths.of(kind);
        if (path.empty()) continue;
        if (auto can = exports::checkExtension(kind, path, path, ","); !can) return can;
    }
    return Done{};
}

std::vector<WantedExport> wantedExports(const ExportPaths& paths, exports::ExportKind::Needs needs, const std::string& scanName,
                                        CoordinateFrame frame) {
    std::vector<WantedExport> wanted;
    for (const exports::ExportKind* kind : kindsOf(needs)) {
        if (const std::string& path = paths.of(*kind); !path.empty()) {
            wanted.push_back({kind, path});
            continue;
        }
        if (paths.folder.empty()) continue;
        for (const exports::ExportFile& file : kind->files) {
            using Coordinates = exports::ExportFile::Coordinates;
            if (file.inFolder && (file.coordinates != Coordinates::MineOnly || frame == CoordinateFrame::Mine))
                wanted.push_back(
                    {kind, (fs::path(paths.folder) / scanName).string() + "_" + exports::exportFileName(*kind, file.extension, frame)});
        }
    }
    return wanted;
}

} // namespace edgescan::cli
