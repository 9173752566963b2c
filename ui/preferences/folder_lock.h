#pragma once
// One window at a time: what several windows read, change and write in the folder that they share.

#include <string>

namespace glint {

/// The right to a folder among those who ask for it this way, held until this is destroyed. Never waits.
class FolderLock {
  public:
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// False while another holds it: then ask again later. True where the file system has no locks at all.
    [[nodiscard]] bool held() const { return held_; }

  private:
    int descriptor_ = -1;
    bool held_ = true;
};

}  // namespace glint
