// SPDX-License-Identifier: MIT
#include "core/io/files/login_name.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace core {

std::string loginName() {
    for (const char* variable : {"LOGNAME", "USER"}) {
        const char* name = std::getenv(variable);
        if (name && *name)
            return name;
    }
    const passwd* entry = ::getpwuid(::geteuid());
    return entry && entry->pw_name && *entry->pw_name ? entry->pw_name : "annotator";
}

} // namespace core
