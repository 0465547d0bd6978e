// SPDX-License-Identifier: Apache-2.0
#include "basis/module_check.h"

#include <memory>
#include <set>
#include <string>

#include "basis/module.h"
#include "basis/self_test.h"
#include "util/error.h"
#include "util/uncancelled.h"

namespace awd {

namespace {

/// Reports the checks of one family and keeps what is to be thrown.
class Reporter {
 public:
  Reporter(const char* file, const std::function<void(const AWDBasisCheck&)>& report)
      : file_(file), report_(report) {}

  void family(uint32_t index, const std::string& name) {
    index_ = index;
    name_ = name;
  }

  void operator()(const Check& check, AWDResult code) {
    const AWDResult status = check.ok() ? AWD_SUCCESS : code;
    if (status != AWD_SUCCESS && result_ == AWD_SUCCESS) {
      result_ = status;
      text_ = "\"" + file_ + "\": basis \"" + name_ + "\": " + check.sentence();
    }
    report_({sizeof(AWDBasisCheck), name_.c_str(), check.name(), check.sentence().c_str(),
             check.worst(), check.limit(), status, index_});
  }

  void throwFailure() const {
    if (result_ != AWD_SUCCESS) throw Error(result_, text_);
  }

 private:
  const std::string file_;
  const std::function<void(const AWDBasisCheck&)>& report_;
  uint32_t index_ = 0;
  std::string name_;
  AWDResult result_ = AWD_SUCCESS;
  std::string text_;
};

/// The error names the file.
std::unique_ptr<Module> openModule(const char* absolutePath) {
  try {
    return std::make_unique<Module>(absolutePath);
  } catch (const Error& error) {
    if (error.code() == AWD_ERROR_INVALID_ARGUMENT) throw;  // it does so already
    throw Error(error.code(), "\"" + std::string(absolutePath) + "\": " + error.what());
  }
}

/// Two families of one name can't both be loaded.
Check checkName(const std::string& name, bool first) {
  Check check("unique name", 0.0);
  if (check.fails(first ? 0.0 : 1.0)) {
    check.say("the name \"%s\" is taken by another family of this module", name.c_str());
  }
  return check;
}

}  // namespace

void checkModuleFile(const char* absolutePath,
                     const std::function<void(const AWDBasisCheck&)>& report) {
  const Uncancelled uncancelled;
  const std::unique_ptr<Module> opened = openModule(absolutePath);
  const AWDBasisModule& module = opened->table();
  Reporter reporter(absolutePath, report);
  std::set<std::string> names;
  for (uint32_t i = 0; i < module.familyCount; ++i) {
    const AWDBasisFamily family = knownPart(*module.families[i]);
    const std::string name = printable(family.name, kLongestName);
    reporter.family(i, name);
    reporter(checkName(name, names.insert(name).second), AWD_ERROR_PLUGIN_NAME_TAKEN);
    for (const Check& check : selfTest(family)) reporter(check, AWD_ERROR_PLUGIN_SELF_TEST);
  }
  reporter.throwFailure();
}

}  // namespace awd
