"""What a reader of the plugin's help finds: pages, sentences, and defaults that are the true ones."""
import io
import os
import re
import sqlite3
import unittest
from contextlib import redirect_stdout

from paraview import servermanager, simple

import galaxy_testing as gt
import plugin_xml

gt.load_plugin()
HELP = os.environ.get("GALAXY_HELP")  # the build's help pages; empty where it has none
HELPERS = {"IntVectorProperty": "SimpleIntInformationHelper",
           "DoubleVectorProperty": "SimpleDoubleInformationHelper",
           "StringVectorProperty": "SimpleStringInformationHelper"}
# Where a proxy's settings are members of another class than its own.
GETTERS = {"SplatSettings": "vtkSplatSettings", "Splats": "vtkSplatProp"}
ANNOTATION = ("ScaleBar", "Compass", "Labels")  # of Splats: members of vtkSkyAnnotation
WITHOUT = ("AnnotationColor",)  # which is the Color of two classes
UNREAD = -7777
UNITS = r"(?i)\b(kpc|pc\^2|mpc|km/s|arcsec|degrees|myr|seconds|pixels)\b"
# Numbers without one, or of one that depends on the data.
WITHOUT_UNIT = ("Spheroid.Luminosity", "FITSReader.MaskValues")


def with_getters():
    """(proxy, class, properties) that are set by commands SetX of a class that has GetX."""
    for _, name, proxy in plugin_xml.proxies():
        found = [
            p for p in plugin_xml.own_properties(proxy)
            if p.tag in HELPERS and p.get("command").startswith("Set")
            and not p.get("repeat_command") and p.get("name") not in WITHOUT
        ]
        if name == "Splats":
            shown = [p for p in found if p.get("name") in ANNOTATION]
            found = [p for p in found if p not in shown]
            yield name, "vtkSkyAnnotation", shown
        if found and name != "SplatsRepresentation":
            yield name, GETTERS.get(name) or proxy.get("class"), found


def fresh(name, class_name, properties):
    """A proxy of a new object of the class that reads its values and sets none."""
    lines = []
    for prop in properties:
        size = int(prop.get("number_of_elements"))
        lines.append(  # the default stays where there is nothing to read
            f'<{prop.tag} name="{prop.get("name")}" command="G{prop.get("command")[1:]}"'
            f' information_only="1" number_of_elements="{size}"'
            f' default_values="{" ".join([str(UNREAD)] * size)}">'
            f"<{HELPERS[prop.tag]} /></{prop.tag}>"
        )
    text = (
        '<ServerManagerConfiguration><ProxyGroup name="fresh">'
        f'<Proxy name="{name}" class="{class_name}">{"".join(lines)}</Proxy>'
        "</ProxyGroup></ServerManagerConfiguration>"
    )
    manager = servermanager.ProxyManager().SMProxyManager
    manager.GetProxyDefinitionManager().LoadConfigurationXMLFromString(text)
    proxy = manager.NewProxy("fresh", name)
    proxy.UpdateVTKObjects()
    proxy.UpdatePropertyInformation()
    return proxy


def values_of(prop):
    return [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]


class Defaults(unittest.TestCase):
    def test_are_those_of_the_classes(self):
        count = 0
        for name, class_name, properties in with_getters():
            proxy = fresh(name, class_name, properties)
            for prop in properties:
                what, given = f"{name}.{prop.get('name')}", prop.get("default_values") or ""
                is_text = prop.tag == "StringVectorProperty"
                values = values_of(proxy.GetProperty(prop.get("name")))
                values = [value or "" for value in values] if is_text else values
                self.assertEqual(values, [given] if is_text else [float(v) for v in given.split()], what)
                count += 1
        self.assertGreater(count, 100)


class Sentences(unittest.TestCase):
    def good(self, text, what):
        text = " ".join((text or "").split())
        self.assertTrue(text.endswith("."), f"{what}: {text!r}")
        # Two of them become emphasis in ParaView's pages.
        self.assertLess(text.count("*"), 2, what)

    def test_every_proxy_and_property_is_described(self):
        for group, name, proxy in plugin_xml.proxies():
            documentation = proxy.find("Documentation")
            self.assertIsNotNone(documentation, name)
            self.good(documentation.text, name)
            if group in ("sources", "filters", "writers"):
                self.good(documentation.get("short_help"), name)
                self.good(documentation.get("long_help"), name)
                self.assertTrue(proxy.get("label"), name)
            for prop in plugin_xml.own_properties(proxy):
                what = f"{name}.{prop.get('name')}"
                self.assertIsNotNone(prop.find("Documentation"), what)
                self.good(prop.find("Documentation").text, what)

    def test_information_is_advanced_and_numbers_have_a_domain(self):
        for _, name, proxy in plugin_xml.proxies():
            for prop in plugin_xml.own_properties(proxy):
                what = f"{name}.{prop.get('name')}"
                if prop.get("information_only"):
                    self.assertIn(prop.get("panel_visibility"), ("advanced", "scripts", "never"), what)
                elif prop.tag in ("IntVectorProperty", "DoubleVectorProperty"):
                    domains = [child for child in prop if child.tag.endswith("Domain")]
                    self.assertTrue(domains, what)

    def test_the_unit_of_a_number_stands_in_its_label_and_its_sentences(self):
        count = 0
        for _, name, proxy in plugin_xml.proxies():
            for prop in plugin_xml.own_properties(proxy):
                is_number = prop.tag in ("IntVectorProperty", "DoubleVectorProperty")
                if not is_number or plugin_xml.is_choice(prop):
                    continue
                text = " ".join(prop.find("Documentation").text.split())
                told = re.search(UNITS, text)
                hints = [hint.get("unit") for hint in prop.iter("PropertyWidgetDecorator")]
                what = f"{name}.{prop.get('name')}"
                self.assertEqual(bool(told and what not in WITHOUT_UNIT), bool(hints), what)
                if hints:
                    word = {"s": "seconds"}.get(hints[0], hints[0])
                    self.assertIn(word.lower(), text.lower(), what)
                    count += 1
        self.assertGreater(count, 40)

    def test_labels_are_words(self):
        """And without their spaces the names, for scripts know a property by its label."""
        manager = servermanager.ProxyManager().SMProxyManager
        for group, name, element in plugin_xml.proxies():
            proxy = manager.NewProxy(group, name)
            for prop in plugin_xml.own_properties(element):
                label = proxy.GetProperty(prop.get("name")).GetXMLLabel()
                self.assertEqual(label.replace(" ", ""), prop.get("name"))
                self.assertNotRegex(label, r"\b[A-Z] [A-Z]", name)  # F WHMCentre

    def test_help_in_python(self):
        for name, words in (("GalaxyModel", "Builds the particles of every component"),
                            ("Spheroid", "bulge"), ("SplatImage", "without a display")):
            text = io.StringIO()
            with redirect_stdout(text):
                help(getattr(simple, name))
            self.assertIn(words, text.getvalue())
        doc = type(simple.Spheroid()).SersicIndex.__doc__
        self.assertIn("4 as an elliptical", doc)


class Pages(unittest.TestCase):
    def test_every_proxy_has_one(self):
        if not HELP or not os.path.exists(HELP):
            self.skipTest("this build has no help pages")
        with sqlite3.connect(HELP) as pages:
            titles = {title for (title,) in pages.execute("select Title from FileNameTable")}
        for group, name, proxy in plugin_xml.proxies():
            if group != "representations":  # the page of Splats is that of its base
                self.assertIn(proxy.get("label"), titles)


if __name__ == "__main__":
    unittest.main()
