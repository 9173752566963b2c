#include "ui/widgets/numbers/number_input.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "models/json/json.h"
#include "models/problem.h"
#include "renderer/explain/equation_text.h"
#include "ui/widgets/kept.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float press_becomes_drag = 3;     // logical pixels: a shorter movement is a click
constexpr std::size_t longest_text = 1024;  // bytes, including the terminating 0

struct Scrub {
    float before = 0;
    double at = 0;     // the value, not rounded for display
    float last_x = 0;  // the cursor's x in the last frame
    float pressed_x = 0;
    bool moved = false;  // the cursor has moved far enough to count as a drag
};
struct Typing {
    float before = 0;
    std::string began_with;
    std::array<char, longest_text> text{};
    std::string problem;  // problem of the current text
    std::string refused;  // why the scene rejects the number; empty if it does not
};
/// The one number being edited.
struct InHand {
    ImGuiID id = 0;
    int frame = -1;  // the last frame in which it was drawn
    bool types = false;
    Scrub scrub;
    Typing typing;
};
/// The number that gets focus next.
struct Awaited {
    std::string pointer;
    int frame = -1;
};
struct NumberState {
    InHand hand;
    Awaited awaited;
    std::vector<Said> said;
    std::string refused_text;
};
NumberState& numbers() { return widget_state<NumberState>(); }
InHand& hand() { return numbers().hand; }

bool is_held(ImGuiID id) { return hand().id == id && hand().frame + 1 >= ImGui::GetFrameCount(); }

// Typing.

/// Begins typing with `text`, all of it selected, so that the next letter replaces it.
void begin_typing(ImGuiID id, float value) {
    hand() = {id, ImGui::GetFrameCount(), true, {}, {}};
    hand().typing.before = value;
    hand().typing.began_with = exact_text(value);
    hand().typing.began_with.copy(hand().typing.text.data(), longest_text - 1);
    // The same request that ImGui's own drags use to open their text field.
    GImGui->NavActivateId = GImGui->NavActivateInputId = id;
    GImGui->NavActivateFlags = ImGuiActivateFlags_PreferInput;
}

bool take_typed(float& value, const Range& range) {
    Typing& typing = hand().typing;
    const std::string text = typing.text.data();
    typing.problem.clear();
    typing.refused.clear();
    if (text == typing.began_with) return assign(value, double(typing.before), range);
    const Calculated found = calculated(text, double(typing.before));
    typing.problem = found.problem;
    return found.problem.empty() && assign(value, found.value, range);
}

/// Returns why typed text is rejected; empty if it is accepted.
std::string why_refused(const Typing& typing, const std::string& text, const Calculated& found) {
    if (text.empty()) return "The field is empty";
    if (!found.problem.empty())
        return fmt::format("“{}” is not a number: {}", shortened(text), found.problem);
    if (!typing.refused.empty())
        return fmt::format("{} is not possible: {}", shortened(text), typing.refused);
    return {};
}

/// Ends typing. Rejected text restores the previous value.
void end_typing(float& value, const Range& range) {
    const Typing typing = hand().typing;
    hand() = {};
    const std::string text = typing.text.data();
    if (text == typing.began_with) return (void)assign(value, double(typing.before), range);
    const Calculated found = calculated(text, double(typing.before));
    if (const std::string why = why_refused(typing, text, found); !why.empty()) {
        if (!found.problem.empty()) numbers().refused_text = text;
        say_refused(fmt::format("{}. The field keeps {}", why, exact_text(typing.before)));
        assign(value, double(typing.before), range);
    } else if (!range.contains(found.value) && value != static_cast<float>(found.value)) {
        say_out_of_range(found.value, range, value);
    }
}

/// Returns the frame of the text being typed, which covers neighbouring fields if the text is wider than its
/// own field.
ImRect frame_for_typing(const ImRect& frame) {
    const float wanted =
        ImGui::CalcTextSize(hand().typing.text.data()).x + 2 * ImGui::GetStyle().FramePadding.x + px(12);
    const ImRect room = ImGui::GetCurrentWindow()->WorkRect;
    const float width = std::max(frame.GetWidth(), std::min(wanted, room.GetWidth()));
    const float left = std::max(std::min(frame.Min.x, room.Max.x - width), room.Min.x);
    return {{std::min(left, frame.Min.x), frame.Min.y}, {std::max(left + width, frame.Max.x), frame.Max.y}};
}

void type_text(ImGuiID id, const ImRect& frame, const char* label, float& value, const Range& range) {
    hand().frame = ImGui::GetFrameCount();
    bool edited = false;
    const PasteInOneLine pasted;
    const bool wrong = !hand().typing.problem.empty() || !hand().typing.refused.empty();
    if (wrong) ImGui::PushStyleColor(ImGuiCol_Text, theme().error);
    if (ImGui::TempInputText(frame, id, label, hand().typing.text.data(), int(longest_text),
                             ImGuiInputTextFlags_AutoSelectAll))
        edited = take_typed(value, range);
    if (wrong) ImGui::PopStyleColor();
    if (GImGui->ActiveId == id) return;
    if (!edited) return end_typing(value, range);
    redraw_within(0);  // the next frame shows whether the scene accepts it
}

// Dragging.

void begin_scrub(ImGuiID id, float value) {
    const float x = ImGui::GetIO().MousePos.x;
    hand() = {id, ImGui::GetFrameCount(), false, {value, double(value), x, x, false}, {}};
}

double scrubbed(double at, float pixels, const NumberInput& input) {
    const Real& kind = input.kind;
    if (input.slider)
        return slider_value(slider_share(at, kind) + double(pixels) / double(input.width), kind);
    const double size = kind.logarithmic ? std::max(std::abs(at), 10 * double(kind.step)) : 1;
    return at + double(pixels) * double(kind.step) * size;
}

/// Rounds to the field's number of decimals, so that a drag gives round numbers.
double rounded(double value, const Real& kind) {
    char text[64];
    std::snprintf(text, sizeof text, kind.format, value);
    return value == 0 || *kind.format != '%' ? value : double(std::strtof(text, nullptr));
}

void drag(float& value, const NumberInput& input) {
    const ImGuiIO& io = ImGui::GetIO();
    Scrub& scrub = hand().scrub;
    if (!scrub.moved && std::abs(io.MousePos.x - scrub.pressed_x) <= px(press_becomes_drag)) return;
    scrub.moved = true;
    const Range& range = input.kind.range;
    const float moved = io.MousePos.x - std::exchange(scrub.last_x, io.MousePos.x);
    const float pixels = moved * (io.KeyShift ? 0.1f : 1.0f);
    if (pixels == 0) return;
    scrub.at = std::clamp(scrubbed(scrub.at, pixels, input), double(lowest(range)), double(highest(range)));
    double wanted = rounded(scrub.at, input.kind);
    if (io.KeyCtrl) {
        const double step = drag_step(input.kind, scrub.at);
        wanted = std::round(scrub.at / step) * step;
    }
    assign(value, wanted, {range.low, range.high, range.words, range.low_open, range.high_open});
}

/// Handles a drag while the button is down, and when it is released.
void hold(ImGuiID id, float& value, const NumberInput& input, bool hovered) {
    hand().frame = ImGui::GetFrameCount();
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
        assign(value, double(hand().scrub.before), input.kind.range);
        hand() = {};
        return ImGui::ClearActiveID();
    }
    drag(value, input);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const bool clicked = !hand().scrub.moved && hovered;
    hand() = {};
    ImGui::ClearActiveID();
    if (clicked) begin_typing(id, value);
}

void draw_number(ImGuiID id, const ImRect& frame, float value, const NumberInput& input, bool hovered) {
    const bool held = GImGui->ActiveId == id;
    const ImVec4 ground = ImGui::GetStyleColorVec4(held      ? ImGuiCol_FrameBgActive
                                                   : hovered ? ImGuiCol_FrameBgHovered
                                                             : ImGuiCol_FrameBg);
    const float rounding = ImGui::GetStyle().FrameRounding;
    ImGui::RenderFrame(frame.Min, frame.Max, ImGui::GetColorU32(ground), true, rounding);
    if (input.slider) {
        const float share = std::clamp(float(slider_share(double(value), input.kind)), 0.0f, 1.0f);
        const float end = frame.Min.x + share * frame.GetWidth();
        if (end - frame.Min.x >= 1)
            ImGui::GetWindowDrawList()->AddRectFilled(
                frame.Min, {end, frame.Max.y}, ImGui::GetColorU32(slider_fill(theme(), ground)), rounding);
    }
    // Not every term's colour is legible on a hovered background.
    const bool plain = hovered || held;
    ImGui::PushStyleColor(ImGuiCol_Text, plain ? theme().text : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    const std::string text = fitting_text(value, input.kind, frame.GetWidth() - px(2));
    ImGui::RenderTextClipped(frame.Min, frame.Max, text.c_str(), nullptr, nullptr, {0.5f, 0.5f});
    ImGui::PopStyleColor();
}

constexpr const char* number_menu_id = "##number menu";

bool item(const char* name, const std::string& about, bool possible = true) {
    const bool chosen = ImGui::MenuItem(name, about.c_str(), false, possible);
    list_control(name, "", last_item());
    return chosen;
}

void copy(const std::string& text) {
    ImGui::SetClipboardText(text.c_str());
    say(fmt::format("{} is on the clipboard", text));
}

void paste(float& value, const Range& range) {
    const char* text = ImGui::GetClipboardText();
    if (text == nullptr) return;  // the window has reported why
    const Calculated found = calculated(text, double(value));
    if (!found.problem.empty())
        return say_refused("The clipboard does not contain a number: " + on_one_line(found.problem));
    assign(value, found.value, range);
    if (!range.contains(found.value)) say_out_of_range(found.value, range, value);
}

/// Draws a number's menu while it is open: Copy, Paste, Reset, Copy pointer. True if it changed the value.
bool number_menu(float& value, const NumberInput& input) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(8), px(6)});
    const bool open = ImGui::BeginPopup(number_menu_id);
    ImGui::PopStyleVar();
    if (!open) return false;
    ImGui::PushFont(fonts().body);
    ImGui::PushStyleColor(ImGuiCol_Text, theme().text);  // regardless of the number's own colour
    const float before = value;
    if (item("Copy", exact_text(value))) copy(exact_text(value));
    if (item("Paste", "")) paste(value, input.kind.range);
    const bool has_default = !std::isnan(input.initial);
    if (has_default && item("Reset to default", exact_text(input.initial), value != input.initial))
        value = input.initial;
    if (value == input.initial && value == before) tooltip("Reset to default", "It is already the default");
    if (!input.pointer.empty()) {
        ImGui::Separator();
        const bool advanced = ImGui::BeginMenu("Advanced");
        list_control("Advanced", "", last_item());
        if (advanced) {
            if (item("Copy pointer", input.pointer)) copy(input.pointer);
            ImGui::EndMenu();
        }
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::EndPopup();
    return value != before;
}

/// Returns whether type_into() requested that number, and clears the request.
bool is_awaited(const std::string& pointer) {
    Awaited& awaited = numbers().awaited;
    if (awaited.frame != ImGui::GetFrameCount() || pointer.empty()) return false;
    if (!is_within(pointer, awaited.pointer)) return false;
    awaited = {};
    return true;
}

/// Makes the number the edited one after a press or Tab.
void take_in_hand(ImGuiID id, float value, const NumberInput& input, bool hovered) {
    const bool tabbed = (GImGui->LastItemData.StatusFlags & ImGuiItemStatusFlags_FocusedByTabbing) != 0 ||
                        GImGui->NavActivateInputId == id || is_awaited(input.pointer);
    const bool pressed = hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (!tabbed && !pressed) return;
    ImGui::SetActiveID(id, ImGui::GetCurrentWindow());
    ImGui::SetFocusID(id, ImGui::GetCurrentWindow());
    ImGui::FocusWindow(ImGui::GetCurrentWindow());
    if (tabbed) return begin_typing(id, value);
    begin_scrub(id, value);
}

}  // namespace

bool assign(float& value, double wanted, const Range& range) {
    const float before = value;
    const auto near = static_cast<float>(std::clamp(wanted, -max_number, max_number));
    // Uses contains(), because a range may include one number outside its interval.
    value = range.contains(near) ? near : std::clamp(near, lowest(range), highest(range));
    return value != before;
}

bool number_input(const char* label, float& value, const NumberInput& input) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    if (window->SkipItems) return false;
    const ImGuiID id = window->GetID(label);
    ImGui::PushFont(fonts().figures);
    const ImVec2 low = window->DC.CursorPos;
    const ImRect frame(low, {low.x + input.width, low.y + ImGui::GetFrameHeight()});
    ImGui::ItemSize(frame, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(frame, id, &frame, ImGuiItemFlags_Inputable)) {
        ImGui::PopFont();
        return false;
    }
    const bool hovered = ImGui::ItemHoverable(frame, id);
    const float before = value;
    if (is_held(id) && GImGui->ActiveId != id) {  // another item was clicked or focused
        if (hand().types) end_typing(value, input.kind.range);
        hand() = {};
    }
    if (!is_held(id)) take_in_hand(id, value, input, hovered);
    if (is_held(id) && !hand().types) hold(id, value, input, hovered);
    if (is_held(id) && hand().types)
        type_text(id, frame_for_typing(frame), label, value, input.kind.range);
    else
        draw_number(id, frame, value, input, hovered);
    if ((hovered || is_held(id)) && !hand().types) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::PopFont();
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup(number_menu_id);
    if (number_menu(value,
                    input))  // marks this as the edited number, so that refuse_edit() may report it
        hand() = {id, ImGui::GetFrameCount(), false, {}, {}};
    return value != before;
}

void say_out_of_range(double wanted, const Range& range, float taken) {
    say_refused(fmt::format("{:.6g} is out of range ({}), so it was set to {}", wanted, range.words,
                            exact_text(taken)));
}

void refuse_edit(const std::string& why) {
    if (hand().types)
        hand().typing.refused = why;
    else if (hand().id == 0 || GImGui->ActiveId != hand().id)
        say_refused("Not possible: " + why);
}

void type_into(const std::string& pointer) { numbers().awaited = {pointer, ImGui::GetFrameCount()}; }

void let_go_of_fields() {
    numbers().hand = {};
    numbers().awaited = {};
    if (ImGui::GetTopMostPopupModal() != nullptr) return;
    ImGui::ClearActiveID();
    if (!GImGui->OpenPopupStack.empty()) ImGui::ClosePopupToLevel(0, true);
}

bool number_in_hand() { return hand().id != 0 && is_held(hand().id); }

void say(const std::string& line) { numbers().said.push_back({line}); }
void say_refused(const std::string& line) { numbers().said.push_back({line, true}); }
void unsay() { numbers().said.pop_back(); }
std::vector<Said> take_said() { return std::exchange(numbers().said, {}); }
std::string take_refused_text() { return std::exchange(numbers().refused_text, {}); }

// Sliders, steps and display texts for each kind of number.

float lowest(const Range& range) {
    const auto low = static_cast<float>(range.low);
    return range.low_open ? std::nextafter(low, static_cast<float>(range.high)) : low;
}

float highest(const Range& range) {
    const auto high = static_cast<float>(range.high);
    return range.high_open ? std::nextafter(high, static_cast<float>(range.low)) : high;
}

bool has_slider(const Real& kind) {
    return kind.range.low > -max_number && double(kind.usual_max) > kind.range.low;
}

double slider_share(double value, const Real& kind) {
    const double low = kind.range.low, usual = double(kind.usual_max) - low,
                 above = std::max(value - low, 0.0);
    return kind.logarithmic ? std::log1p(above) / std::log1p(usual) : above / usual;
}

double slider_value(double share, const Real& kind) {
    const double low = kind.range.low, usual = double(kind.usual_max) - low;
    const double above = kind.logarithmic ? std::expm1(share * std::log1p(usual)) : share * usual;
    return std::clamp(low + above, double(lowest(kind.range)), double(highest(kind.range)));
}

ImVec4 slider_fill(const Theme& theme, const ImVec4& ground) {
    const auto mix = [](float from, float to) { return from + (to - from) * 0.3f; };
    return {mix(ground.x, theme.accent.x), mix(ground.y, theme.accent.y), mix(ground.z, theme.accent.z), 1};
}

double drag_step(const Real& kind, double value) {
    const double size = kind.logarithmic ? std::max(std::abs(value), 10 * double(kind.step)) : 1;
    const double about = 10 * double(kind.step) * size;
    const double power = std::pow(10, std::floor(std::log10(about)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= about * 0.999) return digit * power;
    return 10 * power;
}

std::string shown_text(float value, const Real& kind) {
    if (value == 0 && *kind.zero != 0) return kind.zero;
    constexpr std::size_t longest = 10;  // characters that fit into a field, so that the end is not cut off
    char plain[64];
    std::snprintf(plain, sizeof plain, kind.format, double(value));
    const std::string_view format = kind.format;
    const bool has_decimals = format.starts_with("%.") && format.substr(3).starts_with('f');
    const std::string text =
        has_decimals ? significant_text(double(value), format[2] - '0').append(format.substr(4)) : plain;
    return text.size() > longest ? fmt::format("{:.6g}", value) : text;
}

std::string fitting_text(float value, const Real& kind, float width) {
    std::string text = shown_text(value, kind);
    constexpr int most_digits = 6;
    for (int digits = most_digits; digits > 0 && ImGui::CalcTextSize(text.c_str()).x > width; --digits)
        text = fmt::format("{:.{}g}", value, digits);
    return text;
}

std::string exact_text(float value) { return fmt::format("{}", value); }

namespace {

constexpr int deepest = 40;  // nested brackets: typed text must not exhaust the stack

/// Replaces decimal commas, and the typographic signs that the window itself writes, with plain signs.
std::string in_plain_signs(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> signs{
        {{"−", "-"}, {"×", "*"}, {"·", "*"}, {"÷", "/"}, {"π", "pi"}, {"px", " "}, {",", "."}}};
    std::string plain;
    while (!text.empty()) {
        bool found = false;
        for (const auto& [sign, meant] : signs) {
            if (!text.starts_with(sign)) continue;
            plain += meant;
            text.remove_prefix(sign.size());
            found = true;
            break;
        }
        if (found) continue;
        plain += text.front();
        text.remove_prefix(1);
    }
    return plain;
}

class Calculation {
  public:
    explicit Calculation(std::string_view text) : rest_(text) {}

    Calculated result() {
        const double value = sum();
        skip_blanks();
        if (!rest_.empty()) fail(fmt::format("“{}” is unexpected", rest_));
        if (problem_.empty() && !std::isfinite(value)) fail("it has no finite value");
        return {value, problem_};
    }

  private:
    /// Consumes the sign if it comes next; returns whether it did.
    bool take(std::string_view sign) {
        skip_blanks();
        if (!rest_.starts_with(sign)) return false;
        rest_.remove_prefix(sign.size());
        return true;
    }
    [[nodiscard]] bool at_end() {
        skip_blanks();
        return rest_.empty();
    }
    void skip_blanks() {
        while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    }
    /// Only the first problem is reported.
    double fail(const std::string& problem) {
        if (problem_.empty()) problem_ = problem;
        rest_ = {};
        return 0;
    }

    double sum() {
        double value = product();
        while (true) {
            if (take("+"))
                value += product();
            else if (take("-"))
                value -= product();
            else
                return value;
        }
    }
    double product() {
        double value = signed_power();
        while (true) {
            if (take("*"))
                value *= signed_power();
            else if (take("/"))
                value /= signed_power();
            else
                return value;
        }
    }
    /// Parses powers and signs: −2^2 is −4, and 2^−1 is 1/2.
    double signed_power() {
        if (++depth_ > deepest) return fail("there are too many brackets or signs in it");
        double value = 0;
        if (take("-"))
            value = -signed_power();
        else if (take("+"))
            value = signed_power();
        else {
            value = operand();
            if (take("°")) value *= degree_;
            if (take("^")) value = std::pow(value, signed_power());
        }
        --depth_;
        return value;
    }
    double operand() {
        if (take("(")) {
            const double value = sum();
            if (!take(")")) return fail("“)” is missing");
            return value;
        }
        if (at_end()) return fail("a number is missing");
        if (const auto number = written_number()) return *number;
        return named();
    }
    std::optional<double> written_number() {
        double value = 0;
        const char *first = rest_.data(), *last = first + rest_.size();
        // from_chars accepts "inf" and "nan".
        if (*first != '.' && (*first < '0' || *first > '9')) return {};
        const auto [end, error] = std::from_chars(first, last, value);
        if (error == std::errc::invalid_argument) return {};
        if (error == std::errc::result_out_of_range)  // infinite, or nearly 0
            value = std::strtod(std::string(first, end).c_str(), nullptr);
        rest_.remove_prefix(static_cast<std::size_t>(end - first));
        return value;
    }
    double named() {
        static constexpr std::array constants{std::pair{std::string_view("pi"), std::numbers::pi},
                                              std::pair{std::string_view("deg"), std::numbers::pi / 180}};
        using Function = double (*)(double);
        static constexpr std::array<std::pair<std::string_view, Function>, 5> functions{
            {{"sqrt", [](double x) { return std::sqrt(x); }},
             {"abs", [](double x) { return std::abs(x); }},
             {"sin", [](double x) { return std::sin(x); }},
             {"cos", [](double x) { return std::cos(x); }},
             {"tan", [](double x) { return std::tan(x); }}}};
        for (const auto& [name, value] : constants)
            if (take(name)) return value;
        for (const auto& [name, function] : functions) {
            if (!take(name)) continue;
            if (!take("(")) return fail(fmt::format("“(” is missing after {}", name));
            const double outside = std::exchange(degree_, std::numbers::pi / 180);
            const double value = sum();
            degree_ = outside;
            if (!take(")")) return fail("“)” is missing");
            return function(value);
        }
        return fail(fmt::format("“{}” is not known", rest_));
    }

    std::string_view rest_;
    std::string problem_;
    int depth_ = 0;
    double degree_ = 1;  // factor of °: angle fields are in degrees, functions take radians
};

}  // namespace

Calculated calculated(std::string_view text, double before) {
    std::string plain = in_plain_signs(text);
    plain.erase(0, plain.find_first_not_of(' '));
    if (plain.empty()) return {0, "a number is missing"};
    const bool continues = std::string_view("+-*/").find(plain[0]) != std::string_view::npos;
    if (continues && plain.size() > 1 && plain[1] == '=')
        plain = fmt::format("({}){}({})", before, plain[0], plain.substr(2));
    else if (continues && plain[0] != '-')
        plain = fmt::format("({}){}", before, plain);
    return Calculation(plain).result();
}

}  // namespace glint
