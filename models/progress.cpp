#include "models/progress.h"

namespace glint {
namespace {

thread_local LoadProgress* listening = nullptr;
thread_local bool is_part = false;

}  // namespace

ProgressScope::ProgressScope(LoadProgress& progress) { listening = &progress; }
ProgressScope::~ProgressScope() { listening = nullptr; }

PartOfProgress::PartOfProgress() { is_part = true; }
PartOfProgress::~PartOfProgress() { is_part = false; }

bool report_progress(LoadStage stage, std::uint64_t done, std::uint64_t total) {
    if (listening == nullptr) return true;
    if (!is_part) {
        listening->stage = stage;
        listening->done = done;
        listening->total = total;
    }
    return !listening->cancelled;
}

bool load_cancelled() { return listening != nullptr && listening->cancelled; }

const std::atomic<bool>* load_cancellation() {
    return listening != nullptr ? &listening->cancelled : nullptr;
}

void report_or_leave(LoadStage stage, std::uint64_t done, std::uint64_t total) {
    if (!report_progress(stage, done, total)) throw LoadCancelled();
}

void ParsedBytes::report(std::size_t done) {
    next_ = done + between_reports;
    report_or_leave(LoadStage::Parsing, done, total_);
}

}  // namespace glint
