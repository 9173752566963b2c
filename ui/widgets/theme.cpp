#include "ui/widgets/theme.h"

#include <imgui_freetype.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "ui/widgets/kept.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Converts 0xRRGGBB to an ImGui colour.
ImVec4 rgb(unsigned hex) {
    return {float((hex >> 16) & 255) / 255, float((hex >> 8) & 255) / 255, float(hex & 255) / 255, 1};
}

/// The theme and the scale applied last, and the fonts loaded last.
struct Applied {
    const Theme* theme = &dark_theme();
    float scale = 1;
    Fonts fonts;
};

double luminance(const ImVec4& c) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
}

constexpr double projector_contrast = 7.1;  // slightly above 7, because colours are rounded to bytes

/// Returns `ink`, shifted towards white (on dark backgrounds) or black until it contrasts enough with all of
/// `grounds`.
ImVec4 strengthened(ImVec4 ink, std::initializer_list<ImVec4> grounds, bool dark) {
    const float end = dark ? 1 : 0;
    for (float share = 0; share <= 1; share += 0.01f) {
        const auto mix = [&](float v) { return v + (end - v) * share; };
        const ImVec4 mixed{mix(ink.x), mix(ink.y), mix(ink.z), 1};
        if (std::all_of(grounds.begin(), grounds.end(),
                        [&](const ImVec4& g) { return contrast(mixed, g) >= projector_contrast; }))
            return mixed;
    }
    return {end, end, end, 1};
}

Theme for_projector(Theme t) {
    const auto deeper = [&t](ImVec4& ground, float share) {
        const float end = t.dark ? 0 : 1;
        ground.x += (end - ground.x) * share, ground.y += (end - ground.y) * share;
        ground.z += (end - ground.z) * share;
    };
    for (ImVec4* ground : {&t.window, &t.panel}) deeper(*ground, 0.6f);
    for (ImVec4* ground : {&t.field, &t.field_hovered, &t.field_active}) deeper(*ground, 0.3f);
    for (ImVec4* ink : {&t.text, &t.dim_text, &t.warning, &t.error})
        *ink = strengthened(*ink, {t.window, t.panel, t.field, t.field_hovered, t.field_active}, t.dark);
    for (ImVec4& symbol : t.symbols) symbol = strengthened(symbol, {t.window, t.panel, t.field}, t.dark);
    t.accent = strengthened(t.accent, {t.window, t.panel}, t.dark);
    t.accent_text = strengthened(t.accent_text, {t.accent}, !t.dark);
    t.disabled_text = t.dim_text;
    return t;
}

void set_colours(ImGuiStyle& style, const Theme& t) {
    const ImVec4 clear{0, 0, 0, 0};
    const auto faint = [](ImVec4 c, float opacity) { return ImVec4(c.x, c.y, c.z, opacity); };
    const auto set = [&style](ImGuiCol slot, ImVec4 colour) { style.Colors[slot] = colour; };
    set(ImGuiCol_Text, t.text), set(ImGuiCol_TextDisabled, t.disabled_text);
    set(ImGuiCol_WindowBg, t.panel), set(ImGuiCol_ChildBg, clear), set(ImGuiCol_PopupBg, t.window);
    set(ImGuiCol_Border, t.line), set(ImGuiCol_BorderShadow, clear), set(ImGuiCol_Separator, t.line);
    set(ImGuiCol_FrameBg, t.field), set(ImGuiCol_FrameBgHovered, t.field_hovered);
    set(ImGuiCol_FrameBgActive, t.field_active), set(ImGuiCol_Button, t.field);
    set(ImGuiCol_ButtonHovered, t.field_hovered), set(ImGuiCol_ButtonActive, t.field_active);
    set(ImGuiCol_Header, faint(t.accent, 0.35f)), set(ImGuiCol_HeaderHovered, t.field_hovered);
    set(ImGuiCol_HeaderActive, t.field_active), set(ImGuiCol_CheckMark, t.accent);
    set(ImGuiCol_SliderGrab, t.accent), set(ImGuiCol_SliderGrabActive, t.accent);
    set(ImGuiCol_MenuBarBg, t.window), set(ImGuiCol_TitleBg, t.window), set(ImGuiCol_TitleBgActive, t.window);
    set(ImGuiCol_ScrollbarBg, clear), set(ImGuiCol_ScrollbarGrab, t.field_hovered);
    set(ImGuiCol_ScrollbarGrabHovered, t.field_active), set(ImGuiCol_ScrollbarGrabActive, t.field_active);
    set(ImGuiCol_Tab, clear), set(ImGuiCol_TabHovered, t.field_hovered), set(ImGuiCol_TabActive, t.field);
    set(ImGuiCol_TabUnfocused, clear), set(ImGuiCol_TabUnfocusedActive, t.field);
    set(ImGuiCol_TextSelectedBg, faint(t.accent, 0.4f)), set(ImGuiCol_NavHighlight, t.accent);
    set(ImGuiCol_TableBorderLight, t.line), set(ImGuiCol_TableBorderStrong, t.line);
    set(ImGuiCol_TableHeaderBg, t.field), set(ImGuiCol_TableRowBg, clear), set(ImGuiCol_TableRowBgAlt, clear);
    set(ImGuiCol_ModalWindowDimBg, faint(rgb(0x000000), 0.45f));
    set(ImGuiCol_ResizeGrip, clear), set(ImGuiCol_ResizeGripHovered, t.accent);
    set(ImGuiCol_PlotHistogram, t.accent), set(ImGuiCol_DragDropTarget, t.accent);
}

}  // namespace

const Theme& dark_theme() {
    static const Theme dark{
        .dark = true,
        .window = rgb(0x17191c),
        .panel = rgb(0x1f2226),
        .field = rgb(0x2b2f35),
        .field_hovered = rgb(0x383d45),
        .field_active = rgb(0x454b55),
        .line = rgb(0x33383f),
        .text = rgb(0xe6e8eb),
        .dim_text = rgb(0xb6bcc5),
        .disabled_text = rgb(0x858c97),
        .accent = rgb(0x4c9be8),
        .accent_text = rgb(0x0d1218),
        .warning = rgb(0xe6a23c),
        .error = rgb(0xff7b6b),
        .surround = rgb(0x777777),
        .symbols = {rgb(0x1fbf8f), rgb(0xf0e442), rgb(0x56b4e9), rgb(0xe69f00), rgb(0xd68ab2), rgb(0x4a9fd8),
                    rgb(0xf0742a), rgb(0xf2f2f2), rgb(0xa0a0a0), rgb(0xb5a2f0)}};
    return dark;
}

const Theme& light_theme() {
    static const Theme light{
        .dark = false,
        .window = rgb(0xe9ebee),
        .panel = rgb(0xf6f7f8),
        .field = rgb(0xe2e5e9),
        .field_hovered = rgb(0xd3d8de),
        .field_active = rgb(0xc3cad2),
        .line = rgb(0xcdd2d8),
        .text = rgb(0x1b1e22),
        .dim_text = rgb(0x4d545d),
        .disabled_text = rgb(0x646b74),
        .accent = rgb(0x1f6fc0),
        .accent_text = rgb(0xffffff),
        .warning = rgb(0x8a5a00),
        .error = rgb(0xb3261e),
        .surround = rgb(0x777777),
        .symbols = {rgb(0x00704f), rgb(0x6f6700), rgb(0x0f6f9f), rgb(0x8a5f00), rgb(0xa04878), rgb(0x005f96),
                    rgb(0xa54400), rgb(0x222222), rgb(0x666666), rgb(0x6a48b5)}};
    return light;
}

const Theme& projector_theme(bool dark) {
    static const Theme of_dark = for_projector(dark_theme()), of_light = for_projector(light_theme());
    return dark ? of_dark : of_light;
}

ImVec4 accent_pointed_at(const Theme& theme, bool pressed) {
    const bool light_ink = luminance(theme.accent_text) > luminance(theme.accent);
    const float end = light_ink ? 0 : 1, share = pressed ? 0.28f : 0.16f;
    const auto mix = [&](float v) { return v + (end - v) * share; };
    return {mix(theme.accent.x), mix(theme.accent.y), mix(theme.accent.z), 1};
}

const Theme& theme() { return *widget_state<Applied>().theme; }
float px(float length) {
    return ImGui::GetCurrentContext() == nullptr ? length : length * widget_state<Applied>().scale;
}

void apply_theme(const Theme& chosen, float scale) {
    widget_state<Applied>().theme = &chosen;
    widget_state<Applied>().scale = scale;
    ImGuiStyle style;
    style.WindowPadding = {10, 8};
    style.FramePadding = {7, 5};  // with text of size 15: at least 24 high, as WCAG 2.2 (2.5.8) requires
    style.DisabledAlpha = 0.85f;
    style.ItemSpacing = {6, 4};
    style.ItemInnerSpacing = {5, 4};
    style.CellPadding = {5, 2};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 9;
    style.WindowRounding = 0;
    style.ChildRounding = 0;
    style.FrameRounding = 4;
    style.PopupRounding = 6;
    style.ScrollbarRounding = 6;
    style.GrabRounding = 4;
    style.TabRounding = 4;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.ScaleAllSizes(scale);
    // This is not a design length but ImGui's own lower limit. If scaled by less than 1, it would be rounded
    // to 0.
    style.WindowMinSize = {1, 1};
    set_colours(style, chosen);
    ImGui::GetStyle() = style;
}

double contrast(const ImVec4& a, const ImVec4& b) {
    const double high = std::max(luminance(a), luminance(b)), low = std::min(luminance(a), luminance(b));
    return (high + 0.05) / (low + 0.05);
}

ImU32 to_u32(const ImVec4& colour, float opacity) {
    return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, colour.w * opacity});
}

namespace {

namespace fs = std::filesystem;

struct Family {
    const char *text, *bold, *figures;  // paths below a font folder
};
constexpr std::array families{
    Family{"truetype/dejavu/DejaVuSans.ttf", "truetype/dejavu/DejaVuSans-Bold.ttf",
           "truetype/dejavu/DejaVuSansMono.ttf"},
    Family{"dejavu/DejaVuSans.ttf", "dejavu/DejaVuSans-Bold.ttf", "dejavu/DejaVuSansMono.ttf"},
    Family{"TTF/DejaVuSans.ttf", "TTF/DejaVuSans-Bold.ttf", "TTF/DejaVuSansMono.ttf"},
    Family{"truetype/noto/NotoSans-Regular.ttf", "truetype/noto/NotoSans-Bold.ttf",
           "truetype/noto/NotoSansMono-Regular.ttf"},
    Family{"truetype/liberation/LiberationSans-Regular.ttf", "truetype/liberation/LiberationSans-Bold.ttf",
           "truetype/liberation/LiberationMono-Regular.ttf"},
};

std::vector<fs::path> font_folders() {
    std::vector<fs::path> folders{"/usr/share/fonts", "/usr/local/share/fonts"};
    if (const char* home = std::getenv("HOME")) {
        folders.push_back(fs::path(home) / ".local/share/fonts");
        folders.push_back(fs::path(home) / ".fonts");
    }
    return folders;
}

/// Latin, Greek, and the symbols used in the equation and the window's texts.
constexpr std::array<ImWchar, 25> glyphs{
    0x20,   0xFF,   0x131,  0x131,  0x2E2,  0x2E2,  0x370,  0x3FF,  0x2010, 0x2027, 0x2030, 0x203A, 0x2070,
    0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0x2713, 0x2717, 0x2022, 0x2022, 0};

/// ImGui's own font is Latin-1 only, so other characters are replaced by the most similar letter.
void stand_in(ImFont& font) {
    struct StandIn {
        ImWchar sign, letter;
    };
    for (const auto [sign, letter] : {StandIn{0x2212, '-'},
                                      {0x2013, '-'},
                                      {0x2192, '>'},
                                      {0x2032, '\''},
                                      {0x2026, 0xB7},
                                      {0x2E2, 's'},
                                      {0x3A3, 'S'},
                                      {0x3B1, 'a'},
                                      {0x3B8, 'o'},
                                      {0x2265, '>'},
                                      {0x2264, '<'},
                                      {0x2022, 0xB7},
                                      {0x221E, '8'}})
        font.AddRemapChar(sign, letter);
}

}  // namespace

FontFiles find_fonts() {
    for (const fs::path& folder : font_folders())
        for (const Family& family : families) {
            std::error_code failed;
            if (fs::is_regular_file(folder / family.text, failed) &&
                fs::is_regular_file(folder / family.bold, failed) &&
                fs::is_regular_file(folder / family.figures, failed))
                return {(folder / family.text).string(), (folder / family.bold).string(),
                        (folder / family.figures).string()};
        }
    return {};
}

void load_fonts(const FontFiles& files, float scale, float dots_per_unit) {
    ImGuiIO& io = ImGui::GetIO();
    ImFontAtlas& atlas = *io.Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    io.FontGlobalScale = 1 / dots_per_unit;
    const float dots = scale * dots_per_unit;
    if (files.text.empty()) {
        ImFontConfig config;
        config.SizePixels = 13 * dots;
        ImFont* only = atlas.AddFontDefault(&config);
        widget_state<Applied>().fonts = {only, only, only, only, only, only};
        atlas.Build();
        stand_in(*only);
        return;
    }
    const auto add = [&](const std::string& path, float size) {
        return atlas.AddFontFromFileTTF(path.c_str(), size * dots, nullptr, glyphs.data());
    };
    widget_state<Applied>().fonts = {add(files.text, 15),    add(files.text, 13), add(files.bold, 15),
                                     add(files.figures, 14), add(files.text, 17), add(files.bold, 18)};
    atlas.Build();
}

const Fonts& fonts() { return widget_state<Applied>().fonts; }

float small_text_height() { return fonts().small->FontSize * ImGui::GetIO().FontGlobalScale; }

namespace {

constexpr float least_scale = 0.75f, max_scale = 4;  // dots per logical pixel
constexpr float least_dots = 0.5f, max_dots = 4;     // per unit of the window

/// Whether `dots` is `units` times `ratio`, rounded up or down to whole dots.
bool fits(int units, int dots, float ratio) {
    return std::abs(static_cast<float>(units) * ratio - static_cast<float>(dots)) <= 1;
}

float dots_per_unit(const WindowExtent& extent, float before) {
    const glm::ivec2 size = extent.size, dots = extent.dots;
    if (size != extent.size_after || size.x <= 0 || size.y <= 0 || dots.x <= 0 || dots.y <= 0) return before;
    if (fits(size.x, dots.x, before) && fits(size.y, dots.y, before)) return before;
    const float ratio = static_cast<float>(dots.x) / static_cast<float>(size.x);
    // Units are square. If the height does not match the ratio, the window was resized between the queries.
    if (!fits(size.y, dots.y, ratio)) return before;
    return std::clamp(ratio, least_dots, max_dots);
}

}  // namespace

DisplayScale display_scale(const WindowExtent& extent, const DisplayScale& before) {
    DisplayScale scale;
    scale.dots_per_unit = dots_per_unit(extent, before.dots_per_unit);
    const float content = std::isfinite(extent.content_scale) ? extent.content_scale : 1;
    scale.design = std::clamp(content, least_scale, max_scale) / scale.dots_per_unit;
    return scale;
}

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Draws in a square of side 2 centred at the origin, which is then scaled and moved into place.
struct Pen {
    ImDrawList& list;
    ImVec2 centre;
    float unit, width;
    ImU32 colour;

    [[nodiscard]] ImVec2 at(float x, float y) const { return {centre.x + x * unit, centre.y + y * unit}; }
    void line(float x0, float y0, float x1, float y1) const {
        list.AddLine(at(x0, y0), at(x1, y1), colour, width);
    }
    void ring(float x, float y, float r) const { list.AddCircle(at(x, y), r * unit, colour, 0, width); }
    void disc(float x, float y, float r) const { list.AddCircleFilled(at(x, y), r * unit, colour); }
    void arc(float x, float y, float r, float from, float to) const {
        list.PathArcTo(at(x, y), r * unit, from, to);
        list.PathStroke(colour, 0, width);
    }
    void box(float x0, float y0, float x1, float y1) const {
        list.AddRect(at(x0, y0), at(x1, y1), colour, 0.2f * unit, 0, width);
    }
};

void draw_bulb(const Pen& pen) {
    pen.disc(0, -0.25f, 0.62f);
    pen.line(-0.3f, 0.58f, 0.3f, 0.58f);
    pen.line(-0.22f, 0.86f, 0.22f, 0.86f);
}

void draw_sun(const Pen& pen) {
    pen.disc(0, 0, 0.42f);
    for (int i = 0; i < 8; ++i) {
        const float a = float(i) * pi / 4, x = std::cos(a), y = std::sin(a);
        pen.line(0.64f * x, 0.64f * y, 0.95f * x, 0.95f * y);
    }
}

void draw_spot(const Pen& pen) {
    pen.list.AddTriangleFilled(pen.at(0, -0.85f), pen.at(0.72f, 0.5f), pen.at(-0.72f, 0.5f), pen.colour);
    pen.list.PathArcTo(pen.at(0, 0.5f), 0.72f * pen.unit, 0, pi, 12);
    pen.list.PathFillConvex(pen.colour);
}

void draw_area(const Pen& pen) {
    pen.list.AddQuadFilled(pen.at(-0.45f, -0.6f), pen.at(0.95f, -0.6f), pen.at(0.45f, 0.6f),
                           pen.at(-0.95f, 0.6f), pen.colour);
}

void draw_camera(const Pen& pen) {
    pen.box(-0.95f, -0.5f, 0.3f, 0.55f);
    pen.list.AddTriangleFilled(pen.at(0.38f, 0.02f), pen.at(0.95f, -0.45f), pen.at(0.95f, 0.5f), pen.colour);
}

void draw_object(const Pen& pen) {
    const ImVec2 top = pen.at(0, -0.95f), right = pen.at(0.82f, -0.47f), left = pen.at(-0.82f, -0.47f);
    const ImVec2 middle = pen.at(0, 0), low = pen.at(0, 0.95f);
    const ImVec2 outline[] = {top, right, pen.at(0.82f, 0.47f), low, pen.at(-0.82f, 0.47f), left};
    pen.list.AddPolyline(outline, 6, pen.colour, ImDrawFlags_Closed, pen.width);
    pen.list.AddLine(left, middle, pen.colour, pen.width);
    pen.list.AddLine(right, middle, pen.colour, pen.width);
    pen.list.AddLine(low, middle, pen.colour, pen.width);
}

void draw_shading(const Pen& pen) {  // a ball with one half lit
    pen.ring(0, 0, 0.82f);
    pen.list.PathArcTo(pen.at(0, 0), 0.82f * pen.unit, pi / 2, 3 * pi / 2, 16);
    pen.list.PathFillConvex(pen.colour);
}

void draw_display(const Pen& pen) {
    pen.box(-0.95f, -0.75f, 0.95f, 0.45f);
    pen.line(-0.4f, 0.85f, 0.4f, 0.85f);
    pen.line(0, 0.45f, 0, 0.85f);
}

void draw_eye(const Pen& pen, bool open) {
    if (open) {
        pen.arc(0, 0.62f, 1.1f, pi * 1.19f, pi * 1.81f);
        pen.arc(0, -0.62f, 1.1f, pi * 0.19f, pi * 0.81f);
        pen.disc(0, 0, 0.3f);
    } else {
        pen.arc(0, -0.55f, 1.05f, pi * 0.19f, pi * 0.81f);
        for (const float x : {-0.6f, 0.0f, 0.6f}) pen.line(0.9f * x, 0.38f, 1.1f * x, 0.68f);
    }
}

/// Draws a half circle that ends in an arrow, at its left (undo) or its right (redo).
void draw_turn(const Pen& pen, float way) {
    pen.arc(0, 0.3f, 0.62f, pi, 2 * pi);
    const float x = way * 0.62f;
    pen.list.AddTriangleFilled(pen.at(x - 0.42f, 0.18f), pen.at(x + 0.42f, 0.18f), pen.at(x, 0.78f),
                               pen.colour);
}

void draw_folder(const Pen& pen) {
    pen.list.AddRectFilled(pen.at(-0.85f, -0.6f), pen.at(0, 0), pen.colour, 0.15f * pen.unit);
    pen.list.AddRectFilled(pen.at(-0.85f, -0.4f), pen.at(0.85f, 0.65f), pen.colour, 0.15f * pen.unit);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
    const Pen pen{list, centre, size / 2, std::max(1.0f, size / 12), colour};
    switch (icon) {
    case Icon::Bulb:
        return draw_bulb(pen);
    case Icon::Sun:
        return draw_sun(pen);
    case Icon::Spot:
        return draw_spot(pen);
    case Icon::Area:
        return draw_area(pen);
    case Icon::Camera:
        return draw_camera(pen);
    case Icon::Object:
        return draw_object(pen);
    case Icon::Shading:
        return draw_shading(pen);
    case Icon::Display:
        return draw_display(pen);
    case Icon::Eye:
        return draw_eye(pen, true);
    case Icon::EyeOff:
        return draw_eye(pen, false);
    case Icon::Plus:
        return pen.line(-0.6f, 0, 0.6f, 0), pen.line(0, -0.6f, 0, 0.6f);
    case Icon::Undo:
        return draw_turn(pen, -1);
    case Icon::Redo:
        return draw_turn(pen, 1);
    case Icon::Close:
        return pen.line(-0.5f, -0.5f, 0.5f, 0.5f), pen.line(-0.5f, 0.5f, 0.5f, -0.5f);
    case Icon::More:
        for (const float x : {-0.55f, 0.0f, 0.55f}) pen.disc(x, 0, 0.16f);
        return;
    case Icon::Folder:
        return draw_folder(pen);
    case Icon::File:
        return pen.box(-0.55f, -0.8f, 0.55f, 0.8f);
    case Icon::Up:
        return pen.line(0, 0.7f, 0, -0.6f), pen.line(0, -0.65f, -0.5f, -0.1f),
               pen.line(0, -0.65f, 0.5f, -0.1f);
    }
}

Icon icon_of(LightKind kind) {
    switch (kind) {
    case LightKind::Directional:
        return Icon::Sun;
    case LightKind::Point:
        return Icon::Bulb;
    case LightKind::Spot:
        return Icon::Spot;
    case LightKind::Area:
        return Icon::Area;
    }
    return Icon::Bulb;  // not reached
}

ImVec4 colour_of(const Light& light) {
    const glm::vec3 d = light.diffuse, s = light.specular;
    const glm::vec3 own = d.x + d.y + d.z > 0 ? d : s;
    const float largest = std::max({own.x, own.y, own.z});
    if (!(largest > 0)) return {0.5f, 0.5f, 0.5f, 1};
    return {own.x / largest, own.y / largest, own.z / largest, 1};
}

ImVec4 legible(ImVec4 colour) {
    constexpr double enough = 3;  // contrast of an icon, which is larger than text. Source: WCAG 2.1, 1.4.11
    // The icon is also legible on a selected row of a list, which is darker than the panel.
    constexpr float tint = 0.3f;
    const ImVec4 &panel = theme().panel, &accent = theme().accent;
    const auto mixed = [](float a, float b) { return (1 - tint) * a + tint * b; };
    const ImVec4 chosen{mixed(panel.x, accent.x), mixed(panel.y, accent.y), mixed(panel.z, accent.z), 1};
    while (!theme().dark && contrast(colour, chosen) < enough)
        colour = {0.93f * colour.x, 0.93f * colour.y, 0.93f * colour.z, colour.w};
    return colour;
}

bool icon_button(const char* id, Icon icon, bool on) {
    const float size = ImGui::GetFrameHeight();
    const bool pressed = hit_area(id, {size, size});
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float opacity = ImGui::GetStyle().Alpha;
    const bool hovered = ImGui::IsItemHovered();
    if (on || hovered)
        list.AddRectFilled(low, high, to_u32(on ? theme().accent : theme().field_hovered, opacity),
                           ImGui::GetStyle().FrameRounding);
    const ImVec4& ink = on ? theme().accent_text : hovered ? theme().text : theme().dim_text;
    draw_icon(list, icon, {(low.x + high.x) / 2, (low.y + high.y) / 2}, size * 0.58f, to_u32(ink, opacity));
    return pressed;
}

}  // namespace glint
