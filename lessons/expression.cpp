#include "lessons/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "models/json/json.h"
#include "models/numbers.h"

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
        throw ExpressionProblem{fmt::format("there is no element {} in a list of {}", at, size),
                                size == 0 ? "a list with elements" : "0 to " + std::to_string(size - 1)};
    return elements_of(list)[static_cast<std::size_t>(at)];
}

using Operation = double (*)(double, double);

Operation operation_of(char symbol) {
    switch (symbol) {
    case '+':
        return [](double a, double b) { return a + b; };
    case '-':
        return [](double a, double b) { return a - b; };
    case '*':
        return [](double a, double b) { return a * b; };
    case '/':
        return [](double a, double b) { return a / b; };
    default:
        return [](double a, double b) { return std::pow(a, b); };
    }
}

/// Whether a numeric comparison holds for all elements. A number is compared with each element of a list.
bool all_hold(const std::string& symbol, const Json& a, const Json& b, double tolerance) {
    if (a.is_array() || b.is_array()) {
        const std::size_t size = a.is_array() ? elements_of(a).size() : elements_of(b).size();
        if (a.is_array() && b.is_array() && elements_of(b).size() != size)
            throw ExpressionProblem{"lists of different lengths are compared", "lists of equal length"};
        if (size == 0 && a.is_array() != b.is_array())
            throw ExpressionProblem{"an empty list is compared", "a list with elements"};
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
            throw ExpressionProblem{"text values are compared by " + in_quotes(node.word), "= or !="};
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

/// Copies the values of the parts. The parts may refer to a long answer many times.
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
        return combined(0.0, found_by(node.parts[0], names).value(), operation_of('-'));
    case Kind::Arithmetic:
        return combined(found_by(node.parts[0], names).value(), found_by(node.parts[1], names).value(),
                        operation_of(node.word[0]));
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

// The functions available in expressions. Angles are in degrees.

namespace {

using Values = std::vector<Json>;

const Json::array_t& as_list(const Json& value) {
    if (!value.is_array()) throw ExpressionProblem{in_words(value) + " is not a list", "a list"};
    return elements_of(value);
}

Json each(const Json& value, double (*f)(double)) {
    if (!value.is_array()) return f(as_number(value));
    Json::array_t results;
    for (const Json& element : elements_of(value)) results.push_back(each(element, f));
    return Json(std::move(results));
}
Json sum(const Json& list) {
    Json total(0.0);
    for (const Json& element : as_list(list)) total = combined(total, element, operation_of('+'));
    return total;
}

double dot(const Json& a, const Json& b) {
    as_list(a);
    as_list(b);
    return as_number(sum(combined(a, b, operation_of('*'))));
}

double length(const Json& v) { return std::sqrt(dot(v, v)); }

Json cross(const Json& a, const Json& b) {
    if (as_list(a).size() != 3 || as_list(b).size() != 3)
        throw ExpressionProblem{"cross() is given lists of wrong lengths", "two lists of three numbers"};
    std::array<double, 3> x{}, y{};
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = as_number(elements_of(a)[i]);
        y[i] = as_number(elements_of(b)[i]);
    }
    return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

/// Multiplies a matrix (a list of rows) by a vector.
Json mul(const Json& matrix, const Json& vector) {
    Json::array_t rows;
    for (const Json& row : as_list(matrix)) rows.emplace_back(dot(row, vector));
    return Json(std::move(rows));
}

/// The index of the first element in the order `before`. Skips NaN.
Json place_of(const Json& list, bool (*before)(double, double)) {
    const Json::array_t& elements = as_list(list);
    std::size_t best = elements.size();
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const double x = as_number(elements[i]);
        if (std::isnan(x)) continue;
        if (best == elements.size() || before(x, as_number(elements[best]))) best = i;
    }
    if (best == elements.size()) throw ExpressionProblem{"the list contains no numbers", "at least one"};
    return best;
}
bool is_less(double a, double b) { return a < b; }
bool is_more(double a, double b) { return a > b; }

Json extreme(const Values& v, bool (*before)(double, double)) {
    const Json list = v.size() == 1 ? v[0] : Json(v);
    const auto at = static_cast<std::size_t>(place_of(list, before).get<double>());
    return elements_of(list)[at];
}

Json part(const Values& v) {
    const auto size = static_cast<double>(as_list(v[0]).size());
    const double from = as_number(v[1]), to = as_number(v[2]);
    const bool whole = std::floor(from) == from && std::floor(to) == to;
    if (!(whole && from >= 0 && to >= from && to < size))
        throw ExpressionProblem{"part() has a position outside its list",
                                "whole numbers from 0 to the last one"};
    const auto begin = elements_of(v[0]).begin();
    return Json(Json::array_t(begin + static_cast<std::ptrdiff_t>(from),
                              begin + static_cast<std::ptrdiff_t>(to) + 1));
}

Json mean(const Values& v) {
    return combined(sum(v[0]), static_cast<double>(as_list(v[0]).size()), operation_of('/'));
}

struct Function {
    std::string_view name;
    std::size_t least, most;  // minimum and maximum number of arguments
    Json (*value)(const Values& v);
    double (*of_each)(double x) = nullptr;  // in place of `value`: is applied to each number
};

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

constexpr std::array functions{
    Function{"abs", 1, 1, nullptr, [](double x) { return std::abs(x); }},
    Function{"sqrt", 1, 1, nullptr, [](double x) { return std::sqrt(x); }},
    Function{"exp", 1, 1, nullptr, [](double x) { return std::exp(x); }},
    Function{"log", 1, 1, nullptr, [](double x) { return std::log(x); }},
    Function{"round", 1, 1, nullptr, [](double x) { return std::round(x); }},
    Function{"sin", 1, 1, nullptr, [](double x) { return std::sin(x * degree); }},
    Function{"cos", 1, 1, nullptr, [](double x) { return std::cos(x * degree); }},
    Function{"tan", 1, 1, nullptr, [](double x) { return std::tan(x * degree); }},
    Function{"asin", 1, 1, nullptr, [](double x) { return std::asin(x) / degree; }},
    Function{"acos", 1, 1, nullptr, [](double x) { return std::acos(x) / degree; }},
    Function{"atan", 1, 1, nullptr, [](double x) { return std::atan(x) / degree; }},
    Function{"pi", 0, 0, [](const Values&) { return Json(std::numbers::pi); }},
    Function{"count", 1, 1, [](const Values& v) { return Json(as_list(v[0]).size()); }},
    Function{"sum", 1, 1, [](const Values& v) { return sum(v[0]); }},
    Function{"mean", 1, 1, mean},
    Function{"min", 1, unlimited, [](const Values& v) { return extreme(v, is_less); }},
    Function{"max", 1, unlimited, [](const Values& v) { return extreme(v, is_more); }},
    Function{"where_min", 1, 1, [](const Values& v) { return place_of(v[0], is_less); }},
    Function{"where_max", 1, 1, [](const Values& v) { return place_of(v[0], is_more); }},
    Function{"part", 3, 3, part},
    Function{"dot", 2, 2, [](const Values& v) { return Json(dot(v[0], v[1])); }},
    Function{"length", 1, 1, [](const Values& v) { return Json(length(v[0])); }},
    Function{"unit", 1, 1, [](const Values& v) { return combined(v[0], length(v[0]), operation_of('/')); }},
    Function{"cross", 2, 2, [](const Values& v) { return cross(v[0], v[1]); }},
    Function{"mul", 2, 2, [](const Values& v) { return mul(v[0], v[1]); }},
};

const Function* function_of(std::string_view name) {
    const auto* const at =
        std::find_if(functions.begin(), functions.end(), [&](const Function& f) { return f.name == name; });
    return at == functions.end() ? nullptr : at;
}

}  // namespace

double as_number(const Json& value) {
    if (value.is_number()) return value.get<double>();
    if (value == Json()) return std::numeric_limits<double>::quiet_NaN();
    throw ExpressionProblem{in_words(value) + " is not a number", "a number"};
}

std::string in_words(const Json& value) {
    if (!value.is_number() || std::isfinite(value.get<double>())) return shortened(json_line(value));
    if (std::isnan(value.get<double>())) return "undefined";
    return value.get<double>() < 0 ? "-infinite" : "infinite";
}

Json combined(const Json& a, const Json& b, double (*op)(double, double)) {
    if (!a.is_array() && !b.is_array()) return op(as_number(a), as_number(b));
    const std::size_t size = a.is_array() ? elements_of(a).size() : elements_of(b).size();
    if (a.is_array() && b.is_array() && elements_of(b).size() != size)
        throw ExpressionProblem{"lists of " + std::to_string(size) + " and " +
                                    std::to_string(elements_of(b).size()) + " values are combined",
                                "lists of equal length, or a number and a list"};
    Json::array_t results;
    results.reserve(size);
    for (std::size_t i = 0; i < size; ++i)
        results.push_back(
            combined(a.is_array() ? elements_of(a)[i] : a, b.is_array() ? elements_of(b)[i] : b, op));
    return Json(std::move(results));
}

bool known_function(std::string_view name) { return function_of(name) != nullptr; }

std::vector<std::string> function_names() {
    std::vector<std::string> names;
    names.reserve(std::size(functions));
    for (const Function& f : functions) names.emplace_back(f.name);
    return names;
}

Json call_function(const std::string& name, const std::vector<Json>& arguments) {
    const Function& f = *function_of(name);
    if (arguments.size() < f.least || arguments.size() > f.most)
        throw ExpressionProblem{name + "() is given " + std::to_string(arguments.size()) + " values",
                                (f.most == unlimited ? "at least " : "") + std::to_string(f.least)};
    return f.of_each != nullptr ? each(arguments[0], f.of_each) : f.value(arguments);
}

}  // namespace glint
