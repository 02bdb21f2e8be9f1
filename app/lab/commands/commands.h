// The commands of edgescan-lab, one file each. A command adds its flags to `app` and stores its exit code in `code` when it runs.
#pragma once

#include "app/shared/exits.h"

#include <CLI/CLI.hpp>

namespace edgescan::cli {

void addBenchmark(CLI::App& app, int& code);
void addRepeatability(CLI::App& app, int& code);
void addEvaluate(CLI::App& app, int& code);
void addClicks(CLI::App& app, int& code);
void addFamilies(CLI::App& app, int& code);
void addLearnBorders(CLI::App& app, int& code);
void addLearnConfidence(CLI::App& app, int& code);
void addLearnEdges(CLI::App& app, int& code);
void addLearnRocks(CLI::App& app, int& code);
void addStones(CLI::App& app, int& code);
void addSimulate(CLI::App& app, int& code);
void addCalibrate(CLI::App& app, int& code);
void addEmulate(CLI::App& app, int& code);

} // namespace edgescan::cli
