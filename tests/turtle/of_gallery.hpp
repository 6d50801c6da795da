#pragma once

#include <doctest/doctest.h>

#include <string>

#include "model/model.hpp"

#include "notation/notation.hpp"

/// A system that comes with algae.
inline algae::Model of_gallery(const std::string& name) {
    for (const algae::GalleryEntry& entry : algae::gallery())
        if (entry.name == name) return algae::read_lsystem(entry.text, name);
    FAIL("no ", name, " in the gallery");
    return {};
}
