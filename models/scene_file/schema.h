#pragma once
// The JSON Schema of the scene file, for editors and for programs of other makers.

#include <string>

namespace glint {

/// JSON Schema, draft 2020-12, of the scene file: keys, types, ranges, words, defaults. Made of the rows of
/// models/fields/scene_fields.h. It accepts every valid scene. Conditions between numbers (near < far, an
/// area that is not zero; models/fields/scene_rules.h) are beyond it: what it accepts may still be refused by
/// the reader. Ends with a newline.
[[nodiscard]] std::string scene_schema();

}  // namespace glint
