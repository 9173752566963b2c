#pragma once
// Shared parts of the mesh readers. Each reader converts the bytes of a file to an unfinished mesh (no
// triangles, no bounds) or throws ProblemFound.

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/mesh/mesh.h"
#include "models/numbers.h"
#include "models/problem.h"
#include "models/progress.h"

namespace glint {

// Moves through the text of a mesh file, line by line and word by word, and reports errors with their line.
// Uses no locale and does not allocate; each reader interprets the contents of the lines.

/// Lines end in LF, CR, CR LF or LF CR. Reports the load's progress: every member that moves the cursor may
/// throw LoadCancelled.
class TextCursor {
  public:
    /// `file` is for messages. With `continued`, a backslash before the end of a line joins it with the next.
    /// '#' begins a comment that ends with its line.
    TextCursor(std::string_view text, std::string file, bool continued)
        : at_(text.data()),
          begin_(at_),
          end_(at_ + text.size()),
          parsed_(text.size()),
          file_(std::move(file)),
          continued_(continued) {}

    /// Moves to the next line with a word; false if there is none.
    bool next_line() {
        if (started_) skip_rest();
        started_ = true;
        while (end_of_line()) {
            if (at_ == end_) return false;
            skip_rest();
        }
        return true;
    }

    /// True if this line has no more words.
    bool end_of_line() {
        parsed_.at(static_cast<std::size_t>(at_ - begin_));
        skip_blanks();
        return at_ == end_ || is_line_end(*at_) || *at_ == '#';
    }

    /// The next word of this line; empty at the line's end.
    std::string_view word() {
        if (end_of_line()) return {};
        const char* first = at_;
        while (at_ < end_ && !is_space(*at_)) ++at_;
        return {first, static_cast<std::size_t>(at_ - first)};
    }

    /// The next word as a finite number within +-1e7. `name` describes a missing number in messages.
    float number(std::string_view name) {
        float value = 0;
        return plain_number(name, value) ? value : unusual_number(false);
    }

    /// Like number(), but for a component of a normal: NaN if the word is an infinity or NaN, in any
    /// spelling, or a number out of range.
    float normal_number(std::string_view name) {
        float value = 0;
        return plain_number(name, value) ? value : unusual_number(true);
    }

    /// The next word as a whole number.
    std::int64_t integer(std::string_view name) {
        if (end_of_line()) fail_missing(name, "a whole number");
        std::int64_t value = 0;
        const auto [last, error] = std::from_chars(at_, end_, value);
        if (error != std::errc() || !(last == end_ || is_space(*last))) fail_integer();
        at_ = last;
        return value;
    }

    /// Reads the next three words as numbers. `names`: their names in messages.
    glm::vec3 three(const std::array<std::string_view, 3>& names = {"x", "y", "z"}) {
        const float a = number(names[0]), b = number(names[1]), c = number(names[2]);
        return {a, b, c};
    }

    /// Like three(), with an offset subtracted in double.
    glm::vec3 position(const glm::dvec3& offset) {
        glm::vec3 place;
        for (int i = 0; i < 3; ++i)
            place[i] = number_minus(offset[i], axis_names[static_cast<std::size_t>(i)]);
        return place;
    }
    float number_minus(double offset, std::string_view name) {
        if (offset == 0) return number(name);
        if (end_of_line()) fail_missing(name, "a number");
        const char* first = at_ + (*at_ == '+' ? 1 : 0);
        static_cast<void>(number(name));
        double value = 0;
        static_cast<void>(std::from_chars(first, at_, value));  // a number, or too small for a double
        return static_cast<float>(value - offset);
    }
    glm::vec3 normal(const std::array<std::string_view, 3>& names = {"x", "y", "z"}) {
        const float a = normal_number(names[0]), b = normal_number(names[1]), c = normal_number(names[2]);
        return {a, b, c};
    }

    /// Skips the given beginning of the next word. Precondition: the word starts with it.
    void skip(std::string_view beginning) { at_ += beginning.size(); }

    /// Fails unless the line has ended.
    void end_line(const char* expected) {
        if (!end_of_line()) fail_too_many(expected);
    }

    [[nodiscard]] int line() const { return line_; }

    /// Returns the remaining text.
    [[nodiscard]] std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

    [[noreturn]] void fail(std::string what, std::string expected) const {
        fail_at(line_, std::move(what), std::move(expected));
    }
    [[noreturn]] void fail_at(int line, std::string what, std::string expected) const;

  private:
    static constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};

    static bool is_space(char c) { return c == ' ' || (c <= '\r' && c >= '\t'); }
    static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

    /// Reads the next word; false, without moving, unless from_chars() reads it as a number within +-1e7.
    bool plain_number(std::string_view name, float& value) {
        if (end_of_line()) fail_missing(name, "a number");
        const char* first = at_ + (*at_ == '+' && !(end_ - at_ > 1 && at_[1] == '-') ? 1 : 0);
        const auto [last, error] = std::from_chars(first, end_, value);
        if (error != std::errc() || !(last == end_ || is_space(*last)) ||
            !(std::abs(value) <= static_cast<float>(max_number)))
            return false;
        at_ = last;
        return true;
    }

    void skip_blanks() {
        for (; at_ < end_; ++at_) {
            if (*at_ == '\\' && continued_) {
                if (!skip_continuation()) return;
            } else if (is_line_end(*at_) || !is_space(*at_)) {
                return;
            }
        }
    }
    [[nodiscard]] const char* after_line_end(const char* at) const;
    void skip_rest();
    bool skip_continuation();
    float unusual_number(bool of_normal);
    [[noreturn]] void fail_missing(std::string_view name, const char* expected) const;
    [[noreturn]] void fail_integer();
    [[noreturn]] void fail_too_many(const char* expected);

    const char* at_;
    const char* begin_;
    const char* end_;
    ParsedBytes parsed_;
    std::string file_;
    int line_ = 1;
    bool continued_;
    bool started_ = false;
};

/// Describes a word from a file in a message: a short printable word in quotes, any other word by its length.
/// A scene may name any readable file, whose other contents must not appear in a message.
[[nodiscard]] std::string quoted_word(std::string_view word);

// `offset` is subtracted from positions in double, before they become floats.
[[nodiscard]] Mesh read_obj(std::string_view bytes, const std::string& file, const glm::dvec3& offset);
[[nodiscard]] Mesh read_ply(std::string_view bytes, const std::string& file, const glm::dvec3& offset);
[[nodiscard]] Mesh read_off(std::string_view bytes, const std::string& file, const glm::dvec3& offset);
[[nodiscard]] Mesh read_stl(std::string_view bytes, const std::string& file, const glm::dvec3& offset);

inline constexpr std::size_t max_corners = std::numeric_limits<std::int32_t>::max();

/// The number in `size` bytes, 1 to 8, lowest byte first. Precondition: the bytes exist.
inline std::uint64_t little_endian(const char* at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value |= std::uint64_t{static_cast<unsigned char>(at[i])} << (8 * i);
    return value;
}
/// The float in 4 bytes, lowest byte first. Precondition: the bytes exist.
inline float little_endian_float(const char* at) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(little_endian(at, 4)));
}

// Distinguish binary STL files from text: files of both kinds may begin with "solid". A text file contains no
// zero byte, but the header of a binary file does, in its facet count.

inline constexpr std::size_t binary_stl_header = 84, binary_stl_facet = 50;  // bytes
/// True when the first word is "solid", "SOLID" or "Solid" and no byte of the header is 0.
[[nodiscard]] bool begins_as_text_stl(std::string_view bytes);
/// Returns the number of facets in the header. Precondition: the header is complete.
[[nodiscard]] std::size_t binary_stl_facets(std::string_view bytes);
/// Returns the file size that this header implies; 0 if the header is incomplete.
[[nodiscard]] std::size_t binary_stl_size(std::string_view bytes);

/// The text after "expected": "0 to 7" for eight items; `things` if there are none.
[[nodiscard]] std::string numbers_of(std::size_t count, const char* things);

/// Replaces normals that are not finite, or beyond the limit on numbers, with (0, 0, 0), which counts as no
/// normal. Adds one warning.
void drop_bad_normals(Mesh& mesh);

/// Ends the polygon formed by the most recently appended corners.
void close_face(Mesh& mesh, const std::string& file, int line = 0);

// Merges corners at exactly equal positions: for formats without indices, and for those that repeat a vertex
// for each of its normals.

/// Sets Mesh::first_at_place.
void find_places(Mesh& mesh);

/// Numbers positions in the order of their first use, with an open-addressing hash table of indices. The hash
/// is seeded with the time, so no file can make it slow; the numbers do not depend on the seed.
class Places {
  public:
    /// `expected`: the number of positions, if it is known.
    explicit Places(std::size_t expected = 0) {
        if (expected > 0) slots_.assign(std::bit_ceil(2 * (expected + 1)), no_index);
    }
    std::uint32_t index_of(glm::vec3 place, std::vector<glm::vec3>& positions) {
        place += glm::vec3(0);  // -0 is 0
        if (2 * (positions.size() + 1) > slots_.size()) grow(positions);
        std::size_t slot = hash(place) & (slots_.size() - 1);
        for (; slots_[slot] != no_index; slot = (slot + 1) & (slots_.size() - 1))
            if (positions[slots_[slot]] == place) return slots_[slot];
        slots_[slot] = static_cast<std::uint32_t>(positions.size());
        positions.push_back(place);
        return slots_[slot];
    }

  private:
    [[nodiscard]] std::size_t hash(const glm::vec3& place) const {
        std::uint64_t h = seed_;
        for (int i = 0; i < 3; ++i) {  // one step of splitmix64
            h = (h ^ std::bit_cast<std::uint32_t>(place[i])) * 0xBF58476D1CE4E5B9u;
            h = (h ^ h >> 29) * 0x94D049BB133111EBu;
            h ^= h >> 32;
        }
        return static_cast<std::size_t>(h);
    }
    void grow(const std::vector<glm::vec3>& positions) {
        const std::size_t size = std::max<std::size_t>(64, 2 * slots_.size());
        slots_.assign(size, no_index);
        for (std::uint32_t i = 0; i < positions.size(); ++i) {
            std::size_t slot = hash(positions[i]) & (slots_.size() - 1);
            while (slots_[slot] != no_index) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = i;
        }
    }

    std::vector<std::uint32_t> slots_;  // size: a power of two
    std::uint64_t seed_ =
        static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
};

}  // namespace glint
