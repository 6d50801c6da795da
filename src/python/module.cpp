// The module `algae._algae`: what the package of Python is made of. Its classes and functions are few and strict, and take every
// argument; the package in the folder `algae` checks what people write, names what is wrong with it, and has the names that they see.

#include "python/detail/values.hpp"

namespace algae::python {

namespace {

/// What all classes of pybind11 make their objects by.
newfunc made_by_pybind11 = nullptr;

PyObject* made(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
    return made_by_pybind11(type, arguments, keywords);
}

/// `T.__new__(T)` gave an object without a value, whose methods read memory that nobody wrote. With a function of their own in the classes Python
/// refuses it, as it does `object.__new__(int)`; `T(...)` works as before.
void refuse_objects_without_value(const py::module_& module) {
    for (const auto& item : py::dict(module.attr("__dict__"))) {
        if (Py_TYPE(item.second.ptr()) != py::detail::get_internals().default_metaclass) continue;
        auto* const type = reinterpret_cast<PyTypeObject*>(item.second.ptr());
        made_by_pybind11 = type->tp_new;
        type->tp_new = made;
    }
}

}  // namespace

PYBIND11_MODULE(_algae, module) {
    module.doc() = "The parts that the package algae is made of.";
    module.attr("version") = ALGAE_VERSION;
    add_running(module);
    add_values(module);
    add_systems(module);
    add_growth(module);
    add_languages(module);
    add_figures(module);
    refuse_objects_without_value(module);
}

}  // namespace algae::python
