"""Round trips with the programs that people have: what they write is read, what lober writes they read."""

import csv
import gzip
import json
import re
import subprocess
import warnings
from pathlib import Path

import numpy as np
import pytest

import lober


def ring(points, at=(0.0, 0.0)):
    t = np.arange(points) * (2 * np.pi / points)
    return np.column_stack([np.cos(t) + at[0], np.sin(t) / 3 + at[1]])


CURVES = {"one": ring(40), "zwei \N{GREEK SMALL LETTER SIGMA}": ring(55, (1 / 3, 0.1))}


def require(name):
    for known in lober.formats():
        if known.name == name and known.missing:
            pytest.skip(known.missing)


def same(zones, curves=CURVES, rings=False):
    assert len(zones) == len(curves)
    for zone, curve in zip(zones, curves.values()):
        points = zone.points[:-1] if rings else zone.points
        assert points.tobytes() == curve.tobytes()


def test_formats_are_listed():
    known = {one.name: one for one in lober.formats()}
    assert known["npz"].endings == (".npz",) and known["npz"].takes_several
    assert known["mat"].reads and not known["mat"].writes
    assert not known["vtk"].reads and known["vtk"].writes
    with pytest.raises(lober.UsageError, match="no format is called npx; those that are written are npy, csv"):
        lober.write("x", ring(5), format="npx")


@pytest.mark.parametrize("ending", ["npz", "geojson", "wkt", "dat", "txt", "csv"])
def test_several_curves_come_back(tmp_path, ending):
    require({"dat": "tecplot", "txt": "text"}.get(ending, ending))
    path = tmp_path / f"two.{ending}"
    lober.write(path, CURVES, notes={"source": "a test"})
    file = lober.read_zones(path, columns="x,y,by=curve" if ending == "csv" else "")
    same(file.zones, rings=ending in ("geojson", "wkt"))
    assert lober.read(f"{path}:x,y,by=curve#1" if ending == "csv" else f"{path}#1").tobytes() == list(CURVES.values())[1].tobytes()
    if ending not in ("wkt", "csv"):
        assert [zone.title for zone in file.zones] == list(CURVES)


def test_numpy(tmp_path):
    require("npz")
    path = tmp_path / "two.npz"
    lober.write(path, CURVES, notes={"source": "a test"})
    with np.load(path) as file:
        assert sorted(file.files) == ["offsets", "points", "provenance", "titles"]
        assert file["titles"].tolist() == list(CURVES)
        parts = np.split(file["points"], file["offsets"][1:-1])
        assert all(part.tobytes() == curve.tobytes() for part, curve in zip(parts, CURVES.values()))
        assert str(file["provenance"]) == f"lober: {lober.__version__}\nsource: a test"
    one = ring(30)
    for save in (np.savez, np.savez_compressed):
        save(tmp_path / "arrays.npz", x=one[:, 0], y=one[:, 1], other=np.arange(3))
        assert lober.read(tmp_path / "arrays.npz").tobytes() == one.tobytes()
        assert lober.read(f"{tmp_path}/arrays.npz:x,y").tobytes() == one.tobytes()
    with pytest.raises(lober.DataError, match=r"it holds x \(30\), y \(30\), other \(3\)"):
        lober.read(f"{tmp_path}/arrays.npz:x,z")


def test_gzip(tmp_path):
    with gzip.open(tmp_path / "c.csv.gz", "wt") as file:
        csv.writer(file).writerows(ring(20).tolist())
    assert lober.read(tmp_path / "c.csv.gz").tobytes() == ring(20).tobytes()
    whole = (tmp_path / "c.csv.gz").read_bytes()
    (tmp_path / "cut.gz").write_bytes(whole[:-20])
    with pytest.raises(lober.DataError, match="compressed by gzip: the file ends in the middle"):
        lober.read(tmp_path / "cut.gz")


def test_pandas(tmp_path):
    pandas = pytest.importorskip("pandas")
    lober.write(tmp_path / "two.csv", CURVES)
    table = pandas.read_csv(tmp_path / "two.csv", float_precision="round_trip")
    assert list(table.columns) == ["x", "y", "curve"]
    for k, curve in enumerate(CURVES.values()):
        assert np.array_equal(table[table.curve == k][["x", "y"]].to_numpy(), curve)
    frame = pandas.DataFrame({"t": 0, "lon": ring(9)[:, 0], "lat": ring(9)[:, 1]})
    frame.to_csv(tmp_path / "frame.csv", index=False)
    assert np.array_equal(lober.read(f"{tmp_path}/frame.csv:lon,lat"), ring(9))


@pytest.mark.parametrize("ending", ["csv", "txt"])
def test_notes_of_tables(tmp_path, ending):
    path = tmp_path / f"c.{ending}"
    lober.write(path, ring(9), notes={"source": "a\nb, c"})
    assert path.read_text().splitlines()[:2] == [f"# lober: {lober.__version__}", "# source: a b, c"]
    assert lober.read(path).tobytes() == ring(9).tobytes()
    lober.write(path, CURVES, notes={"source": "x y"})
    same(lober.read_zones(path).zones)
    if ending == "csv":
        pandas = pytest.importorskip("pandas")
        assert list(pandas.read_csv(path, comment="#").columns) == ["x", "y", "curve"]
    lober.write(path, ring(9))
    assert not path.read_text().startswith("#")


def test_tables_of_pandas(tmp_path):
    pandas = pytest.importorskip("pandas")
    days = pandas.date_range("2020-01-01", periods=18, freq="h")
    both = np.concatenate([ring(9), ring(9, (2, 1))])
    frame = pandas.DataFrame({"time": days, "place": ['Lake #1, "north"'] * 9 + ["b;c\td"] * 9, "Lon (deg)": both[:, 0],
                              "Lat, deg": both[:, 1], "depth": [None] * 18})
    for separator, quoting in ((",", csv.QUOTE_MINIMAL), (";", csv.QUOTE_ALL), ("\t", csv.QUOTE_NONNUMERIC)):
        for index in (True, False):
            for encoding in ("utf-8", "utf-8-sig"):
                frame.to_csv(tmp_path / "f.csv", sep=separator, quoting=quoting, index=index, encoding=encoding)
                zones = lober.read_zones(f'{tmp_path}/f.csv:Lon (deg),"Lat, deg",by=place').zones
                assert [zone.title for zone in zones] == ['Lake #1, "north"', "b;c\td"]
                same(zones, {"a": both[:9], "b": both[9:]})
                assert lober.read(f'{tmp_path}/f.csv:Lon (deg),"Lat, deg",by=place#b;c\td').tobytes() == both[9:].tobytes()


def test_scipy(tmp_path):
    scipy_io = pytest.importorskip("scipy.io")
    require("mat")
    both = np.stack([ring(25), ring(25, (2, 1))])
    for options in ({}, {"do_compression": True}, {"format": "4"}):
        scipy_io.savemat(tmp_path / "m.mat", {"x": both[..., 0].T, "y": both[..., 1].T}, **options)
        same(lober.read_zones(tmp_path / "m.mat").zones, {"0": both[0], "1": both[1]})
    scipy_io.savemat(tmp_path / "s.mat", {"orbit": {"x": both[0, :, 0], "y": both[0, :, 1]}})
    assert lober.read(f"{tmp_path}/s.mat:orbit.x,orbit.y").tobytes() == both[0].tobytes()


def test_lists_and_complex_numbers_of_scipy(tmp_path):
    scipy_io = pytest.importorskip("scipy.io")
    require("mat")
    one, two = ring(25), ring(31, (2, 1))
    cells = np.empty(2, dtype=object)
    cells[:] = [one, two]
    orbits = np.zeros(2, dtype=[("x", object), ("y", object)])
    for k, curve in enumerate((one, two)):
        orbits[k] = (curve[:, 0], curve[:, 1])
    z = one @ [1, 1j]
    for options in ({}, {"do_compression": True}):
        scipy_io.savemat(tmp_path / "m.mat", {"cells": cells, "orbits": orbits, "z": z}, **options)
        for choice in ("cells", "orbits.x,orbits.y"):
            same(lober.read_zones(f"{tmp_path}/m.mat:{choice}").zones, {"0": one, "1": two})
        assert lober.read(f"{tmp_path}/m.mat:z").tobytes() == one.tobytes()
    np.save(tmp_path / "z.npy", z)
    np.save(tmp_path / "i.npy", (1000 * one).astype("i4"))
    assert lober.read(tmp_path / "z.npy").tobytes() == one.tobytes()
    assert np.array_equal(lober.read(tmp_path / "i.npy"), (1000 * one).astype("i4"))


def test_h5py(tmp_path):
    h5py = pytest.importorskip("h5py")
    require("hdf5")
    curve = ring(1000)
    with h5py.File(tmp_path / "f.h5", "w") as file:
        file.create_dataset("run/7/x", data=curve[:, 0], compression="gzip", shuffle=True)
        file.create_dataset("run/7/y", data=curve[:, 1].astype(">f8"), chunks=(100,))
    assert lober.read(f"{tmp_path}/f.h5:/run/7/x,/run/7/y").tobytes() == curve.tobytes()
    assert lober.read(f"{tmp_path}/f.h5:x,y").tobytes() == curve.tobytes()


@pytest.mark.parametrize("form", ["NETCDF3_CLASSIC", "NETCDF3_64BIT_OFFSET", "NETCDF3_64BIT_DATA", "NETCDF4"])
def test_netcdf(tmp_path, form):
    netcdf = pytest.importorskip("netCDF4")
    require("hdf5" if form == "NETCDF4" else "netcdf")
    with netcdf.Dataset(tmp_path / "f.nc", "w", format=form) as file:
        file.createDimension("obs", None)  # records
        file.createDimension("traj", 2)
        for k, name in enumerate(("lon", "lat")):
            variable = file.createVariable(name, "f8", ("obs", "traj"))
            variable[:] = np.stack([ring(12)[:, k], ring(12, (1, 1))[:, k]]).T
        file.createVariable("step", "i4", ("obs",))[:] = np.arange(12)
    zones = lober.read_zones(tmp_path / "f.nc").zones
    assert len(zones) == 12  # a row is a curve: here one of two points for each time
    assert zones[3].points.tolist() == [ring(12)[3].tolist(), ring(12, (1, 1))[3].tolist()]


def test_pandas_as_the_document_calls_it(tmp_path):
    """Files of one curve have no row of names, files of several have one."""
    pandas = pytest.importorskip("pandas")
    document = (Path(__file__).parents[2] / "docs" / "reference" / "formats.md").read_text()
    paragraph = next(part for part in document.split("\n\n") if "reads csv of one curve" in part)
    option = re.search(r"`(float_precision=[^`]*)`", paragraph)[1]
    one, several = (f"{call}, {option})" for call in re.findall(r"`(pandas\.read_csv\([^`]*)\)`", paragraph))
    first, second = CURVES.values()
    notes = {"source": "a test"}
    lober.write(tmp_path / "one.csv", first, notes=notes)
    table = eval(one, {"pandas": pandas, "FILE": tmp_path / "one.csv"})
    assert list(table) == ["x", "y"] and np.array_equal(table.to_numpy(), first)
    lober.write(tmp_path / "two.csv", CURVES, notes=notes)
    table = eval(several, {"pandas": pandas, "FILE": tmp_path / "two.csv"})
    assert list(table) == ["x", "y", "curve"]
    for number, curve in enumerate((first, second)):
        assert np.array_equal(table[table["curve"] == number][["x", "y"]].to_numpy(), curve)


def test_geopandas(tmp_path):
    geopandas = pytest.importorskip("geopandas")
    shapely = pytest.importorskip("shapely.geometry")
    lober.write(tmp_path / "two.geojson", CURVES)
    frame = geopandas.read_file(tmp_path / "two.geojson")
    assert frame["name"].tolist() == list(CURVES)
    for polygon, curve in zip(frame.geometry, CURVES.values()):
        assert np.array_equal(np.array(polygon.exterior.coords)[:-1], curve)
        assert polygon.area == pytest.approx(lober.area(curve), rel=1e-13)
    lober.write(tmp_path / "open.geojson", CURVES, closed=False)
    assert set(geopandas.read_file(tmp_path / "open.geojson").geom_type) == {"LineString"}
    frame = geopandas.GeoDataFrame({"n": [1, 2]}, geometry=[shapely.Polygon(curve) for curve in CURVES.values()])
    frame.to_file(tmp_path / "two.shp")
    require("shapefile")
    zones = lober.read_zones(tmp_path / "two.shp").zones
    for zone, polygon in zip(zones, geopandas.read_file(tmp_path / "two.shp").geometry):
        assert np.array_equal(zone.points, np.array(polygon.exterior.coords))


def test_wkt_in_shapely(tmp_path):
    wkt = pytest.importorskip("shapely.wkt")
    lober.write(tmp_path / "two.wkt", CURVES, notes={"source": "a test"})
    lines = [line for line in (tmp_path / "two.wkt").read_text().splitlines() if not line.startswith("#")]
    for line, curve in zip(lines, CURVES.values()):
        assert np.array_equal(np.array(wkt.loads(line).exterior.coords)[:-1], curve)


def test_vtk(tmp_path):
    vtk = pytest.importorskip("vtkmodules.vtkIOXML")
    lober.write(tmp_path / "two.vtp", CURVES, notes={"source": "a test"})
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "two.vtp"))
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfPolys() == 2 and data.GetNumberOfLines() == 0
    titles = data.GetCellData().GetAbstractArray("title")
    assert [titles.GetValue(k) for k in range(2)] == list(CURVES)
    assert "source: a test" in data.GetFieldData().GetAbstractArray("provenance").GetValue(0)
    for k, curve in enumerate(CURVES.values()):
        cell = data.GetCell(k).GetPoints()
        assert [cell.GetPoint(i)[:2] for i in range(cell.GetNumberOfPoints())] == [tuple(point) for point in curve.tolist()]


def test_gmt(tmp_path):
    if subprocess.run(["which", "gmt"], capture_output=True).returncode:
        pytest.skip("GMT is not installed")
    lober.write(tmp_path / "two.txt", CURVES)
    out = subprocess.run(["gmt", "convert", tmp_path / "two.txt", "--FORMAT_FLOAT_OUT=%.17g"], capture_output=True, text=True)
    (tmp_path / "again.txt").write_text(out.stdout)
    same(lober.read_zones(tmp_path / "again.txt").zones)


def test_geojson_provenance(tmp_path):
    lober.write(tmp_path / "c.geojson", ring(5), notes={"input": 'a "b"'})
    data = json.loads((tmp_path / "c.geojson").read_text())
    assert data["provenance"] == {"lober": lober.__version__, "input": 'a "b"'}


def test_date_lines_are_warned_of(tmp_path):
    path = tmp_path / "box.csv"
    path.write_text("lon,lat\n178,10\n-178,10\n-178,14\n178,14\n")
    with pytest.warns(UserWarning, match="segment 0 runs back across the whole map .* give periods=360"):
        lober.read(path)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert lober.area(lober.read(path, periods=360)) == 16
    (tmp_path / "other.csv").write_text("lon,lat\n170,10\n179,10\n179,14\n170,14\n")
    manifest = {"operation": "overlay", "curves": [str(path), str(tmp_path / "other.csv")]}
    with pytest.warns(UserWarning, match="the manifest needs periodic = \"x=360\""):
        lober.batch.run(manifest, tmp_path / "a.results")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        lober.batch.run({**manifest, "periodic": "x=360"}, tmp_path / "b.results")
