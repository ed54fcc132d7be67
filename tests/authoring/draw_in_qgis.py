"""Draws a site in the authoring template with QGIS itself, and converts what was drawn.

Usage: draw_in_qgis.py MAPWRIGHT [PICTURE.png]. Ends with 77 where QGIS for Python is not installed.
"""
import os
import subprocess
import sys
import tempfile

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
try:
    from qgis.core import (QgsApplication, QgsGeometry, QgsMapRendererParallelJob, QgsMapSettings,
                           QgsRectangle, QgsVectorLayer, QgsVectorLayerUtils)
    from qgis.PyQt.QtCore import QSize
    from qgis.PyQt.QtGui import QColor
except ImportError:
    print("skipped: QGIS for Python (package python3-qgis) is not installed")
    sys.exit(77)

LAYERS = ["border", "ramps", "stairs", "buildings", "furniture", "steps", "walls"]

# Layer, drawing, and the fields that are typed in; the rest comes from the template's defaults.
DRAWING = [
    ("buildings", "POLYGON((-60 10,-20 10,-20 50,-60 50,-60 10),(-50 20,-30 20,-30 40,-50 40,-50 20))",
     {"name": "Library", "height": 12.0}),
    ("buildings", "POLYGON((10 -50,40 -50,40 -20,10 -20,10 -50))", {"name": "Workshop", "kind": "shed"}),
    ("furniture", "POLYGON((0 0,6 0,6 1,0 1,0 0))", {"kind": "bench", "name": "Long bench", "height": 0.5}),
    ("walls", "LINESTRING(-70 -60,-70 0,-40 0)", {"name": "Garden wall"}),
    ("walls", "LINESTRING(50 20,50 60)", {"kind": "fence", "height": 1.2}),
    ("stairs", "POLYGON((10 10,14 10,14 13,10 13,10 10))", {"stair_id": "A", "steps": 8, "direction_deg": 90.0}),
    ("ramps", "POLYGON((10 16,20 16,20 18,10 18,10 16))", {"slope_deg": 4.0, "aspect_deg": 270.0}),
    ("steps", "LINESTRING(20 30,26 30)", {"stair_id": "B", "step_no": 1}),
    ("steps", "LINESTRING(20 30.3,26 30.3)", {"stair_id": "B", "step_no": 2}),
    ("steps", "LINESTRING(20 30.6,26 30.6)", {"stair_id": "B", "step_no": 3}),
]

failures = []


def expect(is_true, what):
    if not is_true:
        failures.append(what)


def check_styles(layers):
    for name, layer in layers.items():
        expect(layer.renderer().type() == ("categorizedSymbol" if name in ("buildings", "furniture", "walls")
                                           else "singleSymbol"), f"{name}: the style was not applied")
        for i, field in enumerate(layer.fields()):
            if field.name() in ("kind", "in_out"):
                expect(layer.editorWidgetSetup(i).type() == "ValueMap", f"{name}.{field.name()}: no value list")
    walls = layers["walls"]
    expect(walls.renderer().symbols(__import__("qgis.core").core.QgsRenderContext())[0].symbolLayerCount() == 2,
           "walls: no ticks on the free side")
    expect("0.02" in walls.constraintExpression(walls.fields().indexOf("height")), "walls.height: no limits")


def draw(layers):
    for name, wkt, values in DRAWING:
        layer = layers[name]
        layer.startEditing()
        feature = QgsVectorLayerUtils.createFeature(
            layer, QgsGeometry.fromWkt(wkt), {layer.fields().indexOf(k): v for k, v in values.items()})
        expect(layer.addFeature(feature) and layer.commitChanges(), f"{name}: {layer.commitErrors()}")


def picture(layers, path):
    settings = QgsMapSettings()
    settings.setLayers([layers[name] for name in reversed(LAYERS)])
    settings.setDestinationCrs(layers["walls"].crs())
    settings.setExtent(QgsRectangle(-75, -65, 60, 65))
    settings.setOutputSize(QSize(1200, 1150))
    settings.setOutputDpi(110)
    settings.setBackgroundColor(QColor("white"))
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    image = job.renderedImage()
    expect(len({image.pixel(x, y) for x in range(0, 1200, 7) for y in range(0, 1150, 7)}) > 6,
           "QGIS drew nothing")
    if path:
        image.save(path)


def check_map(text):
    expect("building,name=Library" in text and "\n12;1;" in text, "the library is missing, or its height")
    expect("shed,name=Workshop" in text and "\n3;1;" in text, "the shed, or the default height, is missing")
    expect("fence" in text and "wall,name=Garden wall" in text, "a wall is missing")
    expect(text.count("inner_of=") == 1, "the courtyard is missing")


def main():
    program, path = sys.argv[1], (sys.argv[2] if len(sys.argv) > 2 else "")
    with tempfile.TemporaryDirectory() as folder:
        site, result = os.path.join(folder, "site.gpkg"), os.path.join(folder, "site.txt")
        subprocess.run([program, "new", site, "--origin", "41.3890,2.1130", "--heading", "-20", "--quiet"],
                       check=True)
        layers = {name: QgsVectorLayer(f"{site}|layername={name}", name, "ogr") for name in LAYERS}
        expect(all(layer.isValid() for layer in layers.values()), "QGIS cannot open a layer")
        check_styles(layers)
        draw(layers)
        picture(layers, path)
        converted = subprocess.run([program, "convert", site, "-o", result], capture_output=True, text=True)
        expect(converted.returncode == 0, f"convert: {converted.stderr}")
        check_map(open(result, encoding="utf-8").read())
    for failure in failures:
        print("failed:", failure)
    sys.stdout.flush()
    os._exit(1 if failures else 0)  # QGIS's own end may crash where it has no screen


application = QgsApplication([], False)
application.initQgis()
main()
