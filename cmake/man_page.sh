#!/usr/bin/env bash
# Writes a manual page made of what a program says of itself with --help, and of the sections that stand in a file.
#   man_page.sh PROGRAM NAME VERSION SECTIONS OUT
set -euo pipefail
program=$1 name=$2 version=$3 sections=$4 out=$5

# Text for a man page: backslashes and hyphens as they are typed, no line that begins like a request.
escape() { sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\\([.']\\)/\\\\\\&\\1/"; }

# The first line of a help text: what the program or the verb does.
summary() { head -n 1; }
# The line of its usage without the first word.
usage() { sed -n 's/^Usage: [^ ]* *//p' | head -n 1; }
# The names of its verbs.
verbs() { awk '/^Subcommands:/ { inside = 1; next } inside && /^  [^ ]/ { print $1 }'; }

# The options and positionals of a help text as a list. An explanation begins in column 31, of the same line or, after a long name, of the next.
options() {
  awk '
    function flush() {
      if (name == "") return
      if (text == "") { text = substr(name, 31); name = substr(name, 1, 30) }
      gsub(/^ +| +$/, "", name)
      printf ".TP\n.B %s\n%s\n", name, text
      name = text = ""
    }
    /^[A-Z][a-z]*:/ { flush(); inside = /^(Options|Positionals):/; next }
    !inside || /^$/ { next }
    /^  [^ ]/ { flush(); name = $0; next }
    { text = $0; sub(/^ +/, "", text) }
    END { flush() }'
}

# One verb and its own verbs, each as a subsection.
describe() {
  local help words=("$@")
  help=$("$program" "${words[@]}" --help)
  printf '.SS %s\n' "$(printf '%s' "${words[*]}" | escape)"
  printf '%s.\n.PP\n.B %s %s\n' "$(summary <<<"$help" | escape)" "$(printf '%s' "$name" | escape)" "$(usage <<<"$help" | escape)"
  options <<<"$help" | escape_fields
  for verb in $(verbs <<<"$help"); do
    describe "${words[@]}" "$verb"
  done
}

# Escapes all lines but the requests that options() writes.
escape_fields() {
  local line
  while IFS= read -r line; do
    case $line in
      .TP) printf '.TP\n' ;;
      '.B '*) printf '.B %s\n' "$(printf '%s' "${line#.B }" | escape)" ;;
      *) printf '%s\n' "$line" | escape ;;
    esac
  done
}

page() {
  local help
  help=$("$program" --help)
  printf '.TH %s 1 "" "Handlens %s" "User Commands"\n' "${name^^}" "$version"
  printf '.SH NAME\n%s \\- %s\n' "$(printf '%s' "$name" | escape)" "$(summary <<<"$help" | sed 's/[.]$//' | escape)"
  printf '.SH SYNOPSIS\n.B %s %s\n' "$(printf '%s' "$name" | escape)" "$(usage <<<"$help" | escape)"
  printf '.SH OPTIONS\n'
  options <<<"$help" | escape_fields
  if [[ -n $(verbs <<<"$help") ]]; then
    printf '.SH COMMANDS\n'
    for verb in $(verbs <<<"$help"); do
      describe "$verb"
    done
  fi
  cat "$sections"
}

page > "$out.part"
mv "$out.part" "$out"
