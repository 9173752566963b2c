#pragma once
// Programs are written from programs: texts that hold all variants, each marked by a directive that is a
// comment of their language (`//@...`, in Python `#@...`), alone on its line.
//
//   //@if COND, //@else, //@end   a condition of flags: `a`, `!a`, `a&b`, `a|b` (first all |, of these all &)
//   //@can FLAG...                what needs no text of its own
//   //@calls NAME                 from here on the lines are calls of that name, which gl_calls.h reads;
//                                 `//@calls` alone ends them
//   @name@                        a value; alone on its line it may have several lines
//
// Where a condition names a mistake (`wrong.NAME`) that is on, the line before it says so as a comment.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace glint {

using Flags = std::set<std::string, std::less<>>;
using Values = std::map<std::string, std::string, std::less<>>;

/// All flags that a text mentions: what it cannot do is what it does not mention.
[[nodiscard]] Flags mentioned_flags(std::string_view text);

/// The lines between `//@calls name` and the next `//@calls`, as they are. Precondition: there are such, and
/// conditions are balanced in them (a test reads each).
[[nodiscard]] std::string_view lines_of_calls(std::string_view text, std::string_view name);

/// The comment for a mistake that is on, without the sign that begins a comment.
[[nodiscard]] std::string mistake_comment(std::string_view name);

/// Returns the lines of the text whose conditions hold, with its values filled in. Precondition: directives
/// are balanced and every value is given (a test fills each text).
[[nodiscard]] std::string filled(std::string_view text, const Flags& on, const Values& values);

}  // namespace glint
