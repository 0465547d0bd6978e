// SPDX-License-Identifier: Apache-2.0
#include "basis/registry.h"

#include <dirent.h>
#include <sys/auxv.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <tuple>

#include "basis/library_folder.h"
#include "basis/module.h"
#include "basis/self_test.h"

namespace awd {

namespace {

/// A name as it can be shown: cut where no valid one could go on.
std::string shown(const char* text, std::size_t limit) {
  std::string out(text ? text : "", text ? strnlen(text, limit) : 0);
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return out;
}

/// The entries of $AWD_BASIS_PATH.
std::vector<std::string> environmentFolders() {
  std::vector<std::string> folders;
  const char* variable = getauxval(AT_SECURE) ? nullptr : std::getenv("AWD_BASIS_PATH");
  std::string_view rest = variable ? variable : "";
  while (!rest.empty()) {
    const std::string_view entry = rest.substr(0, rest.find(':'));
    if (!entry.empty()) folders.emplace_back(entry);
    rest.remove_prefix(std::min(rest.size(), entry.size() + 1));
  }
  return folders;
}

}  // namespace

Registry::Registry(Context& context, std::vector<std::string> folders, bool ignoreEnvironment)
    : context_(context), given_(std::move(folders)), ignoreEnvironment_(ignoreEnvironment) {}

Registry::~Registry() = default;

const AWDBasisFamily& Registry::find(const char* name) {
  const AWDBasisFamily* family = nullptr;
  std::string text;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    search();
    if (const Entry* entry = visible(name)) {
      family = &entry->family;
    } else {
      text = missing(name);
    }
  }
  flushLog();
  if (!family) throw Error(AWD_ERROR_UNSUPPORTED, std::move(text));
  return *family;
}

void Registry::load(const char* absolutePath) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::unique_ptr<Module> module = open(absolutePath);
  if (inUse(module->table())) return;
  keep(judgeWhole(module->table(), absolutePath), *module);
}

void Registry::add(const AWDBasisModule& module) {
  const std::lock_guard<std::mutex> lock(mutex_);
  try {
    checkModule(&module);
  } catch (const Error& error) {
    refuse("", error);
    throw;
  }
  accept(judgeWhole(module, ""));
}

std::size_t Registry::count() {
  std::size_t count = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    search();
    count = families_.size() + refused_.size();
  }
  flushLog();
  return count;
}

AWDBasisInfo Registry::info(std::size_t index) {
  const std::size_t all = count();
  const std::lock_guard<std::mutex> lock(mutex_);
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
    for (const std::string& path : environmentFolders()) folders_.push_back(searchFolder(path));
  }
  const std::string own = libraryFolder();
  if (!own.empty()) folders_.push_back(searchFolder(own + "/" AWD_MODULE_FOLDER));
  for (const auto& entry : refused_) {
    // To put a family of the same name before another is what folders have an order for.
    if (entry->status == AWD_ERROR_PLUGIN_NAME_TAKEN) continue;
    std::string text = "basis module \"" + entry->file + "\" refused: ";
    if (!entry->name.empty()) text += "basis \"" + entry->name + "\": ";
    log_.push_back(text + entry->message);
  }
  searched_ = true;
}

Registry::Folder Registry::searchFolder(const std::string& path) {
  if (path[0] != '/') return {path, "not absolute, left out"};
  DIR* folder = opendir(path.c_str());
  if (!folder) {
    const bool missing = errno == ENOENT || errno == ENOTDIR;
    return {path, missing ? "does not exist" : std::strerror(errno)};
  }
  std::vector<std::string> names;
  while (const dirent* item = readdir(folder)) {
    const std::string_view name = item->d_name;
    if (name.size() > 3 && name.substr(name.size() - 3) == ".so") names.emplace_back(name);
  }
  closedir(folder);
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    std::string file = path;
    searchFile(file.append("/").append(name));
  }
  return {path, names.empty() ? "has no .so file" : ""};
}

void Registry::searchFile(const std::string& file) {
  try {
    struct stat status = {};
    if (stat(file.c_str(), &status) != 0) {
      fail(AWD_ERROR_PLUGIN_LOAD, "can't be read: %s", std::strerror(errno));
    }
    if (!S_ISREG(status.st_mode)) fail(AWD_ERROR_PLUGIN_LOAD, "is not a file");
    if (status.st_mode & S_IWOTH) {
      fail(AWD_ERROR_PLUGIN_LOAD, "anybody may write to it: take that right away (chmod o-w)");
    }
  } catch (const Error& error) {
    refuse(file, error);
    return;
  }
  std::unique_ptr<Module> module;
  try {
    module = open(file);
  } catch (const Error&) {
    return;  // listed
  }
  if (inUse(module->table())) return;
  // Here one bad family does not take the others with it: nobody waits for a verdict on the whole.
  Entries entries;
  for (uint32_t i = 0; i < module->table().familyCount; ++i) {
    entries.push_back(judge(*module->table().families[i], file, entries));
  }
  for (auto& entry : entries) {
    if (entry->status != AWD_SUCCESS) refuse(std::move(entry));
  }
  entries.erase(std::remove(entries.begin(), entries.end(), nullptr), entries.end());
  if (!entries.empty()) keep(std::move(entries), *module);
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
  auto entry = std::make_unique<Entry>();
  entry->name = shown(family.name, 64);
  entry->summary = shown(family.summary, 200);
  entry->file = file;
  std::memcpy(&entry->family, &family, sizeof family);  // the rest of a longer one is 0
  entry->family.structSize = sizeof family;
  entry->family.name = entry->name.c_str();
  entry->family.summary = entry->summary.c_str();

  const Entry* taken = visible(entry->name);
  for (const auto& other : besides) {
    if (other->name == entry->name) taken = other.get();
  }
  if (taken) {
    entry->status = AWD_ERROR_PLUGIN_NAME_TAKEN;
    entry->message = "the name is taken by " +
                     (taken->file.empty() ? "a family in memory" : "\"" + taken->file + "\"");
    return entry;
  }
  const std::vector<Check> checks = selfTest(family);
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

void Registry::keep(Entries entries, Module& module) {
  modules_.reserve(modules_.size() + 1);
  accept(std::move(entries));
  modules_.push_back(&module.table());
  module.keep();
}

void Registry::accept(Entries entries) {
  const auto before = [](const auto& a, const auto& b) { return a->name < b->name; };
  families_.reserve(families_.size() + entries.size());
  for (auto& entry : entries) {
    families_.insert(std::upper_bound(families_.begin(), families_.end(), entry, before),
                     std::move(entry));
  }
}

void Registry::refuse(std::unique_ptr<Entry> entry) {
  const auto key = [](const Entry& e) { return std::tie(e.file, e.name, e.message, e.status); };
  const auto before = [&](const auto& a, const auto& b) { return key(*a) < key(*b); };
  const auto at = std::lower_bound(refused_.begin(), refused_.end(), entry, before);
  if (at != refused_.end() && key(**at) == key(*entry)) return;  // asked for again
  refused_.insert(at, std::move(entry));
}

void Registry::refuse(const std::string& file, const Error& reason) {
  auto entry = std::make_unique<Entry>();
  entry->file = file;
  entry->status = reason.code();
  entry->message = reason.what();
  refuse(std::move(entry));
}

const Registry::Entry* Registry::visible(const std::string& name) const {
  const auto before = [](const auto& entry, const std::string& n) { return entry->name < n; };
  const auto at = std::lower_bound(families_.begin(), families_.end(), name, before);
  return at != families_.end() && (*at)->name == name ? at->get() : nullptr;
}

bool Registry::inUse(const AWDBasisModule& module) const {
  return std::find(modules_.begin(), modules_.end(), &module) != modules_.end();
}

std::string Registry::missing(const char* name) const {
  std::string text = "there is no basis \"" + shown(name, 64) + "\"; there ";
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
    text += "; refused \"" + entry->file + "\": " + entry->message;
  }
  return text;
}

void Registry::flushLog() {
  std::vector<std::string> lines;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    lines.swap(log_);
  }
  for (const std::string& line : lines) context_.log(AWD_LOG_WARNING, "%s", line.c_str());
}

}  // namespace awd
