#include "ui/features/inspector/mistake_row.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/search/supposition.h"
#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/features/export/animation.h"
#include "ui/features/inspector/inspector.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// The lower lines of a mistake's tooltip: similar mistakes, and who reported it.
std::string notes_on(const MistakeName& mistake) {
    std::string notes;
    if (!mistake.look_alikes.empty()) {
        std::string names(mistake.look_alikes);
        std::replace(names.begin(), names.end(), ' ', '\n');
        notes += fmt::format("Looks like:\n{}\n", with_spaces(names));
    }
    if (!mistake.sources.empty()) notes += fmt::format("Asked in: {}\n", mistake.sources);
    return notes + "off by default";
}

/// Draws one line in the current font, truncated with an ellipsis.
void cut_line(ImDrawList& list, const Rect& line, const ImVec4& colour, std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    cut_text(list, line.low, line.high.x, text);
    ImGui::PopStyleColor();
}

/// Draws text in the current font, wrapped to as many lines as fit into `area`, the last one truncated with
/// an ellipsis. Returns the y coordinate of the text's lower edge.
float broken_lines(ImDrawList& list, const Rect& area, const ImVec4& colour, std::string_view words) {
    const float height = ImGui::GetTextLineHeight();
    const char *at = words.data(), *const end = at + words.size();
    float y = area.low.y;
    while (at < end && y + height <= area.high.y) {
        const bool is_last = y + 2 * height > area.high.y;
        const char* const next =
            is_last ? end
                    : ImGui::GetFont()->CalcWordWrapPositionA(
                          ImGui::GetFontSize() / ImGui::GetFont()->FontSize, at, end, area.size().x);
        cut_line(list, {{area.low.x, y}, {area.high.x, y + height}}, colour, {at, next});
        at = next;
        while (at < end && *at == ' ') ++at;
        y += height;
    }
    return y;
}

/// Draws the check box of the switch, `edge` wide.
void box(ImVec2 low, float edge, bool on) {
    const ImVec2 high = low + ImVec2(edge, edge);
    ImGui::RenderFrame(low, high, to_u32(theme().field), true, px(3));
    const float inset = std::max(1.0f, std::floor(edge / 6));
    if (on)
        ImGui::RenderCheckMark(ImGui::GetWindowDrawList(), low + ImVec2(inset, inset), to_u32(theme().accent),
                               edge - 2 * inset);
}

/// Draws, next to the picture: the switch and the name, how to recognise the mistake, and who reported it.
void words_of(const MistakeName& mistake, bool on, bool dim, const Rect& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight();
    box({area.low.x, area.low.y + px(1)}, line - px(2), on);
    const std::string title = title_of(mistake);
    Rect first{area.low + ImVec2(line + px(4), 0), {area.high.x, area.low.y + line}};
    const ImVec4& ink = dim ? theme().dim_text : theme().text;
    const bool fits = ImGui::CalcTextSize(title.c_str()).x <= first.size().x;
    if (fits) cut_line(list, first, ink, title);
    ImGui::PushFont(fonts().small);
    const float small_line = ImGui::GetTextLineHeight(), last = mistake.sources.empty() ? 0 : small_line;
    if (!fits)
        first.high.y =
            broken_lines(list, {first.low, {first.high.x, first.low.y + 2 * small_line}}, ink, title);
    const float y = broken_lines(list, {{area.low.x, first.high.y + px(2)}, area.high - ImVec2(0, last)},
                                 theme().dim_text, mistake.looks);
    // One line, because a tracker's name and number cannot be wrapped. The tooltip lists all of them.
    cut_line(list, {{area.low.x, y}, {area.high.x, y + last}}, theme().disabled_text, mistake.sources);
    ImGui::PopFont();
}

}  // namespace

std::string title_of(const MistakeName& mistake) {
    std::string title = with_spaces(mistake.name);
    if (title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
}

std::string SmallLook::words(int index) const {
    const auto place = static_cast<std::size_t>(index);
    return place < pictures.words.size() ? pictures.words[place] : std::string();
}

float small_inset() { return px(4); }

void draw_small(const SmallLook& look, int index, ImVec2 low) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high = low + look.extent();
    const SmallPictures& pictures = look.pictures;
    const std::string words = look.words(index);
    const float strength = index < pictures.taken ? 1 : 0.4f;
    list.AddRectFilled(low, high, to_u32(theme().field), px(3));
    ImGui::PushFont(fonts().small);
    if (words == no_difference) {
        const float wrap = look.extent().x - px(8);
        const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, wrap);
        list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), (low + high - size) / 2,
                     to_u32(theme().dim_text, strength), words.c_str(), nullptr, wrap);
    } else if (pictures.sheet.serial > 0) {
        pictures.sheet.draw(list, index, low, high, strength);
        const float line = ImGui::GetTextLineHeight();
        if (!words.empty())
            rimmed_text(list, {(low.x + high.x) / 2, high.y - line / 2 - px(2)}, {1, 1, 1, strength}, words);
    }
    ImGui::PopFont();
}

bool mistake_row(const MistakeName& mistake, bool& on, const SmallLook& look, int index) {
    const float inset = small_inset(), wide = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(index);
    if (hit_area("##mistake", {wide, look.extent().y + 2 * inset})) on = !on;
    ImGui::PopID();
    if (!ImGui::IsItemVisible()) return false;  // most rows are scrolled out of view: skip their text
    const bool pointed = is_pointed_at();
    tooltip(title_of(mistake).c_str(), fmt::format("{} {}", mistake.what, mistake.looks).c_str(),
            notes_on(mistake), fmt::format("/shading/mistakes/{}", mistake.name));
    const auto [low, high] = last_item();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (pointed) list.AddRectFilled(low, high, to_u32(theme().field_hovered), px(4));
    const ImVec2 corner = low + ImVec2(inset, inset);
    draw_small(look, index, corner);
    if (on) list.AddRect(corner, corner + look.extent(), to_u32(theme().accent), px(3), 0, px(2));
    words_of(mistake, on, look.words(index) == no_difference,
             {corner + ImVec2(look.extent().x + px(8), 0), high - ImVec2(inset, inset)});
    return pointed;
}

namespace {

/// Thumbnails that look the same are compared in a picture this many times as wide and high.
constexpr int enlarged = 4;
/// A difference of fewer than this many levels, out of 255, is hardly visible.
constexpr int seen_levels = 4;

using Bytes = std::vector<std::uint8_t>;

int largest_difference(const Bytes& a, const Bytes& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

/// Draws the scene without mistakes first, then with each one.
class DrawUnderMistakes {
  public:
    DrawUnderMistakes(Scene right, PictureSize size) : right_(std::move(right)), size_(size) {}

    SmallPicture operator()(Renderer& renderer, int index) {
        const Scene scene = index == 0 ? right_ : under(static_cast<std::size_t>(index - 1));
        SmallPicture small{renderer.render(scene, size_, false, mistake_samples), {}};
        if (index == 0) {
            right_small_ = small.picture.rgba;
            return small;
        }
        const int levels = largest_difference(small.picture.rgba, right_small_);
        if (levels == 0 && looks_right(renderer, scene)) return {{}, no_difference};
        if (levels < seen_levels) small.words = hardly_differs;
        return small;
    }

  private:
    [[nodiscard]] Scene under(std::size_t row) const {
        return under_mistakes(right_, {mistakes_as_seen()[row]});
    }
    /// Whether `scene` looks correct even in a larger picture: a speck may disappear in a thumbnail.
    bool looks_right(Renderer& renderer, const Scene& scene) {
        const PictureSize size{enlarged * size_.width, enlarged * size_.height, size_.keeps_width};
        if (!right_enlarged_) right_enlarged_ = renderer.render(right_, size).rgba;
        return renderer.render(scene, size).rgba == *right_enlarged_;
    }

    Scene right_;
    PictureSize size_;
    Bytes right_small_;
    std::optional<Bytes> right_enlarged_;
};

/// Whether nothing moves and all meshes are loaded.
bool at_rest(const UiState& state) {
    return !ImGui::IsAnyMouseDown() && !state.get<AnimateState>().frame && !awaits_mesh(state);
}

/// Records the requested pictures if they differ from those that were started last.
void ask_again(MistakePictures& m, const Scene& scene, PictureSize size) {
    const bool same_size = m.asked_size == size;
    // A change is already recorded: compare and copy the scene only once the button is released.
    if (same_size && !m.begun && ImGui::IsAnyMouseDown()) return;
    if (same_size && m.seen == scene) return;
    m.seen = scene;
    Scene right = under_mistakes(scene, {});
    if (same_size && m.asked == right) return;
    m.asked = std::move(right);
    m.asked_size = size;
    m.asked_since = ImGui::GetTime();
    m.begun = false;
    stop_small_pictures(m.pictures);
}

/// Stops drawing and releases all meshes if the pictures were not visible in this frame. Called
/// after the tab is drawn.
void rest_mistake_pictures(MistakePictures& of_mistakes) {
    if (std::exchange(of_mistakes.looked_at, false)) return;
    take_small_pictures(of_mistakes.pictures);
    if (of_mistakes.asked_size == PictureSize{0, 0}) return;
    stop_small_pictures(of_mistakes.pictures);
    of_mistakes.seen = of_mistakes.asked = {};
    of_mistakes.asked_size = {0, 0};
    of_mistakes.begun = false;
}

}  // namespace

std::span<const std::size_t> mistakes_as_seen() {
    static const std::vector<std::size_t> order = [] {
        std::vector<std::size_t> places;
        for (const SeenAs seen_as : all_seen_as)
            for (std::size_t i = 0; i < mistake_names().size(); ++i)
                if (mistake_names()[i].seen_as == seen_as) places.push_back(i);
        return places;
    }();
    return order;
}

void look_at_mistake_pictures(UiState& state, PictureSize size) {
    MistakePictures& m = state.get<MistakePictures>();
    m.looked_at = true;
    ask_again(m, state.editor.scene(), size);
    take_small_pictures(m.pictures);
    if (m.begun || m.pictures.job || !at_rest(state)) return;
    const double wait = m.asked_since + stillness - ImGui::GetTime();
    if (wait > 0) return redraw_within(wait);
    m.begun = true;
    begin_small_pictures(state.jobs, m.pictures, "Mistakes", size,
                         static_cast<int>(mistakes_as_seen().size()) + 1, DrawUnderMistakes(m.asked, size));
    redraw_within(0);
}

namespace {

/// Once a frame: draws the scene with and without its mistakes in the background, and compares the two.
void look_for_effect(UiState& state) {
    MistakeEffect& e = state.get<MistakeEffect>();
    const Scene& scene = state.editor.scene();
    if (mistakes_on(scene.shading.mistakes) == 0 || !at_rest(state)) return leave(e.job, e.ending);
    if (!(e.of == scene) || e.size != state.full_size) {
        leave(e.job, e.ending);
        e = {scene, state.full_size, ImGui::GetTime(), false, false, {}, e.ending};
    }
    if (e.is_known) return;
    redraw_within(stillness / 4);
    if (e.job && e.job->done()) {
        const Result<bool> found = std::exchange(e.job, nullptr)->take();
        e.is_known = true;
        e.is_none = problem_of(found) == nullptr && std::get<bool>(found);
    } else if (!e.job && has_ended(e.ending) && ImGui::GetTime() - e.since > stillness) {
        Scene wrong = scene;
        wrong.transport.paths = 1;  // all paths would take too long
        e.job = state.jobs.start<bool>("Mistakes", [wrong, size = e.size](LoadProgress&) -> Result<bool> {
            Renderer renderer(1);
            const Bytes bytes = renderer.render(wrong, size).rgba;
            return renderer.render(under_mistakes(wrong, {}), size).rgba == bytes;
        });
    }
}

}  // namespace

extern const Feature mistake_pictures_feature;
const Feature mistake_pictures_feature{
    .end =
        [](UiState& s) {
            rest_mistake_pictures(s.get<MistakePictures>());
            look_for_effect(s);
        },
    .sheet = [](UiState& s) { return &s.get<MistakePictures>().pictures.sheet; }};

namespace {

/// The size of the thumbnails: aspect ratio 4:3, at most a third of the column wide.
PictureSize small_size(float room, bool keeps_width) {
    const int width = static_cast<int>(std::clamp(std::min(px(96), room / 3), 8.0f, 192.0f));
    return {width, width * 3 / 4, keeps_width};
}

/// Draws the picture without mistakes, for comparison. The list scrolls below it.
void right_row(UiState& state, const SmallLook& look) {
    Mistakes& mistakes = state.editor.scene().shading.mistakes;
    ImGui::SetCursorScreenPos(ImGui::GetCursorScreenPos() + ImVec2(small_inset(), small_inset()));
    draw_small(look, 0, ImGui::GetCursorScreenPos());
    ImGui::Dummy(look.extent());
    tooltip("Without mistakes", "The open scene without mistakes, to compare with");
    ImGui::SameLine(0, px(8));
    ImGui::BeginGroup();
    ImGui::TextUnformatted("Without mistakes");
    if (!look.pictures.problem.empty()) {
        warning_text(look.pictures.problem);
    } else if (mistakes_on(mistakes) == 0) {
        small_dim("Hover over a row to preview it; click to switch it on.");
    } else {
        warning_text(mistakes_text(mistakes));
        if (ImGui::Button("All off")) mistakes = {};
        tooltip("All off", "The correct equation");
    }
    ImGui::EndGroup();
    ImGui::Separator();
}

/// Draws the rows below the headings of their groups, and scrolls to `wanted` if it is not null. Returns the
/// hovered one.
const MistakeName* mistake_rows(Mistakes& mistakes, const SmallLook& look, const MistakeName* wanted) {
    const MistakeName* pointed = nullptr;
    std::optional<SeenAs> group;
    int index = 0;
    for (const std::size_t place : mistakes_as_seen()) {
        const MistakeName& mistake = mistake_names()[place];
        if (group != mistake.seen_as) section_heading(std::string(heading_of(mistake.seen_as)).c_str());
        group = mistake.seen_as;
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() - px(2));  // the rows have their own margins
        if (mistake_row(mistake, mistakes.*mistake.flag, look, ++index)) pointed = &mistake;
        if (&mistake == wanted) ImGui::SetScrollHereY(0.3f);
    }
    return pointed;
}

/// The mistakes that are on, in the tab's order.
std::vector<const MistakeName*> names_on(const Mistakes& mistakes) {
    std::vector<const MistakeName*> on;
    for (const std::size_t place : mistakes_as_seen())
        if (mistakes.*mistake_names()[place].flag) on.push_back(&mistake_names()[place]);
    return on;
}

}  // namespace

int mistakes_on(const Mistakes& mistakes) { return static_cast<int>(names_on(mistakes).size()); }

std::string mistakes_text(const Mistakes& mistakes) {
    constexpr std::size_t max_named = 2;
    const std::vector<const MistakeName*> on = names_on(mistakes);
    if (on.empty()) return {};
    std::string text = on.size() == 1 ? "Mistake: " : fmt::format("{} mistakes: ", on.size());
    for (std::size_t i = 0; i < std::min(on.size(), max_named); ++i)
        text.append(i == 0 ? "" : ", ").append(title_of(*on[i]));
    return on.size() > max_named ? text + ", …" : text;
}

void show_mistake(UiState& state, const MistakeName* mistake) {
    const auto on = names_on(state.editor.scene().shading.mistakes);
    state.get<InspectorState>().wanted_mistake = mistake == nullptr && !on.empty() ? on.front() : mistake;
    state.get<InspectorState>().tab = InspectorTab::Mistakes;
    state.layout.right = state.left_shows_inspector = true;
}

void mistakes_tab(UiState& state, const PictureView& view) {
    const PictureSize size = small_size(ImGui::GetContentRegionAvail().x, view.map.size.keeps_width);
    look_at_mistake_pictures(state, size);
    const SmallLook look{state.get<MistakePictures>().pictures, size};
    // In a short window, the picture scrolls with the list, which would otherwise have no room.
    const bool stays = ImGui::GetContentRegionAvail().y > 4 * look.extent().y;
    if (stays) right_row(state, look);
    ImGui::BeginChild("##rows");
    if (!stays) right_row(state, look);
    Mistakes& mistakes = state.editor.scene().shading.mistakes;
    const MistakeName* const pointed =
        mistake_rows(mistakes, look, std::exchange(state.get<InspectorState>().wanted_mistake, nullptr));
    ImGui::EndChild();
    if (pointed == nullptr) return;
    const bool on = mistakes.*pointed->flag;
    Scene other = state.editor.scene();
    other.shading.mistakes.*pointed->flag = !on;
    show_instead(state, other, on ? "without: " + title_of(*pointed) : title_of(*pointed));
}

}  // namespace glint
