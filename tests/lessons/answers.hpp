#pragma once

#include <filesystem>
#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "places.hpp"

// The model answers to exercises, and the systems that answers may open.

inline const std::filesystem::path answers =
    std::filesystem::path(source_folder()) / "lessons" / "answers";

inline algae::Model from_gallery(const std::string& name) {
    for (const algae::GalleryEntry& entry : algae::gallery())
        if (entry.name == name) return algae::read_lsystem(entry.text, name);
    throw algae::Error("no " + name + " in the gallery");
}
