"""Checks of arguments. A public function states its types once, as annotations: calls are checked by them, and make-stubs writes the stubs
from them."""
# mypy: ignore-errors
import difflib
import functools
import inspect
import math
import numbers
import os
import typing

from . import _edgescan

Path = typing.Union[str, bytes, os.PathLike[str], os.PathLike[bytes]]
MADE_BY = {"Scan": "edgescan.open() or edgescan.Scan()", "Result": "edgescan.detect()", "Rocks": "edgescan.rocks()",
           "Simulation": "edgescan.simulate()", "Connection": "edgescan.connect()"}
RENAMED = {"first_line": "line_start"}
INSTEAD = {"Rocks": "rocks.table has its rows, and edgescan-cli rocks --csv writes them", "Simulation": "give its scan", "Sweep": "give its scan"}


def name_of(key):
    return key.replace("-", "_")


def given(value):
    """What was given instead, for the end of a sentence."""
    if value is None:
        return "None"
    kind = type(value).__name__
    text = repr(value) if isinstance(value, (str, bytes, numbers.Number)) else ""
    return f"the {kind} {text}" if 0 < len(text) <= 60 else f"an object of type {kind}"


def wrong(name, wanted, value):
    way = INSTEAD.get(type(value).__name__)
    return TypeError(f"{name} must be {wanted}, not {given(value)}" + (f"; {way}" if way else ""))


def is_bool(value):
    return isinstance(value, bool) or type(value).__name__ in ("bool_", "bool")


def number(name, value):
    if not isinstance(value, numbers.Real) or is_bool(value):
        raise wrong(name, "a number", value)
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def whole(name, value):
    if not isinstance(value, numbers.Integral) or is_bool(value):
        raise wrong(name, "a whole number", value)
    return int(value)


def switch(name, value):
    if not is_bool(value):
        raise wrong(name, "True or False", value)
    return bool(value)


def word(name, value, choices=()):
    """A str; the sentence about other types lists the choices. Unknown words are refused with the words that are allowed, by the core."""
    if not isinstance(value, str):
        raise wrong(name, " or ".join(map(repr, choices)) or "a str", value)
    try:
        value.encode()
    except UnicodeEncodeError:
        raise TypeError(f"{name} must be a str of Unicode text, and {ascii(value)} has half of a surrogate pair") from None
    return value


def path(name, value):
    """The bytes of a path, which need not be UTF-8; "file:///a.pcd" is the path /a.pcd."""
    try:
        encoded = os.fsencode(value)
    except TypeError:
        raise wrong(name, "a path: str, bytes or os.PathLike", value) from None
    except UnicodeEncodeError:
        raise TypeError(f"{name} must be a path as os.fsdecode() gives it, and {ascii(value)} is not") from None
    if b"\0" in encoded:
        raise TypeError(f"{name} must be a path, and {ascii(value)} has a NUL character")
    if not encoded:
        refuse("the path is empty", name, "give the name of a file, or leave it out")
    return _edgescan.path_of_address(encoded)


def each(name, wanted, values):
    """The elements as a list."""
    if isinstance(values, (bytes, bytearray, memoryview)):
        raise wrong(name, wanted, values)
    try:
        return list(values)
    except TypeError:
        raise wrong(name, wanted, values) from None


def number_text(name, value):
    return str(int(value)) if isinstance(value, numbers.Integral) and not is_bool(value) else repr(number(name, value))


def ending(path, extension, what, hint=""):
    """The path of a file that is written in this format. Error if its name ends otherwise."""
    if not path.lower().endswith(extension) and not path.startswith(b"/dev/"):
        refuse(what, os.fsdecode(path), f"give a name that ends with {os.fsdecode(extension)}{hint}")
    return path


def typed(name, value, row):
    """The value of a row's keyword: a number, or the text that is typed on the command line. TypeError if its type is not one of the row's."""
    kind, choices = row.get("kind"), row.get("choices") or []
    if kind == "float":
        return number(name, value)
    if kind == "path":
        return path(name, value)
    if kind == "name":
        return word(name, value)
    if kind == "switch" or choices == ["off", "on"]:
        if isinstance(value, str) and value in choices:
            return value
        return "on" if switch(name, value) else "off"
    if isinstance(value, str):
        return word(name, value)
    if kind == "three numbers":
        return ",".join(number_text(name, one) for one in each(name, "a str or three numbers", value))
    if kind == "word" and "minimum" in row and isinstance(value, numbers.Real) and not is_bool(value):
        return number_text(name, value)
    if row.get("several"):
        return ",".join(word(name, one) for one in each(name, "a str or a list of them", value))
    if choices and not choices[0].isdigit():
        return word(name, value, choices)
    return number_text(name, value)


SIMPLE = {Path: path, float: number, int: whole, bool: switch, str: word}


def converted(name, hint, value):
    """The value of an annotated argument. Hints other than those of SIMPLE, classes, Optional and Literal are checked in the function."""
    kinds = typing.get_args(hint)
    if type(None) in kinds:
        if value is None:
            return None
        hint = typing.Union[tuple(kind for kind in kinds if kind is not type(None))]
        kinds = typing.get_args(hint)
    if hint in SIMPLE:
        return SIMPLE[hint](name, value)
    if typing.get_origin(hint) is typing.Literal:
        return word(name, value, kinds)
    classes = kinds or (hint,)
    if all(getattr(kind, "__name__", "") in MADE_BY for kind in classes):
        if not isinstance(value, tuple(classes)):
            raise wrong(name, " or ".join(f"a {kind.__name__}, as {MADE_BY[kind.__name__]} gives it," for kind in classes).rstrip(","), value)
    return value


def help_of(row):
    """One line of a docstring: the keyword, its help and its limits."""
    if row.get("choices"):
        values = ("any of " if row.get("several") else "") + "|".join(row["choices"])
    elif "minimum" in row:
        unit = row.get("unit", "")
        values = (unit + ", " if unit else "") + f"{row['minimum']:g} to {row['maximum']:g}" + (" or auto" if row.get("automatic") else "")
    else:
        values = ""
    if "default" in row:
        values += ("; " if values else "") + f"default {row['default']}"
    return f"    {name_of(row['key'])}: {row.get('help', '')}" + (f" [{values}]" if values else "")


def bound(title, signature, arguments, keywords):
    """The arguments by name. TypeError in one sentence when they do not fit."""
    for name in keywords:
        if name in signature.parameters:
            continue
        near = [RENAMED[name]] if name in RENAMED else difflib.get_close_matches(name, signature.parameters, 1)
        raise TypeError(f"{title}: there is no keyword {name!r}" + (f"; did you mean {near[0]!r}?" if near else ""))
    places = [p.name for p in signature.parameters.values() if p.kind is not p.KEYWORD_ONLY]
    if len(arguments) > len(places):
        count, names = len(arguments) - places.count("self"), [name for name in places if name != "self"]
        allowed = f"at most {len(names)} ({', '.join(names)})" if names else "none"
        by_name = "; all others are given by name" if len(places) < len(signature.parameters) else ""
        raise TypeError(f"{title}: {count} argument{' was' if count == 1 else 's were'} given by place, and it takes {allowed}{by_name}")
    try:
        return signature.bind(*arguments, **keywords)
    except TypeError as error:
        raise TypeError(f"{title}: {error}") from None


def public(function, title="", rows=()):
    """The function with its arguments checked. Keywords of the rows go into its last parameter, by their keys."""
    title = (title or function.__name__) + "()"
    hints = typing.get_type_hints(function)
    rows = {name_of(row["key"]): row for row in rows}
    parameters = [p for p in inspect.signature(function).parameters.values() if p.kind is not p.VAR_KEYWORD]
    parameters += [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None) for name in rows]
    signature = inspect.Signature([p.replace(annotation=p.empty) for p in parameters])

    @functools.wraps(function)
    def checked(*arguments, **keywords):
        values = bound(title, signature, arguments, keywords).arguments
        of_rows = {rows[name]["key"]: typed(f"{title}: {name}", value, rows[name])
                   for name, value in values.items() if name in rows and value is not None}
        own = {name: converted(f"{title}: {name}", hints.get(name), value) for name, value in values.items() if name not in rows}
        return function(**own, **of_rows)

    checked.__signature__ = signature  # as help() shows it
    checked.typed = parameters
    checked.rows = rows
    return checked


def keywords(*tables):
    """A public function whose keywords and help have the rows of these tables, each with its title."""

    def add(function):
        for title, rows in tables:
            function.__doc__ += f"\n    {title}\n\n" + "\n".join(help_of(row) for row in rows) + "\n"
        return public(function, rows=[row for _, rows in tables for row in rows])

    return add


def method(of):
    """A public method of a class that C++ made."""

    def add(function):
        function.__annotations__["self"] = of.__name__
        function.__qualname__ = f"{of.__name__}.{function.__name__}"
        setattr(of, function.__name__, public(function, function.__qualname__))
        return function

    return add


def answers_missing(of):
    """A class whose AttributeError names the attribute that was probably meant."""

    def missing(self, name):
        near = [] if name.startswith("_") else difflib.get_close_matches(name, dir(of), 1)
        raise AttributeError(f"{of.__name__!r} object has no attribute {name!r}" + (f"; did you mean {near[0]!r}?" if near else ""))

    of.__getattr__ = missing


def refuse(what, where, hint):
    """Raises edgescan.Error."""
    _edgescan.refuse(what, where, hint)
