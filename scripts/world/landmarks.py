"""The object map on MRCLAM, from true poses, against surveyed landmarks (LandmarkMap): rows for scripts/recordings."""
import shlex
import subprocess


def rows(java, folder, work):
    found = sorted(folder.glob("MRCLAM_Dataset*"))
    sets = [str(each) for each in found if (each / "Robot1_Groundtruth.dat").exists()]
    table = [dict(name=each.name, metric="", value="not judged: it has no ground truth", goal="") for each in found if str(each) not in sets]
    words = subprocess.run([*shlex.split(java), "org.u2sa.world.object.LandmarkMap", *sets], check=True, stdout=subprocess.PIPE, text=True).stdout
    for line in words.splitlines()[2:]:
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        name = "%s, %s, UIDs: %s" % tuple(cells[:3])
        found, seen = (int(each) for each in cells[3].split(" of "))
        table.append(dict(name=name, metric="landmarks found [%]", value=100.0 * found / seen, goal="≥ 99" if cells[2] == "barcodes" else ""))
        table.append(dict(name=name, metric="mean error [m]", value=float(cells[5].split()[0]), goal=""))
    return table
