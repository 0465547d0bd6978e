# SPDX-License-Identifier: Apache-2.0
"""What a C compiler makes of the public headers."""

import json
import pathlib
import subprocess
import tempfile

from headers import Interface, read_headers

# How a value is handed over; "other": a pointer, or a struct within another one. size_t is one of
# the fixed widths.
KINDS = {
    "uint8_t": "u8",
    "int32_t": "i32",
    "uint32_t": "u32",
    "uint64_t": "u64",
    "float": "f32",
    "double": "f64",
}
ARRAYS = {"float(*)[2]": "f32[2]", "float(*)[3]": "f32[3]"}


def ask_compiler(compiler: str, include: pathlib.Path) -> dict:
    """functions: {name: number of arguments}; signatures: {name: [result, arguments..]};
    constants: {name: value}; structs: {name: {size, fields: {name: offset}}};
    kinds: {struct: {field: kind}}; defaults: {struct: {field: bytes, in hexadecimal digits}}."""
    source = program(read_headers(include))
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "truth"
        path.with_suffix(".c").write_text(source)
        flags = ["-std=c11", "-Wall", "-Wextra", "-pedantic", "-Werror", f"-I{include}"]
        subprocess.run([compiler, *flags, path.with_suffix(".c"), "-o", path], check=True)
        return json.loads(subprocess.run([path], check=True, capture_output=True).stdout)


def program(interface: Interface) -> str:
    kinds = ", ".join(f'{name}*: "{kind}"' for name, kind in (KINDS | ARRAYS).items()
                      if "(" not in name)
    arrays = ", ".join(f'{name}: "{kind}"' for name, kind in ARRAYS.items())
    return f"""#include <awd/awd.h>
#include <awd/basis.h>
#include <stdio.h>
#define KIND(pointer) _Generic((pointer), {kinds}, {arrays}, default: "other")
{calls(interface)}
static const char* separator = "";
static void begin(const char* name) {{ printf("%s\\"%s\\": {{", separator, name); separator = ""; }}
static void end(void) {{ printf("}}"); separator = ",\\n"; }}
static void word(const char* name, const char* text) {{
  printf("%s\\"%s\\": \\"%s\\"", separator, name, text);
  separator = ", ";
}}
static void number(const char* name, long long value) {{
  printf("%s\\"%s\\": %lld", separator, name, value);
  separator = ", ";
}}
static void bytes(const char* name, const void* from, size_t size) {{
  size_t i;
  printf("%s\\"%s\\": \\"", separator, name);
  for (i = 0; i < size; ++i) printf("%02x", ((const unsigned char*)from)[i]);
  printf("\\"");
  separator = ", ";
}}
static void kinds(const char* name, const char** list, size_t count) {{
  size_t i;
  printf("%s\\"%s\\": [", separator, name);
  for (i = 0; i < count; ++i) printf("%s\\"%s\\"", i ? ", " : "", list[i]);
  printf("]");
  separator = ", ";
}}
int main(void) {{
  printf("{{");
{section("functions", (f'number("{name}", {len(arguments)});'
                       for name, (_, arguments) in interface.functions.items()))}
{section("signatures", (signature(name, *types)
                        for name, types in interface.functions.items()))}
{section("constants", (f'number("{name}", {name});' for name in interface.constants))}
{section("structs", (layout(name, fields) for name, fields in interface.structs.items()))}
{section("kinds", (field_kinds(name, fields) for name, fields in interface.structs.items()))}
{section("defaults", (default(name, macro, interface.structs[name])
                      for name, macro in interface.inits.items()))}
  printf("}}\\n");
  return 0;
}}
"""


def section(name: str, statements) -> str:
    return "\n".join([f'  begin("{name}");', *(f"  {text}" for text in statements), "  end();"])


def calls(interface: Interface) -> str:
    """Never made: they compile if the numbers of arguments are right, since 0 may be any type."""
    lines = [
        f"(void)sizeof(({name}({', '.join('0' for _ in arguments)}), 0));"
        for name, (_, arguments) in interface.functions.items()
    ]
    return "void calls(void);\nvoid calls(void) {\n  " + "\n  ".join(lines) + "\n}"


def kind(type_text: str) -> str:
    return '"void"' if type_text == "void" else f"KIND(({type_text}*)0)"


def signature(name: str, result: str, arguments: list[str]) -> str:
    listed = ", ".join(kind(text) for text in [result, *arguments])
    return f'{{ const char* list[] = {{{listed}}}; kinds("{name}", list, {len(arguments) + 1}); }}'


def layout(name: str, fields: list[str]) -> str:
    offsets = " ".join(f'number("{field}", (long long)offsetof({name}, {field}));'
                       for field in fields)
    return (f'begin("{name}"); number("size", (long long)sizeof({name})); '
            f'begin("fields"); {offsets} end(); end();')


def field_kinds(name: str, fields: list[str]) -> str:
    listed = " ".join(f'word("{field}", KIND(&(({name}*)0)->{field}));' for field in fields)
    return f'begin("{name}"); {listed} end();'


def default(name: str, macro: str, fields: list[str]) -> str:
    listed = " ".join(f'bytes("{field}", &value.{field}, sizeof value.{field});'
                      for field in fields)
    return f'{{ const {name} value = {macro}; begin("{name}"); {listed} end(); }}'
