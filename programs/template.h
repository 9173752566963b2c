#pragma once
// The templates are programs: texts that contain all variants, each marked by a directive that is a comment
// in their language (`//@...`, in Python `#@...`), alone on its line.
//
//   //@if COND, //@else, //@end   a condition on flags: `a`, `!a`, `a&b`, `a|b` (& binds tighter than |)
//   //@can FLAG...                features that need no separate text
//   //@calls NAME                 from here on the lines are calls with that name, which gl_calls.h reads;
//                                 `//@calls` alone ends them
//   @name@                        a value; alone on its line it may expand to several lines
//
// If a condition names an active mistake (`wrong.NAME`), a comment on the line before it describes the
// mistake.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace glint {

using Flags = std::set<std::string, std::less<>>;
using Values = std::map<std::string, std::string, std::less<>>;

/// All flags that a text mentions: the features that it supports.
[[nodiscard]] Flags mentioned_flags(std::string_view text);

/// The unchanged lines between `//@calls name` and the next `//@calls`. Precondition: they exist, and the
/// conditions in them are balanced (a test reads each).
[[nodiscard]] std::string_view lines_of_calls(std::string_view text, std::string_view name);

/// The comment for an active mistake, without the comment marker.
[[nodiscard]] std::string mistake_comment(std::string_view name);

/// Returns the lines of the text whose conditions hold, with values filled in. Precondition: directives are
/// balanced and every value is given (a test fills each text).
[[nodiscard]] std::string filled(std::string_view text, const Flags& on, const Values& values);

}  // namespace glint
