"""Runs in ParaView's own Python while test_galaxy_window.py uses the window: at each picture it notes
what the view shows, and the trace so far, in the folder GALAXY_WINDOW_NOTES."""
import json
import os

from paraview import simple, smtrace

FOLDER = os.environ["GALAXY_WINDOW_NOTES"]
CAMERA = ("CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraViewAngle",
          "CameraParallelProjection")


def note(*_):
    view = simple.GetActiveView()
    shown = {name: view.GetPropertyValue(name) for name in CAMERA}
    shown = {name: list(v) if hasattr(v, "__len__") else v for name, v in shown.items()}
    shown["sources"] = [key[0] for key in simple.GetSources()]
    with open(os.path.join(FOLDER, "pictures.json"), "a", encoding="utf-8") as file:
        file.write(json.dumps(shown) + "\n")
    with open(os.path.join(FOLDER, "trace.py"), "w", encoding="utf-8") as file:
        file.write(smtrace.get_current_trace_output())


smtrace.start_trace()
simple.GetActiveView().SMProxy.GetRenderWindow().AddObserver("EndEvent", note)
