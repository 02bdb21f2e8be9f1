"""The section "Families" of docs/measurements/accuracy.md, from the JSON of `edgescan-lab families`."""
import os
import re
import subprocess
import sys

from accuracy_work import AT_ONCE, CACHE, PROGRAM, ROOT, hash_of, job, key, read

HEAD = "## Families\n"
NAMES = {"default": "**EdgeScan+**", "borders": "*Rock borders*", "default-4": "default set 4", "thesis": "thesis, as printed",
         "log-range": "Canny on log range", "gray": "Canny on log gray levels", "pcl": "PCL OrganizedEdge, un-rolled"}
METHODS = ["default", "borders", "default-4=--preset default-4", "thesis", "log-range", "gray", "pcl"]
GROUPS = [("all", "F of all edges"), ("outline", "F of outlines"), ("strict_outline", "F of outlines, an edge on a crease within a rock is false")]


def kinect_truth(shared):
    """Futures of the folders of truth by the name of the cloud; empty without ../shared."""
    made = {}
    for name in ("test16", "test55"):
        cloud = os.path.join(shared, "mosd_kinect", name + ".pcd")
        script = os.path.join(ROOT, "docs/measurements/kinect-truth")
        folder = os.path.join(CACHE, "kinect-" + key(hash_of(script)), name)

        def make(new, cloud=cloud, script=script):
            os.makedirs(os.path.dirname(new), exist_ok=True)
            subprocess.run([sys.executable, script, cloud, new], check=True)
        if os.path.exists(cloud):
            made[name] = (cloud, folder, job(folder, "labels of " + name, make))
    return made


def scored(shared):
    truths = [future.result() for _, _, future in kinect_truth(shared).values()]
    lab = os.path.join(os.path.dirname(PROGRAM), "edgescan-lab")
    path = os.path.join(CACHE, "families-" + key(hash_of(lab)) + ".json")

    def make(new):
        flags = ["--kinect", os.path.dirname(truths[0])] if truths else []
        arguments = [lab, "families", "--shared", os.path.dirname(shared), "--threads", str(AT_ONCE), "--store", os.path.join(CACHE, "families"), "--progress",
                     "--json", new + ".json"] + [word for method in METHODS for word in ("--with", method)] + flags
        if subprocess.run(arguments, check=False, stdout=subprocess.DEVNULL).returncode != 0:
            raise RuntimeError("edgescan-lab families did not come to its end; run it again to go on")
        os.rename(new + ".json", new)
    return read(job(path, "families", make))


def figure(value):
    return ("%.3f" % value).lstrip("0") if value < 0.9995 else "1"


def group_table(run, group, names):
    rows = ["| family | scenes | " + " | ".join(NAMES.get(name, name) for name in names) + " |", "|---|---" + "|---" * len(names) + "|"]
    for family in run["families"]:
        if "figures" in family:
            figures = [family["figures"][name][group] for name in names]
            rows.append("| %s | %d | " % (family["name"], len(family["scenes"]))
                        + " | ".join("%s (%s)" % (figure(f["mean"]), figure(f["worst_tenth"])) if f["scenes"] else "" for f in figures) + " |")
    return "\n".join(rows) + "\n"


def cells_table(run, names):
    """Jumps / folds / other edge cells per scene."""
    rows = ["| family | scenes | " + " | ".join(NAMES.get(name, name) for name in names) + " |", "|---|---" + "|---" * len(names) + "|"]
    for family in run["families"]:
        scenes = family["scenes"]
        if family["measure"] == "edges" or not scenes:
            continue
        kind = "cells" if family["measure"] == "counts" else "away"

        def per_scene(name, classes):
            total = sum(count for scene in scenes for one, count in scene["scores"][name].get(kind, {}).items() if one in classes)
            return "%.0f" % (total / len(scenes))
        columns = [" / ".join(per_scene(name, classes) for classes in (["jump"], ["convex", "concave"], ["unclassed", "border", "silhouette", "void_rim"]))
                   for name in names]
        rows.append("| %s | %d | " % (family["name"], len(scenes)) + " | ".join(columns) + " |")
    return "\n".join(rows) + "\n"


def section(shared):
    run = scored(shared)
    names = [contestant["name"] for contestant in run["contestants"]]
    parts = [HEAD,
             "Made by `edgescan-lab families`, seeds drawn from `%s`: these scenes were unknown when the settings were chosen. Those that were" % run["draw"],
             "stored beforehand are few. Real stones are first. Cells are the mean over the scenes of the family (*the worst tenth* in brackets), each method",
             "with its fixed settings, tolerance 2 cells. More: [families of scenes](../method/edges.md#families-of-scenes).",
             "The sections below add the counts of all scans instead. So the two Kinect clouds have another F there, with the same settings.\n"]
    for group, title in GROUPS:
        parts += ["%s:\n" % title, group_table(run, group, names)]
    parts += ["Jumps / folds / other edge cells per scene: in corridors all, on walls those away from the truth.\n", cells_table(run, names)]
    skipped = ["* %s: %s" % (family["name"], family["skipped"]) for family in run["families"] if "skipped" in family]
    return "\n".join(parts + (["Not measured:\n"] + skipped + [""] if skipped else []))


def replaced(page, made):
    """The page with the section in place of the one that it has, or before its first section."""
    old = re.search(r"^## Families\n.*?(?=^## )|(?=^## )", page, re.MULTILINE | re.DOTALL)
    return page[:old.start()] + made + "\n" + page[old.end():]
