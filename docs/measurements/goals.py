"""Whether a measured figure reaches its goal, for the tables of the pages beside this file."""
import re


def numbers(text):
    return [float(number) for number in re.findall(r"\d*\.?\d+", text)]


def reached(goal, measured, less_is_better=False):
    """"yes", "no", or "in part" where the texts hold several figures; empty without a goal. A goal of one figure holds for all measured ones."""
    goals, figures = numbers(goal), numbers(measured)
    if not goals or not figures:
        return ""
    met = [(figure <= goals[n % len(goals)]) if less_is_better else (figure >= goals[n % len(goals)]) for n, figure in enumerate(figures)]
    return "yes" if all(met) else "in part" if any(met) else "no"


def with_verdicts(text):
    """The tables of edgescan-bench with a last column "reached" where they have the columns "at least" and "aim"."""
    lines, head = [], None
    for line in text.split("\n"):
        fields = [field.strip() for field in line.strip("|").split("|")] if line.startswith("|") else None
        if fields is None:
            head = None
        elif head is None and "at least" in fields:
            head = fields
            line += " reached |"
        elif head is not None and set(line) <= set("|-"):
            line += "---|"
        elif head is not None:
            least, aim = fields[head.index("at least")], fields[head.index("aim")]
            measured = " ".join(fields[1:head.index("at least")])
            down = bool(least) and bool(aim) and float(aim) < float(least)
            line += " %s |" % reached(least, measured, down)
        lines.append(line)
    return "\n".join(lines)
