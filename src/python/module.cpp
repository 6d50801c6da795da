// The module `algae._algae`: what the package of Python is made of. Its classes and functions are few and strict, and take every
// argument; the package in the folder `algae` checks what people write, names what is wrong with it, and has the names that they see.

#include "python/detail/values.hpp"

namespace algae::python {

PYBIND11_MODULE(_algae, module) {
    module.doc() = "The parts that the package algae is made of.";
    module.attr("version") = ALGAE_VERSION;
    add_running(module);
    add_values(module);
    add_systems(module);
    add_growth(module);
    add_languages(module);
    add_figures(module);
}

}  // namespace algae::python
