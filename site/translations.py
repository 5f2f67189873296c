"""Write the catalogues of all lectures to build/locales, and bring those of site/locales up to date with the lectures.

With a language and a lecture, `de 01_frames`, the lecture gets a catalogue in this language, which is to be translated.
"""

import sys

from babel.messages.catalog import Catalog
from babel.messages.pofile import read_po, write_po
from kinsite.execute import ROOT
from kinsite.sphinx_source import LECTURES
from kinsite.translation import LOCALES, WORDS, catalog_file, changed_parts, template, words_template

HEADER = "# A translation of the course, under the licence of its lectures (LICENSE-lectures)."


def save(catalog: Catalog, path: str) -> None:
    """Write a catalogue into the repository. Lines are not wrapped, so that a change shows as a changed line."""
    (ROOT / path).parent.mkdir(parents=True, exist_ok=True)
    with (ROOT / path).open("wb") as file:
        write_po(file, catalog, width=0, ignore_obsolete=True)


def main(language: str = "", lecture: str = "") -> str:
    """Write the catalogues. Returns a line for each translation that changes a formula, code, a link or a number."""
    templates = {path.stem: template(path) for path in LECTURES} | {WORDS: words_template()}
    for name, catalog in templates.items():
        save(catalog, f"build/locales/{name}.pot")
    print(f"Wrote {len(templates)} templates to build/locales, with {sum(map(len, templates.values()))} passages.")
    for name in (WORDS, lecture) if language and lecture in templates else ():
        if not (path := catalog_file(language, name)).exists():
            save(Catalog(language, name, HEADER, "Forward kinematics", fuzzy=False), str(path))
    faults = []
    for file in sorted(LOCALES.glob("*/LC_MESSAGES/*.po")):
        with file.open("rb") as opened:
            catalog = read_po(opened, locale=file.parts[-3])
        catalog.update(templates[file.stem], update_creation_date=False)
        save(catalog, str(file))
        entries = [entry for entry in catalog if entry.id]
        changed = sum(entry.fuzzy for entry in entries)
        missing = sum(not entry.string for entry in entries)
        print(f"{file.parts[-3]} {file.stem}: {len(entries)} passages, {missing} not translated, {changed} fuzzy")
        faults += [
            f"{file.name}: {parts} must be the same in {entry.string!r}"
            for entry in entries
            if entry.string and (parts := changed_parts(str(entry.id), str(entry.string)))
        ]
    return "\n".join(faults)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]) or 0)
