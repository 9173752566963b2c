#pragma once
// Exports questions to learning platforms as an IMS QTI 2.1 package or as Moodle XML.

#include <optional>
#include <string>
#include <vector>

#include "renderer/picture.h"

namespace glint {

/// A multiple-choice question if it has options, otherwise a numeric one.
struct ExportedQuestion {
    struct Option {
        std::string text, feedback;  // the misconception of a student who chooses it, or empty
        bool is_right = false;
    };
    std::string title, text;  // plain text
    std::optional<Picture> picture;
    std::string alt;  // alternative text of the picture
    std::vector<Option> options;
    double answer = 0, tolerance = 0;
    std::string unit;
    std::string feedback;  // shown after any answer: the working, or empty
};

/// A zip file with a manifest, a test, and a file for each question and picture. Source: IMS Question and
/// Test Interoperability 2.1, 2012; the zip entries are stored, not compressed (PKWARE APPNOTE 6.3).
[[nodiscard]] std::string qti_package(const std::string& title,
                                      const std::vector<ExportedQuestion>& questions);

/// Source: Moodle XML format, https://docs.moodle.org/en/Moodle_XML_format.
[[nodiscard]] std::string moodle_xml(const std::string& title,
                                     const std::vector<ExportedQuestion>& questions);

/// QTI if `out` ends in .zip, otherwise Moodle XML.
[[nodiscard]] std::string exported(const std::string& out, const std::string& title,
                                   const std::vector<ExportedQuestion>& questions);

}  // namespace glint
