#pragma once
// The file that is written beside a target and then takes its place: `.glint-PID-N.tmp`. Whatever ends the
// process, no such file stays for long: its own destructor removes it, a signal's handler does, and what a
// killed process has left is removed by the next one that writes in the same directory.

#include <signal.h>
#include <sys/types.h>

#include <string>

namespace glint {

/// A new file, locked (flock) while it is held, so that other processes can tell it from one that was left.
class Temporary {
  public:
    /// Makes it in the directory of `target`, empty and open for writing. `mode` as for open(): the umask is
    /// taken off. Also removes, once for each directory, what killed processes of this user have left there.
    Temporary(const std::string& target, mode_t mode);
    /// Removes the file unless it has been put in place.
    ~Temporary();
    Temporary(Temporary&& other) noexcept;
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    Temporary& operator=(Temporary&&) = delete;

    /// 0, or the errno that kept it from being made.
    [[nodiscard]] int error() const { return error_; }
    [[nodiscard]] int descriptor() const { return descriptor_; }
    [[nodiscard]] const std::string& path() const { return path_; }

    /// Ends the writing; it stays locked. 0, or the errno of closing: some file systems report a full disk
    /// only here.
    int close();
    /// Renames it to `target`. 0, or an errno.
    int put_in_place(const std::string& target);
    /// Does so, but keeps the file that was there until the end of this object: take_back() brings it back.
    /// On a file system that cannot exchange two files the old one is gone.
    int change_places(const std::string& target);
    void take_back(const std::string& target);

  private:
    bool make(const std::string& path, mode_t mode);

    std::string path_;
    int descriptor_ = -1, lock_ = -1, error_ = 0;
    int slot_ = -1;          // where the signal handler finds it; -1 when there was no room
    bool is_there_ = false;  // the file, or the one that it has changed places with, under its own name
    enum class Change { None, Exchanged, Alone } change_ = Change::None;  // Alone: nothing was there
};

/// A directory that is made, and that goes again unless it is kept: by its own destructor or by a signal's
/// handler, where it is empty.
class NewDirectory {
  public:
    explicit NewDirectory(const std::string& path);
    ~NewDirectory();
    NewDirectory(const NewDirectory&) = delete;
    NewDirectory& operator=(const NewDirectory&) = delete;

    /// 0, or the errno that kept it from being made.
    [[nodiscard]] int error() const { return error_; }
    void keep();

  private:
    std::string path_;
    int slot_ = -1, error_ = 0;
    bool goes_ = false;
};

/// The right to a directory among those who ask for it this way (flock), held until this is destroyed.
class FolderLock {
  public:
    /// Waits at most `patience` seconds for another that holds it.
    explicit FolderLock(const std::string& folder, double patience = 0);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// False while another holds it: then ask again later. True where the file system has no locks at all.
    [[nodiscard]] bool held() const { return held_; }

  private:
    int descriptor_ = -1;
    bool held_ = true;
};

/// While it lives, none of the signals below ends the process: what is renamed meanwhile is renamed as a
/// whole. For a moment: after a second the process ends all the same.
class NoEndBetween {
  public:
    NoEndBetween();
    ~NoEndBetween();
    NoEndBetween(const NoEndBetween&) = delete;
    NoEndBetween& operator=(const NoEndBetween&) = delete;

  private:
    sigset_t before_{};
};

/// Removes every Temporary of this process, and every NewDirectory that is empty and not kept. Only for a
/// process that ends now: threads that still write wait for that. Calls nothing but async-signal-safe
/// functions.
void remove_temporaries();

/// From here on SIGHUP, SIGINT, SIGQUIT and SIGTERM remove the temporaries and then do what they do by
/// default, so that a shell is told the signal. A signal that is ignored (nohup) stays ignored.
void remove_temporaries_on_signals();

}  // namespace glint
