package org.u2sa.report.mosaic;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.plugins.tiff.GeoTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import javax.imageio.plugins.tiff.TIFFField;
import javax.imageio.plugins.tiff.TIFFTag;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.report.ReportFile;
import org.u2sa.report.picture.PictureFile;

/**
 * Writes a mosaic as GeoTIFF (OGC 19-008r4), or as PNG with a world file and the coordinate
 * reference system beside it.
 */
public final class MosaicFile {
  private static final GeoTIFFTagSet TAGS = GeoTIFFTagSet.getInstance();

  private MosaicFile() {}

  /**
   * Writes a mosaic.
   *
   * @param file ends in .png, .tif or .tiff
   * @throws BadInputException if it ends otherwise
   */
  public static void write(SurveyMosaic mosaic, Path file) {
    requireKind(file);
    String name = file.getFileName().toString();
    if (!isPng(name)) {
      ReportFile.write(file, out -> tiff(mosaic, out));
      return;
    }
    String stem = name.substring(0, name.length() - 4);
    ReportFile.write(file, out -> PictureFile.png(out, mosaic.picture()));
    ReportFile.writeText(
        file.resolveSibling(stem + ".pgw"), text -> text.write(worldFile(mosaic.grid())));
    ReportFile.writeText(
        file.resolveSibling(stem + ".prj"), text -> text.write(projection(mosaic.grid())));
  }

  /**
   * Checks the kind of a file.
   *
   * @throws BadInputException if its name is neither a PNG's nor a TIFF's
   */
  public static void requireKind(Path file) {
    String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
    if (!isPng(name) && !name.endsWith(".tif") && !name.endsWith(".tiff")) {
      throw new BadInputException(file + ": expected a name that ends in .png, .tif or .tiff");
    }
  }

  private static boolean isPng(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(".png");
  }

  /** Six lines: steps, rotations, and the middle of the upper left pixel. */
  private static String worldFile(MosaicGrid grid) {
    return String.format(
        Locale.ROOT,
        "%.6f\n0\n0\n%.6f\n%.4f\n%.4f\n",
        grid.pixelM(),
        -grid.pixelM(),
        grid.eastM(0),
        grid.northM(0));
  }

  /** The coordinate reference system (OGC 01-009). */
  private static String projection(MosaicGrid grid) {
    int zone = grid.frame().zone();
    boolean isNorth = grid.frame().isNorth();
    return String.format(
        Locale.ROOT,
        "PROJCS[\"WGS 84 / UTM zone %d%s\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\","
            + "SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],"
            + "UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
            + "PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",%d],"
            + "PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],"
            + "PARAMETER[\"false_northing\",%d],UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"%d\"]]\n",
        zone,
        isNorth ? "N" : "S",
        6 * zone - 183,
        isNorth ? 0 : 10_000_000,
        grid.epsg());
  }

  private static void tiff(SurveyMosaic mosaic, OutputStream out) throws IOException {
    MosaicGrid grid = mosaic.grid();
    BufferedImage picture = mosaic.picture();
    ImageWriter writer = ImageIO.getImageWritersByFormatName("tiff").next();
    try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      ImageWriteParam parameters = writer.getDefaultWriteParam();
      parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
      parameters.setCompressionType("Deflate");
      TIFFDirectory tags =
          TIFFDirectory.createFromMetadata(
              writer.getDefaultImageMetadata(
                  ImageTypeSpecifier.createFromRenderedImage(picture), parameters));
      numbers(tags, GeoTIFFTagSet.TAG_MODEL_PIXEL_SCALE, grid.pixelM(), grid.pixelM(), 0.0);
      numbers(
          tags, GeoTIFFTagSet.TAG_MODEL_TIE_POINT, 0.0, 0.0, 0.0, grid.westM(), grid.northM(), 0.0);
      // version 1.1.0 with 3 keys: projected model, a pixel is an area, the system
      char[] keys = {1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, (char) grid.epsg()};
      TIFFTag directory = TAGS.getTag(GeoTIFFTagSet.TAG_GEO_KEY_DIRECTORY);
      tags.addTIFFField(new TIFFField(directory, TIFFTag.TIFF_SHORT, keys.length, keys));
      writer.setOutput(stream);
      writer.write(null, new IIOImage(picture, null, tags.getAsMetadata()), parameters);
    } finally {
      writer.dispose();
    }
  }

  private static void numbers(TIFFDirectory tags, int tag, double... values) {
    tags.addTIFFField(new TIFFField(TAGS.getTag(tag), TIFFTag.TIFF_DOUBLE, values.length, values));
  }
}
