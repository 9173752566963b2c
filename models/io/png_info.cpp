#include "models/io/png_info.h"

#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <new>
#include <optional>

#include "models/io/file.h"
#include "models/memory_limit.h"

namespace glint {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t max_png_bytes = std::size_t{4} << 30;  // 16384 x 16384 incompressible pixels
constexpr int max_texts = 8;  // each text in a short file may inflate to `max_bytes`

struct PngFault {};
struct ChunkTooLarge {};

/// Reads chunks out of `bytes`, which must outlive it. Throws PngFault, ChunkTooLarge and std::bad_alloc.
class ChunkReader {
  public:
    ChunkReader(std::string_view bytes, std::size_t max_bytes)
        : rest_(bytes), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, warn)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, &rest_, take);
        constexpr std::size_t around_text = 256;  // bytes: keyword, language tags and terminators
        png_set_chunk_malloc_max(png_, max_bytes + around_text);
        png_set_chunk_cache_max(png_, max_texts + 2);
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_AS_DEFAULT,
                                    reinterpret_cast<png_const_bytep>("iTXt"), 1);
    }
    ~ChunkReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    ChunkReader(const ChunkReader&) = delete;
    ChunkReader& operator=(const ChunkReader&) = delete;

    void read_before_pixels() { png_read_info(png_, info_); }
    /// Skips the pixels. libpng requires that reading them has begun.
    void read_to_end() {
        png_start_read_image(png_);
        png_read_end(png_, info_);
    }

    [[nodiscard]] PngInfo info() const {
        PngInfo result{png_get_image_width(png_, info_), png_get_image_height(png_, info_), {}};
        png_textp texts = nullptr;
        const int count = png_get_text(png_, info_, &texts, nullptr);
        for (int i = 0; i < count; ++i)
            result.texts.emplace_back(texts[i].key, std::string(texts[i].text, texts[i].itxt_length));
        return result;
    }
    /// Whether a text was skipped because it was damaged or exceeded a limit.
    [[nodiscard]] bool has_bad_text() const { return has_bad_text_; }

  private:
    [[noreturn]] static void fail(png_structp, png_const_charp) { throw PngFault{}; }
    static void warn(png_structp png, png_const_charp warning) {
        // libpng 1.6.39 warns about a chunk above the limit, and then allocates the length that it claims.
        if (std::string_view(warning).ends_with("chunk data is too large")) throw ChunkTooLarge{};
        auto& reader = *static_cast<ChunkReader*>(png_get_error_ptr(png));
        reader.has_bad_text_ |= std::string_view(warning).starts_with("iTXt");
    }
    static void take(png_structp png, png_bytep data, std::size_t size) {
        auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
        if (size > rest.size()) throw PngFault{};
        rest.copy(reinterpret_cast<char*>(data), size);
        rest.remove_prefix(size);
    }

    std::string_view rest_;
    png_structp png_;
    png_infop info_ = nullptr;
    bool has_bad_text_ = false;
};

std::optional<Problem> why_no_png(std::string_view bytes, const std::string& file) {
    if (bytes.starts_with(signature)) return {};
    return Problem{file, "", "is not a PNG picture", "one that Glint wrote"};
}

}  // namespace

const std::string* PngInfo::text(std::string_view keyword) const {
    const auto found =
        std::find_if(texts.begin(), texts.end(), [&](const auto& text) { return text.first == keyword; });
    return found == texts.end() ? nullptr : &found->second;
}

Result<PngInfo> png_info(std::string_view bytes, std::string_view keyword, std::size_t max_bytes,
                         const std::string& file) {
    if (auto no_png = why_no_png(bytes, file)) return *no_png;
    const Problem bad_text{file, "", "the scene in the picture is damaged or too long",
                           fmt::format("at most {} bytes", max_bytes)};
    try {
        ChunkReader reader(bytes, max_bytes);
        reader.read_before_pixels();
        PngInfo info = reader.info();
        if (info.text(keyword) == nullptr) {
            reader.read_to_end();
            info = reader.info();
        }
        const std::string* const text = info.text(keyword);
        if (text != nullptr && text->size() <= max_bytes) return info;
        if (text == nullptr && !reader.has_bad_text())
            return Problem{file, "", "the picture contains no scene", "a PNG that Glint wrote"};
        return bad_text;
    } catch (const ChunkTooLarge&) {
        return bad_text;
    } catch (const PngFault&) {
        return Problem{file, "", "the picture is damaged or truncated", "a PNG that Glint wrote"};
    }
}

Result<PngInfo> read_png_info(const std::string& path, std::string_view keyword, std::size_t max_bytes) {
    const auto check = [&path](const FileBlock& block) -> std::optional<Problem> {
        return block.at > 0 ? std::nullopt : why_no_png(block.bytes, path);
    };
    const Result<std::string> bytes = read_file(path, max_png_bytes, check);
    if (const Problem* problem = problem_of(bytes)) return *problem;
    return png_info(std::get<std::string>(bytes), keyword, max_bytes, path);
}

}  // namespace glint
