// SPDX-License-Identifier: Apache-2.0
// All that this program says besides its results goes to standard error, and through here.
#pragma once

#include <string>

namespace command {

/// "awd: text", for what a user should know about what was done.
void note(const std::string& text);
/// "awd: warning: text". From any thread.
void warn(const std::string& text);
/// "awd: text", for the reason why the program ends.
void complain(const std::string& text);

/// From now on notes and warnings are not said.
void mute();

/// Whether standard error is a terminal, which alone gets status lines.
bool hasTerminal();
/// Replaces the line that is rewritten in place; it gives way to messages.
void showStatus(const std::string& text);
void clearStatus();

}  // namespace command
