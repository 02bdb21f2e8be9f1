// The module edgescan._edgescan: the classes and functions to which edgescan/__init__.py adds keywords.
#include "app/python/module.h"

#include "core/base/instruction_set.h"
#include "core/base/version.h"
#include "core/exports/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace edgescan::python {

bool noSignal() {
    const py::gil_scoped_acquire locked;
    return PyErr_Occurred() == nullptr && PyErr_CheckSignals() == 0;
}

void raiseSignal() {
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
}

py::str nameOf(const std::string& bytes) {
    PyObject* text = PyUnicode_DecodeFSDefaultAndSize(bytes.data(), static_cast<Py_ssize_t>(bytes.size()));
    if (text == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::str>(text);
}

std::int64_t wholeOf(const py::int_& number) {
    int beyond = 0;
    const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &beyond);
    using Limits = std::numeric_limits<std::int64_t>;
    return beyond < 0 ? Limits::min() : beyond > 0 ? Limits::max() : value;
}

py::object objectOf(nlohmann::ordered_json json) {
    // jsonText() writes a byte that is not UTF-8 as \uef80 to \uefff, and Python's file names have \udc80 to \udcff for it.
    if (json.is_object() && json.contains("warnings")) {
        for (nlohmann::ordered_json& warning : json["warnings"]) warning = withKeywords(warning.get<std::string>());
    }
    std::string text = exports::reportText(json, false);
    for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 2)) {
        if (text.compare(at, 4, "\\uef") == 0 && text[at + 4] >= '8') text.replace(at + 2, 2, "dc");
    }
    return py::module_::import("json").attr("loads")(text);
}

std::string withKeywords(const std::string& text) {
    std::string out;
    std::size_t from = 0;
    for (std::size_t at = text.find("--"); at != text.npos; at = text.find("--", at + 2)) {
        const std::size_t end = std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-", at + 2), text.size());
        const bool begins = at == 0 || std::string_view(" (\"").find(text[at - 1]) != std::string_view::npos;
        if (!begins || end - at < 3 || (end + 1 < text.size() && text[end] == '.' && text[end + 1] != ' ')) continue; // a name of a file
        std::string key = text.substr(at + 2, end - at - 2);
        std::ranges::replace(key, '-', '_');
        out += text.substr(from, at - from) + key;
        from = end;
    }
    out += text.substr(from);
    for (const auto& [flags, keywords] : {std::pair{"this flag", "this keyword"},
                                          {"these flags", "these keywords"},
                                          {"LINE,BEAM LINE,BEAM", "[(line, beam), (line, beam)]"},
                                          {"LINE,BEAM", "(line, beam)"}}) {
        for (std::size_t at = out.find(flags); at != out.npos; at = out.find(flags, at)) out.replace(at, std::strlen(flags), keywords);
    }
    return out;
}

void logWarning(const std::string& sentence) {
    py::module_::import("logging").attr("getLogger")("edgescan").attr("warning")("%s", nameOf(withKeywords(sentence)));
}

namespace {

// edgescan.Error with its three parts; the message is the same sentence as on the command line.
void bindError(py::module_& module) {
    static py::handle type = py::exception<Refused>(module, "Error", PyExc_ValueError).release();
    type.attr("__module__") = "edgescan";
    type.attr("__doc__") = "What was refused, as the sentence that the command line prints; its parts are what, where and hint.";
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const Refused& refused) {
            const Error said{withKeywords(refused.error.what), withKeywords(refused.error.where), withKeywords(refused.error.hint)};
            const py::object error = type(said.sentence());
            error.attr("what") = nameOf(said.what);
            error.attr("where") = nameOf(said.where);
            error.attr("hint") = nameOf(said.hint);
            PyErr_SetObject(type.ptr(), error.ptr());
        }
    });
}

} // namespace
} // namespace edgescan::python

PYBIND11_MODULE(_edgescan, module) {
    using namespace edgescan::python;
    if (const auto set = edgescan::wantedInstructionSet(); !set) throw py::import_error(set.error().sentence());
    module.attr("__version__") = edgescan::version();
    bindError(module);
    module.def("refuse", [](const std::string& what, const std::string& where, const std::string& hint) {
        throw Refused{{what, where, hint}};
    });
    bindTables(module);
    bindScan(module);
    bindArrays(module);
    bindDetect(module);
    bindFindings(module);
    bindPickling(module);
    bindRocks(module);
    bindSweeps(module);
    bindSimulate(module);
}
