#pragma once
// In-memory streams for the OpenEXR library. Internal to renderer/image.

#include <ImfIO.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace glint {

/// An input stream over bytes, which must outlive it.
class ExrSource : public Imf::IStream {
  public:
    explicit ExrSource(const std::string& bytes) : IStream("picture"), bytes_(bytes) {}
    bool read(char c[], int n) override {
        const auto size = static_cast<std::size_t>(n);
        if (size > bytes_.size() - std::min(at_, bytes_.size())) throw std::runtime_error("ends too early");
        std::memcpy(c, bytes_.data() + at_, size);
        at_ += size;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

  private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

/// An output stream that writes to `bytes`.
class ExrSink : public Imf::OStream {
  public:
    ExrSink() : OStream("picture") {}
    void write(const char c[], int n) override {
        const auto size = static_cast<std::size_t>(n);
        if (at_ + size > bytes.size()) bytes.resize(at_ + size);
        bytes.replace(at_, size, c, size);
        at_ += size;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t position) override { at_ = position; }

    std::string bytes;

  private:
    std::size_t at_ = 0;
};

}  // namespace glint
