// Whether a control's text is legible: measured on the drawn output, in every state and theme.
#include <imgui_internal.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Source: WCAG 2.1, success criterion 1.4.3, for text of normal size.
constexpr double least_contrast = 4.5;

ImVec4 over(const ImVec4& top, const ImVec4& below) {
    const auto mix = [&](float t, float b) { return b + (t - b) * top.w; };
    return {mix(top.x, below.x), mix(top.y, below.y), mix(top.z, below.z), 1};
}

bool holds(const ImDrawVert* const (&corner)[3], ImVec2 p) {
    const auto side = [&](ImVec2 a, ImVec2 b) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    const float a = side(corner[0]->pos, corner[1]->pos), b = side(corner[1]->pos, corner[2]->pos),
                c = side(corner[2]->pos, corner[0]->pos);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

/// A drawn letter, and the colour under it.
struct Ink {
    ImVec2 at;
    ImVec4 colour, ground;
};

/// The positions of all fonts' letters in their texture.
using Glyphs = std::set<std::pair<float, float>>;
Glyphs all_glyphs() {
    Glyphs glyphs;
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs) glyphs.insert({glyph.U0, glyph.V0});
    return glyphs;
}

/// All letters of the last frame within `area`, painted over theme().panel in ImGui's order.
class Painter {
  public:
    Painter(const Rect& area, const Glyphs& glyphs) : area_(area), glyphs_(glyphs) {
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int i = 0; i < data.CmdListsCount; ++i)
            for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) paint(*data.CmdLists[i], command);
    }
    [[nodiscard]] const std::vector<Ink>& inks() const { return inks_; }

  private:
    struct Fill {
        const ImDrawVert* corner[3];
        ImVec4 clip;
    };

    void paint(const ImDrawList& list, const ImDrawCmd& command) {
        if (command.UserCallback != nullptr || !overlaps(command.ClipRect)) return;
        const ImDrawIdx* const index = list.IdxBuffer.Data + command.IdxOffset;
        const ImDrawVert* const vertex = list.VtxBuffer.Data + command.VtxOffset;
        const ImVec2 white = ImGui::GetIO().Fonts->TexUvWhitePixel;
        for (unsigned i = 0; i + 3 <= command.ElemCount; i += 3) {
            const ImDrawVert *const a = vertex + index[i], *const b = vertex + index[i + 1],
                                    *const c = vertex + index[i + 2];
            if (!reaches(a->pos, b->pos, c->pos)) continue;
            const bool plain =
                a->uv.x == white.x && a->uv.y == white.y && b->uv.x == white.x && c->uv.x == white.x;
            if (plain && a->col == b->col && b->col == c->col)
                fills_.push_back({{a, b, c}, command.ClipRect});
            else if (!plain && glyphs_.contains({a->uv.x, a->uv.y}) && a->pos.y == b->pos.y)
                add_ink({(a->pos.x + c->pos.x) / 2, (a->pos.y + c->pos.y) / 2}, a->col, command.ClipRect);
        }
    }
    [[nodiscard]] bool reaches(ImVec2 a, ImVec2 b, ImVec2 c) const {
        const auto all = [](bool p, bool q, bool r) { return p && q && r; };
        const ImVec2 low = area_.low, high = area_.high;
        return !all(a.x > high.x, b.x > high.x, c.x > high.x) &&
               !all(a.x < low.x, b.x < low.x, c.x < low.x) &&
               !all(a.y > high.y, b.y > high.y, c.y > high.y) && !all(a.y < low.y, b.y < low.y, c.y < low.y);
    }
    [[nodiscard]] bool overlaps(const ImVec4& clip) const {
        return clip.x <= area_.high.x && clip.z >= area_.low.x && clip.y <= area_.high.y &&
               clip.w >= area_.low.y;
    }
    void add_ink(ImVec2 at, ImU32 colour, const ImVec4& clip) {
        const bool shown = at.x >= clip.x && at.x < clip.z && at.y >= clip.y && at.y < clip.w;
        if (!area_.holds(at) || !shown) return;
        ImVec4 ground = theme().panel;
        for (const Fill& fill : fills_)
            if (at.x >= fill.clip.x && at.x < fill.clip.z && at.y >= fill.clip.y && at.y < fill.clip.w &&
                holds(fill.corner, at))
                ground = over(ImGui::ColorConvertU32ToFloat4(fill.corner[0]->col), ground);
        inks_.push_back({at, ImGui::ColorConvertU32ToFloat4(colour), ground});
    }

    Rect area_;
    const Glyphs& glyphs_;
    std::vector<Fill> fills_;
    std::vector<Ink> inks_;
};

/// A disabled control may be faint.
bool is_exempt(const Ink& ink) {
    const ImVec4& off = theme().disabled_text;
    return ink.colour.w < 0.98f ||
           (std::abs(ink.colour.x - off.x) < 0.01f && std::abs(ink.colour.y - off.y) < 0.01f);
}

/// Checks the letters of a control; returns their number.
std::size_t check_letters(const NamedControl& control, const Glyphs& glyphs, const char* how) {
    const Painter painter(control.at, glyphs);
    double worst = 21;
    for (const Ink& ink : painter.inks())
        if (!is_exempt(ink)) worst = std::min(worst, contrast(over(ink.colour, ink.ground), ink.ground));
    INFO((theme().dark ? "dark " : "light ") << how << " " << control.name << " " << control.key);
    CHECK(worst >= least_contrast);
    return painter.inks().size();
}

/// The positions at which a control of that name and key was checked.
using Checked = std::set<std::tuple<std::string, std::string, float, float>>;

/// Checks each control outside the picture while idle, hovered and pressed, once per position.
std::size_t check_controls(HeadlessWindow& bench, Checked& checked) {
    const Layout layout = lay_out(ImGui::GetIO().DisplaySize, bench.state.layout, 1);
    const std::vector<NamedControl> controls = bench.controls();
    const Glyphs glyphs = all_glyphs();
    std::size_t letters = 0;
    for (const NamedControl& control : controls) {
        const ImVec2 at = HeadlessWindow::middle_of(control.at);
        if (!control.in_sight || layout.centre.holds(at)) continue;
        if (!checked.emplace(control.name, control.key, at.x, at.y).second) continue;
        letters += check_letters(control, glyphs, "idle");
        bench.move(at);
        check_letters(control, glyphs, "hovered");
        bench.button(true);
        check_letters(control, glyphs, "pressed");
        bench.move({5, 795});  // so that nothing is clicked
        bench.button(false);
        bench.frames(1);
    }
    return letters;
}

}  // namespace

TEST_CASE("every control is legible in all its states, in all themes",
          "[ui][window][contrast][long][release]") {
    const bool light = GENERATE(false, true), projector = GENERATE(false, true);
    HeadlessWindow bench({1600, 1000});
    apply_theme(projector ? projector_theme(!light) : light ? light_theme() : dark_theme(), 1);
    bench.state.viewport.probe = glm::dvec2(0.5, 0.5);
    bench.state.get<CompareState>().choice.on = true;
    using Kind = Selection::Kind;
    std::size_t letters = 0;
    Checked checked;
    for (const Kind kind : {Kind::Light, Kind::Object, Kind::Shading, Kind::Display, Kind::Camera}) {
        bench.state.editor.selection = {kind, 0};
        bench.frames(3);
        letters += check_controls(bench, checked);
    }
    CHECK(letters > 500);  // makes sure that letters were found
}

TEST_CASE("disabled controls keep a contrast of 3 to 1", "[ui][contrast]") {
    HeadlessWindow bench;
    for (const Theme* each : {&dark_theme(), &light_theme()}) {
        apply_theme(*each, 1);
        const float alpha = ImGui::GetStyle().DisabledAlpha;
        const auto faded = [&](ImVec4 colour, const ImVec4& below) {
            colour.w = alpha;
            return over(colour, below);
        };
        for (const auto& [ink, ground] :
             {std::pair(each->text, each->field), std::pair(each->dim_text, each->panel),
              std::pair(each->accent_text, each->accent)}) {
            const ImVec4 under = faded(ground, each->panel);
            CHECK(contrast(faded(ink, under), under) >= 3);
        }
        CHECK(contrast(each->disabled_text, each->field) >= 3);
    }
}

TEST_CASE("controls are at least 24 units high at the window's text size of 15", "[ui][contrast]") {
    HeadlessWindow bench;
    CHECK(15 + 2 * ImGui::GetStyle().FramePadding.y >= 24);
}
