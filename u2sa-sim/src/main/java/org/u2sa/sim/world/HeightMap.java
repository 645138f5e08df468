package org.u2sa.sim.world;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.DecodingLimit;
import org.u2sa.sim.motion.Arguments;

/**
 * Terrain as heights on a rectangular grid around the origin, interpolated between them: rows start
 * in the north, as on a map. Beyond its edge, the ground continues at the edge's height. Immutable.
 */
public final class HeightMap implements Terrain {
  private static final int MAX_SIDE = 4_096;
  private static final DecodingLimit LIMIT =
      new DecodingLimit((long) MAX_SIDE * MAX_SIDE, DecodingLimit.MAX_SCANNED_AT_LEISURE);
  private static final double STEEPEST = 20.0; // maximum slope of a map that rays can search

  private final double[] heights; // rows from the north, each from the west [m]
  private final int columns;
  private final int rows;
  private final double spacingEastM;
  private final double spacingNorthM;
  private final double steepest;
  private final double highestM;

  private HeightMap(double[] heights, int columns, double widthM, double depthM) {
    this.heights = heights;
    this.columns = columns;
    rows = heights.length / columns;
    spacingEastM = widthM / (columns - 1);
    spacingNorthM = depthM / (rows - 1);
    double most = 0.0;
    double highest = Double.NEGATIVE_INFINITY;
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        double here = height(column, row);
        highest = Math.max(highest, here);
        double east = column + 1 < columns ? (height(column + 1, row) - here) / spacingEastM : 0.0;
        double north = row + 1 < rows ? (here - height(column, row + 1)) / spacingNorthM : 0.0;
        most = Math.max(most, Math.max(Math.abs(east), Math.abs(north)));
      }
    }
    steepest = most * StrictMath.sqrt(2.0); // maximum slope of a bilinear cell, along its diagonal
    highestM = highest;
  }

  /**
   * Creates a map.
   *
   * @param heights heights above the world's plane by rows from the north, each from the west [m]
   * @param columns number of heights in a row, at least 2; as many rows, at least 2
   * @param widthM extent from west to east [m]
   * @param depthM extent from north to south [m]
   * @throws IllegalArgumentException if the grid or a value is outside its range
   */
  public static HeightMap of(double[] heights, int columns, double widthM, double depthM) {
    if (columns < 2 || heights.length < 2 * columns || heights.length % columns != 0) {
      throw new IllegalArgumentException(
          heights.length + " heights in rows of " + columns + ": expected at least 2 rows of 2");
    }
    Arguments.requirePositive("width of the height map [m]", widthM);
    Arguments.requirePositive("depth of the height map [m]", depthM);
    for (double height : heights) {
      Arguments.requireInside("height [m]", height, -20_000.0, 20_000.0);
    }
    HeightMap map = new HeightMap(heights.clone(), columns, widthM, depthM);
    Arguments.requireInside("steepest slope of the height map", map.steepest, 0.0, STEEPEST);
    return map;
  }

  /**
   * Reads a grey image of 8 or 16 bits, such as a PNG: black is the lowest height, white the
   * highest.
   *
   * @param lowestM height of black above the world's plane [m]
   * @param highestM height of white above it [m]
   * @throws BadInputException naming the file, if it is not such an image or the slopes are too
   *     steep
   */
  public static HeightMap read(
      Path file, double widthM, double depthM, double lowestM, double highestM) {
    requireRegular(file);
    try (ImageInputStream stream = ImageIO.createImageInputStream(file.toFile())) {
      Raster raster = image(stream).getRaster();
      int bits = raster.getSampleModel().getSampleSize(0);
      double full = (1 << bits) - 1;
      int columns = raster.getWidth();
      double[] heights = new double[columns * raster.getHeight()];
      for (int i = 0; i < heights.length; i++) {
        double share = raster.getSample(i % columns, i / columns, 0) / full;
        heights[i] = lowestM + share * (highestM - lowestM);
      }
      return of(heights, columns, widthM, depthM);
    } catch (IOException | IllegalArgumentException e) {
      throw new BadInputException(file + ": height map: " + e.getMessage(), e);
    }
  }

  /** Rejects a folder, and a pipe, which would block. */
  static void requireRegular(Path file) {
    if (!Files.isRegularFile(file)) {
      throw new BadInputException(file + ": height map: no such regular file");
    }
  }

  private static BufferedImage image(ImageInputStream stream) throws IOException {
    if (stream == null) {
      throw new IOException("cannot be opened");
    }
    Optional<ImageReader> found =
        ImageIO.getImageReaders(stream).hasNext()
            ? Optional.of(ImageIO.getImageReaders(stream).next())
            : Optional.empty();
    ImageReader reader =
        found.orElseThrow(() -> new IOException("is not a readable image, such as a PNG"));
    try {
      long scans = DecodingLimit.scans(stream::read);
      stream.seek(0);
      reader.setInput(stream, true, true);
      int width = reader.getWidth(0);
      int height = reader.getHeight(0);
      if (width < 2 || height < 2 || width > MAX_SIDE || height > MAX_SIDE) {
        throw new IOException(
            width + " by " + height + " pixels; expected 2 to " + MAX_SIDE + " each way");
      }
      LIMIT.require(width, height, scans);
      BufferedImage image = reader.read(0);
      if (image.getRaster().getNumBands() != 1 || image.getColorModel().getPixelSize() < 8) {
        throw new IOException("is not grey with 8 or 16 bits per pixel");
      }
      return image;
    } catch (EOFException e) {
      throw new IOException("ends too early", e);
    } catch (RuntimeException e) { // decoders throw these for damaged files
      throw new IOException("is damaged: " + e, e);
    } finally {
      reader.dispose();
    }
  }

  private double height(int column, int row) {
    return heights[row * columns + column];
  }

  /** Column of the cell; its fraction is the place in the cell. */
  private double across(double eastM) {
    return Math.max(0.0, Math.min(columns - 1.0, eastM / spacingEastM + (columns - 1) / 2.0));
  }

  private double along(double northM) {
    return Math.max(0.0, Math.min(rows - 1.0, (rows - 1) / 2.0 - northM / spacingNorthM));
  }

  @Override
  public double heightM(double eastM, double northM) {
    double x = across(eastM);
    double y = along(northM);
    int column = Math.min(columns - 2, (int) x);
    int row = Math.min(rows - 2, (int) y);
    double right = x - column;
    double down = y - row;
    double upper = (1.0 - right) * height(column, row) + right * height(column + 1, row);
    double lower = (1.0 - right) * height(column, row + 1) + right * height(column + 1, row + 1);
    return (1.0 - down) * upper + down * lower;
  }

  @Override
  public double riseEast(double eastM, double northM) {
    double x = eastM / spacingEastM + (columns - 1) / 2.0;
    if (!(x > 0.0 && x < columns - 1)) {
      return 0.0;
    }
    int column = Math.min(columns - 2, (int) x);
    double y = along(northM);
    int row = Math.min(rows - 2, (int) y);
    double down = y - row;
    double upper = height(column + 1, row) - height(column, row);
    double lower = height(column + 1, row + 1) - height(column, row + 1);
    return ((1.0 - down) * upper + down * lower) / spacingEastM;
  }

  @Override
  public double riseNorth(double eastM, double northM) {
    double y = (rows - 1) / 2.0 - northM / spacingNorthM;
    if (!(y > 0.0 && y < rows - 1)) {
      return 0.0;
    }
    int row = Math.min(rows - 2, (int) y);
    double x = across(eastM);
    int column = Math.min(columns - 2, (int) x);
    double right = x - column;
    double left = height(column, row) - height(column, row + 1);
    double other = height(column + 1, row) - height(column + 1, row + 1);
    return ((1.0 - right) * left + right * other) / spacingNorthM;
  }

  @Override
  public Terrain underWheels() {
    return new RoundedTerrain(this);
  }

  @Override
  public double steepest() {
    return steepest;
  }

  @Override
  public double highestM() {
    return highestM;
  }
}
