#!/usr/bin/env python3
"""CT series in many shapes, read by `vallecula series --volume` and by independent readers.

Writes series with pydicom (and volume files with SimpleITK and nibabel), has the program read each, and compares the
place of every slice's corners (1e-3 mm) and every HU (exactly, or to the nearest whole number where the rescale is
fractional) with what pydicom, SimpleITK or nibabel make of the same files.

usage: read_ct.py PROGRAM [--data FOLDER_OF_A_REAL_SERIES] [--only WORD]
Needs pydicom, pylibjpeg (with libjpeg and openjpeg), SimpleITK, nibabel, numpy; exits with 77 when one is missing.
"""
import argparse
import copy
import gzip
import pathlib
import re
import subprocess
import sys
import tempfile
import warnings

try:
    import nibabel
    import numpy as np
    import pydicom
    import pylibjpeg  # noqa: F401
    import SimpleITK as sitk
    from pydicom.dataset import Dataset, FileMetaDataset
    from pydicom.encaps import encapsulate, generate_frames
    from pydicom.sequence import Sequence
    from pydicom.uid import (CTImageStorage, DeflatedExplicitVRLittleEndian, EnhancedCTImageStorage,
                             ExplicitVRBigEndian, ExplicitVRLittleEndian, ImplicitVRLittleEndian, JPEG2000,
                             JPEG2000Lossless, JPEGLossless, JPEGLosslessSV1, JPEGLSLossless, RLELossless)
except ImportError as missing:
    print(f"SKIPPED: {missing}; install pydicom, pylibjpeg, pylibjpeg-libjpeg, pylibjpeg-openjpeg, SimpleITK, nibabel")
    sys.exit(77)

warnings.filterwarnings("ignore")
sitk.ProcessObject.SetGlobalWarningDisplay(False)
POSITION_MM = 1e-3
ROWS, COLUMNS, SLICES = 40, 52, 18


def scene(k, low=0, high=4000):
    """Stored values without any symmetry, so that no axis can be turned unseen."""
    rng = np.random.default_rng(k)
    y, x = np.mgrid[0:ROWS, 0:COLUMNS]
    return np.clip(low + 37 * x + 11 * y + 53 * k + rng.integers(0, 9, (ROWS, COLUMNS)), low, high)


class Geometry:
    def __init__(self, row=(1, 0, 0), column=(0, 1, 0), step=None, spacing=(0.7, 0.9), gap=1.25, origin=(-31.25, 17.5, -400)):
        self.row, self.column = np.array(row, float), np.array(column, float)
        normal = np.cross(self.row, self.column)
        self.step = gap * normal if step is None else np.array(step, float)
        self.spacing, self.origin = spacing, np.array(origin, float)  # spacing: between rows, between columns

    def position(self, k):
        return self.origin + k * self.step


def decimals(values):
    return [pydicom.valuerep.DS(f"{v:.10g}"[:16]) for v in values]


def classic(k, geometry, stored, syntax=ExplicitVRLittleEndian, bits=16, high=None, signed=False, slope="1", intercept="-1024"):
    ds = Dataset()
    ds.file_meta = FileMetaDataset()
    ds.file_meta.TransferSyntaxUID = syntax
    ds.file_meta.MediaStorageSOPClassUID = ds.SOPClassUID = CTImageStorage
    ds.file_meta.MediaStorageSOPInstanceUID = ds.SOPInstanceUID = f"1.2.826.0.1.{k + 1}"
    ds.StudyInstanceUID, ds.SeriesInstanceUID, ds.Modality = "1.2.826.0.2", "1.2.826.0.3", "CT"
    ds.PatientName, ds.PatientID, ds.InstanceNumber = "Doe^Jane", "SECRET-77", 1
    ds.ImageType = ["ORIGINAL", "PRIMARY", "AXIAL"]
    ds.ImagePositionPatient = decimals(geometry.position(k))
    ds.ImageOrientationPatient = decimals([*geometry.row, *geometry.column])
    ds.PixelSpacing = decimals(geometry.spacing)
    ds.Rows, ds.Columns, ds.SamplesPerPixel, ds.PhotometricInterpretation = *stored.shape, 1, "MONOCHROME2"
    allocated = 8 * stored.dtype.itemsize
    ds.BitsAllocated, ds.BitsStored = allocated, min(bits, allocated)
    ds.HighBit, ds.PixelRepresentation = ds.BitsStored - 1, int(signed)
    ds.RescaleSlope, ds.RescaleIntercept, ds.RescaleType = slope, intercept, "HU"
    order = ">" if syntax == ExplicitVRBigEndian else "<"
    ds.PixelData = stored.astype(stored.dtype.newbyteorder(order)).tobytes()
    ds["PixelData"].VR = "OW"
    return ds


def packed(ds, syntax):
    """The pixels of `ds` packed: by pydicom where it can, else by SimpleITK's writer, whose stream is taken over."""
    if syntax in (RLELossless, JPEG2000Lossless):
        ds.compress(syntax, generate_instance_uid=False)
        return ds
    kind = {JPEG2000: "JPEG2000", JPEGLossless: "JPEG", JPEGLosslessSV1: "JPEG", JPEGLSLossless: "JPEGLS"}[syntax]
    with tempfile.TemporaryDirectory() as folder:
        name = folder + "/a.dcm"
        writer = sitk.ImageFileWriter()
        writer.SetFileName(name)
        writer.UseCompressionOn()
        writer.SetCompressor(kind)
        writer.Execute(sitk.GetImageFromArray(ds.pixel_array))
        other = pydicom.dcmread(name)
    if kind == "JPEGLS" and other.file_meta.TransferSyntaxUID != JPEGLSLossless:
        return None  # this SimpleITK cannot write it
    ds.PixelData = encapsulate([next(generate_frames(other.PixelData, number_of_frames=1))])
    ds["PixelData"].VR = "OB"
    ds["PixelData"].is_undefined_length = True
    ds.file_meta.TransferSyntaxUID = syntax
    return ds


def save(ds, file):
    file.parent.mkdir(parents=True, exist_ok=True)
    ds.save_as(file, enforce_file_format=True)


def enhanced(geometry, stored, order, slopes):
    ds = classic(0, geometry, stored[0])
    ds.file_meta.MediaStorageSOPClassUID = ds.SOPClassUID = EnhancedCTImageStorage
    for tag in ("ImagePositionPatient", "ImageOrientationPatient", "PixelSpacing", "RescaleSlope", "RescaleIntercept", "RescaleType"):
        del ds[tag]

    def item(**values):
        inner = Dataset()
        for key, value in values.items():
            setattr(inner, key, value)
        return Sequence([inner])

    shared = Dataset()
    shared.PixelMeasuresSequence = item(PixelSpacing=decimals(geometry.spacing), SliceThickness="1")
    shared.PlaneOrientationSequence = item(ImageOrientationPatient=decimals([*geometry.row, *geometry.column]))
    ds.SharedFunctionalGroupsSequence = Sequence([shared])
    frames = []
    for k in order:
        frame = Dataset()
        frame.PlanePositionSequence = item(ImagePositionPatient=decimals(geometry.position(k)))
        frame.PixelValueTransformationSequence = item(RescaleSlope=slopes[k], RescaleIntercept="-1024", RescaleType="HU")
        frames.append(frame)
    ds.PerFrameFunctionalGroupsSequence = Sequence(frames)
    ds.NumberOfFrames = len(order)
    ds.PixelData = b"".join(stored[k].astype("<u2").tobytes() for k in order)
    return ds


# What the independent readers say: a list of (position of the first voxel, row step, column step, HU array).
def by_pydicom(files):
    slices = []
    for file in files:
        ds = pydicom.dcmread(file, force=True)
        array = ds.pixel_array
        if "PerFrameFunctionalGroupsSequence" not in ds:
            slices.append(plane(ds, ds, ds, array if array.ndim == 2 else array[0], ds))
            continue
        shared = ds.SharedFunctionalGroupsSequence[0]
        for f, frame in enumerate(ds.PerFrameFunctionalGroupsSequence):
            slices.append(plane(frame.PlanePositionSequence[0], shared.PlaneOrientationSequence[0],
                                shared.PixelMeasuresSequence[0], array[f], frame.PixelValueTransformationSequence[0]))
    return slices


def plane(at, orientation, measures, array, rescale):
    direction = np.array(orientation.ImageOrientationPatient, float)
    spacing = [float(v) for v in measures.PixelSpacing]
    hu = array.astype(float) * float(rescale.RescaleSlope) + float(rescale.RescaleIntercept)
    return np.array(at.ImagePositionPatient, float), direction[:3] * spacing[1], direction[3:] * spacing[0], hu


def by_sitk(image):
    direction = np.array(image.GetDirection()).reshape(3, 3)
    steps = direction * np.array(image.GetSpacing())
    array = sitk.GetArrayFromImage(image).astype(float)
    return [(np.array(image.GetOrigin()) + k * steps[:, 2], steps[:, 0], steps[:, 1], array[k]) for k in range(array.shape[0])]


def by_nibabel(file):
    image = nibabel.load(file)
    turn = np.diag([-1, -1, 1, 1]) @ image.affine
    array = np.asanyarray(image.dataobj).astype(float)
    return [(turn[:3, 3] + k * turn[:3, 2], turn[:3, 0], turn[:3, 1], array[:, :, k].T) for k in range(array.shape[2])]


def read_nrrd(file):
    head, voxels = pathlib.Path(file).read_bytes().split(b"\n\n", 1)
    fields = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line)
    sizes = [int(n) for n in fields["sizes"].split()]
    numbers = lambda text: np.array([float(n) for n in re.findall(r"[-+.\de]+", text)])
    assert fields["space"] == "left-posterior-superior" and fields["endian"] == "little" and fields["encoding"] == "raw"
    hu = np.frombuffer(voxels, "<i2").reshape(sizes[::-1])
    return numbers(fields["space origin"]), numbers(fields["space directions"]).reshape(3, 3), hu


class Check:
    def __init__(self, program, only):
        self.program, self.only, self.failures, self.count = program, only, 0, 0

    def wanted(self, name):
        return not self.only or self.only in name

    def run(self, place, *options):
        with tempfile.TemporaryDirectory() as folder:
            out = folder + "/v.nrrd"
            done = subprocess.run([self.program, "series", str(place), "--volume", out, *options], capture_output=True, text=True)
            for secret in ("Doe", "Jane", "SECRET", "1.2.826"):
                assert secret not in done.stdout + done.stderr, done.stdout + done.stderr
            return (read_nrrd(out) if done.returncode == 0 else None), done.stdout + done.stderr

    def verdict(self, name, fault, facts=""):
        self.count += 1
        self.failures += bool(fault)
        print(f"{'FAILED ' if fault else 'ok     '} {name:48s} {fault or facts}", flush=True)

    def agrees(self, name, place, slices, options=(), says=None, extra_slices=0):
        if not self.wanted(name):
            return
        volume, words = self.run(place, *options)
        if volume is None:
            return self.verdict(name, "refused: " + words.strip())
        origin, steps, hu = volume
        fault, worst_mm, worst_hu = None, 0.0, 0.0
        if hu.shape[0] != len(slices) + extra_slices:
            return self.verdict(name, f"{hu.shape[0]} slices, expected {len(slices) + extra_slices}")
        for first, along_row, along_column, truth in slices:
            k = int(round(np.linalg.solve(steps.T, first - origin)[2]))
            if not 0 <= k < hu.shape[0] or hu[k].shape != truth.shape:
                return self.verdict(name, "a slice is missing or has another matrix")
            for j in (0, truth.shape[0] - 1):
                for i in (0, truth.shape[1] - 1):
                    ours = origin + np.array([i, j, k]) @ steps
                    worst_mm = max(worst_mm, np.linalg.norm(ours - first - i * along_row - j * along_column))
            worst_hu = max(worst_hu, np.abs(hu[k] - truth).max())
        whole = all(np.array_equal(s[3], np.round(s[3])) for s in slices)
        if worst_mm > POSITION_MM or worst_hu > (0 if whole else 0.5 + 1e-9):
            fault = f"{worst_mm:.2g} mm, {worst_hu:.3g} HU off"
        if says and says not in words:
            fault = f"does not say '{says}': {words.strip()}"
        self.verdict(name, fault, f"{worst_mm:.1e} mm, {worst_hu:g} HU")

    def refuses(self, name, place, says, options=()):
        if not self.wanted(name):
            return
        volume, words = self.run(place, *options)
        self.verdict(name, "was read" if volume else None if says in words else "says: " + words.strip(), words.strip()[:90])


def dicom_cases(check, root):
    number = iter(range(10000))

    def series(name, geometry=Geometry(), change=lambda ds, k: ds, names=lambda k: f"{(k * 7 + 3) % SLICES:03d}.dcm", count=SLICES,
               dtype=np.uint16, low=0, says=None, sitk_too=False, extra_slices=0, **header):
        if not check.wanted(name):
            return
        folder = root / str(next(number))
        files = []
        for k in range(count):
            ds = change(classic(k, geometry, scene(k, low).astype(dtype), **header), k)
            if ds is None:
                continue
            save(ds, folder / names(k))
            files.append(folder / names(k))
        if not files:
            print(f"left out {name}: nothing here can write it")
            return
        check.agrees(name, folder, by_pydicom(files), says=says, extra_slices=extra_slices)
        if sitk_too:
            reader = sitk.ImageSeriesReader()
            reader.SetFileNames(reader.GetGDCMSeriesFileNames(str(folder)))
            check.agrees(name + " (SimpleITK)", folder, by_sitk(reader.Execute()))

    for syntax in (ImplicitVRLittleEndian, ExplicitVRLittleEndian, ExplicitVRBigEndian, DeflatedExplicitVRLittleEndian):
        series("syntax " + syntax.name, syntax=syntax, sitk_too=True)
    for syntax in (RLELossless, JPEGLossless, JPEGLosslessSV1, JPEGLSLossless, JPEG2000Lossless, JPEG2000):
        series("syntax " + syntax.name, change=lambda ds, k: packed(ds, syntax), sitk_too=True)
        series("signed, syntax " + syntax.name, change=lambda ds, k: packed(ds, syntax), dtype=np.int16, low=-900, signed=True,
               intercept="0")
    series("signed 16 bits", dtype=np.int16, low=-1500, signed=True, intercept="0", sitk_too=True)
    series("signed 12 bits in 16", dtype=np.int16, low=-1000, signed=True, bits=12, intercept="0",
           change=lambda ds, k: ds if ds.__setattr__("PixelData", (np.frombuffer(ds.PixelData, "<i2").clip(-2048, 2047) & 0xFFF)
                                                     .astype("<u2").tobytes()) is None else ds)
    series("12 bits in 16", bits=12, sitk_too=True)
    series("8 bits", dtype=np.uint8, slope="8", sitk_too=True)
    series("32 bits", dtype=np.uint32, bits=32)
    series("fractional slope", slope="0.37", intercept="-1000.5")
    series("rescale of each slice its own",
           change=lambda ds, k: ds if ds.__setattr__("RescaleIntercept", str(-1024 + k)) is None and
           ds.__setattr__("RescaleSlope", str(1 + k % 3)) is None else ds)

    def padding(ds, k):
        ds.add_new("PixelPaddingValue", "US", 5)
        ds.add_new("PixelPaddingRangeLimit", "US", 50)
        return ds
    series("padding value and range stay as rescaled", change=padding)
    c, s = np.cos(0.3), np.sin(0.3)
    for name, row, column in (("sagittal", (0, 1, 0), (0, 0, -1)), ("coronal", (1, 0, 0), (0, 0, -1)),
                              ("head to feet", (1, 0, 0), (0, -1, 0)), ("prone", (-1, 0, 0), (0, -1, 0)),
                              ("oblique", (c, s, 0), (-s * c, c * c, s))):
        series("orientation " + name, Geometry(row, column), sitk_too=True)
    series("gantry tilt", Geometry(column=(0, np.cos(0.26), np.sin(0.26)), step=(0, 0, 2.0)))
    series("anisotropic voxels", Geometry(spacing=(1.9, 0.3), gap=3.1), sitk_too=True)
    series("no file endings, folders in folders", names=lambda k: f"a{k % 3}/b/{k}")
    series("one slice missing", change=lambda ds, k: None if k == 7 else ds, says="missing", extra_slices=1)
    def with_overlay_bits(ds, k):  # PS3.5 8.1.1: what stands above the stored bits is no part of the value
        ds.PixelData = (np.frombuffer(ds.PixelData, "<u2") | 0xA000).astype("<u2").tobytes()
        return ds
    series("12 bits in 16, others set", bits=12, change=with_overlay_bits)

    folder = root / "companions"
    files = []
    for k in range(SLICES):
        save(classic(k, Geometry(), scene(k).astype(np.uint16)), folder / f"s{k}.dcm")
        files.append(folder / f"s{k}.dcm")
    (folder / "copy.dcm").write_bytes((folder / "s3.dcm").read_bytes())
    scout = classic(90, Geometry((0, 1, 0), (0, 0, -1)), scene(1).astype(np.uint16)[:30])
    scout.ImageType = ["ORIGINAL", "PRIMARY", "LOCALIZER"]
    save(scout, folder / "scout.dcm")
    other = classic(91, Geometry(), scene(1).astype(np.uint16))
    other.Modality, other.SeriesInstanceUID = "MR", "1.2.826.0.9"
    save(other, folder / "mr.dcm")
    (folder / "readme.txt").write_text("hello")
    (folder / "truth.nrrd").write_text("NRRD0004\nnot this one")
    check.agrees("scout, copy, MR, text and NRRD beside it", folder, by_pydicom(files), says="there twice")
    bare = root / "bare"
    bare.mkdir()
    for file in files:  # without preamble
        (bare / file.name).write_bytes(file.read_bytes()[132:])
    check.agrees("files without preamble", bare, by_pydicom(sorted(bare.iterdir())))

    stored = [scene(k).astype(np.uint16) for k in range(SLICES)]
    order = [(k * 5 + 2) % SLICES for k in range(SLICES)]
    for name, geometry in (("axial", Geometry()), ("oblique", Geometry((c, s, 0), (-s * c, c * c, s)))):
        ds = enhanced(geometry, stored, order, [str(1 + k % 2) for k in range(SLICES)])
        file = root / f"enhanced-{name}" / "one.dcm"
        save(ds, file)
        check.agrees(f"Enhanced CT {name}, frames shuffled", file, by_pydicom([file]))
        check.agrees(f"Enhanced CT {name}, its folder", file.parent, by_pydicom([file]))
        for syntax in (RLELossless, JPEG2000Lossless):
            again = copy.deepcopy(ds)
            again.compress(syntax, generate_instance_uid=False)
            file = root / f"enhanced-{name}-{syntax.name[:4]}" / "one.dcm"
            save(again, file)
            check.agrees(f"Enhanced CT {name}, {syntax.name}", file, by_pydicom([file]))

    for name, gap in (("bridged", 2.0), ("refused", 9.0)):
        folder, files = root / ("hole-" + name), []
        for k in range(SLICES):
            geometry = Geometry(origin=(0, 0, gap if k > 8 else 0.0), gap=1.0)
            save(classic(k, geometry, scene(k).astype(np.uint16)), folder / f"{k}.dcm")
            files.append(folder / f"{k}.dcm")
        if name == "bridged":
            check.agrees("a hole of 3 mm bridged", folder, by_pydicom(files), says="the widest gap is 3 mm", extra_slices=2)
        else:
            check.refuses("a hole of 10 mm refused", folder, "a gap of 10 mm between z = 8 and z = 18 mm")


def volume_cases(check, root):
    array = np.stack([scene(k).astype(np.int16) - 1024 for k in range(SLICES)])
    c, s = np.cos(0.3), np.sin(0.3)
    for name, direction in (("axial", (1, 0, 0, 0, 1, 0, 0, 0, 1)), ("turned", (0, 0, 1, 1, 0, 0, 0, -1, 0)),
                            ("oblique", (c, -s, 0, s, c, 0, 0, 0, 1))):
        image = sitk.GetImageFromArray(array)
        image.SetSpacing((0.7, 0.9, 1.25))
        image.SetOrigin((-31.25, 17.5, -400))
        image.SetDirection(direction)
        for ending in ("nrrd", "nhdr", "mha", "mhd", "nii", "nii.gz"):
            for squeeze in ((False, True) if ending in ("nrrd", "mha", "mhd") else (False,)):
                for kind in (sitk.sitkInt16, sitk.sitkFloat32, sitk.sitkFloat64, sitk.sitkInt32):
                    if kind != sitk.sitkInt16 and name != "oblique":
                        continue
                    file = root / f"{name}-{kind}-{squeeze}.{ending}"
                    sitk.WriteImage(sitk.Cast(image, kind), str(file), squeeze)
                    label = f"{ending} {name}{' packed' if squeeze else ''} {sitk.GetPixelIDValueAsString(kind)[:14]}"
                    check.agrees(label, file, by_sitk(sitk.ReadImage(str(file))))
                    if ending.startswith("nii"):
                        check.agrees(label + " (nibabel)", file, by_nibabel(file))
    affine = np.array([[-0.7 * c, 0.9 * s, 0, 30], [-0.7 * s, -0.9 * c, 0, -12], [0, 0, 1.25, -400], [0, 0, 0, 1]])
    for name, use in (("sform alone", (2, 0)), ("qform alone", (0, 1))):
        for order in "<>":
            header = nibabel.Nifti1Header(endianness=order)
            header.set_data_dtype(np.int16)
            image = nibabel.Nifti1Image(np.moveaxis(array, 0, 2).swapaxes(0, 1), affine, header)
            image.set_sform(affine, use[0])
            image.set_qform(affine, use[1])
            file = root / f"{name[:5]}{'le' if order == '<' else 'be'}.nii"
            nibabel.save(image, file)
            check.agrees(f"nii {name}, {'little' if order == '<' else 'big'} endian", file, by_nibabel(file))
    head = (f"NRRD0005\ntype: short\ndimension: 3\nspace: right-anterior-superior\nsizes: {COLUMNS} {ROWS} {SLICES}\n"
            "space directions: (-0.7,0,0) (0,-0.9,0) (0,0,1.25)\nspace origin: (30,-12,-400)\nendian: big\nencoding: gzip\n\n")
    (root / "ras.nrrd").write_bytes(head.encode() + gzip.compress(array.astype(">i2").tobytes()))
    check.agrees("nrrd RAS big endian gzip", root / "ras.nrrd", by_sitk(sitk.ReadImage(str(root / "ras.nrrd"))))


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("program")
    arguments.add_argument("--data")
    arguments.add_argument("--only")
    options = arguments.parse_args()
    check = Check(options.program, options.only)
    with tempfile.TemporaryDirectory() as folder:
        dicom_cases(check, pathlib.Path(folder) / "dicom")
        (pathlib.Path(folder) / "volumes").mkdir()
        volume_cases(check, pathlib.Path(folder) / "volumes")
        if options.data and pathlib.Path(options.data).is_dir():
            files = sorted(pathlib.Path(options.data).iterdir())
            check.agrees("a real series (pydicom)", options.data, by_pydicom(files))
            reader = sitk.ImageSeriesReader()
            reader.SetFileNames(reader.GetGDCMSeriesFileNames(options.data))
            check.agrees("a real series (SimpleITK)", options.data, by_sitk(reader.Execute()))
    print(f"{check.failures} of {check.count} failed")
    return int(check.failures > 0 or check.count == 0)


if __name__ == "__main__":
    sys.exit(main())
