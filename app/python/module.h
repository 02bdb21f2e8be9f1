// Shared code of the Python module: errors as exceptions, arrays that refer to C++ memory, and JSON as Python objects.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <nlohmann/json_fwd.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace edgescan::python {

namespace py = pybind11;

using ScanPtr = std::shared_ptr<const Scan>;
/// The C++ side of the Python class Scan.
struct ScanObject {
    ScanPtr scan;
};
/// Keyword arguments, as texts like on the command line.
using Typed = std::map<std::string, std::string>;

/// An Error on its way to Python, where it becomes edgescan.Error.
struct Refused {
    Error error;
};

/// Returns the value, or throws Refused.
template <class T>
T valueOf(Result<T> result) {
    if (!result) throw Refused{result.error()};
    return std::move(*result);
}

/// Runs `work` without the interpreter's lock.
template <class Work>
auto unlocked(Work work) {
    const py::gil_scoped_release released;
    return work();
}

/// For long work without the lock: false after a signal handler raised an exception (Ctrl+C), so that the work ends.
[[nodiscard]] bool noSignal();
/// After such work: raises the exception of the handler.
void raiseSignal();

/// lines x beams, read only, without a copy: the array keeps `owner` alive.
template <class T, class Owner>
py::array gridArray(const Grid<T>& grid, const std::shared_ptr<Owner>& owner) {
    using Number = typename std::conditional_t<std::is_enum_v<T>, std::underlying_type<T>, std::common_type<T>>::type;
    const py::capsule keeper(new std::shared_ptr<Owner>(owner), [](void* kept) { delete static_cast<std::shared_ptr<Owner>*>(kept); });
    py::array_t<Number> array({grid.lines, grid.beams}, reinterpret_cast<const Number*>(grid.cells.data()), keeper);
    array.attr("flags").attr("writeable") = false;
    return array;
}

/// A vector in the same way.
template <class T, class Owner>
py::array vectorArray(const std::vector<T>& values, const std::shared_ptr<Owner>& owner) {
    const py::capsule keeper(new std::shared_ptr<Owner>(owner), [](void* kept) { delete static_cast<std::shared_ptr<Owner>*>(kept); });
    py::array_t<T> array(static_cast<py::ssize_t>(values.size()), values.data(), keeper);
    array.attr("flags").attr("writeable") = false;
    return array;
}

/// A name of a file, or text that may contain one, as os.fsdecode() gives it: os.fsencode() makes the same bytes of it.
[[nodiscard]] py::str nameOf(const std::string& bytes);

/// What the core says, with keywords for flags: "--min-length" is "min_length", and "this flag" is "this keyword". Names of files stay.
[[nodiscard]] std::string withKeywords(const std::string& text);

/// Warns through the logger "edgescan".
void logWarning(const std::string& sentence);

/// A whole number; beyond 64 bits the last one on its side.
[[nodiscard]] std::int64_t wholeOf(const py::int_& number);

/// The frame of that name: scanner, local or mine. Refused if there is no such frame, or if the scan has no place in it.
[[nodiscard]] CoordinateFrame frameOf(const Scan& scan, const std::string& name);

/// Names in it are as nameOf() gives them.
[[nodiscard]] py::object objectOf(nlohmann::ordered_json json);

/// A class of the package, whose objects only the module makes: without a C++ object behind it, an object of Python would have no memory to
/// read.
template <class Object>
class Class : public py::class_<Object> {
public:
    Class(py::module_& module, const char* name, const char* help) : py::class_<Object>(module, name, help) {
        this->attr("__module__") = "edgescan";
        auto* made = reinterpret_cast<PyTypeObject*>(this->ptr());
        made->tp_new = [](PyTypeObject* of, PyObject*, PyObject*) -> PyObject* {
            const char* dot = std::strrchr(of->tp_name, '.');
            PyErr_Format(PyExc_TypeError, "%s(): objects of this class are made by the functions of edgescan",
                         dot == nullptr ? of->tp_name : dot + 1);
            return nullptr;
        };
        PyType_Modified(made);
    }
};

void bindScan(py::module_& module);
void bindArrays(py::module_& module);
void bindPickling(py::module_& module);
void bindFindings(py::module_& module);
void bindTables(py::module_& module);
void bindDetect(py::module_& module);
void bindRocks(py::module_& module);
void bindSweeps(py::module_& module);
void bindSimulate(py::module_& module);

} // namespace edgescan::python
