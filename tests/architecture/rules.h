// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace architecture {

/// What breaks a rule, one line each: path:line: why. Empty if all is well.
using Violations = std::vector<std::string>;

/// core <- widgets <- app, and inside core and widgets a folder includes only itself and folders below it.
Violations wrongDirections(const std::vector<SourceFile>& files);
/// Components (a header and its source together) that include each other in a circle.
Violations includeCycles(const std::vector<SourceFile>& files);
/// Libraries outside the folders that may use them (Qt, VTK, assimp, OpenCV, SQLite, ...).
Violations brokenFences(const std::vector<SourceFile>& files);
/// Headers that only the classes that build the window may include, included elsewhere: a panel takes the parts that it
/// needs, never the whole session.
Violations wholeSessions(const std::vector<SourceFile>& files);
/// Quoted includes that name no file of the project: includes go from the root.
Violations unknownIncludes(const std::vector<SourceFile>& files);
/// Folders of core or widgets that have no place in their order, so that no rule would look at their includes.
Violations unrankedFolders(const std::vector<SourceFile>& files);
/// Folders of the product that `text` does not name: their last part, after one of the marks and not within a word.
Violations unnamedFolders(const std::vector<SourceFile>& files, const std::string& text,
                          const std::vector<std::string>& marks);
/// Folders with more than 20 components, tests included; app/batch has one file per command.
Violations crowdedFolders(const std::vector<SourceFile>& files);
/// Files of more than 400 lines.
Violations longFiles(const std::vector<SourceFile>& files);
/// Functions of more than 60 lines, found by their indentation (the formatter guarantees it).
Violations longFunctions(const std::vector<SourceFile>& files);
/// Turns of phrase that are not plain engineering English: "is no X" for "is not an X", "nothing if" for an empty
/// optional, "somebody" and its kin for a person or a rater.
Violations unplainWords(const std::vector<SourceFile>& files);
/// Files without the licence line, headers without #pragma once, folders with names that mean nothing.
Violations untidyFiles(const std::vector<SourceFile>& files);

} // namespace architecture
