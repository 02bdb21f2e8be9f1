// edgescan-cli verify: rebuilds exports from their records and compares them.
#include "core/exports/verify.h"
#include "app/cli/commands.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/exports/report.h"
#include "core/files/open_save/sidecar_grid.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace edgescan::cli {
namespace {

struct Verify {
    std::vector<std::string> files;
    std::string scans, json;
};

/// The named exports without duplicates. A record counts as its export: users type `verify RESULTS/*`.
std::vector<std::string> exportsOf(const std::vector<std::string>& named) {
    static const std::string kRecord = files::sidecarPath("").string();
    std::vector<std::string> exports;
    for (const std::string& file : named) {
        const std::string whole = file.ends_with(kRecord) ? file.substr(0, file.size() - kRecord.size()) : file;
        if (std::ranges::find(exports, whole) == exports.end()) exports.push_back(whole);
    }
    return exports;
}

int run(const Verify& verify) {
    JsonLines json(verify.json);
    std::size_t identical = 0, differing = 0, unchecked = 0, reports = 0;
    std::optional<std::filesystem::path> scans;
    if (!verify.scans.empty()) scans = verify.scans;
    for (const std::string& file : exportsOf(verify.files)) {
        if (exports::isReport(file)) { // "verify RESULTS/*" names them, too
            const Error none{"this is a report, for which no record is written", file, "verify the clouds and pictures"};
            printError(none);
            json.add(refusal("verify", file, none));
            ++reports;
            continue;
        }
        const auto one = [&] {
            const Result<exports::Verification> verification = exports::verifyExport(file, scans);
            if (!verification) printError(verification.error());
            json.add(verification ? document("verify", exports::verificationReport(*verification))
                                  : refusal("verify", file, verification.error()));
            if (verification && verify.json != "-") printResult(exports::verificationText(*verification));
            return !verification ? kRefused : verification->identical ? kDone : kDiffers;
        };
        const int code = guarded(one, kRefused);
        ++(code == kDone ? identical : code == kDiffers ? differing : unchecked);
    }
    const bool onlyReports = reports > 0 && identical + differing + unchecked == 0;
    return json.ended(differing > 0 ? kDiffers : onlyReports ? kRefused : codeOf(identical, unchecked));
}

} // namespace

void addVerify(CLI::App& app, int& code) {
    auto verify = std::make_shared<Verify>();
    CLI::App& command =
        *app.add_subcommand("verify", "Rebuilds exports from their records and says identical, or which byte differs first");
    command.add_option("EXPORT", verify->files, "Clouds and pictures that this program exported, or the records next to them")->required();
    command.add_option("--scans", verify->scans, "Folder to look for the scan in, in addition to that of the export")->type_name("DIR");
    addJsonFlag(command, verify->json, "One JSON object per export and line");
    command.callback([verify, &code] { code = run(*verify); });
}

} // namespace edgescan::cli
