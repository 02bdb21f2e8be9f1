// A cell of a scan on the command line: LINE,BEAM, counted from 0.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>

namespace edgescan::cli {

struct TypedCell {
    int line = 0;
    int beam = 0;
};

/// Error: the text is not LINE,BEAM. `flag`: where it was typed.
[[nodiscard]] Result<TypedCell> typedCell(const std::string& text, const char* flag);

/// Refuses what is not LINE,BEAM.
[[nodiscard]] CLI::Validator cellText();

/// The index of the cell in the scan. Error: the scan has no such cell.
[[nodiscard]] Result<std::uint32_t> cellIn(const Scan& scan, const std::string& text, const char* flag);

} // namespace edgescan::cli
