// Draws a line of the equation, piece by piece.
#include <fmt/core.h>

#include "renderer/explain/equation_text.h"
#include "renderer/explain/printed_number.h"
#include "ui/features/inspector/equation/equation_tab.h"
#include "ui/features/inspector/equation/quantity_look.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/equation/words.h"

namespace glint {
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
    [[nodiscard]] bool edited() const { return edited_; }

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
        edited_ |= line_.exponent(number, colour);
    }
    void handle(const std::string& pointer, int decimals, const ImVec4& colour) {
        NumberHandle number = number_handle(scene_, pointer);
        number.number.kind.format = decimal_format(number.number.value, decimals);
        edited_ |= line_.handle(number, colour);
    }

    TextLine& line_;
    const HandledScene& scene_;
    int channel_;
    bool edited_ = false;
};

}  // namespace

bool draw_line(const EquationLine& term, const HandledScene& scene, int channel) {
    const LineDecimals decimals = written_decimals(term, channel, shown);
    const std::string result = shown(term.result[channel]);
    TextLine line(28);
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
    return pieces.edited();
}

}  // namespace glint
