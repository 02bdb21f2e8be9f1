"""Reads an export of EdgeScan with a library or inside a program, and saves it again: exchange_read.py LIBRARY FILE OUT [SAVED].
OUT gets one row of eight-byte numbers per point: x y z red green blue class, not a number where the program has none."""
import collections
import csv
import os
import sys

import numpy


def rows(points, colours=None, classes=None):
    """The rows of OUT; colours count to 255."""
    made = numpy.full((len(points), 7), numpy.nan)
    made[:, :3] = points
    if colours is not None:
        made[:, 3:6] = colours
    if classes is not None:
        made[:, 6] = classes
    return made


CLASSES = {name: n for n, name in enumerate(["CLOUD", "EDGE_POINTS_JUMP", "EDGE_POINTS_CONVEX", "EDGE_POINTS_CONCAVE", "EDGE_POINTS_BORDER",
                                             "EDGE_POINTS_SILHOUETTE", "EDGE_POINTS_RIM"])}  # the layers of drawings


def kind_of(path):
    return path.rsplit(".", 1)[1]


def first_columns(path):
    with open(path, newline="") as file:
        return next(csv.reader(file))[:3]


def read_open3d(path, saved):
    import open3d
    cloud = open3d.io.read_point_cloud(path)
    if not cloud.has_points():
        raise RuntimeError("nothing was read")
    if saved and not open3d.io.write_point_cloud(saved, cloud):
        raise RuntimeError("nothing was saved")
    return rows(numpy.asarray(cloud.points), 255 * numpy.asarray(cloud.colors) if cloud.has_colors() else None)


def read_pandas(path, saved):
    import pandas
    if is_of_rocks(path):
        return pandas_describes(path)
    table = pandas.read_csv(path) if kind_of(path) == "csv" else pandas.read_csv(path, sep=" ", header=None)
    if saved:
        table.to_csv(saved, index=False) if kind_of(path) == "csv" else table.to_csv(saved, sep=" ", header=False, index=False)
    return rows(table.iloc[:, :3].to_numpy(), classes=table.get("class"))


def read_numpy(path, saved):
    points = numpy.loadtxt(path)
    if saved:
        numpy.savetxt(saved, points)
    return rows(points)


def read_laspy(path, saved):
    import laspy
    cloud = laspy.read(path)
    if saved:
        cloud.write(saved)
    classes = numpy.array(cloud.classification)
    return rows(numpy.array(cloud.xyz), numpy.stack([cloud.red, cloud.green, cloud.blue], axis=1) / 257, numpy.where(classes > 64, classes - 64, 0))


def is_of_rocks(path):
    return os.path.basename(path).startswith("rocks.")


def described(layers, system):
    """What a file of rocks holds, as a sentence: how many shapes of each kind, and the coordinate system."""
    return ", ".join(f"{count} {kind}" for kind, count in sorted(layers.items())) + (f"; {system}" if system else "; no coordinate system")


def gdal_describes(path):
    from osgeo import ogr
    source, kinds = ogr.Open(path), collections.Counter()
    for layer in source:
        system = layer.GetSpatialRef()
        for one in layer:
            shape = one.GetGeometryRef()
            kinds[(one.GetField("Layer") + " " if kind_of(path) == "dxf" else "") + (shape.GetGeometryName() if shape else "rows")] += 1
    return described(kinds, system and system.GetName())


def qgis_describes(path):
    from qgis.core import QgsVectorLayer, QgsWkbTypes
    layer = QgsVectorLayer(path, "rocks", "ogr")
    kinds = collections.Counter(QgsWkbTypes.displayString(one.geometry().wkbType()) if layer.isSpatial() else "rows" for one in layer.getFeatures())
    return described(kinds, layer.crs().description())


def ezdxf_describes(path):
    import ezdxf
    drawing = ezdxf.readfile(path)
    return described(collections.Counter(f"{one.dxf.layer} {one.dxftype()}" for one in drawing.modelspace()), "")


def pandas_describes(path):
    import pandas
    table = pandas.read_csv(path)
    return f"{len(table)} rows, {len(table.columns)} columns, {table.iloc[:, 4:7].dtypes.astype(str).eq('float64').sum()} of 3 coordinates as numbers"


def read_gdal(path, saved):
    from osgeo import gdal, ogr
    gdal.UseExceptions()
    if is_of_rocks(path):
        return gdal_describes(path)
    if saved:
        gdal.VectorTranslate(saved, path, format="CSV")
    source = ogr.Open(path)
    if kind_of(path) == "csv":
        names = first_columns(path)
        found = [[float(one.GetField(n)) for n in names + ["class"]] for one in source.GetLayer(0)]
        return rows([one[:3] for one in found], classes=[one[3] for one in found])
    points, classes = [], []
    for one in source.GetLayer(0):
        shape = one.GetGeometryRef()
        if one.GetField("Layer") in CLASSES:
            points.append((shape.GetX(), shape.GetY(), shape.GetZ()))
            classes.append(CLASSES[one.GetField("Layer")])
    return rows(points, classes=classes)


def read_ezdxf(path, saved):
    import ezdxf
    from ezdxf.colors import aci2rgb
    if is_of_rocks(path):
        return ezdxf_describes(path)
    drawing = ezdxf.readfile(path)
    errors = drawing.audit().errors
    if errors:
        raise RuntimeError(f"{len(errors)} errors")
    found = list(drawing.modelspace().query("POINT"))
    of_layer = {layer.dxf.name: aci2rgb(layer.color) for layer in drawing.layers}
    return rows([tuple(one.dxf.location) for one in found], [of_layer[one.dxf.layer] for one in found], [CLASSES[one.dxf.layer] for one in found])


def read_qgis(path, saved):
    from qgis.core import QgsApplication, QgsCoordinateTransformContext, QgsVectorFileWriter, QgsVectorLayer
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    application = QgsApplication([], False)
    application.initQgis()
    if is_of_rocks(path):
        return qgis_describes(path)
    if kind_of(path) == "csv":
        x, y, z = first_columns(path)
        layer = QgsVectorLayer(f"file://{path}?delimiter=,&xField={x}&yField={y}&zField={z}", "cloud", "delimitedtext")
    else:
        layer = QgsVectorLayer(f"{path}|layername=entities|geometrytype=Point", "cloud", "ogr")
    if not layer.isValid():
        raise RuntimeError("the layer is not valid")
    if saved:
        options = QgsVectorFileWriter.SaveVectorOptions()
        options.driverName = "CSV"
        QgsVectorFileWriter.writeAsVectorFormatV3(layer, saved, QgsCoordinateTransformContext(), options)
    points, classes = [], []
    for one in layer.getFeatures():
        point = one.geometry().constGet()
        points.append((point.x(), point.y(), point.z()))
        classes.append(one["class"] if kind_of(path) == "csv" else CLASSES[one["Layer"]])
    return rows(points, classes=classes)


def read_paraview(path, saved):
    from paraview import simple
    from vtkmodules.util.numpy_support import vtk_to_numpy
    source = simple.OpenDataFile(path)
    if kind_of(path) == "csv":
        x, y, z = first_columns(path)
        source = simple.TableToPoints(Input=source, XColumn=x, YColumn=y, ZColumn=z)
    simple.UpdatePipeline()
    if saved:
        simple.SaveData(saved, proxy=source, **({"Precision": 12} if kind_of(saved) == "csv" else {}))
    data = simple.servermanager.Fetch(source)
    array = lambda name: None if data.GetPointData().GetArray(name) is None else vtk_to_numpy(data.GetPointData().GetArray(name))
    return rows(vtk_to_numpy(data.GetPoints().GetData()), array("RGB"), array("class"))


def read_blender(path, saved):
    import bpy
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    axes = {"forward_axis": "Y", "up_axis": "Z"}
    reads, saves = (bpy.ops.wm.ply_import, bpy.ops.wm.ply_export) if kind_of(path) == "ply" else (bpy.ops.wm.obj_import, bpy.ops.wm.obj_export)
    reads(filepath=path, **axes)
    mesh = bpy.context.selected_objects[0].data
    points = numpy.empty(3 * len(mesh.vertices))
    mesh.vertices.foreach_get("co", points)
    colours = None
    if mesh.color_attributes:
        colours = numpy.empty(4 * len(mesh.vertices))
        mesh.color_attributes[0].data.foreach_get("color_srgb", colours)
        colours = 255 * colours.reshape(-1, 4)[:, :3]
    if saved:
        saves(filepath=saved, **axes)
    return rows(points.reshape(-1, 3), colours)


if __name__ == "__main__":
    library, file, out = (sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else sys.argv[1:])[:3]
    to_save = sys.argv[-1] if sys.argv[-1] != out else None
    try:
        read = globals()[f"read_{library}"](file, to_save)
        print(read) if isinstance(read, str) else read.astype("<f8").tofile(out)
    except Exception as problem:
        print(f"refused: {problem or type(problem).__name__}", flush=True)
        os._exit(1)
    sys.stdout.flush()
    os._exit(0)  # some programs end with an error after a sound result
