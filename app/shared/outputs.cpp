// Checks the outputs: the second of two results in the same file would overwrite the first one without a warning.
#include "app/shared/outputs.h"

#include "app/shared/exits.h"
#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/own_kind.h"
#include "core/base/replaced_files.h"
#include "core/base/whole_file.h"
#include "core/exports/report.h"
#include "core/files/open_save/sidecar_grid.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;

/// The same path for every spelling of a file and every link to it, also before the file exists.
fs::path whole(const fs::path& path) {
    std::error_code ignored;
    if (isStandardOutput(path)) return "-";
    const auto target = finalTarget(path); // a link may lead to a file that does not exist yet
    return fs::weakly_canonical(fs::absolute(target ? *target : path, ignored), ignored);
}

std::string replacedMark(const std::string& path) { return popReplaced(path) ? " (replaced)" : ""; }

std::string placeText(const std::string& path) { return isStreamOrDevice(path) ? "standard output" : printable(path); }

std::string namesOf(const std::vector<std::string>& paths) {
    std::string names;
    for (const std::string& path : paths)
        names += (names.empty() ? "" : ", ") + (path == "-" ? "standard output" : fs::path(path).filename().string());
    return names;
}

} // namespace

using Json = nlohmann::ordered_json;

Json document(const std::string& command, const Json& report) {
    Json whole{{"schema", "edgescan-" + command + "/1"}};
    whole.update(report);
    return whole;
}

Json refusal(const std::string& command, const std::string& input, const Error& error) {
    return document(command, {{"input", input}, {"error", {{"what", error.what}, {"where", error.where}, {"hint", error.hint}}}});
}

Result<Done> writeDocument(const std::string& path, const Json& document, bool indented) {
    return writeWholeFile(path, exports::reportText(document, indented) + "\n");
}

CLI::Validator replacesOnly(std::vector<std::string> documents) {
    const auto replaces = [documents = std::move(documents)](const std::string& file) {
        std::string refused;
        for (const std::string& name : documents) {
            const auto same = checkIsOfKind(file, "edgescan-" + name);
            if (same) return std::string();
            refused = file + ": " + same.error().what + "; " + same.error().hint;
        }
        return refused;
    };
    return {replaces, ""};
}

CLI::Option& addJsonFlag(CLI::App& command, std::string& path, const std::string& what, std::vector<std::string> documents) {
    if (documents.empty()) documents = {command.get_name()};
    return *command.add_option("--json", path, what + "; - is standard output")
                ->type_name("FILE")
                ->check(namedAs("JSON", ".json"))
                ->check(replacesOnly(std::move(documents)));
}

void JsonLines::add(const Json& document) {
    if (path_ == "-")
        printResult(document, false);
    else if (!path_.empty())
        lines_ += exports::reportText(document, false) + "\n";
}

int JsonLines::ended(int code) {
    if (path_.empty() || path_ == "-") return code;
    const Result<Done> written = writeWholeFile(path_, lines_);
    return written ? code : failWith(written.error());
}

Result<Done> checkDistinct(std::span<const std::string> outputs) {
    std::set<fs::path> taken;
    for (const std::string& path : outputs) {
        if (path.empty() || (isDevice(path) && !isStandardOutput(path)) || whole(path).empty()) continue; // empty: too long a name
        if (!taken.insert(whole(path)).second) return Error{"two results cannot have one file", path, "give each a name of its own"};
    }
    for (const std::string& path : outputs) {
        if (!path.empty() && !isDevice(path) && taken.contains(whole(files::sidecarPath(path))))
            return Error{"another result has the name of the record next to this file", path, "give it a name of its own"};
    }
    return Done{};
}

Result<Done> checkOutputs(std::span<const std::string> outputs) {
    for (const std::string& path : outputs) {
        if (path.empty()) continue;
        if (auto can = checkCanBeWritten(path); !can) return can;
    }
    return Done{};
}

std::string placesText(const std::vector<std::string>& paths) {
    std::string places;
    for (const std::string& path : paths) {
        if (!path.empty()) places += (places.empty() ? "" : ", ") + placeText(path) + replacedMark(path);
    }
    return places;
}

std::string namesText(const std::vector<std::string>& paths, const std::string& folder) {
    std::string names;
    for (const std::string& path : paths) {
        if (path.empty()) continue;
        const bool isInside = fs::path(path).parent_path() == fs::path(folder + "/").parent_path();
        names += (names.empty() ? "" : ", ") + printable(isInside ? fs::path(path).filename().string() : path) + replacedMark(path);
    }
    return names;
}

CLI::Validator namedAs(const char* kind, const char* extension, bool orStream) {
    const auto check = [kind = std::string(kind), extension = std::string(extension), orStream](const std::string& name) {
        const bool named = asciiLower(fs::path(name).extension().string()) == extension;
        if (named || (orStream && (name.empty() || isStreamOrDevice(name)))) return std::string();
        return "\"" + name + "\" is not a name for " + kind + "; give a name that ends with " + extension +
               (orStream ? ", or - for standard output" : "");
    };
    return {check, ""};
}

void WrittenOutputs::add(const std::string& path, const Result<exports::Written>& written) {
    add<exports::Written>(path, written);
    if (!written || !written->coordinates) return;
    placed_.push_back(placeText(path));
    const auto same = std::ranges::find(coordinates_, written->coordinates->frame, &exports::WrittenCoordinates::frame);
    if (same != coordinates_.end())
        same->add(*written->coordinates);
    else
        coordinates_.push_back(*written->coordinates);
}

std::string WrittenOutputs::coordinates(const std::string& folder) const {
    std::string text = printable(folder);
    for (const std::string& place : folder.empty() ? placed_ : std::vector<std::string>()) text += (text.empty() ? "" : ", ") + place;
    for (const exports::WrittenCoordinates& each : coordinates_)
        text += (&each == &coordinates_.front() ? ": " : " ") + exports::coordinatesText(each);
    return coordinates_.empty() ? std::string() : text;
}

Result<Done> WrittenOutputs::outcome() const {
    if (!first_) return Done{};
    Error error = *first_;
    if (!missing_.empty()) error.what += "; not written either: " + namesOf(missing_);
    if (!written_.empty()) error.what += "; written: " + namesOf(written_);
    return error;
}

} // namespace edgescan::cli
