// Writes JSON documents.
#include "app/shared/json_output.h"

#include "app/shared/exits.h"
#include "app/shared/outputs.h"
#include "core/base/whole_file.h"
#include "core/exports/report.h"

namespace edgescan::cli {

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

CLI::Option& addJsonFlag(CLI::App& command, std::string& path, const std::string& what) {
    return *command.add_option("--json", path, what + "; - is standard output")->type_name("FILE")->check(namedAs("JSON", ".json"));
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
    if (written) return code;
    printError(written.error());
    return kRefused;
}

} // namespace edgescan::cli
