#pragma once

#include "verify/detail/checking.hpp"

namespace algae::verify {

/// That the infinite word of a D0L system has so many factors of n letters for all n, by its bispecial factors.
void check_bispecial(const Obligation& task);

}  // namespace algae::verify
