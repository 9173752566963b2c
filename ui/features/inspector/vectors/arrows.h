#pragma once
// Arrows, arcs and letters that are legible on any picture: a dark rim below a bright line.

#include <imgui.h>

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ui/picture/screen.h"
#include "ui/widgets/area.h"
#include "ui/widgets/theme.h"

namespace glint {

// Places labels without overlaps, each as near to its preferred position as earlier labels allow. The most
// important labels come first.

class LabelRoom {
  public:
    LabelRoom() = default;
    /// Labels stay within `bounds` if they fit.
    explicit LabelRoom(const Rect& bounds) : bounds_(bounds) {}

    /// No label may cover `area`.
    void keep_free(const Rect& area) { taken_.push_back(area); }

    /// Finds a centre for a label of `size`, at most `reach` away from `wanted`, and reserves that area.
    /// Returns nothing and reserves nothing if there is not enough room.
    [[nodiscard]] std::optional<ImVec2> place(ImVec2 wanted, ImVec2 size, float reach);

    /// Returns place(), or `wanted` if there is not enough room.
    [[nodiscard]] ImVec2 place_anyhow(ImVec2 wanted, ImVec2 size, float reach);

  private:
    [[nodiscard]] bool is_free(const Rect& area) const;
    [[nodiscard]] ImVec2 inside(ImVec2 middle, ImVec2 size) const;
    std::optional<Rect> bounds_;
    std::vector<Rect> taken_;
};

/// Draws world-space vectors at one point.
struct PointPen {
    ImDrawList& list;
    const PictureView& view;
    glm::dvec3 origin{0};  // in world coordinates
    double reach = 1;      // scene units: the length of a drawn unit vector

    /// Returns the window position of the point at `offset` times the reach from the origin.
    [[nodiscard]] ImVec2 at(glm::dvec3 offset) const;
};

/// A pen at `origin` whose unit vectors are `length` logical pixels long when seen from the side.
[[nodiscard]] PointPen pen_at(ImDrawList& list, const PictureView& view, glm::dvec3 origin, float length);

/// Labels that are drawn after all arrows are known, without covering each other or an arrow. Letters are
/// placed before angles, and earlier letters before later ones.
class Words {
  public:
    /// Keeps labels off a line from `from` to `to`.
    void keep_off(ImVec2 from, ImVec2 to);
    /// Draws the letter of an arrow, centred near `centre`; if displaced, a line connects it to `centre`.
    void letter(ImVec2 centre, const ImVec4& colour, const std::string& text);
    /// Draws an angle, centred near `centre`; omitted if there is not enough room.
    void degrees(ImVec2 centre, const ImVec4& colour, const std::string& text);
    void draw(ImDrawList& list) const;

  private:
    struct Word {
        ImVec2 wanted;
        ImVec4 colour;
        std::string text;
    };
    LabelRoom lines_;
    std::vector<Word> letters_, angles_;
};

struct ArrowLook {
    ImVec4 colour;
    float width = 2;  // logical pixels
    const char* letter = "";
    Words* words = nullptr;  // receives the letter; null: it is drawn at once
};
/// Draws an arrow from `from` to `to` with its letter at the tip; an arrow towards or away from the viewer
/// becomes a circle with a dot.
void draw_arrow(ImDrawList& list, ImVec2 from, ImVec2 to, const ArrowLook& look);

/// Draws the arc from direction a to b (unit vectors) with its angle in degrees, at `radius` times the pen's
/// reach. The label avoids other labels, and is omitted if there is not enough room.
void draw_arc(const PointPen& pen, glm::dvec3 a, glm::dvec3 b, double radius, const ImVec4& colour,
              Words& words);

}  // namespace glint
