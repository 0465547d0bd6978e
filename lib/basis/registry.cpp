// SPDX-License-Identifier: Apache-2.0
#include "basis/registry.h"

#include <dirent.h>
#include <pthread.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <tuple>

#include "basis/environment_folders.h"
#include "basis/library_folder.h"
#include "basis/module.h"
#include "basis/self_test.h"
#include "basis/trust.h"

namespace awd {

namespace {

std::string nameOf(const AWDBasisFamily& family) { return printable(family.name, kLongestName); }

}  // namespace

void Registry::Mutex::lock() {
  if (owner_.load(std::memory_order_relaxed) == std::this_thread::get_id()) {
    fail(AWD_ERROR_INVALID_OPERATION,
         "called from within a basis module that the device is looking at: its functions must not "
         "call the library");
  }
  mutex_.lock();
  pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &cancelState_);
  owner_.store(std::this_thread::get_id(), std::memory_order_relaxed);
}

void Registry::Mutex::unlock() noexcept {
  owner_.store(std::thread::id(), std::memory_order_relaxed);
  const int before = cancelState_;
  mutex_.unlock();
  pthread_setcancelstate(before, nullptr);
}

Registry::Registry(Context& context, std::vector<std::string> folders, bool ignoreEnvironment)
    : context_(context), given_(std::move(folders)), ignoreEnvironment_(ignoreEnvironment) {}

Registry::~Registry() = default;

const AWDBasisFamily& Registry::find(const char* name) {
  const AWDBasisFamily* family = nullptr;
  std::string text;
  {
    const std::lock_guard<Mutex> lock(mutex_);
    const Entry* entry = visible(name);
    if (!entry) {  // one that is there wins over all that could be found
      search();
      settle(name);
      entry = visible(name);
    }
    if (entry) {
      family = &entry->family;
    } else {
      settleAll();
      text = missing(name);
    }
  }
  flushLog();
  if (!family) throw Error(AWD_ERROR_UNSUPPORTED, std::move(text));
  return *family;
}

void Registry::load(const char* absolutePath) {
  const std::lock_guard<Mutex> lock(mutex_);
  const std::unique_ptr<Module> module = open(absolutePath);
  const AWDBasisModule& table = module->table();
  for (uint32_t i = 0; i < table.familyCount; ++i) settle(nameOf(*table.families[i]));
  if (inUse(table)) return;
  accept(judgeWhole(table, absolutePath), table);
  module->keep();
}

void Registry::add(const AWDBasisModule& module) {
  const std::lock_guard<Mutex> lock(mutex_);
  try {
    checkModule(&module);
  } catch (const Error& error) {
    refuse("", error);
    throw;
  }
  for (uint32_t i = 0; i < module.familyCount; ++i) settle(nameOf(*module.families[i]));
  if (inUse(module)) return;
  accept(judgeWhole(module, ""), module);
}

std::size_t Registry::count() {
  std::size_t count = 0;
  {
    const std::lock_guard<Mutex> lock(mutex_);
    search();
    settleAll();
    count = families_.size() + refused_.size();
  }
  flushLog();
  return count;
}

AWDBasisInfo Registry::info(std::size_t index) {
  const std::size_t all = count();
  const std::lock_guard<Mutex> lock(mutex_);
  if (index >= families_.size() + refused_.size()) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "index %zu is not below the count of %zu", index, all);
  }
  const Entry& entry =
      index < families_.size() ? *families_[index] : *refused_[index - families_.size()];
  AWDBasisInfo info = AWD_BASIS_INFO_INIT;
  info.name = entry.name.c_str();
  info.summary = entry.summary.c_str();
  info.file = entry.file.c_str();
  info.status = entry.status;
  info.message = entry.message.c_str();
  info.flags = entry.family.flags;
  info.order = entry.family.order;
  info.minLevel = entry.family.minLevel;
  info.maxLevel = entry.family.maxLevel;
  return info;
}

void Registry::search() {
  if (searched_) return;
  folders_.clear();
  for (const std::string& path : given_) folders_.push_back(searchFolder(path));
  if (!ignoreEnvironment_) {
    for (const std::string& path : environmentFolders("AWD_BASIS_PATH")) {
      folders_.push_back(searchFolder(path));
    }
  }
  const std::string own = libraryFolder();
  if (!own.empty()) folders_.push_back(searchFolder(own + "/" AWD_MODULE_FOLDER));
  searched_ = true;
}

Registry::Folder Registry::searchFolder(const std::string& path) {
  if (path[0] != '/') return {path, "not absolute, left out"};
  DIR* folder = opendir(path.c_str());
  if (!folder) {
    const bool missing = errno == ENOENT || errno == ENOTDIR;
    return {path, missing ? "does not exist" : std::strerror(errno)};
  }
  const std::unique_ptr<DIR, int (*)(DIR*)> closed(folder, closedir);
  struct stat status = {};
  if (fstat(dirfd(folder), &status) == 0 && (status.st_mode & S_IWOTH)) {
    return {path, "anybody may write to it, left out"};
  }
  std::vector<std::string> names;
  while (const dirent* item = readdir(folder)) {
    const std::string_view name = item->d_name;
    if (name.size() > 3 && name.substr(name.size() - 3) == ".so") names.emplace_back(name);
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    std::string file = path;
    searchFile(file.append("/").append(name));
  }
  return {path, names.empty() ? "has no .so file" : ""};
}

void Registry::searchFile(const std::string& file) {
  try {
    const std::string why = distrust(file);
    if (!why.empty()) fail(AWD_ERROR_PLUGIN_LOAD, "%s", why.c_str());
    const auto module = std::make_shared<Module>(file.c_str());
    const AWDBasisModule& table = module->table();
    const bool again = std::any_of(candidates_.begin(), candidates_.end(), [&](const auto& other) {
      return &other.module->table() == &table;
    });
    if (again || inUse(table)) return;
    for (uint32_t i = 0; i < table.familyCount; ++i) {
      candidates_.push_back({nameOf(*table.families[i]), file, table.families[i], module});
    }
  } catch (const Error& error) {
    warn(*refuse(file, error));
  }
}

void Registry::settle(const std::string& name) {
  for (auto at = candidates_.begin(); at != candidates_.end();) {
    if (at->name == name) {
      settle(*at);
      at = candidates_.erase(at);
    } else {
      ++at;
    }
  }
}

void Registry::settleAll() {
  while (!candidates_.empty()) {
    settle(candidates_.front());
    candidates_.erase(candidates_.begin());
  }
}

void Registry::settle(const Candidate& candidate) {
  Entries entry;
  entry.push_back(judge(*candidate.family, candidate.file, entry));
  if (entry.front()->status == AWD_SUCCESS) {
    accept(std::move(entry), candidate.module->table());
    candidate.module->keep();
    return;
  }
  // To put a family of the same name before another is what folders have an order for.
  const Entry& refused = *refuse(std::move(entry.front()));
  if (refused.status != AWD_ERROR_PLUGIN_NAME_TAKEN) warn(refused);
}

void Registry::warn(const Entry& refused) {
  std::string text = "basis module " + placeOf(refused) + " refused: ";
  if (!refused.name.empty()) text += "basis \"" + refused.name + "\": ";
  log_.push_back(text + refused.message);
}

std::unique_ptr<Module> Registry::open(const std::string& file) {
  try {
    return std::make_unique<Module>(file.c_str());
  } catch (const Error& error) {
    // What was never a candidate is not listed as one.
    if (error.code() == AWD_ERROR_INVALID_ARGUMENT) throw;
    refuse(file, error);
    throw Error(error.code(), "\"" + file + "\": " + error.what());
  }
}

std::unique_ptr<Registry::Entry> Registry::judge(const AWDBasisFamily& family,
                                                 const std::string& file,
                                                 const Entries& besides) const {
  const AWDBasisFamily known = knownPart(family);
  auto entry = std::make_unique<Entry>();
  entry->name = nameOf(family);
  entry->summary = printable(family.summary, kLongestSummary);
  entry->file = file;
  entry->family = known;
  entry->family.name = entry->name.c_str();
  entry->family.summary = entry->summary.c_str();

  const Entry* taken = visible(entry->name);
  for (const auto& other : besides) {
    if (other->name == entry->name) taken = other.get();
  }
  if (taken) {
    entry->status = AWD_ERROR_PLUGIN_NAME_TAKEN;
    entry->message = std::string("the name is taken by ") +
                     (taken->file.empty() ? "a family " : "") + placeOf(*taken);
    return entry;
  }
  const std::vector<Check> checks = selfTest(known, false);
  if (const Check* failure = firstFailure(checks)) {
    entry->status = AWD_ERROR_PLUGIN_SELF_TEST;
    entry->message = failure->sentence();
  }
  return entry;
}

Registry::Entries Registry::judgeWhole(const AWDBasisModule& module, const std::string& file) {
  Entries entries;
  for (uint32_t i = 0; i < module.familyCount; ++i) {
    entries.push_back(judge(*module.families[i], file, entries));
  }
  const auto bad = std::find_if(entries.begin(), entries.end(),
                                [](const auto& entry) { return entry->status != AWD_SUCCESS; });
  if (bad == entries.end()) return entries;
  const AWDResult code = (*bad)->status;
  std::string text = file.empty() ? "" : "\"" + file + "\": ";
  text += "basis \"" + (*bad)->name + "\": " + (*bad)->message;
  for (auto& entry : entries) {
    if (entry->status != AWD_SUCCESS) refuse(std::move(entry));
  }
  throw Error(code, std::move(text));
}

void Registry::accept(Entries entries, const AWDBasisModule& module) {
  const auto before = [](const auto& a, const auto& b) { return a->name < b->name; };
  modules_.reserve(modules_.size() + 1);
  families_.reserve(families_.size() + entries.size());
  for (auto& entry : entries) {
    families_.insert(std::upper_bound(families_.begin(), families_.end(), entry, before),
                     std::move(entry));
  }
  if (!inUse(module)) modules_.push_back(&module);
}

const Registry::Entry* Registry::refuse(std::unique_ptr<Entry> entry) {
  const auto key = [](const Entry& e) { return std::tie(e.file, e.name, e.message, e.status); };
  const auto before = [&](const auto& a, const auto& b) { return key(*a) < key(*b); };
  const auto at = std::lower_bound(refused_.begin(), refused_.end(), entry, before);
  if (at != refused_.end() && key(**at) == key(*entry)) return at->get();  // asked for again
  return refused_.insert(at, std::move(entry))->get();
}

const Registry::Entry* Registry::refuse(const std::string& file, const Error& reason) {
  auto entry = std::make_unique<Entry>();
  entry->file = file;
  entry->status = reason.code();
  entry->message = reason.what();
  return refuse(std::move(entry));
}

const Registry::Entry* Registry::visible(const std::string& name) const {
  const auto before = [](const auto& entry, const std::string& n) { return entry->name < n; };
  const auto at = std::lower_bound(families_.begin(), families_.end(), name, before);
  return at != families_.end() && (*at)->name == name ? at->get() : nullptr;
}

bool Registry::inUse(const AWDBasisModule& module) const {
  return std::find(modules_.begin(), modules_.end(), &module) != modules_.end();
}

std::string Registry::placeOf(const Entry& entry) {
  return entry.file.empty() ? "in memory" : '"' + entry.file + '"';
}

std::string Registry::missing(const char* name) const {
  std::string text = "there is no basis \"" + printable(name, kLongestName) + "\"; there ";
  text += families_.empty() ? "are none" : families_.size() == 1 ? "is" : "are";
  for (const auto& entry : families_) {
    text += (entry == families_.front() ? " " : ", ") + entry->name;
  }
  text += "; looked in";
  for (const Folder& folder : folders_) {
    text += (&folder == &folders_.front() ? " \"" : ", \"") + folder.path + "\"";
    if (!folder.note.empty()) text += " (" + folder.note + ")";
  }
  if (folders_.empty()) text += " no folder";
  for (const auto& entry : refused_) {
    text += "; refused " + placeOf(*entry) + ": " + entry->message;
  }
  return text;
}

void Registry::flushLog() {
  std::vector<std::string> lines;
  {
    const std::lock_guard<Mutex> lock(mutex_);
    lines.swap(log_);
  }
  for (const std::string& line : lines) context_.log(AWD_LOG_WARNING, "%s", line.c_str());
}

}  // namespace awd
