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
#include "renderer/explain/explain.h"
#include "renderer/explain/quantity.h"
#include "ui/document/scene_edit.h"
#include "ui/widgets/area.h"
#include "ui/widgets/theme.h"

namespace glint {

// A number in the scene that can be dragged within the equation.

/// A draggable number. Valid while the scene's lists do not change.
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
/// the scene is read-only. Precondition: the number exists.
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
    /// Monospaced figures that can be copied with a right click.
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

/// Draws the equation on one line, each symbol in its colour; hovering over a symbol explains it.
void formula(Reflection reflection, TransportModel transport);

// Texts about the numbers in an explanation, such as what was clipped. All functions are pure.

/// Describes an area light's samples: "36 samples, n·l −0.12 to 0.71".
[[nodiscard]] std::string sample_words(const ExplainedLight& area, const Light& light);

/// Names the channels that exceed 1 after exposure: "clips: R 1.31 → 1"; empty if none does.
[[nodiscard]] std::string clipping_reason(glm::vec3 sum, float exposure);

/// The terms in the sum at one point; for corners and flat points, after weighting.
struct TermSums {
    glm::vec3 emission{0}, ambient{0}, diffuse{0}, specular{0};
    glm::vec3 tone{0};     // cool to warm: replaces emission, ambient and diffuse
    glm::vec3 bounced{0};  // replaces global ambient light
};
[[nodiscard]] TermSums term_sums(const Explanation& explanation);

/// The angle (degrees, 0 to 180) of a cosine; clamps cosines that rounding has pushed past 1.
[[nodiscard]] double angle_deg(float cosine);

/// Formats a number in a column: three decimals, fewer for large numbers, more for small ones until two
/// significant digits show. A magnitude below one millionth becomes 0, without a sign.
[[nodiscard]] std::string shown_number(float value);
[[nodiscard]] std::string shown_vector(glm::vec3 v);

// A label for a JSON pointer into the scene file, and the panel that contains its number.

struct NamedNumber {
    std::string owner;  // "Bulb", "Teapot", "Camera"
    std::string what;   // "position x", "diffuse red", "falloff quadratic"; empty for the entire owner
    Selection selection;
};

/// The item that a pointer refers to or into: NamedNumber::owner.
[[nodiscard]] std::string owner_of(const std::string& pointer, const Scene& scene);
/// Names a number of this scene, or an entire object. For an invalid pointer, returns its text.
[[nodiscard]] NamedNumber named_number(const std::string& pointer, const Scene& scene);

}  // namespace glint
