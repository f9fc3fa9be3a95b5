# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the documentation agree with what ParaView shows and with what the sources say."""

import os
import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree

from paraview import servermanager

from plugin import load_plugin

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = pathlib.Path(os.environ["PELLUCID_DOCUMENTATION"])


def page(name):
    text = (PAGES / name).read_text(encoding="ascii")
    return re.sub(r"<link[^>]*>", "", text)


def rows():
    """The cells of the table of parameters by the name in Python."""
    cells = [
        ["".join(cell.itertext()) for cell in row.iter("td")]
        for row in ElementTree.fromstring(page("parameters.html")).iter("tr")
    ]
    return {row[1]: row for row in cells if row}


def sources():
    """All strings of the sources, with those joined that stand side by side."""
    text = "".join(
        file.read_text(encoding="ascii")
        for folder in ("Filters", "Rendering", "Plugin")
        for file in sorted((ROOT / folder).rglob("*.cxx"))
    )
    return re.sub(r'"\s*"', "", text)


class TestPluginDocumentation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        load_plugin()

    def test_every_parameter_is_in_the_table_with_its_default(self):
        display = servermanager.CreateProxy("representations", "PellucidRepresentation")
        own = ElementTree.parse(ROOT / "Plugin/Representations/PellucidRepresentation.xml")
        exposed = [each.get("name") for each in own.find(".//PropertyGroup").iter("Property")]
        table = rows()
        self.assertEqual(sorted(table), sorted(exposed))
        wrapped = servermanager._getPyProxy(display)
        for name, (label, _, _, default, text) in table.items():
            with self.subTest(name):
                each = display.GetProperty(name)
                self.assertTrue(text)
                if each.GetInformationOnly():
                    continue
                self.assertEqual(label, each.GetXMLLabel())
                value = wrapped.GetProperty(name)
                self.assertIn(str(value).strip("[]', "), self.spellings(default))

    @staticmethod
    def spellings(default):
        """As Python may show what the page calls a default."""
        numbers = {"on": "1", "off": "0"}.get(default, default)
        spelled = {default, numbers}
        try:
            spelled.add(", ".join(str(float(number)) for number in numbers.split()))
        except ValueError:
            pass
        return spelled

    def test_messages_are_those_of_the_sources(self):
        said = sources()
        messages = re.findall('<td class="message">(.*?)</td>', page("messages.html"), re.DOTALL)
        self.assertGreater(len(messages), 10)
        for message in messages:
            for part in message.split("..."):
                self.assertIn(part.strip(), said)

    def test_links_lead_to_pages(self):
        for name in ("index.html", "limits.html", "messages.html", "parameters.html"):
            for target in re.findall('href="(.*?)"', (PAGES / name).read_text(encoding="ascii")):
                self.assertTrue((PAGES / target).exists(), (name, target))


if __name__ == "__main__":
    unittest.main()
