// edgescan-cli verify: makes exports again from their records and says whether they are the same.
#include "core/report/verify.h"
#include "app/cli/commands.h"
#include "app/shared/options.h"
#include "core/report/report.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace edgescan::cli {
namespace {

struct Verify {
    std::vector<std::string> files;
    std::string scans;
    bool json = false;
};

int run(const Verify& verify) {
    int code = kDone;
    std::optional<std::filesystem::path> scans;
    if (!verify.scans.empty()) scans = verify.scans;
    for (const std::string& file : verify.files) {
        const Result<Verification> verification = verifyExport(file, scans);
        if (!verification) {
            complain(verification.error());
            code = kRefused;
            continue;
        }
        std::cout << (verify.json ? reportText(verificationReport(*verification), false) : verificationText(*verification)) << '\n';
        if (!verification->identical) code = kRefused;
    }
    return code;
}

} // namespace

void addVerify(CLI::App& app, int& code) {
    auto verify = std::make_shared<Verify>();
    CLI::App& command =
        *app.add_subcommand("verify", "Makes exports again from their provenance and says identical, or which byte differs first");
    command.add_option("EXPORT", verify->files, "Clouds and pictures that this program exported")->required();
    command.add_option("--scans", verify->scans, "Folder to look for the scan in, besides that of the export");
    command.add_flag("--json", verify->json, "One JSON object per export");
    command.callback([verify, &code] { code = run(*verify); });
}

} // namespace edgescan::cli
