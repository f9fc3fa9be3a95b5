# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Write the page of all parameters: make_parameters.py PellucidRepresentation.xml parameters.html.

The definitions that ParaView reads are the only source of names, ranges, defaults and meanings.
"""

import html
import sys
import xml.etree.ElementTree as ElementTree

PAGE = """<html>
<head>
<title>Parameters</title>
<link rel="stylesheet" type="text/css" href="pellucid.css">
</head>
<body>
<h1>Parameters of the representation Pellucid</h1>
<p>In Python they are properties of the display that <code>simple.Show()</code> returns. What is told after
drawing: <code>display.UpdatePropertyInformation()</code>, then
<code>display.GetPropertyValue("Fragments")</code>.</p>
{sections}
</body>
</html>
"""

SECTION = """<h2>{title}</h2>
<table>
<tr><th width="17%">In the panel</th><th width="25%">In Python</th><th width="14%">Range</th>
<th width="10%">Default</th><th width="34%">Meaning</th></tr>
{rows}
</table>"""

ROW = "<tr><td>{label}</td><td><code>{name}</code></td><td>{range}</td><td>{default}</td><td>{text}</td></tr>"


def is_information(element):
    return element.get("information_only") == "1"


def is_advanced(element):
    return element.get("panel_visibility") == "advanced" and not is_information(element)


def is_default(element):
    return not is_advanced(element) and not is_information(element)


SECTIONS = [
    ("Shown at first", is_default),
    ("Shown as advanced properties", is_advanced),
    ("Told after drawing, in Python", is_information),
]


def entries(element):
    """The texts of an enumeration by their values."""
    return {entry.get("value"): entry.get("text") for entry in element.iter("Entry")}


def range_of(element):
    if is_information(element):
        return ""
    if entries(element):
        return ", ".join(entries(element).values())
    if element.find("BooleanDomain") is not None:
        return "on, off"
    for domain in ("DoubleRangeDomain", "IntRangeDomain"):
        limits = element.find(domain)
        if limits is not None and limits.get("max"):
            return f"{limits.get('min')} to {limits.get('max')}"
        if limits is not None:
            return f"at least {limits.get('min')}"
    if element.find("ArrayListDomain") is not None:
        return "a point array of one component"
    return ""


def default_of(element):
    default = element.get("default_values")
    if is_information(element):
        return ""
    if entries(element):
        return entries(element)[default]
    if element.find("BooleanDomain") is not None:
        return "on" if default == "1" else "off"
    if element.find("ArrayListDomain") is not None:
        return default.split()[-1] if default else "None"
    return default


def row_of(element):
    texts = {
        "label": element.get("label", ""),
        "name": element.get("name"),
        "range": range_of(element),
        "default": default_of(element),
        "text": " ".join(element.find("Documentation").text.split()),
    }
    return ROW.format(**{key: html.escape(text) for key, text in texts.items()})


definitions, page = sys.argv[1:]
root = ElementTree.parse(definitions).getroot()
properties = [
    element
    for element in root.find("ProxyGroup/PellucidRepresentationProxy")
    if element.tag.endswith("Property")
]
sections = [
    SECTION.format(title=title, rows="\n".join(row_of(each) for each in properties if belongs(each)))
    for title, belongs in SECTIONS
]
with open(page, "w", encoding="ascii") as file:
    file.write(PAGE.format(sections="\n".join(sections)))
