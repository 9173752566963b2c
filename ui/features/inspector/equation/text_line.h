#pragma once
// A line of the equation: letters in their colours, numbers to read and numbers to drag, on one baseline. It
// wraps at the end of the column.

#include <imgui.h>

#include <optional>
#include <string>
#include <utility>

#include "models/fields/scene_fields.h"
#include "models/scene/reflection.h"
#include "models/scene/scene.h"
#include "models/scene/shading.h"
#include "renderer/explain/quantity.h"
#include "ui/widgets/area.h"
#include "ui/widgets/theme.h"

namespace glint {

// A number of the scene that can be dragged within the equation.

/// Valid while the scene's lists do not change.
struct NumberHandle {
    SceneNumber number;
    std::string name;  // "shininess of Teapot"
};

/// A quantity whose first letter is framed, with the number after it. Reset when that letter is drawn.
struct QuantityMark {
    std::optional<Quantity> quantity;
    bool scrolls = false;  // the letter is also scrolled into view
};

/// A scene whose numbers are shown, and the same scene for editing; the latter is null if read-only.
struct HandledScene {
    const Scene& shown;
    Scene* edited = nullptr;
    QuantityMark* mark = nullptr;
};
/// The number at `pointer` in the scene, named after its keys and its light or object. It has no target if
/// the scene is read-only. Precondition: it exists.
[[nodiscard]] NumberHandle number_handle(const HandledScene& scene, const std::string& pointer);

class TextLine {
  public:
    /// Begins at the cursor; lines after the first are indented by `indent` logical pixels.
    explicit TextLine(float indent = 14, QuantityMark* mark = nullptr);
    ~TextLine();
    TextLine(const TextLine&) = delete;
    TextLine& operator=(const TextLine&) = delete;

    TextLine& plain(const std::string& text);
    TextLine& plain(const std::string& text, const ImVec4& colour);
    /// Monospaced program text.
    TextLine& code(const std::string& text, const ImVec4& colour);
    /// Monospaced figures; a right click copies them.
    TextLine& number(const std::string& text, const ImVec4& colour);
    /// The letter of a quantity; for a cosine, each letter in its vector's colour. Hovering over it explains
    /// it.
    TextLine& symbol(Quantity quantity);
    TextLine& times();
    /// A draggable number, with a dotted underline.
    TextLine& handle(const NumberHandle& number, const ImVec4& colour);
    /// A handle, or a plain number, raised like an exponent.
    TextLine& exponent(const NumberHandle& number, const ImVec4& colour);
    TextLine& raised(const std::string& text, const ImVec4& colour);
    /// Sets the text of "Copy line" in the menus of the following numbers.
    TextLine& copied_as(std::string line);
    /// Writes the result at the right edge of the column.
    void result(const std::string& text, const ImVec4& colour);
    TextLine& gap(float width);
    /// Keeps the output of draw(), such as a value with its name, on one line if it fits. draw() is called
    /// twice, first only to measure.
    template <class Draw> TextLine& together(const Draw& draw) {
        const float x = x_;
        measures_ = true;
        draw();
        measures_ = false;
        const float width = x_ - x;
        x_ = x;
        keep_together(width);
        draw();
        return *this;
    }

    [[nodiscard]] static float height();

  private:
    void place(float width);
    /// Continues on a new line if the next `width` does not fit on this one.
    void keep_together(float width);
    TextLine& piece(const std::string& text, const ImVec4& colour, ImFont* font, float down);
    TextLine& edit(const NumberHandle& number, const ImVec4& colour, float down);

    void menu_of(const std::string& number);
    void letters(Quantity quantity);
    void end_mark(const Rect& value);

    float x_, y_, left_, right_, indent_;
    std::string line_;
    int numbers_ = 0;
    bool measures_ = false;      // nothing is drawn: only x_ advances
    QuantityMark* wanted_mark_;  // null: none
    std::optional<Rect> mark_;   // the letter of the marked quantity, until its value is drawn
    bool marks_result_ = false;  // whether the marked quantity is the line's result
};

// The style of the equation's letters in the window.

/// The colour of a letter.
[[nodiscard]] Symbol colour_of(Quantity quantity);

/// The two vectors of a cosine. Precondition: is_cosine().
[[nodiscard]] std::pair<Quantity, Quantity> vectors_of(Quantity cosine);

// The lighting equation in symbols.

/// Draws it on one line, each symbol in its colour; hovering over a symbol explains it.
void formula(Reflection reflection, TransportModel transport);

}  // namespace glint
