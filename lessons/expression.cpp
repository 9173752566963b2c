#include "lessons/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/expression_node.h"
#include "models/json/json.h"

namespace glint {
namespace {

constexpr std::size_t max_listed_values = 1'000'000;

using Kind = ExpressionKind;

/// Points to a named value or a literal of the expression, or owns a computed value. Reading one number of a
/// long explanation therefore does not copy it.
struct Found {
    const Json* stored = nullptr;
    Json made;

    [[nodiscard]] const Json& value() const { return stored != nullptr ? *stored : made; }
    [[nodiscard]] Json take() && {
        if (stored != nullptr) return *stored;
        return std::move(made);
    }
    /// Returns `part`, which is inside this value.
    [[nodiscard]] Found only(const Json& part) const {
        return stored != nullptr ? Found{&part, {}} : Found{nullptr, part};
    }
};

Found found_by(const ExpressionNode& node, const NamedValues& names);

bool truth_of(const ExpressionNode& node, const NamedValues& names) {
    const Found found = found_by(node, names);
    const Json& value = found.value();
    if (!value.is_boolean())
        throw ExpressionProblem{in_words(value) + " is neither true nor false", "a condition"};
    return value.get<bool>();
}

const Json& member_of(const Json& object, const std::string& name) {
    if (const Json* member = find_member(object, name)) return *member;
    std::vector<std::string> members;
    if (object.is_object())
        for (const auto& [key, unused] : object.items()) members.push_back(key);
    throw ExpressionProblem{"there is no " + in_quotes(name),
                            members.empty() ? "an object with it" : in_quotes(nearest(name, members))};
}

/// Collects the member `name` of each element of a list, which may contain nested lists.
Json members_of(const Json& list, const std::string& name) {
    Json::array_t results;
    for (const Json& element : elements_of(list))
        results.push_back(element.is_array() ? members_of(element, name) : member_of(element, name));
    return Json(std::move(results));
}

const Json& element_of(const Json& list, const Json& place) {
    const double at = as_number(place);
    const std::size_t size = elements_of(list).size();
    if (!(at >= 0 && at < static_cast<double>(size)) || at != std::floor(at))
        throw ExpressionProblem{fmt::format("there is no element {} of a list of {}", at, size),
                                size == 0 ? "a list with elements" : "0 to " + std::to_string(size - 1)};
    return elements_of(list)[static_cast<std::size_t>(at)];
}

double arithmetic(char symbol, double a, double b) {
    switch (symbol) {
    case '+':
        return a + b;
    case '-':
        return a - b;
    case '*':
        return a * b;
    case '/':
        return a / b;
    default:
        return std::pow(a, b);
    }
}

Json arithmetic_of(char symbol, const Json& a, const Json& b) {
    switch (symbol) {
    case '+':
        return combined(a, b, [](double x, double y) { return arithmetic('+', x, y); });
    case '-':
        return combined(a, b, [](double x, double y) { return arithmetic('-', x, y); });
    case '*':
        return combined(a, b, [](double x, double y) { return arithmetic('*', x, y); });
    case '/':
        return combined(a, b, [](double x, double y) { return arithmetic('/', x, y); });
    default:
        return combined(a, b, [](double x, double y) { return arithmetic('^', x, y); });
    }
}

/// Whether a numeric comparison holds for all elements. A number is compared with each element of a list.
bool all_hold(const std::string& symbol, const Json& a, const Json& b, double tolerance) {
    if (a.is_array() || b.is_array()) {
        const std::size_t size = a.is_array() ? elements_of(a).size() : elements_of(b).size();
        if (a.is_array() && b.is_array() && elements_of(b).size() != size)
            throw ExpressionProblem{"lists of different lengths are compared", "equally many elements"};
        if (size == 0 && a.is_array() != b.is_array())
            throw ExpressionProblem{"a list of 0 is compared", "a list with elements"};
        for (std::size_t i = 0; i < size; ++i)
            if (!all_hold(symbol, a.is_array() ? elements_of(a)[i] : a, b.is_array() ? elements_of(b)[i] : b,
                          tolerance))
                return false;
        return true;
    }
    const double x = as_number(a), y = as_number(b);
    if (symbol == "=") return x == y || std::abs(x - y) <= tolerance;
    if (symbol == "<") return x < y;
    if (symbol == "<=") return x <= y;
    if (symbol == ">") return x > y;
    return x >= y;
}

/// Whether any element differs by more than `tolerance`; false for NaN.
bool differ(const Json& a, const Json& b, double tolerance) {
    const Json differences = combined(a, b, [](double x, double y) { return std::abs(x - y); });
    const auto is_more = [tolerance](const auto& self, const Json& value) -> bool {
        if (!value.is_array()) return as_number(value) > tolerance;
        const Json::array_t& elements = elements_of(value);
        return std::any_of(elements.begin(), elements.end(),
                           [&](const Json& element) { return self(self, element); });
    };
    return is_more(is_more, differences);
}

/// The tolerance after "within", or 0.
double tolerance_of(const ExpressionNode& comparison, const NamedValues& names) {
    if (comparison.parts.size() < 3) return 0;
    const double tolerance = as_number(found_by(comparison.parts[2], names).value());
    if (!(tolerance >= 0)) throw ExpressionProblem{"has the tolerance " + in_words(tolerance), "0 or more"};
    return tolerance;
}

Json comparison_of(const ExpressionNode& node, const NamedValues& names) {
    const double tolerance = tolerance_of(node, names);
    const Found first = found_by(node.parts[0], names), second = found_by(node.parts[1], names);
    const Json &a = first.value(), &b = second.value();
    const auto is_plain = [](const Json& v) { return v.is_string() || v.is_boolean(); };
    if (is_plain(a) || is_plain(b)) {
        if (node.word != "=" && node.word != "!=")
            throw ExpressionProblem{"texts are compared by " + in_quotes(node.word), "= or !="};
        return (a == b) == (node.word == "=");
    }
    return node.word == "!=" ? differ(a, b, tolerance) : all_hold(node.word, a, b, tolerance);
}

const Json& named_value(const ExpressionNode& node, const NamedValues& names) {
    const auto found = names.find(node.word);
    if (found != names.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [name, unused] : names) known.push_back(name);
    throw ExpressionProblem{in_quotes(node.word) + " is not known",
                            known.empty() ? "a run above it" : in_quotes(nearest(node.word, known))};
}

Json made_by(const ExpressionNode& node, const NamedValues& names);

Found found_by(const ExpressionNode& node, const NamedValues& names) {
    if (node.kind == Kind::Literal) return {&node.literal, {}};
    if (node.kind == Kind::Name) return {&named_value(node, names), {}};
    if (node.kind != Kind::Member && node.kind != Kind::Element) return {nullptr, made_by(node, names)};
    const Found whole = found_by(node.parts[0], names);
    if (node.kind == Kind::Element)
        return whole.only(element_of(whole.value(), found_by(node.parts[1], names).value()));
    if (whole.value().is_array()) return {nullptr, members_of(whole.value(), node.word)};
    return whole.only(member_of(whole.value(), node.word));
}

std::size_t count_values(const Json& json) {
    std::size_t count = 1;
    if (json.is_structured())
        for (const Json& element : json) count += count_values(element);
    return count;
}

/// Copies the values of the parts. They may refer to a long answer many times.
std::vector<Json> part_values(const std::vector<ExpressionNode>& parts, const NamedValues& names) {
    std::vector<Json> values;
    std::size_t count = 0;
    for (const ExpressionNode& part : parts) {
        Found found = found_by(part, names);
        count += count_values(found.value());
        if (count > max_listed_values)
            throw ExpressionProblem{fmt::format("lists more than {} values", max_listed_values), "fewer"};
        values.push_back(std::move(found).take());
    }
    return values;
}

Json made_by(const ExpressionNode& node, const NamedValues& names) {
    switch (node.kind) {
    case Kind::Literal:
    case Kind::Name:
    case Kind::Member:
    case Kind::Element:
        break;  // handled by found_by()
    case Kind::Negate:
        return combined(0.0, found_by(node.parts[0], names).value(),
                        [](double a, double b) { return a - b; });
    case Kind::Arithmetic:
        return arithmetic_of(node.word[0], found_by(node.parts[0], names).value(),
                             found_by(node.parts[1], names).value());
    case Kind::Compare:
        return comparison_of(node, names);
    case Kind::And:
        return truth_of(node.parts[0], names) && truth_of(node.parts[1], names);
    case Kind::Or:
        return truth_of(node.parts[0], names) || truth_of(node.parts[1], names);
    case Kind::Not:
        return !truth_of(node.parts[0], names);
    case Kind::List:
    case Kind::Call:
        break;
    }
    std::vector<Json> values = part_values(node.parts, names);
    return node.kind == Kind::List ? Json(std::move(values)) : call_function(node.word, values);
}

void collect_names(const ExpressionNode& node, std::vector<std::string>& names) {
    if (node.kind == Kind::Name && std::find(names.begin(), names.end(), node.word) == names.end())
        names.push_back(node.word);
    for (const ExpressionNode& part : node.parts) collect_names(part, names);
}

/// Finds the innermost false part of a condition.
const ExpressionNode& first_false(const ExpressionNode& node, const NamedValues& names) {
    if (node.kind == Kind::And)
        for (const ExpressionNode& part : node.parts)
            if (!truth_of(part, names)) return first_false(part, names);
    return node;
}

}  // namespace

void require_tolerances(const ExpressionNode& node) {
    for (const ExpressionNode& part : node.parts) require_tolerances(part);
    if (node.kind != Kind::Compare || node.parts.size() < 3) return;
    std::vector<std::string> names;
    collect_names(node.parts[2], names);
    if (names.empty()) (void)tolerance_of(node, {});
}

Result<Json> Expression::value(const NamedValues& names) const {
    try {
        if (root_) return found_by(*root_, names).take();
        return Problem{"", "", "the expression is empty", "a value"};
    } catch (const ExpressionProblem& problem) {
        return Problem{"", "", in_quotes(text_) + ": " + problem.what, problem.expected};
    }
}

Result<bool> Expression::holds(const NamedValues& names) const {
    const Result<Json> found = value(names);
    if (const Problem* problem = problem_of(found)) return *problem;
    const auto& truth = std::get<Json>(found);
    if (truth.is_boolean()) return truth.get<bool>();
    return Problem{"", "", in_quotes(text_) + " is " + in_words(truth), "true or false"};
}

Result<double> Expression::number(const NamedValues& names) const {
    const Result<Json> found = value(names);
    if (const Problem* problem = problem_of(found)) return *problem;
    const auto& number = std::get<Json>(found);
    if (number.is_number() && std::isfinite(number.get<double>())) return number.get<double>();
    return Problem{"", "", in_quotes(text_) + " is " + in_words(number), "a number"};
}

Result<std::vector<double>> Expression::numbers(const NamedValues& names) const {
    const Result<Json> found = value(names);
    if (const Problem* problem = problem_of(found)) return *problem;
    const auto& list = std::get<Json>(found);
    std::vector<double> numbers;
    for (const Json& element : elements_of(list))
        if (element.is_number() && std::isfinite(element.get<double>()))
            numbers.push_back(element.get<double>());
    if (list.is_array() && numbers.size() == elements_of(list).size()) return numbers;
    return Problem{"", "", in_quotes(text_) + " is " + in_words(list), "a list of numbers"};
}

std::string Expression::with_values(const NamedValues& names) const {
    if (!root_) return {};
    try {
        const ExpressionNode& part = first_false(*root_, names);
        if (part.kind != Kind::Compare) return text_;
        const auto part_shown = [&](std::size_t i) {
            return in_words(found_by(part.parts[i], names).value());
        };
        std::string text = part_shown(0) + " " + part.word + " " + part_shown(1);
        if (part.parts.size() > 2) text += " within " + part_shown(2);
        return text;
    } catch (const ExpressionProblem& problem) {
        return problem.what;
    }
}

std::vector<std::string> Expression::names() const {
    std::vector<std::string> names;
    if (root_) collect_names(*root_, names);
    return names;
}

}  // namespace glint
