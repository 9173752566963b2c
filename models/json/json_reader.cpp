#include "models/json/json_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <vector>

#include "models/io/utf8.h"
#include "models/progress.h"

namespace glint {
namespace {

/// An iterator that reports how far it has read: the library tells its listener what it met, but not where.
struct CountingIterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at = nullptr;
    const char** reached = nullptr;

    reference operator*() const { return *at; }
    CountingIterator& operator++() {
        *reached = ++at;
        return *this;
    }
    bool operator==(const CountingIterator& o) const { return at == o.at; }
};

/// The most bytes of a string of JSON text, as it is written.
std::size_t longest_string(std::string_view text) {
    std::size_t longest = 0, begin = 0;
    bool is_inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_inside) longest = std::max(longest, i - begin);
        if (text[i] == '\\' && is_inside) {
            ++i;
        } else if (text[i] == '"') {
            is_inside = !is_inside;
            begin = i + 1;
        }
    }
    return longest;
}

/// Builds the document from the parser's events and refuses what a scene file must not have. The names of the
/// events are the library's.
class Builder {
  public:
    Builder(std::string_view text, const std::string& file)
        : text_(text), file_(file), reached_(text.data()), parsed_(text.size()) {
        // The library keeps the string that it reads twice, and a list that grows is there twice for a while.
        string_being_read_ = 3 * longest_string(text);
        reckon();
    }

    Json take() && { return std::move(root_); }
    MemoryShare take_share() {
        string_being_read_ = 0;
        reckon();
        return std::move(share_);
    }
    [[nodiscard]] CountingIterator begin() { return {text_.data(), &reached_}; }
    [[nodiscard]] CountingIterator end() { return {text_.data() + text_.size(), &reached_}; }

    bool null() { return value(nullptr); }
    bool boolean(bool b) { return value(b); }
    bool number_integer(std::int64_t n) { return number(n); }
    bool number_unsigned(std::uint64_t n) { return number(n); }
    bool number_float(double n, const std::string&) { return number(n); }
    bool string(std::string& s) { return value(std::move(s)); }
    bool binary(Json::binary_t&) { return false; }  // not in JSON text

    bool start_object(std::size_t) { return open(Json::object(), JsonEvent::OpenedObject); }
    bool start_array(std::size_t) { return open(Json::array(), JsonEvent::OpenedArray); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        understood(JsonEvent::Value);
        if (open_.back()->contains(name))
            fail({"", "", fmt::format("the key {} stands twice", in_quotes(name)), "it once"});
        key_ = name;
        understood(JsonEvent::Key);
        return true;
    }

    bool parse_error(std::size_t, const std::string& token, const Json::exception& error) {
        constexpr int number_overflow = 406;  // its documented id
        if (error.id == number_overflow)
            fail({"", "", shortened(token) + " is out of range", "a number within -1e30 and 1e30"});
        const JsonContainer container = open_.empty()               ? JsonContainer::None
                                        : open_.back()->is_object() ? JsonContainer::Object
                                                                    : JsonContainer::Array;
        Problem problem = syntax_problem({text_, understood_, place(), last_, container});
        problem.file = file_;
        throw ProblemFound{std::move(problem), true};
    }

  private:
    [[nodiscard]] std::size_t place() const { return static_cast<std::size_t>(reached_ - text_.data()); }

    /// Takes the share of the text and of what has been made of it. Throws Refused.
    void reckon() {
        constexpr std::uint64_t bytes_a_value =
            96;  // of a member with its key, or of an empty object, at most
        share_.set(memory_need(MemoryUse::Files,
                               text_.size() + place() + string_being_read_ + bytes_a_value * count_));
        reckoned_ = place();
    }

    void understood(JsonEvent event) {
        last_ = event;
        understood_ = place();
    }

    /// The value belongs to the key that was read last, to the end of the innermost array, or is the root.
    Json& put(Json v) {
        if (++count_ > max_json_values)
            fail({"", "", "too many values", fmt::format("at most {} in a scene", max_json_values)});
        if (count_ % 1024 == 0 || place() > reckoned_ + (1 << 20)) reckon();
        parsed_.at(place());
        understood(JsonEvent::Value);
        if (open_.empty()) return root_ = std::move(v);
        Json& into = *open_.back();
        if (into.is_object()) return into[key_] = std::move(v);
        into.push_back(std::move(v));
        return into.back();
    }
    bool value(Json v) {
        put(std::move(v));
        return true;
    }
    template <class Number> bool number(Number n) {
        put(n);
        // The parser knows the end of a number by the character after it, which it has read too, unless the
        // text ended. Only after a 0, as in 01, can that character be a digit.
        const bool digit = std::isdigit(static_cast<unsigned char>(reached_[-1])) != 0;
        const bool after_zero = std::is_integral_v<Number> && n == 0 && place() > 1 && reached_[-2] == '0';
        if (!digit || after_zero) --understood_;
        return true;
    }
    bool open(Json&& container, JsonEvent event) {
        if (open_.size() == max_json_depth)
            fail({"", "", "nested too deep", fmt::format("at most {} deep", max_json_depth)});
        const bool in_object = !open_.empty() && open_.back()->is_object();
        Json& made =
            put(std::move(container));  // before anything is put into it, so that it stays where it is
        // In an array, key_ was read long ago and may be as long as the text: it is not copied.
        open_keys_.push_back(in_object ? key_ : std::string());
        open_.push_back(&made);
        understood(event);
        return true;
    }
    bool close() {
        open_.pop_back();
        open_keys_.pop_back();
        understood(JsonEvent::Value);
        return true;
    }

    [[nodiscard]] std::string pointer() const {
        std::string text;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const bool last = i + 1 == open_.size();
            if (open_[i]->is_array())
                text += fmt::format("/{}", last ? open_[i]->size() : open_[i]->size() - 1);
            else if (!last || last_ == JsonEvent::Key)
                text.append("/").append(escaped_token(last ? key_ : open_keys_[i + 1]));
        }
        return text;
    }
    [[noreturn]] void fail(Problem problem) const {
        problem.file = file_;
        problem.pointer = pointer();
        problem.line = line_of(text_, place() == 0 ? 0 : place() - 1);
        throw ProblemFound{std::move(problem)};
    }

    std::string_view text_;
    const std::string& file_;
    const char* reached_;
    ParsedBytes parsed_;
    MemoryShare share_;
    std::uint64_t string_being_read_ = 0;  // bytes that reading one takes, of the longest
    std::size_t reckoned_ = 0;             // the place in the text when the share was set last
    Json root_;
    TakenApart root_taken_apart_{root_};
    std::vector<Json*> open_;             // containers around the place, outermost first
    std::vector<std::string> open_keys_;  // the key under which each stands; unused in arrays
    std::string key_;
    JsonEvent last_ = JsonEvent::Nothing;
    std::size_t understood_ = 0;  // where what was understood last ends
    std::size_t count_ = 0;
};

}  // namespace

Json read_json(std::string_view text, const std::string& file, MemoryShare* share) {
    if (text.size() > max_json_bytes)
        throw ProblemFound{{file, "", fmt::format("{} bytes of text", text.size()), "at most 64 MiB"}};
    if (const std::size_t bad = first_invalid_utf8(text); bad < text.size()) {
        const auto byte = static_cast<unsigned char>(text[bad]);
        throw ProblemFound{{file, "", fmt::format("the byte 0x{:02x} is not UTF-8", byte), "UTF-8 text",
                            line_of(text, bad)}};
    }
    text = without_byte_order_mark(text);
    if (text.starts_with(byte_order_mark))  // the library would pass over this one
        throw ProblemFound{{file, "", "a second byte-order mark", "at most one before the text", 1}};
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)  // its end to the library
        throw ProblemFound{
            {file, "", "the byte 0x00", "text without it, which JSON never has", line_of(text, zero)}};
    try {
        Builder builder(text, file);
        Json::sax_parse(builder.begin(), builder.end(), &builder);  // what is wrong is thrown
        if (share != nullptr) *share = builder.take_share();
        return std::move(builder).take();
    } catch (const LoadCancelled&) {
        throw ProblemFound{{file, "", cancelled_words, ""}};
    } catch (const Refused& refused) {
        throw ProblemFound{memory_problem(refused, file)};
    }
}

void take_apart(Json& document) noexcept {  // NOLINT(bugprone-exception-escape)
    if (!document.is_structured()) return;
    for (Json& inner : document) take_apart(inner);
    document.clear();
}

void copy_json(const Json& from, Json& to) {
    if (from.is_object()) {
        to = Json::object();
        for (auto member = from.begin(); member != from.end(); ++member)
            copy_json(member.value(), to[member.key()]);
    } else if (from.is_array()) {
        to = Json::array();
        for (const Json& element : from) {
            to.push_back(nullptr);
            copy_json(element, to.back());
        }
    } else {
        to = from;
    }
}

std::string escaped_token(std::string_view token) {
    std::string text;
    for (const char c : token) {
        if (c == '~') text += "~0";
        if (c == '/') text += "~1";
        if (c != '~' && c != '/') text += c;
    }
    return text;
}

std::string shortened(std::string_view text, std::size_t most) {
    const std::string_view kept = first_characters(text, most);
    return std::string(kept) + (kept.size() < text.size() ? "…" : "");
}

std::string in_quotes(std::string_view text) { return fmt::format("\"{}\"", shortened(text)); }

}  // namespace glint
