#pragma once
// An expression as a syntax tree. Internal to the expression code of lessons/.

#include <string>
#include <vector>

#include "lessons/expression.h"

namespace glint {

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

/// Evaluates a function. Throws ExpressionProblem. The parser calls `known`.
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
