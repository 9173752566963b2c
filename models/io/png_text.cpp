#include "models/io/png_text.h"

#include <fmt/core.h>
#include <zlib.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include "models/memory_limit.h"

namespace glint {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t frame_bytes = 12;  // of a chunk around its data: length, type, checksum

std::uint32_t big_endian(std::string_view four) {
    std::uint32_t number = 0;
    for (const char c : four.substr(0, 4)) number = number << 8 | static_cast<unsigned char>(c);
    return number;
}

struct Chunk {
    std::string_view type, data;
};

/// Takes the first chunk off `rest`; nothing when it is cut off or its checksum is wrong.
std::optional<Chunk> take_chunk(std::string_view& rest) {
    if (rest.size() < frame_bytes) return std::nullopt;
    const std::size_t length = big_endian(rest);
    if (length > rest.size() - frame_bytes) return std::nullopt;
    const std::string_view checked = rest.substr(4, 4 + length);  // type and data
    const auto* bytes = reinterpret_cast<const Bytef*>(checked.data());
    if (crc32_z(0, bytes, checked.size()) != big_endian(rest.substr(8 + length))) return std::nullopt;
    rest.remove_prefix(frame_bytes + length);
    return Chunk{checked.substr(0, 4), checked.substr(4)};
}

/// Inflates `deflated`; nothing when it is damaged or its text is longer than `max_bytes`. A few bytes can
/// inflate to a thousand times as many, so memory is taken only as text arrives. Throws Refused.
std::optional<std::string> inflated(std::string_view deflated, std::size_t max_bytes) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return std::nullopt;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(deflated.data()));  // zlib only reads it
    stream.avail_in = static_cast<uInt>(deflated.size());
    const std::unique_ptr<z_stream, int (*)(z_stream*)> owner(&stream, inflateEnd);
    std::string text;
    MemoryShare share;
    std::array<Bytef, 1 << 14> block{};
    int status = Z_OK;
    while (status == Z_OK && text.size() <= max_bytes) {
        stream.next_out = block.data();
        stream.avail_out = static_cast<uInt>(block.size());
        status = inflate(&stream, Z_NO_FLUSH);
        const std::string_view more(reinterpret_cast<const char*>(block.data()),
                                    block.size() - stream.avail_out);
        if (more.size() > text.capacity() - text.size()) {
            const std::size_t room = 2 * (text.size() + more.size());
            share.set(memory_need(MemoryUse::Files, text.capacity() + room));  // both, while it moves
            text.reserve(room);
        }
        text.append(more);
    }
    if (status != Z_STREAM_END || text.size() > max_bytes) return std::nullopt;
    return text;
}

/// The part of `rest` before the next zero byte, which is taken off with it.
std::string_view take_field(std::string_view& rest) {
    const std::size_t end = std::min(rest.find('\0'), rest.size());
    const std::string_view field = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return field;
}

}  // namespace

std::optional<Problem> why_no_png(std::string_view bytes, const std::string& file) {
    if (bytes.starts_with(signature)) return {};
    return Problem{file, "", "is not a PNG picture", "one that Glint wrote"};
}

Result<std::string> png_text(std::string_view bytes, std::string_view keyword, std::size_t max_bytes,
                             const std::string& file) {
    const auto problem = [&file](std::string what, std::string expected) {
        return Problem{file, "", std::move(what), std::move(expected)};
    };
    if (auto no_png = why_no_png(bytes, file)) return *no_png;
    bytes.remove_prefix(signature.size());
    while (const std::optional<Chunk> chunk = take_chunk(bytes)) {
        if (chunk->type == "IEND") return problem("the picture carries no scene", "a PNG that Glint wrote");
        std::string_view rest = chunk->data;
        if (chunk->type != "iTXt" || take_field(rest) != keyword || rest.size() < 2) continue;
        const bool compressed = rest[0] == 1;
        rest.remove_prefix(2);   // compression flag and method
        (void)take_field(rest);  // language
        (void)take_field(rest);  // translated keyword
        if (!compressed && rest.size() <= max_bytes) return std::string(rest);
        if (std::optional<std::string> text = compressed ? inflated(rest, max_bytes) : std::nullopt)
            return *text;
        return problem("the scene in the picture is damaged or too long",
                       fmt::format("at most {} bytes", max_bytes));
    }
    return problem("the picture is damaged or cut off", "a PNG that Glint wrote");
}

bool has_png_text(const std::string& path, std::string_view keyword) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(path, failed)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string begin(signature.size(), ' ');
    if (!file.read(begin.data(), std::ssize(begin)) || begin != signature) return false;
    const std::size_t named = 8 + keyword.size() + 1;  // length, type, the keyword and the zero after it
    for (std::string head(named, ' '); file.read(head.data(), std::ssize(head));) {
        const std::string_view chunk(head);
        if (chunk.substr(4, 4) == "iTXt" && chunk.substr(8, keyword.size()) == keyword && head.back() == '\0')
            return true;
        file.seekg(std::streamoff{big_endian(chunk)} + std::streamoff{frame_bytes} - std::ssize(head),
                   std::ios::cur);
    }
    return false;
}

}  // namespace glint
