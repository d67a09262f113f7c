# SPDX-License-Identifier: BSD-3-Clause
"""Prints what pillow or gdal reads from a TIFF: a line a page, its width, height, no-data value and the bits of its values in hexadecimal,
the top row first. Exits with 77 where that module is absent. Usage: print_tiff.py pillow|gdal FILE"""
import struct
import sys


def pillow_pages(file):
    from PIL import Image, ImageSequence
    gdal_no_data = 42113
    with Image.open(file) as image:
        for page in ImageSequence.Iterator(image):
            assert page.mode == "F", page.mode
            yield page.width, page.height, page.tag_v2[gdal_no_data], page.tobytes()


def gdal_pages(file):
    from osgeo import gdal
    gdal.UseExceptions()
    for name in [name for name, _ in gdal.Open(file).GetSubDatasets()] or [file]:
        page = gdal.Open(name)
        assert page.RasterCount == 1, page.RasterCount
        band = page.GetRasterBand(1)
        assert gdal.GetDataTypeName(band.DataType) == "Float32", band.DataType
        yield page.RasterXSize, page.RasterYSize, band.GetNoDataValue(), band.ReadRaster()


try:
    for width, height, no_data, values in {"pillow": pillow_pages, "gdal": gdal_pages}[sys.argv[1]](sys.argv[2]):
        print(width, height, no_data, *(f"{bits:08x}" for bits in struct.unpack(f"={width * height}I", values)))
except ModuleNotFoundError as error:
    print(error, file=sys.stderr)
    sys.exit(77)
