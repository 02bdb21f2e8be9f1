// One flag per kind of export, for the commands that write several: where each goes, and what it is called in a folder.
#pragma once

#include "app/shared/typed_settings.h"
#include "core/base/result.h"
#include "core/exports/export_kinds.h"

#include <CLI/CLI.hpp>

#include <array>
#include <string>
#include <vector>

namespace edgescan::cli {

/// In the order of the flags: by what they hold.
[[nodiscard]] std::vector<const exports::ExportKind*> kindsOf(exports::ExportKind::Needs needs);

/// Paths by ExportContent, as typed; empty: not asked for.
struct ExportPaths {
    std::array<std::string, static_cast<std::size_t>(exports::ExportContent::End)> typed;
    std::string folder; ///< for those that are not typed

    [[nodiscard]] std::string& of(const exports::ExportKind& kind) { return typed.at(static_cast<std::size_t>(kind.content)); }
    [[nodiscard]] const std::string& of(const exports::ExportKind& kind) const { return typed.at(static_cast<std::size_t>(kind.content)); }
};

void addExportFlags(CLI::App& command, exports::ExportKind::Needs needs, ExportPaths& paths, const std::string& group);

/// Adds -o DIR, for all of them at once.
void addFolderFlag(CLI::App& command, ExportPaths& paths, const std::string& group);

/// "detect --mask, detect --gray": the commands and flags that write a file of this name; empty: there are none.
[[nodiscard]] std::string flagsFor(const std::string& path);

/// Error: an extension that names no format for the kind, or a folder with the name of a file.
Result<Done> checkExtensions(const ExportPaths& paths);

/// Whether one of these paths is a file, and not standard output or a device.
bool writesFiles(const std::vector<std::string>& paths);

/// Error: the folder of -o is a file, or has the name of one.
Result<Done> checkFolder(const std::string& folder);

/// What is to be written of one scan.
[[nodiscard]] std::vector<WantedExport> wantedExports(const ExportPaths& paths, exports::ExportKind::Needs needs,
                                                      const std::string& scanName, CoordinateFrame frame);

/// Error: a writing flag that changes no file among these, or filled cells without filling.
Result<Done> checkWriting(const WriteFlags& write, const std::vector<WantedExport>& wanted, const MethodFlags& method = noFlags());

} // namespace edgescan::cli
