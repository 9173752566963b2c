#include "ui/widgets/fonts.h"

#include <imgui_freetype.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace glint {
namespace {

namespace fs = std::filesystem;

Fonts loaded;  // applied last (ui/ui.h)

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

/// Latin, Greek, and the symbols in the equation and the window's texts.
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
        loaded = {only, only, only, only, only, only};
        atlas.Build();
        stand_in(*only);
        return;
    }
    const auto add = [&](const std::string& path, float size) {
        return atlas.AddFontFromFileTTF(path.c_str(), size * dots, nullptr, glyphs.data());
    };
    loaded = {add(files.text, 15),    add(files.text, 13), add(files.bold, 15),
              add(files.figures, 14), add(files.text, 17), add(files.bold, 18)};
    atlas.Build();
}

const Fonts& fonts() { return loaded; }

float small_text_height() { return fonts().small->FontSize * ImGui::GetIO().FontGlobalScale; }

}  // namespace glint
