package org.u2sa.sim.world;

import java.awt.image.Raster;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.plugins.tiff.BaselineTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import javax.imageio.plugins.tiff.TIFFField;
import javax.imageio.plugins.tiff.TIFFImageReadParam;
import javax.imageio.stream.ImageInputStream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.sim.motion.Arguments;

/**
 * Reads digital elevation models in the GeoTIFF format (OGC 19-008r4): one band of altitudes above
 * sea level [m], in WGS 84 degrees (EPSG 4326) or UTM (EPSG 326xx, 327xx), north up. Other
 * ellipsoidal or vertical datums are treated as if they were these.
 */
final class GeoTiff {
  private static final int MAX_SIDE = 8_192;
  private static final int MAX_POINTS = 2_048; // points of the height map in either direction
  private static final int SCALE = 33_550; // ModelPixelScale: x, y, z
  private static final int TIEPOINT = 33_922; // ModelTiepoint: column, row, 0, x, y, z
  private static final int KEYS = 34_735; // GeoKeyDirectory
  private static final int NO_DATA = 42_113; // GDAL_NODATA
  private static final Pattern NOT_FINITE = Pattern.compile("(?i)[+-]?(nan|inf(inity)?)");
  private static final int MODEL_TYPE = 1_024; // GTModelTypeGeoKey: 1 projected, 2 geographic
  private static final int RASTER_TYPE = 1_025; // GTRasterTypeGeoKey: 1 area, 2 point
  private static final int GEODETIC_CRS = 2_048;
  private static final int PROJECTED_CRS = 3_072;
  private static final double M_PER_DEGREE = 111_320.0;

  private final Raster raster;
  private final double[] scale;
  private final double[] tie;
  private final double shift; // of the tie point from the pixel's centre [px]
  private final Optional<UtmGrid> grid; // empty for degrees
  private final double noData;

  private GeoTiff(Raster raster, TIFFDirectory tags) throws IOException {
    this.raster = raster;
    scale = numbers(tags, SCALE, 2, "ModelPixelScale");
    tie = numbers(tags, TIEPOINT, 6, "ModelTiepoint");
    if (!(scale[0] > 0.0 && scale[1] > 0.0)) {
      throw new IOException("pixels of " + scale[0] + " by " + scale[1] + ": expected above 0");
    }
    boolean isProjected = key(tags, MODEL_TYPE) == 1;
    int code = key(tags, isProjected ? PROJECTED_CRS : GEODETIC_CRS);
    int zone = code % 100;
    boolean isUtm = (code / 100 == 326 || code / 100 == 327) && zone >= 1 && zone <= 60;
    if (isProjected ? !isUtm : code != 4_326) {
      throw new IOException("EPSG " + code + ": expected 4326 (WGS 84), 326xx or 327xx (its UTM)");
    }
    grid =
        isProjected
            ? Optional.of(
                new UtmGrid(ReferenceFrame.parse("UTM " + zone + (code / 100 == 326 ? "N" : "S"))))
            : Optional.empty();
    shift = key(tags, RASTER_TYPE) == 2 ? 0.0 : 0.5;
    noData = noData(tags);
  }

  /** Whether a file name is that of a GeoTIFF. */
  static boolean isNamed(String file) {
    return file.toLowerCase(Locale.ROOT).matches(".*\\.tiff?");
  }

  /**
   * Reads the heights around the origin of a plane.
   *
   * @param widthM extent from west to east, centred on the origin [m]
   * @param depthM extent from north to south [m]
   * @throws BadInputException naming the file, if it is not a GeoTIFF, or does not cover the extent
   */
  static HeightMap read(Path file, LocalPlane plane, double widthM, double depthM) {
    HeightMap.requireRegular(file);
    try (ImageInputStream stream = ImageIO.createImageInputStream(file.toFile())) {
      Arguments.requireInside("width [m]", widthM, 1.0, 100_000.0);
      Arguments.requireInside("depth [m]", depthM, 1.0, 100_000.0);
      return image(stream).around(plane, widthM, depthM);
    } catch (IOException | IllegalArgumentException e) {
      throw new BadInputException(file + ": height map: " + e.getMessage(), e);
    }
  }

  private static GeoTiff image(ImageInputStream stream) throws IOException {
    Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName("tiff");
    if (stream == null || !readers.hasNext()) {
      throw new IOException("cannot be opened");
    }
    ImageReader reader = readers.next();
    try {
      reader.setInput(stream, true, false);
      int width = reader.getWidth(0);
      int height = reader.getHeight(0);
      if (width < 2 || height < 2 || width > MAX_SIDE || height > MAX_SIDE) {
        throw new IOException(
            width + " by " + height + " pixels; expected 2 to " + MAX_SIDE + " each way");
      }
      requireRoom(width, height, Runtime.getRuntime().maxMemory());
      TIFFDirectory known = TIFFDirectory.createFromMetadata(reader.getImageMetadata(0));
      requireOneBand(known);
      requireNoJpeg(known);
      stream.seek(0);
      reader.setInput(stream, true, false); // reads all tags again, unknown ones too
      TIFFImageReadParam parameters = new TIFFImageReadParam();
      parameters.setReadUnknownTags(true);
      Raster raster = reader.read(0, parameters).getRaster();
      TIFFDirectory tags = TIFFDirectory.createFromMetadata(reader.getImageMetadata(0));
      return new GeoTiff(raster, tags);
    } catch (EOFException e) {
      throw new IOException("ends too early", e);
    } catch (RuntimeException e) { // decoders throw these for damaged files
      String why =
          e.getMessage() == null || e instanceof NullPointerException ? "" : ": " + e.getMessage();
      throw new IOException("is damaged" + why, e);
    } finally {
      reader.dispose();
    }
  }

  /** Checks the number of bands, before memory is taken for each. */
  private static void requireOneBand(TIFFDirectory tags) throws IOException {
    TIFFField samples = tags.getTIFFField(BaselineTIFFTagSet.TAG_SAMPLES_PER_PIXEL);
    int bands = samples == null ? 1 : samples.getAsInt(0);
    if (bands != 1) {
      throw new IOException(bands + " bands; expected one");
    }
  }

  /** Rejects tiles that are JPEG images: each may be of any size, whatever its tile's. */
  private static void requireNoJpeg(TIFFDirectory tags) throws IOException {
    TIFFField compression = tags.getTIFFField(BaselineTIFFTagSet.TAG_COMPRESSION);
    int code = compression == null ? 0 : compression.getAsInt(0);
    if (code == BaselineTIFFTagSet.COMPRESSION_JPEG
        || code == BaselineTIFFTagSet.COMPRESSION_OLD_JPEG) {
      throw new IOException("is compressed as JPEG; expected Deflate, LZW, PackBits or none");
    }
  }

  /** Checks the decoded size: a compressed map of one height is a thousand times smaller. */
  static void requireRoom(int width, int height, long heapBytes) throws IOException {
    long bytes = (long) width * height * Float.BYTES;
    if (bytes > heapBytes / 2) {
      throw new IOException(
          String.format(
              "%d by %d pixels take %d MB, more than half of this program's memory, %d MB",
              width, height, bytes >> 20, heapBytes >> 20));
    }
  }

  private static double[] numbers(TIFFDirectory tags, int tag, int least, String name)
      throws IOException {
    TIFFField field = tags.getTIFFField(tag);
    if (field == null || field.getCount() < least) {
      throw new IOException("has no " + name + "; expected a GeoTIFF");
    }
    return field.getAsDoubles();
  }

  /** Value of a short key; 0 if absent. */
  private static int key(TIFFDirectory tags, int id) {
    TIFFField field = tags.getTIFFField(KEYS);
    int count = field == null ? 0 : field.getCount();
    for (int i = 4; i + 3 < count; i += 4) {
      if (field.getAsInt(i) == id && field.getAsInt(i + 1) == 0) {
        return field.getAsInt(i + 3);
      }
    }
    return 0;
  }

  /** NaN if none is given, or if it is not finite: such heights never count. */
  private static double noData(TIFFDirectory tags) {
    TIFFField field = tags.getTIFFField(NO_DATA);
    String text = field == null ? "nan" : field.getAsString(0).trim();
    return NOT_FINITE.matcher(text).matches() ? Double.NaN : Double.parseDouble(text);
  }

  private HeightMap around(LocalPlane plane, double widthM, double depthM) throws IOException {
    double perUnit = grid.isPresent() ? 1.0 : M_PER_DEGREE;
    double east = grid.isPresent() ? 1.0 : Math.cos(Math.toRadians(plane.origin().latitudeDeg()));
    int columns = points(widthM / (scale[0] * perUnit * east));
    int rows = points(depthM / (scale[1] * perUnit));
    double[] heights = new double[columns * rows];
    for (int i = 0; i < heights.length; i++) {
      double x = (i % columns / (columns - 1.0) - 0.5) * widthM;
      double y = (0.5 - i / columns / (rows - 1.0)) * depthM;
      heights[i] = altitudeM(plane.at(x, y, 0.0)) - plane.origin().altitudeM();
    }
    return HeightMap.of(heights, columns, widthM, depthM);
  }

  private static int points(double pixels) {
    return (int) Math.max(2.0, Math.min(MAX_POINTS, Math.ceil(pixels) + 1.0));
  }

  private double altitudeM(Geodetic place) throws IOException {
    Point at = grid.map(utm -> utm.grid(place)).orElse(place.point());
    double column = tie[0] - shift + (at.x() - tie[3]) / scale[0];
    double row = tie[1] - shift - (at.y() - tie[4]) / scale[1];
    if (!(column >= -0.5
        && row >= -0.5
        && column <= raster.getWidth() - 0.5
        && row <= raster.getHeight() - 0.5)) {
      throw new IOException(
          String.format(
              Locale.ROOT,
              "does not reach %.6f, %.6f; expected a smaller width or depth, or a home within the map",
              place.longitudeDeg(),
              place.latitudeDeg()));
    }
    double x = Math.max(0.0, Math.min(raster.getWidth() - 1.0, column));
    double y = Math.max(0.0, Math.min(raster.getHeight() - 1.0, row));
    int left = Math.min(raster.getWidth() - 2, (int) x);
    int top = Math.min(raster.getHeight() - 2, (int) y);
    double right = x - left;
    double down = y - top;
    return (1.0 - down) * ((1.0 - right) * sample(left, top) + right * sample(left + 1, top))
        + down * ((1.0 - right) * sample(left, top + 1) + right * sample(left + 1, top + 1));
  }

  private double sample(int column, int row) throws IOException {
    double height = raster.getSampleDouble(column + raster.getMinX(), row + raster.getMinY(), 0);
    if (height == noData || !Double.isFinite(height)) {
      throw new IOException("has no height in column " + column + ", row " + row);
    }
    return height;
  }
}
