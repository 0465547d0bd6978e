// SPDX-License-Identifier: Apache-2.0
// The basis families of one device, by name, and the candidates that were refused.
#pragma once

#include <atomic>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "awd/basis.h"
#include "awd/device.h"
#include "util/context.h"
#include "util/error.h"

namespace awd {

class Module;

class Registry {
 public:
  /// folders: absolute, searched first and in this order.
  Registry(Context& context, std::vector<std::string> folders, bool ignoreEnvironment);
  ~Registry();

  bool ignoresEnvironment() const { return ignoreEnvironment_; }

  /// The family of that name; looks for modules when there is none and that has not been done.
  /// AWD_ERROR_UNSUPPORTED with the names there are, the paths tried and the candidates refused if
  /// there is none.
  const AWDBasisFamily& find(const char* name);

  /// Loads one module file; everything it offers, or nothing. A file that is in use already is
  /// no error.
  void load(const char* absolutePath);
  /// Registers a table in memory; everything it offers, or nothing. One that is in use already is
  /// no error.
  void add(const AWDBasisModule& module);

  std::size_t count();
  /// Sorted: families by name, then refused candidates by file.
  AWDBasisInfo info(std::size_t index);

 private:
  /// A family or a refused candidate. Never changes or moves: its texts are the host's to read.
  struct Entry {
    std::string name, summary, file, message;
    AWDResult status = AWD_SUCCESS;
    AWDBasisFamily family = {};
  };
  using Entries = std::vector<std::unique_ptr<Entry>>;
  struct Folder {
    std::string path;
    std::string note;  ///< why nothing could be found there; "" if it was read
  };

  /// A family of a module that was found but has not been asked for. To test them all at once
  /// would let every host wait for families that it has no use for.
  struct Candidate {
    std::string name, file;
    const AWDBasisFamily* family;
    std::shared_ptr<Module> module;
  };

  void search();
  Folder searchFolder(const std::string& path);
  void searchFile(const std::string& file);
  /// Opens a module or lists the file as refused and throws.
  std::unique_ptr<Module> open(const std::string& file);
  /// A visible family or a refused candidate, by its name and by the self-test.
  std::unique_ptr<Entry> judge(const AWDBasisFamily& family, const std::string& file,
                               const Entries& besides) const;
  /// All families of a module; if one is refused it is listed, and this throws.
  Entries judgeWhole(const AWDBasisModule& module, const std::string& file);
  /// Judges candidates of a name, or all, in the order in which they were found: the first good
  /// one wins. One bad family does not take the others of its module with it, since nobody waits
  /// for a verdict on the whole.
  void settle(const std::string& name);
  void settleAll();
  void settle(const Candidate& candidate);
  /// Makes families of a module visible, all or none.
  void accept(Entries entries, const AWDBasisModule& module);
  /// Lists what was refused, once.
  const Entry* refuse(std::unique_ptr<Entry> entry);
  const Entry* refuse(const std::string& file, const Error& reason);
  void warn(const Entry& refused);
  const Entry* visible(const std::string& name) const;
  bool inUse(const AWDBasisModule& module) const;
  /// How messages name where a family comes from.
  static std::string placeOf(const Entry& entry);
  /// All that helps whoever asked for a family that is not there.
  std::string missing(const char* name) const;
  /// Sends what there is to say to the host, with no lock held.
  void flushLog();

  Context& context_;
  const std::vector<std::string> given_;
  const bool ignoreEnvironment_;

  /// A mutex that fails instead of waiting for itself: when a function of a basis module, which is
  /// called by the self-test, calls the library. A thread does not leave while it has it.
  class Mutex {
   public:
    void lock();
    void unlock() noexcept;

   private:
    std::mutex mutex_;
    int cancelState_ = 0;
    std::atomic<std::thread::id> owner_{};
  };
  Mutex mutex_;  // guards all below; never held while the host is called
  bool searched_ = false;
  std::vector<Folder> folders_;                 // that were searched
  std::vector<Candidate> candidates_;           // as they were found
  Entries families_;                            // by name
  Entries refused_;                             // by file, then by name
  std::vector<const AWDBasisModule*> modules_;  // with families in use
  std::vector<std::string> log_;                // warnings
};

}  // namespace awd
