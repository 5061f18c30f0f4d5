"""The plugin's server-manager XML, as its tests read it."""
import glob
import os
import xml.etree.ElementTree as ElementTree

import galaxy_testing as gt

PROXIES = ("SourceProxy", "WriterProxy", "RepresentationProxy", "Proxy")


def groups():
    """(name, element) of every ProxyGroup in Plugin/*.xml."""
    for path in sorted(glob.glob(os.path.join(gt.ROOT, "Plugin", "*.xml"))):
        for group in ElementTree.parse(path).getroot().iter("ProxyGroup"):
            yield group.get("name"), group


def proxies():
    """(group, name, element) of every proxy that the plugin defines."""
    for group, element in groups():
        for proxy in element:
            if proxy.tag in PROXIES:
                yield group, proxy.get("name"), proxy


def made_by_users():
    """(group, name, element) of what stands in the menus or opens files."""
    return [proxy for proxy in proxies() if proxy[0] in ("sources", "filters")]


def own_properties(proxy):
    return [child for child in proxy if child.tag.endswith("Property")]


def properties(proxy):
    """The elements of a proxy's properties, those of its bases beside its own."""
    found = own_properties(proxy)
    base = proxy.get("base_proxyname")
    if base:
        found += properties(next(element for _, name, element in proxies() if name == base))
    return found


def is_choice(prop):
    """Whether a number stands for one of several words, or for yes and no."""
    return any(prop.find(domain) is not None for domain in ("EnumerationDomain", "BooleanDomain"))
