package org.u2sa.report.mosaic;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.u2sa.interfaces.DecodingLimit;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.ImageFootprint;

/**
 * Combines images and their footprints, matched by sensor and exposure time, into a mosaic. The
 * ground within an image is assumed to be a plane. Not thread-safe.
 */
public final class SurveyMosaic {
  private static final int MAX_WAITING = 32; // images or footprints without the other
  private static final DecodingLimit LIMIT =
      new DecodingLimit(25_000_000L, DecodingLimit.MAX_SCANNED_AT_LEISURE);
  private static final double MAX_AWAY_DEG = 1.0;
  private static final double MAX_ANGLE_RAD = Math.toRadians(60.0); // from the vertical

  private final MosaicGrid grid;
  private final UtmGrid utm;
  private final Geodetic middle;
  private final MosaicCanvas canvas;
  private final Map<String, U2SAData> waiting = new LinkedHashMap<>();
  private int used;
  private int refused;

  /**
   * @param grid its pixels
   */
  public SurveyMosaic(MosaicGrid grid) {
    this.grid = grid;
    utm = new UtmGrid(grid.frame());
    middle = utm.place(Point.of(grid.eastM(grid.columns() / 2), grid.northM(grid.rows() / 2), 0.0));
    canvas = new MosaicCanvas(grid);
  }

  /** Whether an image is usable: its footprint is in GLOBAL and seen steeply enough. */
  static boolean isUsable(ImageFootprint footprint) {
    return footprint.referenceFrame().equals(ReferenceFrame.GLOBAL)
        && footprint.points().size() == 4
        && footprint.angle() <= MAX_ANGLE_RAD;
  }

  /** Processes an image or a footprint; ignores other messages. */
  public void take(U2SAData message) {
    if (message instanceof CameraImage image) {
      pair(image.sensorName() + " " + image.timestamp(), message);
    } else if (message instanceof ImageFootprint footprint && isUsable(footprint)) {
      pair(footprint.sensorName() + " " + footprint.timestamp(), message);
    }
  }

  private void pair(String key, U2SAData message) {
    U2SAData other = waiting.remove(key);
    if (other instanceof CameraImage image && message instanceof ImageFootprint footprint) {
      draw(image, footprint);
    } else if (other instanceof ImageFootprint footprint && message instanceof CameraImage image) {
      draw(image, footprint);
    } else {
      waiting.put(key, message);
      if (waiting.size() > MAX_WAITING) {
        waiting.remove(waiting.keySet().iterator().next());
      }
    }
  }

  private void draw(CameraImage image, ImageFootprint footprint) {
    if (footprint.points().stream().anyMatch(this::isFar)) {
      refused++;
      return;
    }
    double[] xs = new double[4];
    double[] ys = new double[4];
    for (int i = 0; i < 4; i++) {
      Point at = utm.grid(Geodetic.of(footprint.points().get(i)));
      xs[i] = at.x();
      ys[i] = at.y();
    }
    try {
      BufferedImage pixels = decoded(image);
      int width = pixels.getWidth();
      int height = pixels.getHeight();
      Optional<ImageProjection> projection = ImageProjection.of(xs, ys, width, height);
      if (projection.isPresent()) {
        int[] rgb = pixels.getRGB(0, 0, width, height, null, 0, width);
        canvas.draw(rgb, width, height, projection.get(), xs, ys);
        used++;
        return;
      }
    } catch (IOException e) {
      // counted like an image that shows no ground: one damaged image must not spoil the mosaic
    }
    refused++;
  }

  /** Whether a position is too far away for the zone's projection. */
  private boolean isFar(Point place) {
    double eastDeg = Math.IEEEremainder(place.x() - middle.longitudeDeg(), 360.0);
    return !(Math.abs(eastDeg) < MAX_AWAY_DEG
        && Math.abs(place.y() - middle.latitudeDeg()) < MAX_AWAY_DEG);
  }

  private static BufferedImage decoded(CameraImage image) throws IOException {
    byte[] bytes = image.data().toBytes();
    try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
      if (!readers.hasNext()) {
        throw new IOException("no image");
      }
      ImageReader reader = readers.next();
      try {
        reader.setInput(in, true, true);
        long scans = DecodingLimit.scans(new ByteArrayInputStream(bytes)::read);
        LIMIT.require(reader.getWidth(0), reader.getHeight(0), scans);
        return reader.read(0);
      } catch (RuntimeException e) { // decoders throw these for damaged files
        throw new IOException("damaged", e);
      } finally {
        reader.dispose();
      }
    }
  }

  public MosaicGrid grid() {
    return grid;
  }

  /** The mosaic; transparent where nothing was seen. */
  public BufferedImage picture() {
    return canvas.picture();
  }

  /** Number of images used. */
  public int used() {
    return used;
  }

  /** Number of images that were damaged or whose footprint is not a quadrilateral. */
  public int refused() {
    return refused;
  }

  /** Ground area shown [m²]. */
  public double areaM2() {
    return canvas.seen() * grid.pixelM() * grid.pixelM();
  }

  /** Position of the middle of a pixel. */
  public Geodetic place(int column, int row) {
    return utm.place(Point.of(grid.eastM(column), grid.northM(row), 0.0));
  }
}
