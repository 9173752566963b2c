#pragma once
// Draws the fields of a struct as rows of a panel, from models/fields/scene_fields.h: label, control,
// tooltip, default. A panel names the rows that need a special order or style and ends with rest(), so new
// fields appear automatically.

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "ui/widgets/widgets.h"

namespace glint {

// One control per type. A reset restores `initial`.
inline void draw_field(const Row& row, const Text& kind, std::string& value, const std::string&,
                       const Help& help) {
    name_field(row.label, value, kind.max_characters, help);
}
void draw_field(const Row& row, const Switch& kind, bool& value, bool initial, const Help& help);
inline void draw_field(const Row& row, const Real& kind, float& value, float initial, const Help& help) {
    number_field(row.label, value, kind, initial, help);
}
inline void draw_field(const Row& row, const Colour&, glm::vec3& value, const glm::vec3& initial,
                       const Help& help) {
    colour_field(row.label, value, initial, help);
}
void draw_field(const Row& row, const Vector& kind, glm::vec3& value, const glm::vec3& initial,
                const Help& help);
void draw_field(const Row& row, const Homogeneous& kind, glm::vec4& value, const glm::vec4& initial,
                const Help& help);
void draw_field(const Row& row, const Count& kind, int& value, int initial, const Help& help);
template <class E> void draw_field(const Row& row, const OneOf&, E& value, E, const Help& help) {
    choice_field(row.label, value, help);
}

/// What can be typed into the control of a type; for a switch, the key that toggles it.
enum class Typed { Nothing, Number, Text, Key };
template <class Kind> constexpr Typed typed_into(const Kind&) { return Typed::Number; }
constexpr Typed typed_into(const Switch&) { return Typed::Key; }
constexpr Typed typed_into(const OneOf&) { return Typed::Nothing; }
constexpr Typed typed_into(const Text&) { return Typed::Text; }

/// Draws a control; it is dimmed while it has no effect.
void dimmed_unless(bool applies, const std::function<void()>& draw);

// A field can be requested by its pointer, as the palette does.

/// Makes the field's panel scroll to the field in the following frames, marks the field for a moment and, if
/// it accepts typing, focuses it. A switch toggles with Space or Enter while it is marked. `component`: "/1",
/// the component of a vector to focus; empty: the first.
void ask_for_field(const std::string& pointer, const std::string& component = "");
/// Whether a requested field is below `pointer` ("/npr"), so that a fold containing it has to open.
[[nodiscard]] bool field_is_asked_below(const std::string& pointer);
/// Draws a field with `draw` and handles a request for it. `typed`: what can be typed into it.
void draw_asked(const std::string& pointer, Typed typed, const std::function<void()>& draw);

class FieldPanel {
  public:
    /// The fields of `value`, which must outlive the panel; `pointer` is its JSON pointer.
    template <class T> FieldPanel(T& value, const std::string& pointer) { add(value, pointer); }

    /// Draws these fields, in this order.
    FieldPanel& draw(std::initializer_list<std::string_view> keys) {
        for (const std::string_view key : keys)
            if (Field* field = find(key)) draw(*field);
        return *this;
    }
    /// Draws a field with the panel's own control(row, help, usual); usual() draws the standard control.
    template <class Control> FieldPanel& draw_as(std::string_view key, const Control& control) {
        Field* field = find(key);
        if (field == nullptr) return *this;
        field->drawn = true;
        draw_asked(field->help.pointer, field->typed, [&] {
            dimmed_unless(field->row.applies, [&] { control(field->row, field->help, field->draw); });
        });
        return *this;
    }
    /// Draws a struct under its own heading with draw_group(value, pointer), if it has an effect.
    template <class T, class Draw> FieldPanel& group(std::string_view key, T& value, const Draw& draw_group) {
        Field* field = find(key);
        if (field == nullptr || !field->row.applies) return *this;
        section_heading(field->row.label);
        draw_group(value, field->help.pointer);
        return *this;
    }
    /// Leaves out a field that the panel draws itself.
    FieldPanel& skip(std::string_view key) {
        if (Field* field = find(key)) field->drawn = true;
        return *this;
    }
    /// Dims a field for a reason that does not depend on its struct.
    FieldPanel& dim(std::string_view key, bool applies) {
        if (Field* field = find(key)) field->row.applies = field->row.applies && applies;
        return *this;
    }
    FieldPanel& heading(const char* title) {
        section_heading(title);
        return *this;
    }
    /// Draws all fields that have not been drawn or skipped.
    FieldPanel& rest() {
        for (Field& field : fields_)
            if (!field.drawn) draw(field);
        return *this;
    }

  private:
    struct Field {
        Row row;
        Help help;
        std::function<void()> draw;
        bool drawn = false;
        Typed typed = Typed::Nothing;
    };

    template <class T> void add(T& value, const std::string& pointer) {
        fields_with_defaults(value, [&](const Row& row, const auto& kind, auto& member, const auto& from) {
            const Help help{row.help, pointer + "/" + std::string(row.key)};
            Field field{
                row, help, {}, true};  // a type without its own control is left to group() or the panel
            if constexpr (requires { draw_field(row, kind, member, from, help); }) {
                field.drawn = false;
                field.typed = typed_into(kind);
                field.draw = [row, kind, &member, &from, help] { draw_field(row, kind, member, from, help); };
            }
            fields_.push_back(std::move(field));
        });
    }
    Field* find(std::string_view key) {
        const auto at =
            std::find_if(fields_.begin(), fields_.end(), [&](const Field& f) { return f.row.key == key; });
        return at == fields_.end() ? nullptr : &*at;
    }
    void draw(Field& field) {
        field.drawn = true;
        draw_asked(field.help.pointer, field.typed, [&] { dimmed_unless(field.row.applies, field.draw); });
    }

    std::vector<Field> fields_;
};

/// Draws all fields of a struct.
template <class T> void field_rows(T& value, const std::string& pointer) {
    FieldPanel(value, pointer).rest();
}

/// Draws a drop-down for the enumerators of E; true if a different one was chosen.
template <class E> bool choice_field(const char* label, E& value, const Help& help) {
    const E before = value;
    value = static_cast<E>(choose(label, static_cast<int>(value), choices<E>, help));
    return value != before;
}

/// Draws joined buttons for the enumerators of E, in a row with a label.
template <class E> bool segment_field(const char* label, E& value, const Help& help) {
    label_cell(label);
    const E before = value;
    value = static_cast<E>(segments(label, static_cast<int>(value), choices<E>, help));
    return value != before;
}

}  // namespace glint
