// Writes JSON documents to standard output.
#include "app/shared/json_output.h"

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

} // namespace edgescan::cli
