"""Holds `vallecula compare` and the files of a package against independent programs.

  python3 exchange_formats.py PROGRAM [PACKAGE.patient]

PROGRAM is the vallecula to ask. Needs numpy, scipy, SimpleITK, nibabel, pydicom, meshio. One label map, oblique in the
patient, is written by those libraries in every format that is read: each must be voxel for voxel the same
(Dice 1, Hausdorff 0). Two different ones are measured by SimpleITK and scipy and must agree with what compare prints.
With a package its labels.nrrd, landmarks.mrk.json and STL are read by SimpleITK, json and meshio.
"""
import json
import os
import subprocess
import sys
import tempfile

import nibabel
import numpy as np
import pydicom
import SimpleITK as sitk
from pydicom.dataset import Dataset, FileMetaDataset
from pydicom.sequence import Sequence
from scipy import ndimage

NAMES = {1: "skin", 2: "bone_skull", 3: "bone_mandible", 4: "tongue", 6: "airway"}
CODES = {1: "39937001", 2: "89546000", 3: "91609006", 4: "21974007", 6: "89187006"}
SPACING = (0.7, 0.8, 1.1)


def rotation():
    a, b, c = np.radians([17.0, -9.0, 24.0])
    x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    y = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    z = np.array([[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]])
    return z @ y @ x


def blobs(seed, shape=(31, 40, 37)):
    """Labels of smooth random shape, z, y, x."""
    random = np.random.default_rng(seed)
    fields = [ndimage.gaussian_filter(random.standard_normal(shape), 3.0) for _ in NAMES]
    which = np.argmax(fields, axis=0)
    labels = np.array(list(NAMES), dtype=np.uint8)[which]
    labels[np.max(fields, axis=0) < np.quantile(np.max(fields, axis=0), 0.3)] = 0
    return labels


def image_of(labels, origin=(-12.5, 31.25, -70.0), direction=None):
    image = sitk.GetImageFromArray(labels)
    image.SetSpacing(SPACING)
    image.SetOrigin(origin)
    image.SetDirection((rotation() if direction is None else direction).ravel())
    return image


def name_segments(image):
    for n, (value, name) in enumerate(NAMES.items()):
        image.SetMetaData(f"Segment{n}_ID", f"Segment_{n}")
        image.SetMetaData(f"Segment{n}_Name", name)
        image.SetMetaData(f"Segment{n}_LabelValue", str(value))
        image.SetMetaData(f"Segment{n}_Layer", "0")
    return image


def lps_affine(image):
    affine = np.eye(4)
    affine[:3, :3] = np.array(image.GetDirection()).reshape(3, 3) * np.array(image.GetSpacing())
    affine[:3, 3] = image.GetOrigin()
    return affine


def write_ras_nrrd(image, path):
    """The same place said in RAS, with names and raw big-endian 16-bit voxels."""
    flip = np.diag([-1.0, -1.0, 1.0, 1.0])
    affine = flip @ lps_affine(image)
    vector = lambda v: "(" + ",".join(repr(float(x)) for x in v) + ")"
    with open(path, "wb") as out:
        size = image.GetSize()
        out.write(("NRRD0004\ntype: unsigned short\ndimension: 3\nspace: right-anterior-superior\n"
                   f"sizes: {size[0]} {size[1]} {size[2]}\nspace directions: "
                   + " ".join(vector(affine[:3, a]) for a in range(3)) + "\nkinds: domain domain domain\n"
                   f"endian: big\nencoding: raw\nspace origin: {vector(affine[:3, 3])}\n").encode())
        for n, (value, name) in enumerate(NAMES.items()):
            out.write(f"Segment{n}_ID:=S{n}\nSegment{n}_Name:={name.upper()}\nSegment{n}_LabelValue:={value}\n"
                      f"Segment{n}_Layer:=0\n".encode())
        out.write(b"\n" + sitk.GetArrayFromImage(image).astype(">u2").tobytes())


def write_layers(image, path):
    """Slicer's 4D file of overlapping segments: skin lies under all others, in a layer of its own."""
    labels = sitk.GetArrayFromImage(image)
    skin = (labels > 0).astype(np.uint8)
    others = np.where(labels == 1, 0, labels)
    both = np.stack([skin, others], axis=-1)  # z, y, x, layer: layer runs fastest
    affine = lps_affine(image)
    vector = lambda v: "(" + ",".join(repr(float(x)) for x in v) + ")"
    with open(path, "wb") as out:
        size = image.GetSize()
        out.write(("NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\n"
                   f"sizes: 2 {size[0]} {size[1]} {size[2]}\nspace directions: none "
                   + " ".join(vector(affine[:3, a]) for a in range(3)) + "\nkinds: list domain domain domain\n"
                   f"encoding: raw\nspace origin: {vector(affine[:3, 3])}\n").encode())
        for n, (value, name) in enumerate(NAMES.items()):
            layer, label = (0, 1) if value == 1 else (1, value)
            out.write(f"Segment{n}_ID:=S{n}\nSegment{n}_Name:={name}\nSegment{n}_LabelValue:={label}\n"
                      f"Segment{n}_Layer:={layer}\n".encode())
        out.write(b"\n" + both.tobytes())
    return skin


def write_dicom_seg(image, path):
    """Binary SEG: one frame a segment and slice that is not empty, bits running on from frame to frame."""
    labels = sitk.GetArrayFromImage(image)
    affine = lps_affine(image)
    direction = np.array(image.GetDirection()).reshape(3, 3)
    ds = Dataset()
    ds.file_meta = FileMetaDataset()
    ds.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
    ds.file_meta.MediaStorageSOPClassUID = ds.SOPClassUID = "1.2.840.10008.5.1.4.1.1.66.4"
    ds.file_meta.MediaStorageSOPInstanceUID = ds.SOPInstanceUID = pydicom.uid.generate_uid()
    ds.Modality = "SEG"
    ds.PatientName = "Doe^Jane"
    ds.Rows, ds.Columns = labels.shape[1:]
    ds.BitsAllocated = ds.BitsStored = 1
    ds.HighBit = ds.PixelRepresentation = 0
    ds.SamplesPerPixel = 1
    ds.PhotometricInterpretation = "MONOCHROME2"
    ds.SegmentationType = "BINARY"
    segments, frames, bits = [], [], []
    for number, (value, name) in enumerate(NAMES.items(), 1):
        segment = Dataset()
        segment.SegmentNumber = number
        segment.SegmentLabel = name if value != 4 else "Zunge"  # the code must tell it
        code = Dataset()
        code.CodeValue, code.CodingSchemeDesignator, code.CodeMeaning = CODES[value], "SCT", name
        segment.SegmentedPropertyTypeCodeSequence = Sequence([code])
        segments.append(segment)
        for k in range(labels.shape[0]):
            mask = labels[k] == value
            if not mask.any():
                continue
            frame = Dataset()
            position, identification = Dataset(), Dataset()
            position.ImagePositionPatient = [f"{v:.10g}" for v in affine[:3, 3] + k * affine[:3, 2]]
            identification.ReferencedSegmentNumber = number
            frame.PlanePositionSequence = Sequence([position])
            frame.SegmentIdentificationSequence = Sequence([identification])
            frames.append(frame)
            bits.append(mask.ravel())
    shared, orientation, measures = Dataset(), Dataset(), Dataset()
    orientation.ImageOrientationPatient = [f"{v:.10g}" for v in list(direction[:, 0]) + list(direction[:, 1])]
    measures.PixelSpacing = [SPACING[1], SPACING[0]]
    measures.SliceThickness = SPACING[2]
    shared.PlaneOrientationSequence = Sequence([orientation])
    shared.PixelMeasuresSequence = Sequence([measures])
    ds.SharedFunctionalGroupsSequence = Sequence([shared])
    ds.PerFrameFunctionalGroupsSequence = Sequence(frames)
    ds.SegmentSequence = Sequence(segments)
    ds.NumberOfFrames = len(frames)
    packed = np.packbits(np.concatenate(bits), bitorder="little").tobytes()
    ds.PixelData = packed + b"\0" * (len(packed) % 2)
    ds["PixelData"].VR = "OB"
    ds.save_as(path, enforce_file_format=True)


def compare(program, a, b):
    result = subprocess.run([program, "compare", a, b, "--json"], capture_output=True, text=True)
    if result.returncode != 0:
        raise SystemExit(f"{os.path.basename(b)}: {result.stderr}")
    out = json.loads(result.stdout)
    return out["resampled"], {s["name"]: s for s in out["structures"]}


def check(good, what):
    print(("ok    " if good else "WRONG ") + what)
    if not good:
        check.failed = True


check.failed = False


def distances(a, b, spacing):
    """Surface distances both ways by scipy's exact transform; surface: a voxel with one of six neighbours outside."""
    ends = []
    for mask in (a, b):
        ends.append(mask & ~ndimage.binary_erosion(mask, ndimage.generate_binary_structure(3, 1), border_value=0))
    to = [ndimage.distance_transform_edt(~end, sampling=spacing[::-1]) for end in ends]
    return to[1][ends[0]], to[0][ends[1]], ends


def formats(program, folder):
    labels = blobs(1)
    image = image_of(labels)
    at = lambda name: os.path.join(folder, name)
    sitk.WriteImage(name_segments(image), at("reference.nrrd"), True)
    cases = []
    write_ras_nrrd(image, at("ras.nrrd"))
    cases.append("ras.nrrd")
    sitk.WriteImage(image, at("sitk.nii.gz"))
    cases.append("sitk.nii.gz")
    ras = np.diag([-1.0, -1.0, 1.0, 1.0]) @ lps_affine(image)
    voxels = labels.transpose(2, 1, 0)
    nibabel.save(nibabel.Nifti1Image(voxels.astype(np.float64), ras), at("float.nii"))
    cases.append("float.nii")
    nibabel.save(nibabel.Nifti2Image(voxels.astype(np.int16), ras), at("second.nii.gz"))
    cases.append("second.nii.gz")
    only_q = nibabel.Nifti1Image(voxels.astype(np.int32), None)
    only_q.set_qform(ras, 1)
    only_q.set_sform(None, 0)
    nibabel.save(only_q, at("qform.nii"))
    cases.append("qform.nii")
    header = nibabel.Nifti1Header(endianness=">")
    nibabel.save(nibabel.Nifti1Image(voxels.astype(">i2"), ras, header), at("big.nii"))
    cases.append("big.nii")
    write_dicom_seg(image, at("seg.dcm"))
    cases.append("seg.dcm")
    for name in cases:
        resampled, found = compare(program, at("reference.nrrd"), at(name))
        same = set(found) == set(NAMES.values()) and all(s["dice"] == 1 and s["hausdorff_mm"] == 0 for s in found.values())
        check(same and not resampled, f"{name}: the same voxels at the same place")

    skin = write_layers(image, at("layers.seg.nrrd"))
    _, found = compare(program, at("reference.nrrd"), at("layers.seg.nrrd"))
    check(found["skin"]["voxels_b"] == int(skin.sum()) and found["tongue"]["dice"] == 1, "layers.seg.nrrd: overlaps kept")

    low = [5, 6, 4]
    high = [30, 33, 25]
    cropped = image[low[0]:high[0], low[1]:high[1], low[2]:high[2]]
    sitk.WriteImage(name_segments(cropped), at("cropped.nrrd"), True)
    resampled, found = compare(program, at("reference.nrrd"), at("cropped.nrrd"))
    inside = labels[low[2]:high[2], low[1]:high[1], low[0]:high[0]]
    check(resampled and all(found[n]["voxels_b"] == int((inside == v).sum()) for v, n in NAMES.items()),
          "cropped.nrrd: each voxel where it was")

    straight = sitk.Image([50, 45, 40], sitk.sitkUInt8)
    straight.SetOrigin((-20.0, 25.0, -75.0))
    straight.SetSpacing((0.9, 0.9, 0.9))
    truth = sitk.GetArrayFromImage(sitk.Resample(image, straight, sitk.Transform(), sitk.sitkNearestNeighbor, 0))
    sitk.WriteImage(name_segments(filled(straight, truth)), at("straight.nrrd"), True)
    resampled, found = compare(program, at("straight.nrrd"), at("reference.nrrd"))
    worst = min(s["dice"] for s in found.values())
    check(resampled and worst > 0.9999, f"resampled as SimpleITK does (least Dice {worst:.6f})")


def filled(like, labels):
    out = sitk.GetImageFromArray(labels.astype(np.uint8))
    out.CopyInformation(like)
    return out


def measures(program, folder):
    a, b = blobs(1), ndimage.shift(blobs(1), (1, -2, 2), order=0)
    b[:, :, 30:] = blobs(2)[:, :, 30:]
    at = lambda name: os.path.join(folder, name)
    images = [image_of(x, direction=np.eye(3)) for x in (a, b)]
    for image, name in zip(images, ("a.nrrd", "b.nrrd")):
        sitk.WriteImage(name_segments(image), at(name), True)
    _, found = compare(program, at("a.nrrd"), at("b.nrrd"))
    overlap = sitk.LabelOverlapMeasuresImageFilter()
    overlap.Execute(*images)
    for value, name in NAMES.items():
        ours = found[name]
        check(abs(ours["dice"] - overlap.GetDiceCoefficient(value)) < 1e-9, f"{name}: Dice {ours['dice']:.4f}")
        ab, ba, ends = distances(a == value, b == value, SPACING)
        surfaces = [filled(images[0], end) for end in ends]
        hausdorff = sitk.HausdorffDistanceImageFilter()
        hausdorff.Execute(*surfaces)
        rank = lambda d: np.sort(d)[int(np.ceil(0.95 * d.size)) - 1]
        for key, truth in (("hausdorff_mm", hausdorff.GetHausdorffDistance()),
                           ("hausdorff_95_mm", max(rank(ab), rank(ba))),
                           ("mean_surface_mm", (ab.sum() + ba.sum()) / (ab.size + ba.size))):
            check(abs(ours[key] - truth) < 1e-4, f"{name}: {key} {ours[key]:.4f} ({truth:.4f})")


def package(program, path, folder):
    import meshio

    image = sitk.ReadImage(os.path.join(path, "labels.nrrd"))
    labels = sitk.GetArrayFromImage(image)
    keys = {k: image.GetMetaData(k) for k in image.GetMetaDataKeys()}
    names = {int(keys[f"Segment{n}_LabelValue"]): keys[f"Segment{n}_Name"] for n in range(20) if f"Segment{n}_Name" in keys}
    check(set(names) == set(np.unique(labels)) - {0} and names[4] == "tongue", f"labels.nrrd: {len(names)} named segments")
    for n, (value, name) in enumerate(names.items()):
        where = np.argwhere(labels == value)
        extent = " ".join(f"{where[:, a].min()} {where[:, a].max()}" for a in (2, 1, 0))
        good = keys[f"Segment{n}_Extent"] == extent and "~SCT^" in keys[f"Segment{n}_Tags"]
        check(good and keys[f"Segment{n}_Layer"] == "0", f"labels.nrrd: extent and code of {name}")
    sitk.WriteImage(image, os.path.join(folder, "again.nrrd"), True)
    resampled, found = compare(program, os.path.join(path, "labels.nrrd"), os.path.join(folder, "again.nrrd"))
    check(not resampled and all(s["dice"] == 1 for s in found.values()), "labels.nrrd: through SimpleITK and back")

    with open(os.path.join(path, "landmarks.mrk.json")) as f:
        markup = json.load(f)["markups"][0]
    points = {p["label"]: p["position"] for p in markup["controlPoints"]}
    check(markup["coordinateSystem"] == "LPS" and len(points) == 10, "landmarks.mrk.json: ten points in LPS")
    at = image.TransformPhysicalPointToIndex(points["glottis_centre"])
    check(labels[at[2], at[1], at[0]] == 6, "landmarks.mrk.json: the glottis lies in the airway of labels.nrrd")

    subprocess.run([program, "export", path, "--stl", folder], check=True, capture_output=True)
    for name, value in (("mandible", [3]), ("airway", [6]), ("tongue", [4, 5])):
        mesh = meshio.read(os.path.join(folder, name + ".stl"))
        t = mesh.points[mesh.cells_dict["triangle"]].astype(float)
        volume = np.einsum("ij,ij->i", t[:, 0], np.cross(t[:, 1], t[:, 2])).sum() / 6.0
        truth = np.isin(labels, value).sum() * np.prod(image.GetSpacing())
        check(abs(volume / truth - 1) < 0.06, f"{name}.stl: {volume / 1000:.3f} ml of {truth / 1000:.3f} ml, outwards")


def main():
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        formats(program, folder)
        measures(program, folder)
        if len(sys.argv) > 2:
            package(program, sys.argv[2], folder)
    sys.exit(1 if check.failed else 0)


main()
