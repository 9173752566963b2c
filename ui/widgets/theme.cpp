#include "ui/widgets/theme.h"

#include <imgui_freetype.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <vector>

#include "ui/widgets/kept.h"

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
    // Units are square. If the height does not match the ratio, the two values belong to different sizes.
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

}  // namespace glint
