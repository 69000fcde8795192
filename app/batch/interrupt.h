// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>

namespace app {

/// Turns SIGINT and SIGTERM into a request to stop; a second one ends the program at once. Call it first thing in main.
void watchForInterrupts();

/// Stop is requested once the user has pressed Ctrl+C: long work ends cleanly and keeps what is finished.
std::stop_token interruptToken();

} // namespace app
