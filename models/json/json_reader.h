#pragma once
// JSON text -> nlohmann::json, strictly: comments, repeated keys, invalid UTF-8 and hostile sizes are
// problems with the line they stand in, said in our words. Source: RFC 8259; docs/interface.md, "The scene
// file". Only models/ includes nlohmann (tests/architecture holds that); all others use json_value.h.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "models/memory_limit.h"
#include "models/problem.h"

namespace glint {

using Json = nlohmann::json;

/// Thrown while a document is read, and caught before any public function of models returns.
struct ProblemFound {
    Problem problem;
    bool is_syntax = false;  // the text is not JSON
};

inline constexpr std::size_t max_json_bytes = std::size_t{64} << 20;
inline constexpr std::size_t max_json_depth = 64;  // objects and arrays inside each other
/// No valid scene comes near it (10,000 objects of 40 values, 4096 lights of 50), and a text of nothing but
/// `[]` would take twenty times its size in memory.
inline constexpr std::size_t max_json_values = 2'000'000;

/// Returns the document; a leading byte-order mark is passed over. Throws ProblemFound with `file`, the line
/// and, where there is one, the pointer. `share` is given the share of the text and of the document, for a
/// caller that keeps both.
[[nodiscard]] Json read_json(std::string_view text, const std::string& file, MemoryShare* share = nullptr);

/// Empties a document from the inside out. The library's destructor allocates memory for arrays and objects
/// that are not empty, and ends the program where there is none.
void take_apart(Json& document) noexcept;  // NOLINT(bugprone-exception-escape): only a scalar's throws

/// Takes a document apart in its destructor, which must run before the document's own.
class TakenApart {
  public:
    explicit TakenApart(Json& document) : document_(document) {}
    ~TakenApart() { take_apart(document_); }  // NOLINT(bugprone-exception-escape)
    TakenApart(const TakenApart&) = delete;
    TakenApart& operator=(const TakenApart&) = delete;

  private:
    Json& document_;
};

/// Copies `from` into `to`, which is null. Where memory runs out half-way, the library's own copy would end
/// the program: it destroys what it has copied, and for that it allocates (take_apart).
void copy_json(const Json& from, Json& to);

/// A reference token as it stands in a JSON pointer: ~ as ~0, / as ~1 (RFC 6901, section 3).
[[nodiscard]] std::string escaped_token(std::string_view token);

/// Returns the text cut to so many characters, with an ellipsis where it is cut: a value inside a message.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most = 40);
/// shortened(text) in double quotes.
[[nodiscard]] std::string in_quotes(std::string_view text);

// json_syntax.cpp says in our words what is wrong with JSON text at the place where a parser stopped.

/// What a parser understood last.
enum class JsonEvent { Nothing, Key, Value, OpenedObject, OpenedArray };
enum class JsonContainer { None, Object, Array };

/// Where a parser stopped.
struct JsonStop {
    std::string_view text;
    std::size_t understood = 0;  // end of what it understood last
    std::size_t reached = 0;     // end of what it looked at
    JsonEvent last = JsonEvent::Nothing;
    JsonContainer container = JsonContainer::None;  // around the place
};

/// Line (from 1), what is wrong and what was expected; the file is left empty.
[[nodiscard]] Problem syntax_problem(const JsonStop& stop);

/// Line of the byte at `place`, from 1.
[[nodiscard]] int line_of(std::string_view text, std::size_t place);

}  // namespace glint
