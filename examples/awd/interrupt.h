// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a flag that long work looks at.
#pragma once

namespace command {

/// From now on the first SIGINT only sets the flag; the second one ends the program as usual. A
/// program that was started with SIGINT ignored goes on ignoring it.
void catchInterrupt();
bool wasInterrupted();

}  // namespace command
