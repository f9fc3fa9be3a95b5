# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Say what the API reference leaves out: check_documentation.py FOLDER, with Doxygen's xml and html.

Every class says in a few words and in full what it is, and under "Reference" where it comes from, or
that it comes from nowhere else. Every public method has a text; that of a setter of a number or flag
names the default, and the range where there is one. So does every function of the Python package.
No page links to a file or folder that is not there.
"""

import pathlib
import re
import sys
import urllib.parse
import xml.etree.ElementTree as ElementTree

LONG = 120  # characters of a class' text, at least
NUMBERS = {"bool", "int", "double", "float", "vtkIdType", "vtkTypeBool", "unsigned int"}
RANGE = re.compile(r"at least|at most|\bin \[|\bbetween\b|\b(from )?\S+ to \S+|\b[A-Z]+_?[A-Z]{2,}\b|\b0 or 1\b")
# What VTK has in every class and explains itself.
COMMON = {"New", "PrintSelf", "NewInstance", "IsA", "SafeDownCast"}


def text_of(element, *names):
    return " ".join("".join(element.find(name).itertext()) for name in names
                    if element.find(name) is not None).strip()


def name_of(element):
    return element.findtext("compoundname") or element.findtext("name")


def is_inherited(member):
    return "override" in (member.findtext("argsstring") or "")


def set_findings(member, text):
    name = member.findtext("name")
    parameters = member.findall("param")
    types = {"".join(parameter.find("type").itertext()) for parameter in parameters}
    if not re.match(r"Set[A-Z]", name) or not types <= NUMBERS or member.get("static") == "yes":
        return
    if not re.search(r"[Dd]efault|of an index", text):
        yield "names no default"
    if parameters and parameters[0].findtext("declname") == "limited" and not RANGE.search(text):
        yield "names no range"


def member_findings(compound):
    class_name = name_of(compound).split("::")[-1]
    for member in compound.iter("memberdef"):
        name = member.findtext("name")
        is_special = name in COMMON or name.lstrip("~") == class_name or name.startswith("operator")
        if member.get("prot") != "public" or is_special or is_inherited(member):
            continue
        text = text_of(member, "briefdescription", "detaileddescription")
        if not text:
            yield f"{class_name}::{name}: has no text"
        elif member.get("kind") == "function":
            yield from (f"{class_name}::{name}: {finding}" for finding in set_findings(member, text))


def class_findings(compound):
    name = name_of(compound)
    if not text_of(compound, "briefdescription"):
        yield f"{name}: has no @brief"
    if len(text_of(compound, "detaileddescription")) < LONG:
        yield f"{name}: its text is shorter than {LONG} characters"
    titles = [title.text for title in compound.iterfind("detaileddescription//simplesect/title")]
    if "Reference" not in titles:
        yield f'{name}: has no "@par Reference"; where there is none to name, say so there'


def findings(folder):
    count = 0
    for path in sorted(folder.glob("*.xml")):
        for compound in ElementTree.parse(path).getroot().iter("compounddef"):
            is_class = compound.get("kind") == "class" and compound.get("prot") == "public"
            is_package = compound.get("kind") == "namespace" and name_of(compound) == "pellucid"
            if is_class:
                count += 1
                yield from class_findings(compound)
            if is_class or is_package:
                yield from member_findings(compound)
    if count == 0:
        yield f"{folder}: no class is documented"


def dead_links(folder):
    for page in sorted(folder.glob("*.html")):
        for link in sorted(set(re.findall(r'(?:href|src)="([^"#?:]+)[#?"]', page.read_text(encoding="utf-8")))):
            if not (folder / urllib.parse.unquote(link)).exists():
                yield f"{page.name}: links to {link}, which is not there"


root = pathlib.Path(sys.argv[1])
found = [*findings(root / "xml"), *dead_links(root / "html")]
print("\n".join(found))
sys.exit(1 if found else 0)
