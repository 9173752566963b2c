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

/// What is wrong with an expression or with what it is given; caught before a function of Expression returns.
struct ExpressionProblem {
    std::string what, expected;
};

/// Throws ExpressionProblem where a tolerance that depends on no name is below 0 or not a number.
void require_tolerances(const ExpressionNode& node);

/// A function's value. Throws ExpressionProblem; `known` is asked while parsing.
[[nodiscard]] Json call_function(const std::string& name, const std::vector<Json>& arguments);
[[nodiscard]] bool known_function(std::string_view name);
[[nodiscard]] std::vector<std::string> function_names();

/// op(a, b), element by element where one or both are lists. Throws ExpressionProblem.
[[nodiscard]] Json combined(const Json& a, const Json& b, double (*op)(double, double));
/// The number; throws ExpressionProblem for anything but a number and null, which is not a number (NaN).
[[nodiscard]] double as_number(const Json& value);
/// The value as a message writes it: JSON has no number beyond the finite ones.
[[nodiscard]] std::string in_words(const Json& value);

}  // namespace glint
