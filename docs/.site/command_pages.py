"""The pages of the programs' commands and options, from click: one for each command."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import click
from cells import cell, code, escaped


def pages(programs: Mapping[str, click.Command]) -> dict[str, str]:
    """Text of each page by the file's name: the overview, then each program's own page and those of its commands."""
    index = ["# Command reference", "", "Generated from the programs; the same as `COMMAND --help`.", ""]
    texts: dict[str, list[str]] = {"index.md": index}
    for program, command in programs.items():
        index += [f"## {program}", "", "| command | does |", "|---|---|"]
        for name, below, context in commands(command, context_of(command, program)):
            depth = name.count(" ")
            if depth <= 1:
                page = name.replace(" ", "-") + ".md"
                texts[page] = []
                index.append(f"| [`{name}`]({page}) | {cell(escaped(below.get_short_help_str(limit=200)))} |")
            texts[page] += [f"{'#' if depth <= 1 else '##'} {name}", "", *command_section(below, context)]
        index.append("")
    return {name: "\n".join(lines).rstrip() + "\n" for name, lines in texts.items()}


def commands(command: click.Command, context: click.Context) -> Iterator[tuple[str, click.Command, click.Context]]:
    """(full name, command, context) of a command and of all below it that are not hidden."""
    yield context.command_path, command, context
    for name in command.list_commands(context) if isinstance(command, click.Group) else ():
        below = command.get_command(context, name)
        if below is not None and not below.hidden:
            yield from commands(below, context_of(below, name, context))


def context_of(command: click.Command, name: str, parent: click.Context | None = None) -> click.Context:
    """The context in which a command's help is written."""
    return click.Context(command, info_name=name, parent=parent, **command.context_settings)


def command_section(command: click.Command, context: click.Context) -> list[str]:
    """Usage and text as the terminal shows them, then a table of options."""
    context.terminal_width = context.max_content_width = 110
    formatter = context.make_formatter()
    command.format_usage(context, formatter)
    command.format_help_text(context, formatter)
    lines = ["```text", formatter.getvalue().rstrip(), "```", ""]
    records = [record for param in command.get_params(context) if (record := param.get_help_record(context))]
    lines += ["| option | meaning |", "|---|---|"]
    lines += [f"| {code(option)} | {cell(escaped(meaning))} |" for option, meaning in records]
    return [*lines, ""]
