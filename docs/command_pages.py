"""For docs/make-manual: a page for each command and one for the settings, made from the help of the programs, so that they are never out of date."""
import os
import re
import subprocess

FOLDER = "reference/commands"
PAGE = ".md"
SETTINGS = "reference/settings" + PAGE


def help_of(programs, *words):
    program = os.path.join(programs, words[0])
    said = subprocess.run([program, *words[1:], "--help"], check=True, stdout=subprocess.PIPE, text=True).stdout
    return said.replace(program, words[0])


def sections(said):
    """The summary of a help, its usage, and for each heading the rows (what to type, what it means)."""
    lines = said.split("\n")
    usage = next((n for n, line in enumerate(lines) if line.startswith("Usage:")), 0)
    parts = []
    for line in lines[usage + 1:]:
        if line and not line.startswith(" "):
            parts.append((line.rstrip(":"), []))
        elif re.match(r"  \S", line) and parts:
            typed, _, meaning = line.strip().partition("  ")
            parts[-1][1].append([typed, meaning.strip()])
        elif line.strip() and parts and parts[-1][1]:
            parts[-1][1][-1][1] = (parts[-1][1][-1][1] + " " + line.strip()).strip()
    return " ".join(lines[:usage]).strip(), lines[usage].replace("Usage:", "").strip(), [part for part in parts if part[1]]


def table(head, rows):
    def field(text):
        return text.replace("|", "&#124;").replace("<", "&lt;").replace("*", "&#42;")
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] + ["| " + " | ".join(map(field, row)) + " |" for row in rows]) + "\n"


def typed_text(typed):
    """"--lines NUMBER 0..10=0" of a help as "--lines NUMBER 0..10=0" in code; a choice in braces is separated by strokes in a field of a table."""
    return "<code>%s</code>" % typed.replace("|", "&#124;").replace("<", "&lt;")


def flag_table(rows, first="type"):
    text = table([first, "meaning"], [["@%d@" % n, meaning] for n, (_, meaning) in enumerate(rows)])
    for n, (typed, _) in enumerate(rows):
        text = text.replace("@%d@" % n, typed_text(typed))
    return text


def examples(command, said, texts):
    """The examples of the help, and lines of the guide that call the command, each with the page that explains it: tests run both."""
    found = {line: None for line in said if line.startswith(command + " ")}
    for page, text in texts.items():
        if os.path.dirname(page) != "guide":
            continue
        for block in re.findall(r"```\n(.*?)```", text, re.S):
            for line in block.split("\n"):
                if line.startswith(command + " ") and line not in found:
                    found[line] = page
    return found


def command_page(command, said, texts):
    summary, usage, parts = sections(said)
    shown = [typed for heading, rows in parts if heading == "Examples" for typed, _ in rows]
    page = "# %s\n\n%s\n\n```\n%s\n```\n" % (command, summary, usage)
    calls = examples(command, shown, texts)
    if calls:
        page += "\n## Examples\n"
        for line, source in calls.items():
            page += "\n```\n%s\n```\n" % line
            if source:
                page += "\nSee [%s](../../%s).\n" % (texts[source].split("\n", 1)[0].lstrip("# "), source)
    for heading, rows in parts:
        if heading == "Examples" or [typed for typed, _ in rows] == ["-h,--help"]:
            continue
        if heading == "Method":
            page += "\n## Method\n\nThe flags of the method are the [settings](../settings%s).\n" % PAGE
        else:
            page += "\n## %s\n\n%s" % (heading, flag_table(rows, "code" if heading == "Exit codes" else "type"))
    return page


def settings_page(said):
    rows = []
    for typed, meaning in next(part for heading, part in sections(said)[2] if heading == "Method"):
        limits = re.search(r" ?\[([^\]]*)\]$", meaning)
        values, _, default = (limits.group(1) if limits else "").rpartition("; default ")
        rows.append(["@%s@" % typed.split()[0], meaning[:limits.start()] if limits else meaning, values.replace("|", ", "), default.replace(",", ", ")])
    text = table(["flag", "meaning", "values", "default"], rows)
    text = re.sub(r"@(--[a-z0-9-]+)@", r"<code>\1</code>", text)
    return ("# Settings\n\nPresets, records and Python use the same names: `min-length` in a preset, `min_length=` in Python. "
            "[Tune the edges](../guide/tune%s) explains the important ones.\n\n%s" % (PAGE, text))


def command_pages(programs, texts):
    """Paths and texts of the pages, for the programs in the folder `programs`; `texts` are the other pages."""
    made = {}
    for program in ("edgescan", "edgescan-cli", "edgescan-lab"):
        if not os.path.isfile(os.path.join(programs, program)):
            continue
        said = help_of(programs, program)
        _, _, parts = sections(said)
        commands = [typed for heading, rows in parts if heading != "Examples" for typed, _ in rows if re.fullmatch("[a-z]+", typed)]
        if not commands:
            made[os.path.join(FOLDER, program + PAGE)] = command_page(program, said, texts)
        for name in commands:
            one = help_of(programs, program, name)
            made[os.path.join(FOLDER, program + "-" + name + PAGE)] = command_page("%s %s" % (program, name), one, texts)
            if (program, name) == ("edgescan-cli", "detect"):
                made[SETTINGS] = settings_page(one)
    return made
