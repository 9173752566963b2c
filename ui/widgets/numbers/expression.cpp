#include "ui/widgets/numbers/expression.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace glint {
namespace {

constexpr int deepest = 40;  // nested brackets: typed text must not exhaust the stack

/// Replaces decimal commas, and the typographic signs that the window itself writes, by plain signs.
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
