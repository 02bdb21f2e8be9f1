// A report as PDF.
#pragma once

#include <QByteArray>

#include <string>

namespace edgescan::ui {

/// The pages of a report (core/exports/html/scan_page.h) without what only works on a screen: A4, with page numbers.
[[nodiscard]] QByteArray pdfOfPage(const std::string& html);

} // namespace edgescan::ui
