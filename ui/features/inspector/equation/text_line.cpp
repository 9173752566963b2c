#include "ui/features/inspector/equation/text_line.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "models/fields/scene_fields.h"
#include "renderer/explain/equation_text.h"
#include "ui/features/inspector/equation/equation_tab.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float padding_x = 2, padding_y = 1;  // of a handle, logical pixels

/// The width of the current number, at least that of two digits, so that it is easy to grab.
float handle_width(const NumberHandle& handle) {
    const std::string text = shown_text(static_cast<float>(handle.number.value), handle.number.kind);
    ImGui::PushFont(fonts().figures);
    const float width = std::max(ImGui::CalcTextSize(text.c_str()).x, ImGui::CalcTextSize("00").x);
    ImGui::PopFont();
    return width + 2 * px(padding_x) + px(2);
}

void draw_mark_around(const Rect& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low = area.low - px(1) * ImVec2(4, 1), high = area.high + px(1) * ImVec2(4, 1);
    list.AddRect({std::max(low.x, list.GetClipRectMin().x + px(1)), low.y}, high, to_u32(theme().accent),
                 px(4), 0, px(2));
}

void dotted_line(ImVec2 low, ImVec2 high, ImU32 colour) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const int dots = static_cast<int>((high.x - low.x - px(4)) / px(3));
    for (int i = 0; i <= dots; ++i) {
        const float x = low.x + px(2) + px(3) * float(i);
        list.AddRectFilled({x, high.y - px(1)}, {x + px(1.5f), high.y}, colour);
    }
}

}  // namespace

TextLine::TextLine(float indent, QuantityMark* mark) : wanted_mark_(mark) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    left_ = x_ = at.x;
    y_ = at.y;
    right_ = at.x + ImGui::GetContentRegionAvail().x;
    indent_ = px(indent);
}

float TextLine::height() {
    ImGui::PushFont(fonts().figures);
    const float line = ImGui::GetTextLineHeight();
    ImGui::PopFont();
    return line + 2 * px(padding_y);
}

/// Moves the cursor to a position where the next `width` fits, on a new line if needed.
void TextLine::place(float width) {
    keep_together(width);
    ImGui::SetCursorScreenPos({x_, y_});
    x_ += width;
}

void TextLine::keep_together(float width) {
    if (measures_) return;
    if (x_ + width <= right_ || x_ <= left_ + indent_) return;
    x_ = left_ + indent_;
    y_ += height();
}

TextLine& TextLine::piece(const std::string& text, const ImVec4& colour, ImFont* font, float down) {
    ImGui::PushFont(font);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    if (measures_) {
        x_ += size.x;
        ImGui::PopFont();
        return *this;
    }
    place(size.x);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + (height() - size.y) / 2 + down}, to_u32(colour),
                                        text.c_str());
    ImGui::PopFont();
    ImGui::Dummy({size.x, height()});
    return *this;
}

TextLine& TextLine::plain(const std::string& text) { return plain(text, theme().dim_text); }
TextLine& TextLine::plain(const std::string& text, const ImVec4& colour) {
    return piece(text, colour, fonts().body, 0);
}
TextLine& TextLine::code(const std::string& text, const ImVec4& colour) {
    return piece(text, colour, fonts().figures, 0);
}
TextLine& TextLine::number(const std::string& text, const ImVec4& colour) {
    piece(text, colour, fonts().figures, 0);
    if (!measures_ && mark_ && !marks_result_) end_mark(last_item());
    menu_of(text);
    return *this;
}
TextLine& TextLine::raised(const std::string& text, const ImVec4& colour) {
    piece(text, colour, fonts().small, -px(4));
    menu_of(text);
    return *this;
}

void TextLine::menu_of(const std::string& number) {
    if (measures_) return;
    // The line's position makes the IDs of its menus unique.
    ImGui::PushID(static_cast<int>(left_));
    ImGui::PushID(static_cast<int>(y_ - ImGui::GetWindowPos().y + ImGui::GetScrollY()));
    copy_menu(numbers_++, number, line_);
    ImGui::PopID();
    ImGui::PopID();
}
TextLine& TextLine::copied_as(std::string line) {
    line_ = std::move(line);
    return *this;
}

TextLine& TextLine::symbol(Quantity quantity) {
    const ImVec2 begin{x_, y_};
    letters(quantity);
    if (measures_ || wanted_mark_ == nullptr || wanted_mark_->quantity != quantity) return *this;
    wanted_mark_->quantity.reset();
    const Rect last = last_item();  // for a cosine, its second letter
    const bool went_on = last.low.y > begin.y + px(2);
    mark_ = Rect{{went_on ? left_ + indent_ : begin.x, last.low.y}, last.high};
    marks_result_ = (quantity >= Quantity::AmbientTerm && quantity <= Quantity::SpecularTerm) ||
                    quantity == Quantity::Result || quantity == Quantity::WarmShare;
    list_control("Marked number", row_of(quantity).letter, *mark_);
    if (wanted_mark_->scrolls) ImGui::SetScrollHereY(0.4f);
    return *this;
}

TextLine::~TextLine() {
    if (mark_) draw_mark_around(*mark_);
}

/// Draws the mark around the letter and its value, together if they are next to each other.
void TextLine::end_mark(const Rect& value) {
    const Rect letter = *mark_;
    mark_.reset();
    if (!marks_result_ && value.low.y == letter.low.y) return draw_mark_around({letter.low, value.high});
    draw_mark_around(letter);
    draw_mark_around(value);
}

void TextLine::letters(Quantity quantity) {
    const QuantityRow& row = row_of(quantity);
    const auto letter = [&](Quantity q) {
        piece(row_of(q).letter, theme()[colour_of(q)], fonts().body, 0);
        if (!measures_) tooltip(text_of(q).c_str(), row_of(q).meaning);
    };
    if (is_cosine(quantity)) {
        const auto vectors = vectors_of(quantity);
        ImGui::PushFont(fonts().body);
        keep_together(ImGui::CalcTextSize(row.letter).x);
        ImGui::PopFont();
        letter(vectors.first);
        plain("·");
        if (!measures_) tooltip(row.letter, row.meaning);
        letter(vectors.second);
        return;
    }
    letter(quantity);
    if (*row.index == 0) return;
    piece(row.index, theme()[colour_of(quantity)], fonts().small, px(3));
    if (!measures_) tooltip(text_of(quantity).c_str(), row.meaning);
}

TextLine& TextLine::times() { return gap(2).plain("×").gap(2); }

TextLine& TextLine::gap(float width) {
    x_ += px(width);
    return *this;
}

TextLine& TextLine::edit(const NumberHandle& handle, const ImVec4& colour, float down) {
    const float width = handle_width(handle);
    const SceneNumber& n = handle.number;
    if (measures_) {
        x_ += width;
        return *this;
    }
    place(width);
    ImGui::SetCursorScreenPos(ImGui::GetCursorScreenPos() + ImVec2(0, down));
    ImGui::PushStyleColor(ImGuiCol_FrameBg, {0, 0, 0, 0});
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(padding_x), px(padding_y)});
    auto value = static_cast<float>(n.value);
    if (bare_number(handle.name.c_str(), value, n.kind, static_cast<float>(n.initial), {n.help, n.pointer},
                    width) &&
        n.place != nullptr)
        *n.place = value;
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    if (!is_read_only()) dotted_line(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), to_u32(colour, 0.8f));
    return *this;
}

TextLine& TextLine::handle(const NumberHandle& handle, const ImVec4& colour) {
    return edit(handle, colour, 0);
}
TextLine& TextLine::exponent(const NumberHandle& handle, const ImVec4& colour) {
    return edit(handle, colour, -px(4));
}

void TextLine::result(const std::string& text, const ImVec4& colour) {
    ImGui::PushFont(fonts().figures);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::PopFont();
    if (x_ + px(3) + width > right_) y_ += height();
    x_ = right_ - width;
    number(text, colour);
    if (mark_) end_mark(last_item());
}

Symbol colour_of(Quantity quantity) {
    switch (quantity) {
    case Quantity::EmissionTerm:
    case Quantity::MaterialEmission:
        return Symbol::Emission;
    case Quantity::AmbientTerm:
    case Quantity::BouncedTerm:
    case Quantity::MaterialAmbient:
    case Quantity::GlobalAmbient:
    case Quantity::LightAmbient:
        return Symbol::Ambient;
    case Quantity::DiffuseTerm:
    case Quantity::MaterialDiffuse:
    case Quantity::LightDiffuse:
    case Quantity::Rough:
        return Symbol::Diffuse;
    case Quantity::SpecularTerm:
    case Quantity::MaterialSpecular:
    case Quantity::LightSpecular:
    case Quantity::Power:
    case Quantity::Highlight:
    case Quantity::QuarterPi:
    case Quantity::Facets:
    case Quantity::Masking:
    case Quantity::Fresnel:
        return Symbol::Specular;
    case Quantity::N:
    case Quantity::NL:
    case Quantity::NH:
    case Quantity::NV:
        return Symbol::N;
    case Quantity::L:
    case Quantity::LV:
        return Symbol::L;
    case Quantity::V:
        return Symbol::V;
    case Quantity::R:
    case Quantity::RV:
        return Symbol::R;
    case Quantity::H:
        return Symbol::H;
    default:
        return Symbol::Construction;
    }
}

std::pair<Quantity, Quantity> vectors_of(Quantity cosine) {
    if (cosine == Quantity::RV) return {Quantity::R, Quantity::V};
    if (cosine == Quantity::NH) return {Quantity::N, Quantity::H};
    if (cosine == Quantity::LV) return {Quantity::L, Quantity::V};
    if (cosine == Quantity::NV) return {Quantity::N, Quantity::V};
    return {Quantity::N, Quantity::L};
}

namespace {

/// Writes the factor of the highlight.
void highlight(TextLine& f, Reflection reflection) {
    const ReflectionInfo info = info_of(reflection);
    const auto power = [&f](Quantity cosine) {
        f.plain("(").symbol(cosine).plain(")").symbol(Quantity::Power);
    };
    switch (info.cosine) {
    case HighlightCosine::RV:
        return power(Quantity::RV);
    case HighlightCosine::NH:
        return power(Quantity::NH);
    case HighlightCosine::LV:
        return power(Quantity::LV);
    case HighlightCosine::None:
        break;
    }
    if (reflection != Reflection::CookTorrance) return (void)f.symbol(Quantity::Highlight);
    f.gap(2).symbol(Quantity::QuarterPi).gap(2).symbol(Quantity::Facets).symbol(Quantity::Masking);
    f.symbol(Quantity::Fresnel).plain("/").symbol(Quantity::NV);
}

}  // namespace

void formula(Reflection reflection, TransportModel transport) {
    const ReflectionInfo info = info_of(reflection);
    if (!info.is_lit) return dim_text("No lighting: the mesh's own colours.");
    TextLine f(20);
    f.symbol(Quantity::Result).plain(" = ").symbol(Quantity::MaterialEmission);
    f.together([&] {
        if (transport == TransportModel::Bounces)
            f.plain("+").symbol(Quantity::MaterialDiffuse).symbol(Quantity::Bounced);
        else
            f.plain("+").symbol(Quantity::MaterialAmbient).symbol(Quantity::GlobalAmbient);
    });
    f.together([&] {
        f.plain("+Σ").symbol(Quantity::Share);
        if (transport != TransportModel::Local) f.gap(2).symbol(Quantity::Reach).gap(2);
        f.plain("(");
        f.symbol(Quantity::MaterialAmbient).symbol(Quantity::LightAmbient);
    });
    f.together([&] {
        f.plain("+").symbol(Quantity::MaterialDiffuse).symbol(Quantity::LightDiffuse).symbol(Quantity::NL);
        if (info.rough_diffuse) f.symbol(Quantity::Rough);
        if (!info.has_highlight) f.plain(")");
    });
    if (!info.has_highlight) return;
    f.together([&] {
        f.plain("+").symbol(Quantity::MaterialSpecular).symbol(Quantity::LightSpecular);
        highlight(f, reflection);
        f.plain(")");
    });
}

// Draws a line of the equation, piece by piece.

namespace {

std::string shown(double x) { return shown_number(static_cast<float>(x)); }

std::string trimmed(const std::string& text) { return text.substr(text.find_first_not_of(' ')); }

/// Draws the numbers of one line.
class LinePieces {
  public:
    LinePieces(TextLine& line, const HandledScene& scene, int channel)
        : line_(line), scene_(scene), channel_(channel) {}

    void factor(const EquationFactor& f, int decimals, int exponent_decimals) {
        if (f.is_mean) line_.plain("mean ");
        if (f.power) line_.plain("(");
        line_.symbol(f.quantity);
        if (f.quantity == Quantity::QuarterPi) return;
        const ImVec4& colour = is_cosine(f.quantity) ? theme().text : theme()[colour_of(f.quantity)];
        if (!f.pointer.empty())
            handle(f.is_colour ? fmt::format("{}/{}", f.pointer, channel_) : f.pointer, decimals, colour);
        else if (f.clamped_from < 0)
            line_.gap(3).number(trimmed(shown(f.clamped_from)), theme().warning).plain("→0", theme().warning);
        else
            line_.gap(3).number(decimal_text(f.value[channel_], decimals), colour);
        if (f.power) power(*f.power, exponent_decimals);
    }
    void made_by(const std::string& pointer) {
        const NamedNumber named = named_number(pointer, scene_.shown);
        const std::size_t word = named.what.rfind(' ');
        line_.plain(" by " + (word == std::string::npos ? named.what : named.what.substr(word + 1)));
        handle(pointer, 2, theme().text);
    }

  private:
    void power(const EquationPower& p, int decimals) {
        line_.plain(")");
        const ImVec4& colour = theme()[colour_of(Quantity::Power)];
        if (p.pointer.empty()) {
            line_.raised(decimal_text(p.exponent, decimals), colour);
            return;
        }
        NumberHandle number = number_handle(scene_, p.pointer);
        number.number.kind.format = decimal_format(p.exponent, decimals);
        line_.exponent(number, colour);
    }
    void handle(const std::string& pointer, int decimals, const ImVec4& colour) {
        NumberHandle number = number_handle(scene_, pointer);
        number.number.kind.format = decimal_format(number.number.value, decimals);
        line_.handle(number, colour);
    }

    TextLine& line_;
    const HandledScene& scene_;
    int channel_;
};

}  // namespace

void draw_line(const EquationLine& term, const HandledScene& scene, int channel) {
    const LineDecimals decimals = written_decimals(term, channel, shown);
    const std::string result = shown(term.result[channel]);
    TextLine line(28, scene.mark);
    line.copied_as(fmt::format("{} = {}{}", text_of(term.term), written_product(term, channel, shown),
                               term.left_out.empty() ? " = " + trimmed(result) : ""));
    line.symbol(term.term).gap(4).plain("=").gap(4);
    LinePieces pieces(line, scene, channel);
    for (std::size_t i = 0; i < term.factors.size(); ++i)
        line.together([&] {
            if (i > 0 && term.factors[i].divides) line.gap(3).plain("/").gap(3);
            if (i > 0 && !term.factors[i].divides) line.times();
            pieces.factor(term.factors[i], decimals.value[i], decimals.exponent[i]);
        });
    if (!term.left_out.empty()) {
        line.together([&] {
            line.gap(4).plain("=").number(shown(term.product(channel)), theme().dim_text).plain(", ");
        });
        line.plain(term.left_out, theme().warning);
    }
    for (const std::string& pointer : term.made_by) line.together([&] { pieces.made_by(pointer); });
    line.result(trimmed(result),
                term.result[channel] == 0 ? theme().disabled_text : theme()[colour_of(term.term)]);
}

namespace {

TermSums sums_at(const ExplainedPoint& at) {
    TermSums sums{at.emission, at.global_ambient, {}, {}, at.cool_to_warm.color, at.bounces.term};
    for (const ExplainedLight& light : at.lights) {
        sums.ambient += light.ambient;
        sums.diffuse += light.diffuse;
        sums.specular += light.specular;
    }
    return sums;
}

}  // namespace

std::string sample_words(const ExplainedLight& area, const Light& light) {
    const auto less = [](const ExplainedLight& a, const ExplainedLight& b) { return a.n_dot_l < b.n_dot_l; };
    const auto [low, high] = std::minmax_element(area.samples.begin(), area.samples.end(), less);
    if (low == area.samples.end()) return {};
    return fmt::format("{}, n·l {} to {}", sample_count(area, light), shown_number(low->n_dot_l),
                       shown_number(high->n_dot_l));
}

std::string clipping_reason(glm::vec3 sum, float exposure) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
        const float shown = sum[i] * exposure;
        if (shown > 1.0005f)
            text += fmt::format("{}{} {} → 1", text.empty() ? "clips: " : ", ", "RGB"[i],
                                shown < 1e4f ? fmt::format("{:.2f}", shown) : fmt::format("{:.4g}", shown));
    }
    return text;
}

TermSums term_sums(const Explanation& explanation) {
    if (!explanation.lit_per_corner) return sums_at(explanation.at);
    TermSums sums;
    for (const ExplainedCorner& corner : explanation.corners) {
        const TermSums at = sums_at(corner.at);
        sums.tone += corner.weight * at.tone;
        sums.bounced += corner.weight * at.bounced;
        sums.emission += corner.weight * at.emission;
        sums.ambient += corner.weight * at.ambient;
        sums.diffuse += corner.weight * at.diffuse;
        sums.specular += corner.weight * at.specular;
    }
    return sums;
}

double angle_deg(float cosine) {
    return std::acos(std::clamp(double(cosine), -1.0, 1.0)) * 180 / std::numbers::pi;
}

std::string shown_number(float value) {
    constexpr float rounding = 1e-5f;  // remainder after floats of about 1 cancel
    const float size = std::abs(value) < rounding ? 0 : std::abs(value);
    const char* sign = value < 0 && size > 0 ? "−" : " ";
    if (size >= 1e5f) return fmt::format("{}{:.1e}", sign, size);
    if (size >= 1000) return fmt::format("{}{:.0f}", sign, size);
    if (size >= 100) return fmt::format("{}{:.1f}", sign, size);
    if (size >= 10) return fmt::format("{}{:.2f}", sign, size);
    return sign + significant_text(double(size), 3);
}

std::string shown_vector(glm::vec3 v) {
    return fmt::format("{} {} {}", shown_number(v.x), shown_number(v.y), shown_number(v.z));
}

namespace {

std::vector<std::string> parts_of(const std::string& pointer) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at < pointer.size();) {
        const std::size_t end = std::min(pointer.find('/', at + 1), pointer.size());
        parts.push_back(pointer.substr(at + 1, end - at - 1));
        at = end;
    }
    return parts;
}

/// The index that a part contains, or -1.
int index_of_part(const std::string& part) {
    int index = -1;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    return error == std::errc() && end == part.data() + part.size() ? index : -1;
}

struct Owner {
    std::string name;
    Selection selection;
};

/// The owner of the number at a pointer with these parts. Precondition: there is at least one part.
Owner owner_at(const std::vector<std::string>& parts, const Scene& scene) {
    const std::string& section = parts[0];
    const int index = parts.size() > 1 ? index_of_part(parts[1]) : -1;
    const auto at = static_cast<std::size_t>(index);  // -1 becomes the largest value
    if (section == "lights" && at < scene.lights.size())
        return {scene.lights[at].name, {Selection::Kind::Light, index}};
    if (section == "objects" && at < scene.objects.size())
        return {scene.objects[at].name, {Selection::Kind::Object, index}};
    if (section == "camera") return {"Camera", {Selection::Kind::Camera, 0}};
    if (section == "display") return {"Display", {Selection::Kind::Display, 0}};
    if (section == "npr") return {"Strokes and tones", {Selection::Kind::Shading, 0}};
    return {"Scene", {Selection::Kind::Shading, 0}};
}

}  // namespace

std::string owner_of(const std::string& pointer, const Scene& scene) {
    const std::vector<std::string> parts = parts_of(pointer);
    return parts.empty() ? pointer : owner_at(parts, scene).name;
}

NamedNumber named_number(const std::string& pointer, const Scene& scene) {
    const std::vector<std::string> parts = parts_of(pointer);
    if (parts.empty()) return {pointer, "", {Selection::Kind::Camera, 0}};
    const Owner owner = owner_at(parts, scene);
    const bool is_item =
        owner.selection.kind == Selection::Kind::Light || owner.selection.kind == Selection::Kind::Object;
    const bool is_whole = is_item && parts.size() == 2;
    return {owner.name, is_whole ? "" : words_of_pointer(scene, pointer), owner.selection};
}

NumberHandle number_handle(const HandledScene& scene, const std::string& pointer) {
    const NamedNumber named = named_number(pointer, scene.shown);
    const auto number =
        scene.edited != nullptr ? number_at(*scene.edited, pointer) : number_at(scene.shown, pointer);
    return {number.value(),
            named.owner == "Scene" ? named.what : fmt::format("{} of {}", named.what, named.owner)};
}

}  // namespace glint
