// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <stop_token>
#include <string>

namespace app {

/// Thrown by a verb that ended early because the user asked for it; what() says what became of the work.
class Interrupted : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Turns SIGINT and SIGTERM into a request to stop; a second one ends the program at once. Call it first thing in main.
void watchForInterrupts();

/// Stop is requested once the user has pressed Ctrl+C: long work ends cleanly and keeps what is finished.
std::stop_token interruptToken();

/// The exit status of a program that a signal stopped, as shells count it: 128 + signal (130 after Ctrl+C); 0 if none
/// came.
int interruptStatus();

} // namespace app
