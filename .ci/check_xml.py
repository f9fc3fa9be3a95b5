# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Say what is wrong with server-manager files: not well-formed, or a part without documentation.

Every proxy needs a short and a long help, every property with a command a text.
"""

import sys
import xml.etree.ElementTree as ElementTree


def findings(path):
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        yield str(error)
        return
    for element in root.iter():
        documentation = element.find("Documentation")
        if element.tag.endswith("Proxy") and element.get("class"):
            if documentation is None or not (
                    documentation.get("short_help") and documentation.get("long_help")):
                yield f"proxy {element.get('name')} has no short_help or no long_help"
        elif element.tag.endswith("Property") and element.get("command"):
            if documentation is None or not (documentation.text or "").strip():
                yield f"property {element.get('name')} has no documentation"


for file in sys.argv[1:]:
    for finding in findings(file):
        print(f"{file}: {finding}")
