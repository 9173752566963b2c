#include "models/io/files_read.h"

#include <mutex>
#include <set>

#include "models/io/file.h"

namespace glint {
namespace {

struct Noted {
    std::mutex mutex;
    std::set<std::string> files;  // as replaced_file() names them
};

Noted& noted() {
    static Noted all;
    return all;
}

}  // namespace

void note_read(const std::string& path) {
    const std::string replaced = replaced_file(path);
    const std::lock_guard lock(noted().mutex);
    noted().files.insert(replaced);
}

bool was_read(const std::string& path) {
    const std::string replaced = replaced_file(path);
    const std::lock_guard lock(noted().mutex);
    return !replaced.empty() && noted().files.count(replaced) > 0;
}

}  // namespace glint
