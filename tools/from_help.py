#!/usr/bin/env python3
"""Completions for bash, zsh and fish, and the man page, made from the program's own --help.

from_help.py PROGRAM            writes completions/ and man/ anew
from_help.py PROGRAM --compare  says which of them are not those of the program, and fails if any is not
"""
import pathlib
import re
import subprocess
import sys
from dataclasses import dataclass, field

root = pathlib.Path(__file__).resolve().parents[1]
note = "Made from matrigrate --help by tools/from_help.py; do not edit."
choices_of = {  # values that the help names, and those of `matrigrate list`
    "--layer": ["degradation", "displacement", "von_mises", "pressure", "fibre_von_mises"],
    "--integrator": ["adaptive", "reference"],
    "--layout": ["celltrackscolab", "trackmate", "plain", "btrack", "trackpy", "mosaic", "manual-tracking", "mtrackj", "imaris",
                 "cellprofiler", "napari", "celltrackr"],
    "--splits": ["refuse", "cut", "drop"],
    "--time-unit": ["ms", "s", "min", "h", "d"],
}
takes_file = {"FILE"}
takes_folder = {"DIR", "FOLDER"}
folder_options = {"--output", "--from"}
file_options = {"--scenario", "--schema", "--with"}


@dataclass
class Option:
    names: list[str]
    value: str  # what follows it: "TEXT"; empty of a flag
    text: str

    @property
    def long(self) -> str:
        return self.names[-1]


@dataclass
class Verb:
    words: list[str]  # ["study", "plan"]; none of the program itself
    summary: str
    usage: str
    positionals: list[tuple[str, str]] = field(default_factory=list)  # "FILE", its meaning
    options: list[Option] = field(default_factory=list)
    verbs: list[tuple[str, str]] = field(default_factory=list)
    footer: str = ""

    @property
    def name(self) -> str:
        return "_".join(["matrigrate", *self.words])


def entries(block):
    """Left column and joined right column of each entry; a line that begins further right goes on with the one above."""
    found = []
    for line in block:
        match = re.match(r"  (\S.*?)(?:\s{2,}(\S.*))?$", line) if re.match(r"  \S", line) else None
        if match:
            left, right = match.group(1), match.group(2) or ""
            found.append([left, right])
        else:
            found[-1][1] = f"{found[-1][1]} {line.strip()}".strip()
    return [tuple(entry) for entry in found]


def option_of(left, text):
    names, _, value = left.partition(" ")
    value = value.split("Excludes:")[0].strip()
    default = re.search(r"=(\S+)$", value)
    text = f"{text} (default: {default.group(1)})" if default and "{" not in value else text
    return Option(names.split(","), re.split(r"[=: ]", value)[0] if value else "", text)


def parse(program, words, summary=""):
    text = subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True).stdout
    lines = text.rstrip().splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith("Usage: "))
    verb = Verb(words, summary or " ".join(lines[:start]), lines[start].removeprefix("Usage: "))
    blocks, title = {"footer": []}, "footer"
    for line in lines[start + 1:]:
        if line in ("Options:", "Positionals:", "Verbs:", "More verbs:"):
            title = line[:-1].lower()
            blocks[title] = []
        elif not line and title != "footer":
            title = "footer"
        else:
            blocks[title].append(line)
    verb.positionals = [(left.split()[0], right) for left, right in entries(blocks.get("positionals", []))]
    verb.options = [option_of(*entry) for entry in entries(blocks.get("options", []))]
    verb.verbs = entries(blocks.get("verbs", [])) + entries(blocks.get("more verbs", []))
    verb.footer = "\n".join(blocks["footer"]).strip()
    return verb


def parse_all(program):
    top = parse(program, [])
    found = [top]
    for name, summary in top.verbs:
        verb = parse(program, [name], summary)
        found += [verb, *(parse(program, [name, inner], text) for inner, text in verb.verbs)]
    return found


def listed(program, title):
    """The names in a part of `matrigrate list`."""
    text = subprocess.run([program, "list"], capture_output=True, text=True, check=True).stdout
    part = next(block for block in text.split("\n\n") if block.startswith(title))
    return [line.split()[0] for line in part.splitlines()[1:]]


def kind_of(option):
    """What to complete behind an option: a list of words, "file", "folder" or "" for anything."""
    if option.long in choices_of:
        return choices_of[option.long]
    return "folder" if option.long in folder_options else "file" if option.long in file_options else ""


def kind_of_argument(verb):
    name = verb.positionals[0][0] if verb.positionals else ""
    words = choices_of.get(" ".join(verb.words))
    return words or ("file" if name in takes_file else "folder" if name in takes_folder else "")


def bash(verbs):
    def answer(kind):
        if isinstance(kind, list):
            return f'COMPREPLY=($(compgen -W "{" ".join(kind)}" -- "$cur"))'
        return {"file": "_matrigrate_files -f", "folder": "_matrigrate_files -d"}.get(kind, "COMPREPLY=()")

    text = f"""# bash completion of matrigrate. {note}
# Put it into ~/.local/share/bash-completion/completions/matrigrate, or: source completions/matrigrate.bash

_matrigrate_files() {{ # -f or -d: names that may hold blanks
  local IFS=$'\\n'
  COMPREPLY=($(compgen "$1" -- "$cur"))
  compopt -o filenames 2>/dev/null
}}

_matrigrate() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} verb=matrigrate word
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case ${{verb}}_$word in
"""
    named = "|".join(verb.name for verb in verbs[1:])
    text += f"    {named}) verb=${{verb}}_$word ;;\n    esac\n  done\n  case $verb:$previous in\n"
    for verb in verbs:
        for option in verb.options:
            if option.value:
                places = "|".join(f"{verb.name}:{name}" for name in option.names)
                text += f"  {places}) {answer(kind_of(option))}; return ;;\n"
    text += "  esac\n  case $verb in\n"
    for verb in verbs:
        words = " ".join(option.long for option in verb.options)
        if verb.verbs:
            inner = f'COMPREPLY=($(compgen -W "{" ".join(name for name, _ in verb.verbs)}" -- "$cur"))'
        else:
            inner = answer(kind_of_argument(verb))
        text += f"""  {verb.name})
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "{words}" -- "$cur")); else {inner}; fi ;;
"""
    return text + "  esac\n}\n\ncomplete -F _matrigrate matrigrate\n"


def zsh(verbs):
    def quoted(text):
        return re.sub(r"([\[\]:])", r"\\\1", text.replace("'", "'\\''").replace("`", "\\`"))

    def action(kind):
        if isinstance(kind, list):
            return f"({' '.join(kind)})"
        return {"file": "_files", "folder": "_files -/"}.get(kind, " ")

    text = f"#compdef matrigrate\n# zsh completion of matrigrate. {note}\n# Put it into a folder of $fpath.\n"
    for verb in reversed(verbs):
        text += f"\n_{verb.name}() {{\n"
        if verb.verbs:
            text += "  local -a verbs=(\n"
            text += "".join(f"    '{name}:{quoted(summary)}'\n" for name, summary in verb.verbs) + "  )\n"
            text += "  local state line\n"
        text += "  _arguments -s"
        for option in verb.options:
            for name in option.names:
                value = f":{option.value.lower()}:{action(kind_of(option))}" if option.value else ""
                many = "*" if "repeated" in option.text else ""
                text += f" \\\n    '{many}{name}[{quoted(option.text)}]{value}'"
        if verb.verbs:
            text += f""" \\
    '1: :->verb' '*:: :->rest'
  case $state in
  verb) _describe verb verbs ;;
  rest) (( $+functions[_{verb.name}_$line[1]] )) && _{verb.name}_$line[1] ;;
  esac
}}
"""
        else:
            for name, _ in verb.positionals[:1]:
                many = "*" if "..." in verb.usage else "1"
                text += f" \\\n    '{many}:{name.lower()}:{action(kind_of_argument(verb))}'"
            text += "\n}\n"
    return text + '\n_matrigrate "$@"\n'


def fish(verbs):
    def quoted(text):
        return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"

    text = (f"# fish completion of matrigrate. {note}\n# Put it into ~/.config/fish/completions/.\n\n"
            "# Whether the verbs typed so far are those given, and no more.\n"
            "function __matrigrate_at\n  set -l verbs\n  for word in (commandline -opc)[2..]\n"
            "    switch (string join -- _ matrigrate $verbs $word)\n"
            f"      case {' '.join(verb.name for verb in verbs[1:])}\n        set -a verbs $word\n    end\n  end\n"
            '  test "$verbs" = "$argv"\nend\n\n'
            "complete -c matrigrate -f\n")
    for verb in verbs:
        at = f"complete -c matrigrate -n '__matrigrate_at{''.join(' ' + word for word in verb.words)}'"
        text += "\n"
        for name, summary in verb.verbs:
            text += f"{at} -a {name} -d {quoted(summary)}\n"
        kind = kind_of_argument(verb)
        if isinstance(kind, list):
            text += f"{at} -a {quoted(' '.join(kind))}\n"
        elif kind:
            text += f"{at} {'-F' if kind == 'file' else '-a ' + quoted('(__fish_complete_directories)')}\n"
        for option in verb.options:
            names = " ".join(f"-l {n[2:]}" if n.startswith("--") else f"-s {n[1:]}" for n in option.names)
            kind = kind_of(option)
            value = "" if not option.value else " -x"
            if isinstance(kind, list):
                value += f" -a {quoted(' '.join(kind))}"
            elif kind:
                value = " -r -F" if kind == "file" else value + " -a " + quoted("(__fish_complete_directories)")
            text += f"{at} {names}{value} -d {quoted(option.text)}\n"
    return text


def man(verbs, version):
    def plain(text):
        text = text.replace("\\", "\\e").replace("-", "\\-")
        return "\n".join("\\&" + line if line.startswith((".", "'")) else line for line in text.splitlines())

    top = verbs[0]
    text = f""".\\" {note}
.TH MATRIGRATE 1 "" "matrigrate {version}" "User commands"
.SH NAME
matrigrate \\- simulate a cell that migrates through a degradable viscoelastic matrix
.SH SYNOPSIS
.B matrigrate
.I VERB
[options]
.SH DESCRIPTION
{plain(top.summary)}
.PP
Quantities in a scenario are texts with a unit, such as "200 Pa". Results are in um, s, nN, and stress in Pa.
.SH VERBS
"""
    for verb in verbs[1:]:
        usage = verb.usage.removeprefix("matrigrate ").replace("[OPTIONS] ", "").replace(" [OPTIONS]", "")
        text += f".SS {plain('matrigrate ' + usage)}\n{plain(verb.summary)}.\n"
        for name, meaning in verb.positionals:
            text += f".TP\n.I {plain(name)}\n{plain(meaning)}\n"
        for option in verb.options:
            if option.long != "--help":
                value = f" \\fI{plain(option.value)}\\fR" if option.value else ""
                text += f".TP\n\\fB{plain(', '.join(option.names))}\\fR{value}\n{plain(option.text)}\n"
        if verb.footer and verb.footer != top.footer:
            text += f".PP\n{plain(verb.footer)}\n"
    return text + f""".SH EXIT STATUS
{plain(top.footer)}
.SH FILES
A run writes report.html, the page to open, and tables, frames, pictures and checkpoints beside it; docs/outputs.md of
the source lists them.
.SH SEE ALSO
docs/parameters.md, docs/studies.md and docs/restarts.md of the source.
"""


def main():
    program, compare = sys.argv[1], "--compare" in sys.argv[2:]
    choices_of["--preset"] = listed(program, "Presets")
    choices_of["validate"] = [*listed(program, "Cases"), "all"]
    verbs = parse_all(program)
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
    made = {"completions/matrigrate.bash": bash(verbs), "completions/_matrigrate": zsh(verbs),
            "completions/matrigrate.fish": fish(verbs), "man/matrigrate.1": man(verbs, version)}
    for name, text in made.items():
        path = root / name
        if not compare:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            sys.exit(f"{name} is not that of the program; write it anew: tools/from_help.py {program}")


main()
