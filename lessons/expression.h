#pragma once
// Small expressions over the JSON output of Glint's commands, for the claims, questions and tasks of lessons
// (docs/lessons.md). The text is untrusted input.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "models/json/json.h"
#include "models/problem.h"

namespace glint {

/// The values of the names that an expression may use.
using NamedValues = std::map<std::string, Json, std::less<>>;

struct ExpressionNode;

/// Numbers, lists of numbers, text, true and false; + - * / ^, comparisons, and, or, not; member access such
/// as `a.lights[0].n_dot_l`; function calls. Angles are in degrees. A number and a list are combined element
/// by element.
class Expression {
  public:
    Expression() = default;  // an empty expression without a value

    /// Parses at most 1000 bytes, with at most 32 levels of nested brackets and signs.
    [[nodiscard]] static Result<Expression> parse(std::string_view text);

    /// Returns a problem if a name is not in `names`, a member is missing, an operation does not fit its
    /// operands, or the resulting lists exceed the available memory. Division by zero and similar errors give
    /// NaN, for which every comparison is false.
    [[nodiscard]] Result<Json> value(const NamedValues& names) const;
    /// The value of a condition; a problem if it is not a boolean.
    [[nodiscard]] Result<bool> holds(const NamedValues& names) const;
    /// The value of an expression that must be a number, or a list of numbers.
    [[nodiscard]] Result<double> number(const NamedValues& names) const;
    [[nodiscard]] Result<std::vector<double>> numbers(const NamedValues& names) const;

    /// The first false part of the condition with its values, for messages: "0.45 = 0.5 within 0.001".
    [[nodiscard]] std::string with_values(const NamedValues& names) const;

    [[nodiscard]] const std::string& text() const { return text_; }
    /// The names that the expression reads, each once.
    [[nodiscard]] std::vector<std::string> names() const;

  private:
    std::string text_;
    std::shared_ptr<const ExpressionNode> root_;
};

// An expression as a syntax tree. Internal to the expression code of lessons/.

enum class ExpressionKind {
    Literal,  // a number, text, true, false
    Name,
    Member,   // member `word` of the part
    Element,  // the first part [ the second ]
    Call,     // word ( parts )
    List,
    Negate,
    Arithmetic,  // parts separated by word: + - * / ^
    Compare,     // word = != < <= > >=; a third part: within
    And,
    Or,
    Not
};

struct ExpressionNode {
    ExpressionKind kind = ExpressionKind::Literal;
    std::string word;
    Json literal;
    std::vector<ExpressionNode> parts;
};

/// A problem in an expression or its operands. Every public function of Expression catches it.
struct ExpressionProblem {
    std::string what, expected;
};

/// Throws ExpressionProblem if a tolerance that contains no names is negative or not a number.
void require_tolerances(const ExpressionNode& node);

/// Evaluates a function; throws ExpressionProblem if the arguments are wrong. The parser has already checked
/// the name with known_function().
[[nodiscard]] Json call_function(const std::string& name, const std::vector<Json>& arguments);
[[nodiscard]] bool known_function(std::string_view name);
[[nodiscard]] std::vector<std::string> function_names();

/// Applies op(a, b), element by element if one or both are lists. Throws ExpressionProblem.
[[nodiscard]] Json combined(const Json& a, const Json& b, double (*op)(double, double));
/// Converts a value to a number; null becomes NaN. Throws ExpressionProblem for anything else.
[[nodiscard]] double as_number(const Json& value);
/// Formats a value for a message, including non-finite numbers, which JSON lacks.
[[nodiscard]] std::string in_words(const Json& value);

}  // namespace glint
