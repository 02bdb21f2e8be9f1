// edgescan-cli audit: checks whether an audit log was altered, and lists the altered lines.
#include "app/cli/commands.h"
#include "app/shared/exits.h"
#include "app/shared/outputs.h"
#include "core/base/audit_log/audit_check.h"
#include "core/base/number_text.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace edgescan::cli {
namespace {

struct Audited {
    std::string file, last, json;
};

nlohmann::ordered_json auditReport(const Audited& asked, const AuditCheck& check) {
    nlohmann::ordered_json faults = nlohmann::ordered_json::array();
    for (const AuditFault& fault : check.faults)
        faults.push_back(
            {{"kind", auditFaultName(fault.kind)}, {"line", fault.place}, {"written_as", fault.n}, {"sentence", fault.sentence}});
    return {{"input", asked.file}, {"lines", check.lines}, {"last_sha256", check.last}, {"recovered", check.recovered}, {"faults", faults}};
}

/// Writes the JSON; `code` is the exit code if that succeeds.
int written(const Audited& asked, const nlohmann::ordered_json& document, int code) {
    const Result<Done> done = writeDocument(asked.json, document);
    return done ? code : failWith(done.error());
}

CLI::Validator hashText() {
    const auto check = [](const std::string& text) {
        const bool isHash = text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
        return isHash ? std::string() : "\"" + text + "\" is not a hash; give the 64 digits of 0 to 9 and a to f that audit prints";
    };
    return {check, ""};
}

int run(const Audited& asked) {
    const auto check = checkAudit(asked.file, asked.last);
    if (!check) {
        printError(check.error());
        return asked.json.empty() ? kRefused : written(asked, refusal("audit", asked.file, check.error()), kRefused);
    }
    const int code = check->faults.empty() ? kDone : kDiffers;
    if (asked.json != "-") {
        for (const AuditFault& fault : check->faults) printResult(std::string(auditFaultName(fault.kind)) + ": " + fault.sentence);
        printResult(counted(check->lines, "line") + " as " + (check->lines == 1 ? "it was" : "they were") + " written, " +
                    counted(check->faults.size(), "fault") + "; last hash " + (check->last.empty() ? "none" : check->last));
    }
    return asked.json.empty() ? code : written(asked, document("audit", auditReport(asked, *check)), code);
}

} // namespace

void addAudit(CLI::App& app, int& code) {
    auto asked = std::make_shared<Audited>();
    CLI::App& command = *app.add_subcommand("audit", "Checks an audit log: names each line that was altered, dropped or moved");
    command.add_option("LOG", asked->file, "The log, audit.jsonl")->required();
    command.add_option("--last", asked->last, "A hash of it that was noted elsewhere: a log without that line lacks its end")
        ->type_name("HASH")
        ->check(hashText());
    addJsonFlag(command, asked->json, "Every fault with its line");
    command.callback([asked, &code] { code = run(*asked); });
}

} // namespace edgescan::cli
