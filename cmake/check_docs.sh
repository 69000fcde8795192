#!/usr/bin/env bash
# Checks the documents: links inside the repository lead to files, files of the tree that are named exist, the README stays short.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
status=0
complain() { echo "$1"; status=1; }

while read -r page; do
  folder=$(dirname "$page")
  while read -r target; do
    [[ -e $folder/${target%%#*} ]] || complain "$page: the link to $target leads nowhere"
  done < <(grep -o '](\([^)]*\))' "$page" | sed 's/^](//; s/)$//' | grep -Ev '^(https?:|#|mailto:)' | sort -u)
  while read -r path; do
    [[ -e $path ]] || complain "$page: $path does not exist"
  done < <(grep -oE '`(core|widgets|app|tests|cmake|resources|docs|translations)/[A-Za-z0-9_./-]+`' "$page" | tr -d '`' | sort -u)
done < <(find . -name '*.md' -not -path './build*' -not -path './.git/*' | sort)

lines=$(wc -l <README.md)
((lines <= 110)) || complain "README.md: $lines lines, at most 110; details belong in docs/"
exit $status
