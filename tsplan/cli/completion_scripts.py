"""Scripts for shells, made from the words that a command line may have."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from tsplan.cli.parser_words import Command, Option, Value

_BASH = """\
_tsplan() {{
    local IFS=$'\\n' word=${{COMP_WORDS[COMP_CWORD]}} words= files=
    if [ "$COMP_CWORD" -eq 1 ]; then
        words={commands}
    else
        case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}" in
{values}
            *) case "${{COMP_WORDS[1]}} $word" in
{places}
            esac;;
        esac
    fi
    COMPREPLY=($(compgen -W "$words" -- "$word"))
    if [ -n "$files" ]; then COMPREPLY+=($(compgen -f -- "$word")); fi
}}
complete -o filenames -F _tsplan tsplan
"""


def bash_script(commands: Iterable[Command]) -> str:
    """For bash, from 3.2 on."""
    every = tuple(commands)
    values = [
        f"            {_either(f'{command.name} {name}' for name in option.names)}) "
        f"{_bash_value(option.value)};;"
        for command in every
        for option in command.options
        if option.value is not None
    ]
    places = [line for command in every for line in _bash_places(command)]
    return _BASH.format(
        commands=_lines(command.name for command in every),
        values="\n".join(values),
        places="\n".join(places),
    )


def _bash_places(command: Command) -> Iterator[str]:
    names = _lines(name for option in command.options for name in option.names)
    yield f"                {_quoted(command.name + ' -')}*) words={names};;"
    yield f"                {_quoted(command.name + ' ')}*) {_bash_value(command.value)};;"


def _bash_value(value: Value) -> str:
    return f"words={_lines(value.words)} files={'yes' if value.file else ''}"


def _either(texts: Iterable[str]) -> str:
    return "|".join(map(_quoted, texts))


def _lines(words: Iterable[str]) -> str:
    return _quoted("\n".join(words)).replace("\n", "'$'\\n''")


def _quoted(text: str) -> str:
    """A text in single quotes for bash and zsh."""
    return "'" + text.replace("'", "'\\''") + "'"


_ZSH = """\
#compdef tsplan
_tsplan() {{
    local -a commands=(
{commands}
    )
    if (( CURRENT == 2 )); then
        _describe command commands
        return
    fi
    local command=$words[2]
    shift words
    (( CURRENT -= 1 ))
    case $command in
{cases}
    esac
}}
compdef _tsplan tsplan
"""


def zsh_script(commands: Iterable[Command]) -> str:
    """For zsh, after `compinit`."""
    every = tuple(commands)
    described = (
        f"        {_quoted(command.name + ':' + command.help.replace(':', chr(92) + ':'))}"
        for command in every
    )
    return _ZSH.format(
        commands="\n".join(described), cases="\n".join(_zsh_case(command) for command in every)
    )


def _zsh_case(command: Command) -> str:
    options = [
        _quoted(f"*{name}[{_zsh_text(option.help)}]{_zsh_value(option.value)}")
        for option in command.options
        for name in option.names
    ]
    places = _quoted(f"*{_zsh_value(command.value)}")
    return f"        {command.name}) _arguments {' '.join([*options, places])};;"


def _zsh_text(text: str) -> str:
    for letter in "\\[]:":
        text = text.replace(letter, "\\" + letter)
    return text


def _zsh_value(value: Value | None) -> str:
    if value is None:
        return ""
    words = f"({' '.join(value.words)})"
    if value.words and value.file:
        return f":value:{{_alternative 'words:word:{words}' 'files:file:_files'}}"
    if value.words:
        return f":value:{words}"
    return ":value:_files" if value.file else ":value: "


def fish_script(commands: Iterable[Command]) -> str:
    """For fish."""
    lines = ["complete -c tsplan -f"]
    for command in commands:
        first = f"complete -c tsplan -n __fish_use_subcommand -a {command.name}"
        lines.append(f"{first} -d {_fish(command.help)}")
        seen = f"complete -c tsplan -n '__fish_seen_subcommand_from {command.name}'"
        if command.value.words:
            lines.append(f"{seen} -a {_fish(' '.join(command.value.words))}")
        if command.value.file:
            lines.append(f"{seen} -F")
        lines += [f"{seen} {_fish_option(option)}" for option in command.options]
    return "\n".join(lines) + "\n"


def _fish_option(option: Option) -> str:
    names = [f"-l {name[2:]}" if name[:2] == "--" else f"-s {name[1:]}" for name in option.names]
    value = []
    if option.value is not None:
        value = ["-r -F"] if option.value.file else ["-x"]
        if option.value.words:
            value.append(f"-a {_fish(' '.join(option.value.words))}")
    return " ".join([*names, *value, f"-d {_fish(option.help)}"])


def _fish(text: str) -> str:
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


SCRIPTS: Mapping[str, Callable[[Iterable[Command]], str]] = {
    "bash": bash_script,
    "zsh": zsh_script,
    "fish": fish_script,
}
"""What writes the script of each shell."""
