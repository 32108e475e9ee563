"""Makes the files of the folder formats, in which it is run, with the programs that people have.

Each holds two curves of five points, x and y below: those of the second are the first's moved by (2, 1).
"""

import gzip
import json
import pathlib

import geopandas
import h5py
import netCDF4
import numpy as np
import scipy.io
import shapely.geometry

x = np.array([0.0, 1.0, 1.5, 0.1, -0.3])
y = np.array([0.0, 0.1, 1.0, 1.25, 0.7])
xs, ys = np.stack([x, x + 2]), np.stack([y, y + 1])
points = np.c_[x, y]

with gzip.GzipFile("table.txt.gz", "wb", mtime=0) as file:
    np.savetxt(file, points, fmt="%.17g")

np.savez("two.npz", x=xs, y=ys, name=np.array(["one", "two"]))
np.savez_compressed("one.npz", xy=np.asfortranarray(points.astype(">f4")), count=np.int16(5), half=x.astype("f2"))
np.savez_compressed("parts.npz", points=np.concatenate([points, points + [2, 1]]), offsets=np.array([0, 5, 10]),
                    titles=np.array(["one", "zweite \N{GREEK SMALL LETTER SIGMA}"]), curve=np.repeat([4, 2], 5))

scipy.io.savemat("v4.mat", {"x": x, "y": y}, format="4")
scipy.io.savemat("v5.mat", {"x": xs.T, "y": ys.T, "s": {"x": x.astype("f4"), "y": y}, "z": x + 1j * y, "text": "no numbers"},
                 do_compression=True, oned_as="column")
kind = h5py.h5t.C_S1.copy()
kind.set_size(7)
with h5py.File("v73.mat", "w", userblock_size=512) as file:
    for name, numbers in {"x": xs, "y": ys}.items():
        file[name] = numbers  # MATLAB's first axis is HDF5's last: a column of MATLAB is a curve
        of_class = h5py.h5a.create(file[name].id, b"MATLAB_class", kind, h5py.h5s.create(h5py.h5s.SCALAR))
        of_class.write(np.array(b"double"))
with open("v73.mat", "r+b") as file:
    file.write(b"MATLAB 7.3 MAT-file, made for a test".ljust(124) + b"\x00\x02IM")

with h5py.File("groups.h5", "w", libver="earliest") as file:
    file.create_group("orbit/inner")
    file.create_dataset("orbit/inner/x", data=x, compression="gzip")
    file.create_dataset("orbit/inner/y", data=y.astype("f4"))
    file.create_dataset("orbit/xy", data=points.T + [[2], [1]])
    file.create_dataset("orbit/id", data=np.array([0, 0, 0, 1, 1], dtype="i1"))
    file.create_dataset("text", data=[b"no", b"numbers"])

for form, name in [("NETCDF3_CLASSIC", "classic.nc"), ("NETCDF3_64BIT_OFFSET", "offset.nc"),
                   ("NETCDF3_64BIT_DATA", "data.nc"), ("NETCDF4", "four.nc")]:
    with netCDF4.Dataset(name, "w", format=form) as file:
        file.createDimension("trajectory", 2)
        file.createDimension("obs", 7)
        lon = file.createVariable("lon", "f8", ("trajectory", "obs"), fill_value=-999.0)
        lat = file.createVariable("lat", "i4", ("trajectory", "obs"))
        lat.scale_factor, lat.add_offset = 0.05, 1.0
        lon[:, :5], lat[:, :5] = xs, ys
        lon[:, 5:] = np.ma.masked
with netCDF4.Dataset("grid.nc", "w", format="NETCDF3_CLASSIC") as file:
    for name in ("lon", "lat"):
        file.createDimension(name, 5)
        file.createVariable(name, "f8", (name,))[:] = x


def ring(k):
    return [[float(a), float(b)] for a, b in zip(xs[k], ys[k])] + [[float(xs[k][0]), float(ys[k][0])]]


hole = [[0.4, 0.4], [0.6, 0.4], [0.5, 0.6], [0.4, 0.4]]
with open("features.geojson", "w") as file:
    json.dump({"features": [
        {"geometry": {"coordinates": [ring(0), hole], "type": "Polygon"}, "type": "Feature", "id": 7,
         "properties": {"name": "one", "nested": {"type": "Point", "coordinates": [9, 9]}, "list": ["name", "x"]}},
        {"type": "Feature", "id": "two", "properties": None, "geometry": {"type": "GeometryCollection", "geometries": [
            {"type": "LineString", "coordinates": [[*p, 5.0] for p in ring(1)]}]}},
        {"type": "Feature", "properties": {}, "geometry": None},
        {"type": "Feature", "properties": {}, "geometry": {"type": "MultiPolygon",
                                                           "coordinates": [[ring(0), hole], [ring(1)]]}},
        {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [1, 2]}},
        {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [3, 4.5]}},
    ], "type": "FeatureCollection"}, file, indent=1)

frame = geopandas.GeoDataFrame({"n": [1, 2]}, geometry=[shapely.geometry.Polygon(ring(0), [hole]),
                                                        shapely.geometry.Polygon(ring(1))])
frame.to_file("polygons.shp")
for ending in ("cpg", "dbf", "prj", "shx"):
    pathlib.Path("polygons").with_suffix("." + ending).unlink(missing_ok=True)

# Attributes that say which numbers are none, and what the others mean; two curves of x and y / 20, from 0 to 65535 / 20.
for form, name in [("NETCDF3_CLASSIC", "packed.nc"), ("NETCDF4", "packed4.nc")]:
    with netCDF4.Dataset(name, "w", format=form) as file:
        file.createDimension("trajectory", 2)
        file.createDimension("obs", 9)
        lon = file.createVariable("Lon", "i2", ("trajectory", "obs"), fill_value=-1)
        lon.set_auto_maskandscale(False)
        lon.setncattr("_Unsigned", "true")
        lon.setncattr("scale_factor", 0.05)
        lon.setncattr("valid_range", np.array([0, -16], "i2"))
        lat = file.createVariable("Lat", "f4", ("trajectory", "obs"))
        lat.set_auto_maskandscale(False)
        lat.setncattr("missing_value", np.array([-999.9, 1e30], "f4"))
        lat.setncattr("valid_max", np.float32(500))
        for k in (0, 1):
            lon[k] = np.array([0, 20, 30, 65000, 40000, 5, 6, 65535, 65530], "u2").view("i2")
            lat[k] = [k, k + 0.5, k + 1, k + 2, k + 3, -999.9, 1e30, 7, 8]
        lat[1, 4] = 501
    with netCDF4.Dataset(name.replace("packed", "unwritten"), "w", format=form) as file:
        file.createDimension("obs", 5)
        for name_of, kind in (("x", "i4"), ("y", "i2")):  # the last ones were never written
            file.createVariable(name_of, kind, ("obs",))[:3] = [1, 2, 4]

# Curves of different lengths, one behind the other, as CF and the drifter archive have them; the second is empty.
for form, name in [("NETCDF3_CLASSIC", "ragged.nc"), ("NETCDF4", "ragged4.nc")]:
    with netCDF4.Dataset(name, "w", format=form) as file:
        file.createDimension("traj", 3)
        file.createDimension("obs", 10)
        file.createVariable("LONGITUDE", "f8", ("obs",), fill_value=-1e34)[:] = xs.ravel()
        file.createVariable("LATITUDE", "f8", ("obs",))[:] = ys.ravel()
        rowsize = file.createVariable("rowsize", "i4", ("traj",))
        rowsize.sample_dimension = "obs"
        rowsize[:] = [5, 0, 5]
        number = file.createVariable("ID", "i4", ("traj",))
        number.cf_role = "trajectory_id"
        number[:] = [101, 7, 2002]
    with netCDF4.Dataset(name.replace("ragged", "indexed"), "w", format=form) as file:
        file.createDimension("profile", 3)
        file.createDimension("obs", 10)
        file.createDimension("letters", 6)
        file.createVariable("lon", "f8", ("obs",))[:] = xs.T.ravel()
        file.createVariable("lat", "f8", ("obs",))[:] = ys.T.ravel()
        index = file.createVariable("index", "i4", ("obs",))
        index.instance_dimension = "profile"
        index[:] = [2, 0] * 5
        names = file.createVariable("station", "S1", ("profile", "letters"))
        names.cf_role = "profile_id"
        names[:] = netCDF4.stringtochar(np.array(["Bonn", "x", "Como 2"], "S6"))
np.savez("empty.npz", points=np.concatenate([points, points + [2, 1]]), offsets=np.array([0, 0, 5, 5, 10, 10]))

# Complex numbers, lists of curves of different lengths, links.
z = x + 1j * y
np.savez("complex.npz", z=z.astype("c16"), both=np.asfortranarray(np.stack([z, z + 2 + 1j])).astype(">c8"))
cells = np.empty(3, dtype=object)
cells[:] = [points, np.zeros((0, 2)), points.T + [[2], [1]]]
orbits = np.zeros(2, dtype=[("x", object), ("y", object), ("name", object)])
orbits[0], orbits[1] = (x, y, "one"), (np.append(x + 2, 9.0), np.append(y + 1, 8.0), "two")
scipy.io.savemat("lists.mat", {"c": cells, "s": orbits, "z": z, "w": np.stack([z, z + 2 + 1j]).T})
# octave7.mat is Octave's: x = [0;1;1.5;0.1;-0.3]; y = [0;0.1;1;1.25;0.7]; s(1).x = x; s(1).y = y; s(2).x = [x+2;9];
# s(2).y = [y+1;8]; c = {[x y], [x+2 y+1]}; zz = {x+1i*y, (x+2)+1i*(y+1)}; one = struct('x', {{x, x+2}}, 'y', {{y, y+1}});
# save -v7 octave7.mat s c zz one
with h5py.File("lists73.mat", "w", userblock_size=512) as file:
    for name, elements in {"c": [points.T, np.array([0, 0], "u8"), points + [2, 1]], "s/x": [x[None], x[None] + 2],
                           "s/y": [y[None], y[None] + 1]}.items():
        references = np.empty((len(elements), 1), dtype=h5py.ref_dtype)
        for k, element in enumerate(elements):
            file[f"#refs#/{name.replace('/', '_')}{k}"] = element
            if element.dtype == "u8":
                file[f"#refs#/{name}{k}"].attrs["MATLAB_empty"] = np.uint8(1)
            references[k, 0] = file[f"#refs#/{name.replace('/', '_')}{k}"].ref
        file.create_dataset(name, data=references)
    file["z"] = np.array(list(zip(x, y)), dtype=[("real", "f8"), ("imag", "f8")])[None]
with open("lists73.mat", "r+b") as file:
    file.write(b"MATLAB 7.3 MAT-file, made for a test".ljust(124) + b"\x00\x02IM")
with h5py.File("links.h5", "w", libver="earliest") as file:
    file["run/7/x"], file["run/7/y"], file["run/7/z"] = x, y, z
    file["last"] = h5py.SoftLink("/run/7")
    file["nowhere"] = h5py.SoftLink("/run/8")
    file["elsewhere"] = h5py.ExternalLink("two.npz", "/x")
    file["a#1"], file["b,1"] = x + 2, y + 1
