// The commands of edgescan-cli, one file each. A command adds its flags to `app` and stores its exit code in `code` when it runs.
#pragma once

#include "app/shared/exits.h"

#include <CLI/CLI.hpp>

namespace edgescan::cli {

void addInfo(CLI::App& app, int& code);
void addDetect(CLI::App& app, int& code);
void addConvert(CLI::App& app, int& code);
void addVerify(CLI::App& app, int& code);
void addRecord(CLI::App& app, int& code);
void addReplay(CLI::App& app, int& code);
void addWhy(CLI::App& app, int& code);
void addRocks(CLI::App& app, int& code);
void addBatch(CLI::App& app, int& code);
void addReport(CLI::App& app, int& code);
void addCompare(CLI::App& app, int& code);
void addAudit(CLI::App& app, int& code);
void addThumbnail(CLI::App& app, int& code);

} // namespace edgescan::cli
