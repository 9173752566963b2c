#include "tests/fuzz/json_mutator.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "models/scene_file/scene_file.h"
#include "tests/fuzz/fuzz.h"

namespace glint::fuzz {
namespace {

std::size_t below(std::mt19937& random, std::size_t n) { return random() % n; }

bool is_word(std::string_view text) {
    constexpr std::size_t longest = 24;
    return !text.empty() && text.size() <= longest && text.find_first_of(" ,;()$#") == std::string_view::npos;
}

void collect(const Json& json, std::vector<std::string>& words) {
    if (json.is_string() && is_word(json.get_ref<const std::string&>()))
        words.push_back(json.get_ref<const std::string&>());
    for (const Json& element : elements_of(json)) collect(element, words);
    for (const auto& [name, value] : members_of(json)) {
        if (is_word(name)) words.push_back(name);
        collect(value, words);
    }
}

/// Every key and word that a scene file may contain, from its schema and thus from the rows of
/// scene_fields.h.
const std::vector<std::string>& words() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> found;
        collect(json_or_null(scene_schema()), found);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }();
    return all;
}

double random_number(std::mt19937& random) {
    constexpr double hard[] = {0,      -0.0,    1,    -1,    0.5,  2,    4,     9,     16,    64,
                               90,     180,     1e7,  -1e7,  2e7,  1e39, 1e308, 1e-45, 1e-46, 1e-300,
                               1e-6,   65536,   4096, 10001, 1e18, 0.1,  3,     255,   256,   2147483648.0,
                               9.3e18, 16777217};
    if (below(random, 3) != 0) return hard[below(random, std::size(hard))];
    return (static_cast<double>(random()) / 4294967295.0 - 0.5) * (below(random, 2) == 0 ? 4 : 400);
}

/// The number of values in `json`, including `json` itself.
std::size_t count_of(const Json& json) {
    std::size_t count = 1;
    for (const Json& element : elements_of(json)) count += count_of(element);
    for (const auto& [name, value] : members_of(json)) count += count_of(value);
    return count;
}

/// The value with this index, counted depth first; 0 is `json` itself.
const Json& value_at(const Json& json, std::size_t index) {
    if (index == 0) return json;
    --index;
    const auto within = [&index](const Json& value) {
        const std::size_t count = count_of(value);
        if (index < count) return true;
        index -= count;
        return false;
    };
    for (const Json& element : elements_of(json))
        if (within(element)) return value_at(element, index);
    for (const auto& [name, value] : members_of(json))
        if (within(value)) return value_at(value, index);
    return json;
}

/// How one value changes: it is replaced, left out, or duplicated (in an object, under a different key).
struct Change {
    enum Kind { Replace, LeaveOut, Double } kind;
    std::size_t index;
    const Json& replacement;
    const std::string& name;
};

Json changed(const Json& json, const Change& change, std::size_t& at) {
    if (at++ == change.index && change.kind == Change::Replace) return change.replacement;
    if (json.is_array()) {
        Json::array_t elements;
        for (const Json& element : elements_of(json)) {
            const bool here = at == change.index;
            Json next = changed(element, change, at);
            if (here && change.kind == Change::Double) elements.push_back(next);
            if (!here || change.kind != Change::LeaveOut) elements.push_back(std::move(next));
        }
        return Json(std::move(elements));
    }
    if (!json.is_object()) return json;
    Json members = Json::object();
    for (const auto& [name, value] : members_of(json)) {
        const bool here = at == change.index;
        Json next = changed(value, change, at);
        if (here && change.kind == Change::Double) members[change.name] = next;
        if (!here || change.kind != Change::LeaveOut) members[name] = std::move(next);
    }
    return members;
}

}  // namespace

Json random_leaf(std::mt19937& random) {
    switch (below(random, 8)) {
    case 0:
        return below(random, 2) == 0;
    case 1:
        return words()[below(random, words().size())];
    case 2:
        return below(random, 2) == 0 ? Json::array() : Json::object();
    case 3:
        return Json();
    case 4: {
        Json vector = Json::array();
        for (std::size_t i = 2 + below(random, 3); i > 0; --i) vector.push_back(random_number(random));
        return vector;
    }
    default:
        return random_number(random);
    }
}

std::string with_changed_json(std::string_view text, std::mt19937& random) {
    const Json json = json_or_null(text);
    if (json.is_null()) return std::string(text);
    const std::size_t count = count_of(json);
    const Json other = below(random, 3) == 0 ? value_at(json, below(random, count)) : random_leaf(random);
    const std::string name = words()[below(random, words().size())];
    constexpr Change::Kind kinds[] = {Change::Replace, Change::Replace, Change::LeaveOut, Change::Double};
    std::size_t at = 0;
    return json_line(
        changed(json, {kinds[below(random, std::size(kinds))], below(random, count), other, name}, at));
}

std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
    std::mt19937 random(seed);
    if (below(random, 2) == 0) return LLVMFuzzerMutate(data, size, max_size);
    const std::string changed = with_changed_json(text_of(data, size), random);
    if (changed.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
    return put(changed, data, max_size);
}

}  // namespace glint::fuzz
