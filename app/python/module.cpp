// The module edgescan._edgescan: the classes and functions to which edgescan/__init__.py adds keywords.
#include "app/python/module.h"

#include "core/base/instruction_set.h"
#include "core/base/version.h"
#include "core/exports/report.h"

#include <nlohmann/json.hpp>

namespace edgescan::python {

bool noSignal() {
    const py::gil_scoped_acquire locked;
    return PyErr_Occurred() == nullptr && PyErr_CheckSignals() == 0;
}

void raiseSignal() {
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
}

py::object objectOf(const nlohmann::ordered_json& json) {
    return py::module_::import("json").attr("loads")(exports::reportText(json, false));
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
            const py::object error = type(refused.error.sentence());
            error.attr("what") = refused.error.what;
            error.attr("where") = refused.error.where;
            error.attr("hint") = refused.error.hint;
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
    bindTables(module);
    bindScan(module);
    bindDetect(module);
    bindRocks(module);
    bindSweeps(module);
    bindSimulate(module);
}
