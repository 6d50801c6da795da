#pragma once

#include <string>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

/// The systems that the tests of claims open by name: those of the gallery.
inline algae::Model gallery_system(const std::string& name) {
    for (const algae::GalleryEntry& entry : algae::gallery())
        if (entry.name == name) return algae::read_lsystem(entry.text, name + ".lsys");
    throw algae::Error("no file \"" + name + "\", and nothing of that name in the gallery");
}

/// A claim with a title and these lines.
inline algae::Claim claim(const std::string& lines) {
    return algae::read_claim("claim T\n" + lines, "x.claim", gallery_system);
}

/// What is said about these lines of a claim, which begin in its second line; "" if nothing is wrong.
inline std::string claim_findings(const std::string& lines) {
    try {
        claim(lines);
        return {};
    } catch (const algae::Diagnostics& error) {
        return error.what();
    }
}

/// The findings without their places in lines of their own: "2:6: MESSAGE", one a line.
inline std::string claim_messages(const std::string& lines) {
    std::string all;
    try {
        claim(lines);
    } catch (const algae::Diagnostics& error) {
        for (const algae::Diagnostic& finding : error.findings())
            all += (all.empty() ? "" : "\n") + std::to_string(finding.place.line) + ":" +
                   std::to_string(finding.place.column) + ": " + finding.message;
    }
    return all;
}

/// Whether this form of statement is said.
template <typename Form>
bool is_said(const algae::Statement& statement) {
    return std::holds_alternative<Form>(statement.says);
}

/// What a statement of this form says. Throws if it is of another form.
template <typename Form>
Form said_in(const algae::Statement& statement) {
    return std::get<Form>(statement.says);
}

/// The language of an expression, as it is printed.
inline std::string read_back(const std::string& expression) {
    const algae::WrittenLanguage written = algae::read_language(expression, gallery_system);
    return algae::to_string(written.language, *written.alphabet);
}
