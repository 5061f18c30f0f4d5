"""Runs in ParaView's own Python while test_abort_window.py uses the window: after each picture it
notes what was drawn in the folder GALAXY_WINDOW_NOTES."""
import json
import os

from paraview import simple

FOLDER = os.environ["GALAXY_WINDOW_NOTES"]


def note(*_):
    for representation in simple.GetRepresentations().values():
        if representation.GetProperty("RenderStatistics"):
            representation.UpdatePropertyInformation()
            with open(os.path.join(FOLDER, "pictures.json"), "a", encoding="utf-8") as file:
                file.write(json.dumps(str(representation.GetPropertyValue("RenderStatistics"))) + "\n")



simple.GetActiveView().SMProxy.GetRenderWindow().AddObserver("EndEvent", note)
