#pragma once
// An expression as a tree. Inside models/lesson only.

#include <string>
#include <vector>

#include "lessons/expression.h"

namespace glint {

enum class ExpressionKind {
    Literal,  // a number, text, true, false
    Name,
    Member,   // .word of the part
    Element,  // the first part [ the second ]
    Call,     // word ( the parts )
    List,
    Negate,
    Arithmetic,  // the parts, word + - * / ^ between them
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

/// A problem in an expression or its operands; caught before a function of Expression returns.
struct ExpressionProblem {
    std::string what, expected;
};

/// Throws ExpressionProblem if a tolerance that depends on no name is below 0 or not a number.
void require_tolerances(const ExpressionNode& node);

/// A function's value. Throws ExpressionProblem. The parser calls `known`.
[[nodiscard]] Json call_function(const std::string& name, const std::vector<Json>& arguments);
[[nodiscard]] bool known_function(std::string_view name);
[[nodiscard]] std::vector<std::string> function_names();

/// op(a, b), element by element if one or both are lists. Throws ExpressionProblem.
[[nodiscard]] Json combined(const Json& a, const Json& b, double (*op)(double, double));
/// The number; NaN for null. Throws ExpressionProblem for anything else.
[[nodiscard]] double as_number(const Json& value);
/// The value for a message: JSON has only finite numbers.
[[nodiscard]] std::string in_words(const Json& value);

}  // namespace glint
