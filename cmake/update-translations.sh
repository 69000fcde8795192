#!/usr/bin/env bash
# Brings translations/*.ts up to date with the sources: new texts come in as unfinished, texts that are gone leave.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for file in translations/handlens_*.ts; do
  options=()
  [[ $file == *_en.ts ]] && options=(-pluralonly) # the sources are English: only plurals need words
  lupdate -silent -I . -locations none -no-obsolete "${options[@]}" widgets app/desktop -ts "$file"
done
