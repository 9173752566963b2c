#pragma once
// Describes a field of a scene: its texts (Row) and its kind (a number, a colour, one of a set, ...). The
// fields themselves are in scene_fields.h.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "models/numbers.h"
#include "models/scene/scene.h"

namespace glint {

/// The names and texts of one member of a struct.
struct Row {
    std::string_view key;       // in the scene file
    const char* label = "";     // in a panel
    const char* help = "";      // one line: for tooltips, the documentation and the JSON Schema
    const char* undo = "";      // the name of its undo step; {} is replaced by the item's name
    bool applies = true;        // false: it has no effect now, such as the cone of a light that is not a spot
    bool omit_default = false;  // written only if it differs from the default
    bool moves_faces = true;    // false: it affects how a pixel is lit, but never which face is visible

    [[nodiscard]] constexpr Row undone_as(const char* words) const { return with(&Row::undo, words); }
    [[nodiscard]] constexpr Row when(bool has_effect) const { return with(&Row::applies, has_effect); }
    [[nodiscard]] constexpr Row omitted_by_default() const { return with(&Row::omit_default, true); }
    [[nodiscard]] constexpr Row of_lighting() const { return with(&Row::moves_faces, false); }

  private:
    template <class T> [[nodiscard]] constexpr Row with(T Row::*member, T value) const {
        Row row = *this;
        row.*member = value;
        return row;
    }
};

// The kinds of members. Dragging adds `step` per pixel; `format` is a printf format for panels.

/// A float.
struct Real {
    Range range = any_number;
    const char* unit = "";
    float step = 0.01f;
    const char* format = "%.3f";
    float usual_max = 0;       // above 0: values are usually in [low end of the range, usual_max]
    bool logarithmic = false;  // dragging multiplies the value
    const char* zero = "";     // the text for 0 in a panel if 0 has a special meaning; empty: "0"
};
/// Linear RGB; each channel is at least 0, and 1 is full intensity.
struct Colour {};
/// Three floats.
struct Vector {
    const char* condition = "";  // condition on the values, for the documentation; see violation_of()
    const char* unit = "";
    float step = 0.01f;
    const char* format = "%.2f";
};
/// (x, y, z, w) of a light: the direction towards it if w = 0, else a position, divided by w.
struct Homogeneous {
    LightKind kind;
    [[nodiscard]] constexpr bool is_direction() const { return kind == LightKind::Directional; }
};
struct Switch {};
struct Text {
    std::size_t max_characters = 0;  // 0: the general limit on texts in a scene
};
/// The path of a mesh file, as written in the scene file.
struct Path {};
/// One of the rows of `choices<E>`.
struct OneOf {};
/// An int.
struct Count {
    int low, high;
    bool (*is_allowed)(int) = nullptr;  // null: every number from low to high
    std::string_view words = {};        // for "expected ..."; empty: derived from low and high
    const char* zero = "";              // like Real::zero

    /// Returns true if x is a whole number from low to high, and allowed.
    [[nodiscard]] bool contains(double x) const {
        return x >= low && x <= high && x == static_cast<int>(x) &&
               (is_allowed == nullptr || is_allowed(static_cast<int>(x)));
    }
    /// The allowed number nearest to x; the larger of two equally near ones. Precondition: x is not NaN.
    [[nodiscard]] int nearest(double x) const {
        const int middle = static_cast<int>(std::lround(std::clamp(x, double(low), double(high))));
        for (int away = 0; away <= high - low; ++away)
            for (const int n : {middle + away, middle - away})
                if (contains(n)) return n;
        return middle;
    }
};
/// The text after "expected": "1, 4, 9", "a whole number from 1 to 8", or "1" if that is the only value.
[[nodiscard]] std::string words_of(const Count& count);
/// A struct with fields of its own.
struct Group {};
/// A list of structs, at most `max`.
struct List {
    std::size_t max;
    std::string_view plural;
};
/// One of the projections; its `type` is in the same object as its fields.
struct OneProjection {};
/// A primitive or a file.
struct OneMesh {};

}  // namespace glint
