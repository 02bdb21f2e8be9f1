// Display settings that are not switches of a menu: one table of those that a session stores.
#pragma once

#include <map>
#include <string>

namespace edgescan::ui {

struct Desk;

/// By key; numbers with a decimal point in every language. GUI thread, like the other functions.
[[nodiscard]] std::map<std::string, std::string> looksOf(const Desk& desk);
/// Missing or invalid entries leave the display unchanged.
void useLooks(const Desk& desk, const std::map<std::string, std::string>& looks);
/// Only those that are restored when a scan is opened.
void useLooksOfScan(const Desk& desk, const std::map<std::string, std::string>& looks);

} // namespace edgescan::ui
