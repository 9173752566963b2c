"""Writes completions for bash and zsh from --help: completions.py GLINT SHARE"""
import re
import subprocess
import sys
from pathlib import Path

glint, share = sys.argv[1], Path(sys.argv[2])


def help_of(*words):
    return subprocess.run([glint, *words, "--help"], check=True, capture_output=True, text=True).stdout


def options_of(text):
    """Returns [(names, description)] for the list under "Options:"."""
    return [(names.split(","), words) for names, words in re.findall(r"^  (-\S+)(?: \S+)?\s{2,}(.+)$", text, re.M)]


commands = {}  # name -> (summary, options)
for name in dict.fromkeys(re.findall(r"^  glint ([a-z]+)", help_of(), re.M)):
    text = help_of(name)
    commands[name] = (text.split("\n")[0], options_of(text))

bash = ["# Bash completion for glint, generated from --help.", "_glint() {",
        '    local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} options="--help --version --lesson --set --threads --memory"',
        "    case $command in"]
for name, (_, options) in commands.items():
    bash.append(f'    {name}) options="{" ".join(n for names, _ in options for n in names)}" ;;')
bash += ["    esac",
         "    case $word in",
         '    -*) mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word") ;;',
         f'    *) [ "$COMP_CWORD" -gt 1 ] || mapfile -t COMPREPLY < <(compgen -W "{" ".join(commands)}" -- "$word") ;;',
         "    esac", "}", "complete -o default -F _glint glint", ""]


def quoted(words):
    return "'" + words.replace("'", "'\\''").replace(":", "\\:").replace("[", "\\[").replace("]", "\\]") + "'"


zsh = ["#compdef glint", "# Zsh completion for glint, generated from --help.", "_glint() {", "    local -a commands options",
       "    commands=("]
zsh += [f"        {quoted(name)[:-1]}:{quoted(words)[1:]}" for name, (words, _) in commands.items()]
zsh += ["    )", "    if (( CURRENT == 2 )); then", "        _describe command commands", "        _files", "        return",
        "    fi", "    case $words[2] in"]
for name, (_, options) in commands.items():
    zsh.append(f"    {name}) options=(" +
               " ".join(f"{quoted(n)[:-1]}:{quoted(words)[1:]}" for names, words in options for n in names) + ") ;;")
zsh += ["    esac", '    if [[ $PREFIX == -* ]]; then', "        _describe option options", "    else", "        _files", "    fi",
        "}", '_glint "$@"', ""]

for path, lines in ((share / "bash-completion/completions/glint", bash), (share / "zsh/vendor-completions/_glint", zsh)):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines))
