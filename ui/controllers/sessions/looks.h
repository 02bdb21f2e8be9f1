// How the views look where that is no switch of a menu: one table of what a session keeps of it.
#pragma once

#include <map>
#include <string>

namespace edgescan::ui {

struct Desk;

/// By key; numbers with a point, whatever the language. GUI thread, as the others.
[[nodiscard]] std::map<std::string, std::string> looksOf(const Desk& desk);
/// What is missing or cannot be understood stays as it is.
void useLooks(const Desk& desk, const std::map<std::string, std::string>& looks);
/// Those alone that opening a scan puts back.
void useLooksOfScan(const Desk& desk, const std::map<std::string, std::string>& looks);

} // namespace edgescan::ui
