# SPDX-License-Identifier: Apache-2.0
"""What the public headers declare, read from their text."""

import dataclasses
import pathlib
import re

# Declared for plugins to define; libawd does not export it.
PLUGIN_ENTRY = "AWD_BASIS_ENTRY"


@dataclasses.dataclass
class Interface:
    functions: dict[str, tuple[str, list[str]]]  # name: type of the result, types of the arguments
    constants: list[str]
    structs: dict[str, list[str]]  # name: fields
    inits: dict[str, str]  # struct: the macro that initialises it


class HeaderError(Exception):
    """Text that is not understood: better told than passed over."""


def read_headers(folder: pathlib.Path) -> Interface:
    """All of awd/*.h in an include folder."""
    paths = sorted((folder / "awd").glob("*.h"))
    if not paths:
        raise HeaderError(f"no headers in {folder / 'awd'}")
    interface = Interface({}, [], {}, {})
    for path in paths:
        try:
            add_header(interface, path.read_text())
        except HeaderError as error:
            raise HeaderError(f"{path.name}: {error}") from error
    return interface


def add_header(interface: Interface, text: str) -> None:
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL).replace("\\\n", " ")
    directives = [line for line in text.splitlines() if line.startswith("#")]
    code = "\n".join(line for line in text.splitlines() if not line.startswith("#"))
    add_macros(interface, directives)
    add_enumerators(interface, code)
    add_structs(interface, code)
    add_functions(interface, code)


def add_macros(interface: Interface, directives: list[str]) -> None:
    """Those that are numbers are constants; those of braces, with sizeof, initialise a struct."""
    for line in directives:
        match = re.match(r"#\s*define (AWD_\w+)\s+(\S.*)", line)
        if not match:
            continue
        name, body = match.groups()
        initialised = re.search(r"\{\s*sizeof\((AWD\w+)\)", body)
        if name.endswith("_INIT"):
            if not initialised:
                raise HeaderError(f"{name} has no sizeof of its struct")
            interface.inits[initialised.group(1)] = name
        elif re.fullmatch(r"[-+*()\s]*(?:(?:0x[0-9A-Fa-f]+|\d+|AWD_\w+)[uUlL]*[-+*()\s]*)+", body):
            interface.constants.append(name)


def add_enumerators(interface: Interface, code: str) -> None:
    for body in re.findall(r"\benum\s*\w*\s*\{(.*?)\}", code, re.DOTALL):
        for item in filter(None, (part.strip() for part in body.split(","))):
            match = re.fullmatch(r"(AWD_\w+)\s*=\s*\S.*", item)
            if not match:
                raise HeaderError(f"not an enumerator with its value: {item}")
            interface.constants.append(match.group(1))


def add_structs(interface: Interface, code: str) -> None:
    found = re.findall(r"typedef struct (AWD\w+)\s*\{(.*?)\}\s*\1\s*;", code, re.DOTALL)
    if len(found) != len(re.findall(r"\bstruct\s+\w*\s*\{", code)):
        raise HeaderError("a struct that is not `typedef struct AWDName {..} AWDName;`")
    for name, body in found:
        interface.structs[name] = [
            field
            for member in filter(None, (part.strip() for part in body.split(";")))
            for field in field_names(member)
        ]


def field_names(member: str) -> list[str]:
    """Of `float u, v`, `float at[3]` or `void(AWD_CALL* eval)(double x)`."""
    function = re.match(r"[\w\s*]+\(\s*AWD_CALL\s*\*\s*(\w+)\s*\)\s*\(", member)
    if function:
        return [function.group(1)]
    names = [re.search(r"(\w+)\s*(?:\[\w+\]\s*)*$", part) for part in member.split(",")]
    if "(" in member or not all(names):
        raise HeaderError(f"not a field: {member}")
    return [match.group(1) for match in names]


def add_functions(interface: Interface, code: str) -> None:
    found = re.findall(
        r"\bAWD_EXPORT\s+([^;()]*?)\bAWD_CALL\s+(\w+)\s*\(([^;()]*)\)\s*AWD_NOEXCEPT\s*;", code
    )
    if len(found) != len(re.findall(r"\bAWD_EXPORT\b", code)):
        raise HeaderError("a function that is not `AWD_EXPORT T AWD_CALL name(..) AWD_NOEXCEPT;`")
    for result, name, arguments in found:
        if name == PLUGIN_ENTRY:
            continue
        listed = [] if arguments.strip() in ("", "void") else arguments.split(",")
        interface.functions[name] = (result.strip(), [argument_type(text) for text in listed])


def argument_type(argument: str) -> str:
    """Of `const float at[3]`, which is a pointer, or `AWDScene scene`."""
    match = re.fullmatch(r"\s*(.*?[\s*])(\w+)\s*(\[\w*\])?\s*", argument, re.DOTALL)
    if not match:
        raise HeaderError(f"not an argument: {argument}")
    return match.group(1).strip() + ("*" if match.group(3) else "")
