# SPDX-License-Identifier: Apache-2.0
"""What the public headers declare, read by regular expressions from what the C preprocessor makes
of them, and laid out by the C compiler. What is not understood is an error: nothing is skipped."""
import os
import re
import subprocess
import tempfile
from typing import NamedTuple

INCLUDE = os.environ["AWD_INCLUDE"]
CC = os.environ.get("AWD_CC", "cc")
FOLDER = os.path.join(INCLUDE, "awd")

# Macros of the headers that are no numbers.
NO_NUMBERS = re.compile(r"AWD_(CALL|EXPORT|NOEXCEPT|LEVEL|BASIS_ENTRY|\w+_INIT|\w+_H)$")


class Header(NamedTuple):
    functions: dict  # name: (result type, [argument types])
    structs: dict  # name: [field]
    constants: list  # names
    inits: dict  # struct: macro that initialises it
    types: dict  # name of a type: "handle", "callback" or the type it stands for


def preprocessed():
    """The declarations of our headers alone; AWD_EXPORT has become EXPORTED."""
    text = "#include <awd/awd.h>\n#include <awd/basis.h>\n"
    command = [CC, "-E", "-x", "c", "-std=c99", "-D__attribute__(x)=EXPORTED", "-I", INCLUDE, "-"]
    run = subprocess.run(command, input=text, capture_output=True, text=True, check=True)
    ours, lines = False, []
    for line in run.stdout.splitlines():
        marker = re.match(r'# \d+ "(.*?)"', line)
        if marker:
            ours = os.path.dirname(marker[1]) == FOLDER
        elif ours:
            lines.append(line)
    return " ".join(" ".join(lines).split())


def statements(text):
    """Split at the semicolons outside of braces."""
    depth, start = 0, 0
    for i, letter in enumerate(text):
        depth += (letter == "{") - (letter == "}")
        if letter == ";" and depth == 0:
            yield text[start:i].strip()
            start = i + 1
    if text[start:].strip():
        raise ValueError(f"not understood: {text[start:]}")


def argument_types(text):
    """Of "const float p[3], size_t n": ["const float*", "size_t"]."""
    if text.strip() in ("void", ""):
        return []
    types = []
    for argument in text.split(","):
        match = re.fullmatch(r"\s*((?:const |struct )*\w+(?: ?\*(?: const)?)*) ?(\w+)(\[\d*\])?\s*",
                             argument)
        if not match:
            raise ValueError(f"argument not understood: {argument}")
        types.append(match[1].replace(" *", "*") + ("*" if match[3] else ""))
    return types


def field_names(text):
    names = []
    for field in filter(None, (part.strip() for part in text.split(";"))):
        callback = re.fullmatch(r"[\w *]+\( ?\* ?(\w+)\)\(.*\)", field)
        plain = re.fullmatch(r"(?:const |struct )*\w+(?: ?\*(?: const)?)* ?(\w+(?:\[\d+\])?(?:, "
                             r"\w+(?:\[\d+\])?)*)", field)
        if callback:
            names.append(callback[1])
        elif plain:
            names += [re.sub(r"\[.*", "", name) for name in plain[1].split(", ")]
        else:
            raise ValueError(f"field not understood: {field}")
    return names


def read():
    header = Header({}, {}, [], {}, {})
    for statement in statements(preprocessed()):
        for pattern, take in PATTERNS:
            match = re.fullmatch(pattern, statement)
            if match:
                take(header, match)
                break
        else:
            raise ValueError(f"declaration not understood: {statement}")
    read_macros(header)
    return header


def take_enum(header, match):
    for item in match[1].split(","):
        name = re.fullmatch(r"\s*(AWD_\w+) = [^,]+", item)
        if name:
            header.constants.append(name[1])
        elif item.strip():
            raise ValueError(f"enumerator not understood: {item}")


def take_function(header, match):
    # The entry point of plugins is theirs.
    if match[2] != "awdBasisModule_v1":
        header.functions[match[2]] = (match[1].strip(), argument_types(match[3]))


PATTERNS = [
    (r"typedef (u?int\d+_t) (AWD\w+)", lambda h, m: h.types.update({m[2]: m[1]})),
    (r"typedef struct \w+Impl\* ?(AWD\w+)", lambda h, m: h.types.update({m[1]: "handle"})),
    (r"typedef [\w *]+\( ?\* ?(AWD\w+)\)\(.*\)", lambda h, m: h.types.update({m[1]: "callback"})),
    (r"enum \{(.*)\}", take_enum),
    (r"typedef struct (\w+) \{(.*)\} \1", lambda h, m: h.structs.update({m[1]: field_names(m[2])})),
    (r"struct \w+", lambda h, m: None),
    (r"EXPORTED ((?:const |struct )*\w+(?: ?\*)?) ?(\w+)\((.*)\)", take_function),
]


def read_macros(header):
    """Those defined in all languages are numbers; those for C and C++ initialise a struct."""
    for name in sorted(os.listdir(FOLDER)):
        if not name.endswith(".h"):
            continue
        with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
            text = re.sub(r"\\\n", " ", file.read())
        for macro, value in re.findall(r"^ *# *define +(AWD\w+)(.*)$", text, re.M):
            struct = re.match(r" +(AWD\w+) \{", value)
            if struct and macro.endswith("_INIT"):
                header.inits[struct[1]] = macro
            elif not NO_NUMBERS.match(macro):
                header.constants.append(macro)


def compiled(header):
    """Values of the constants, sizes, offsets and initial bytes, as the C compiler has them."""
    lines = ["#include <awd/awd.h>", "#include <awd/basis.h>", "#include <stdio.h>",
             "int main(void) {"]
    for name in header.constants:
        lines.append(f'  printf("constant {name} %lld\\n", (long long)({name}));')
    for struct, fields in header.structs.items():
        lines.append(f'  printf("size {struct} %zu\\n", sizeof({struct}));')
        for field in fields:
            offset = f"offsetof({struct}, {field})"
            lines.append(f'  printf("offset {struct} {field} %zu\\n", {offset});')
    for struct, macro in header.inits.items():
        lines.append(f"  {{ static const {struct} value = {macro};")
        lines.append("    const unsigned char* bytes = (const unsigned char*)&value;")
        lines.append(f'    printf("init {struct} ");')
        lines.append("    for (size_t i = 0; i < sizeof value; ++i) printf(\"%02x\", bytes[i]);")
        lines.append('    printf("\\n"); }')
    lines.append("  return 0;\n}\n")
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "layout.c")
        with open(source, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
        program = os.path.join(folder, "layout")
        subprocess.run([CC, "-std=c99", "-Wall", "-Werror", "-I", INCLUDE, source, "-o", program],
                       check=True)
        output = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    values = {"constants": {}, "structs": {}, "inits": {}}
    for line in output.splitlines():
        kind, name, *rest = line.split()
        if kind == "constant":
            values["constants"][name] = int(rest[0])
        elif kind == "size":
            values["structs"][name] = {"size": int(rest[0]), "fields": {}}
        elif kind == "offset":
            values["structs"][name]["fields"][rest[0]] = int(rest[1])
        else:
            values["inits"][name] = bytes.fromhex(rest[0])
    return values
