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

