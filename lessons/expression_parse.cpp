// A recursive-descent parser from text to tree: one function per precedence level.
#include <fmt/format.h>

#include <charconv>

#include "lessons/expression.h"
#include "models/json/json.h"

namespace glint {
namespace {

using Kind = ExpressionKind;

constexpr std::size_t max_expression_bytes = 1000;
constexpr int max_expression_depth = 32;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Parser {
  public:
    explicit Parser(std::string_view text) : rest_(text) {}

    ExpressionNode whole() {
        ExpressionNode node = condition();
        skip_blanks();
        if (!rest_.empty()) fail_here("an operator or the end");
        return node;
    }

  private:
    /// Increments the parser's nesting depth for the lifetime of the object.
    class Deeper {
      public:
        explicit Deeper(int& depth) : depth_(depth) {
            if (++depth_ > max_expression_depth)
                throw ExpressionProblem{"is nested too deeply",
                                        fmt::format("at most {} levels", max_expression_depth)};
        }
        ~Deeper() { --depth_; }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;

      private:
        int& depth_;
    };

    [[noreturn]] void fail_here(std::string expected) const {
        const std::string what =
            rest_.empty() ? "ends too early" : "has " + in_quotes(rest_) + " where it does not belong";
        throw ExpressionProblem{what, std::move(expected)};
    }
    void skip_blanks() {
        while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t')) rest_.remove_prefix(1);
    }
    bool take(std::string_view symbol) {
        skip_blanks();
        if (!rest_.starts_with(symbol)) return false;
        rest_.remove_prefix(symbol.size());
        return true;
    }
    void require(std::string_view symbol) {
        if (!take(symbol)) fail_here(in_quotes(symbol));
    }
    /// The next word, without consuming it.
    [[nodiscard]] std::string_view next_word() {
        skip_blanks();
        std::size_t end = 0;
        if (!rest_.empty() && is_letter(rest_[0]))
            while (end < rest_.size() && (is_letter(rest_[end]) || is_digit(rest_[end]))) ++end;
        return rest_.substr(0, end);
    }
    bool take_word(std::string_view word) {
        if (next_word() != word) return false;
        rest_.remove_prefix(word.size());
        return true;
    }
    std::string name() {
        std::string word(next_word());
        if (word.empty()) fail_here("a name");
        rest_.remove_prefix(word.size());
        return word;
    }

    // Takes the parts as parameters instead of a braced list: if the second element throws during
    // initialisation, GCC 12 destroys parts that were never constructed (GCC bug 66139).
    static ExpressionNode made(Kind kind, std::string word) { return {kind, std::move(word), {}, {}}; }
    static ExpressionNode made(Kind kind, std::string word, ExpressionNode part) {
        ExpressionNode node = made(kind, std::move(word));
        node.parts.push_back(std::move(part));
        return node;
    }
    static ExpressionNode made(Kind kind, std::string word, ExpressionNode first, ExpressionNode second) {
        ExpressionNode node = made(kind, std::move(word), std::move(first));
        node.parts.push_back(std::move(second));
        return node;
    }

    /// Parses a condition in brackets.
    ExpressionNode enclosed() {
        const Deeper deeper(depth_);
        return condition();
    }
    ExpressionNode condition() {
        ExpressionNode left = both();
        while (take_word("or")) left = made(Kind::Or, "or", std::move(left), both());
        return left;
    }
    ExpressionNode both() {
        ExpressionNode left = inverse();
        while (take_word("and")) left = made(Kind::And, "and", std::move(left), inverse());
        return left;
    }
    ExpressionNode inverse() {
        if (!take_word("not")) return comparison();
        const Deeper deeper(depth_);
        return made(Kind::Not, "not", inverse());
    }
    ExpressionNode comparison() {
        ExpressionNode left = sum();
        for (const char* const symbol : {"<=", ">=", "!=", "=", "<", ">"}) {
            if (!take(symbol)) continue;
            ExpressionNode node = made(Kind::Compare, symbol, std::move(left), sum());
            if (take_word("within")) {
                if (node.word != "=" && node.word != "!=")
                    throw ExpressionProblem{"has a tolerance after " + in_quotes(node.word),
                                            "\"within\" after = or != only"};
                node.parts.push_back(sum());
            }
            return node;
        }
        return left;
    }
    ExpressionNode sum() {
        ExpressionNode left = product();
        while (true) {
            const char* const symbol = take("+") ? "+" : take("-") ? "-" : nullptr;
            if (symbol == nullptr) return left;
            left = made(Kind::Arithmetic, symbol, std::move(left), product());
        }
    }
    ExpressionNode product() {
        ExpressionNode left = negative();
        while (true) {
            const char* const symbol = take("*") ? "*" : take("/") ? "/" : nullptr;
            if (symbol == nullptr) return left;
            left = made(Kind::Arithmetic, symbol, std::move(left), negative());
        }
    }
    ExpressionNode negative() {
        if (!take("-")) return power();
        const Deeper deeper(depth_);
        return made(Kind::Negate, "-", negative());
    }
    ExpressionNode power() {
        ExpressionNode base = postfix();
        if (!take("^")) return base;
        const Deeper deeper(depth_);
        return made(Kind::Arithmetic, "^", std::move(base), negative());
    }
    ExpressionNode postfix() {
        ExpressionNode node = primary();
        while (true) {
            if (!rest_.empty() && rest_[0] == '.') {
                rest_.remove_prefix(1);
                node = made(Kind::Member, name(), std::move(node));
            } else if (!rest_.empty() && rest_[0] == '[') {
                rest_.remove_prefix(1);
                node = made(Kind::Element, "", std::move(node), enclosed());
                require("]");
            } else {
                return node;
            }
        }
    }
    ExpressionNode primary() {
        if (take("(")) {
            ExpressionNode node = enclosed();
            require(")");
            return node;
        }
        if (take("[")) {
            std::vector<ExpressionNode> parts = listed("]");
            return {Kind::List, "", {}, std::move(parts)};
        }
        skip_blanks();
        if (rest_.empty()) fail_here("a value");
        if (rest_[0] == '"') return quoted();
        if (is_digit(rest_[0]) || rest_[0] == '.') return number();
        if (next_word().empty()) fail_here("a value");
        std::string word = name();
        if (word == "true" || word == "false") return {Kind::Literal, "", Json(word == "true"), {}};
        if (rest_.starts_with("(")) return call(std::move(word));
        return made(Kind::Name, std::move(word));
    }
    ExpressionNode call(std::string word) {
        if (!known_function(word))
            throw ExpressionProblem{in_quotes(word) + " is not a function",
                                    in_quotes(nearest(word, function_names()))};
        rest_.remove_prefix(1);
        std::vector<ExpressionNode> arguments = listed(")");
        return {Kind::Call, std::move(word), {}, std::move(arguments)};
    }
    std::vector<ExpressionNode> listed(std::string_view end) {
        std::vector<ExpressionNode> parts;
        if (take(end)) return parts;
        do parts.push_back(enclosed());
        while (take(","));
        require(end);
        return parts;
    }
    ExpressionNode quoted() {
        const std::size_t end = rest_.find('"', 1);
        if (end == rest_.npos) throw ExpressionProblem{"has an unclosed quote", "\""};
        ExpressionNode node{Kind::Literal, "", Json(rest_.substr(1, end - 1)), {}};
        rest_.remove_prefix(end + 1);
        return node;
    }
    ExpressionNode number() {
        double value = 0;
        const char* const begin = rest_.data();
        const auto [end, error] = std::from_chars(begin, begin + rest_.size(), value);
        if (error != std::errc{}) fail_here("a number");
        rest_.remove_prefix(static_cast<std::size_t>(end - begin));
        return {Kind::Literal, "", Json(value), {}};
    }

    std::string_view rest_;
    int depth_ = 0;
};

}  // namespace

Result<Expression> Expression::parse(std::string_view text) {
    if (text.size() > max_expression_bytes)
        return Problem{"", "", "the expression is too long",
                       fmt::format("at most {} bytes", max_expression_bytes)};
    Expression expression;
    expression.text_ = text;
    try {
        expression.root_ = std::make_shared<const ExpressionNode>(Parser(text).whole());
        require_tolerances(*expression.root_);
    } catch (const ExpressionProblem& problem) {
        return Problem{"", "", in_quotes(text) + " " + problem.what, problem.expected};
    }
    return expression;
}

}  // namespace glint
