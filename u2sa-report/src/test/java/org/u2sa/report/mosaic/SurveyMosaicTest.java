package org.u2sa.report.mosaic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.plugins.tiff.GeoTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import javax.imageio.stream.ImageInputStream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.testkit.ProgressiveJpeg;

/** Images of a chessboard on the ground, by a pinhole camera 40 m above it. */
class SurveyMosaicTest {
  private static final Geodetic MIDDLE = new Geodetic(-76.55, 38.32, 40.0);
  private static final UtmGrid UTM = new UtmGrid(ReferenceFrame.utm(18, true));
  private static final int WIDTH = 300;
  private static final int HEIGHT = 200;
  private static final double FOCAL_PX = 300.0;
  private static final double SQUARE_M = 4.0;

  @TempDir private Path folder;
  private final SurveyMosaic mosaic =
      new SurveyMosaic(MosaicGrid.around(List.of(MIDDLE), 0.2, 12.0));

  private static int chess(Point utm) {
    long squares = (long) Math.floor(utm.x() / SQUARE_M) + (long) Math.floor(utm.y() / SQUARE_M);
    return Math.floorMod(squares, 2L) == 0 ? 0xE0E0E0 : 0x202020;
  }

  /** Ground below a pixel; the camera looks down, the image's top to the aircraft's front. */
  private static Geodetic ground(Rotation nedFromFrd, double upM, double column, double row) {
    double u = (column - 0.5 * (WIDTH - 1)) / FOCAL_PX;
    double v = (row - 0.5 * (HEIGHT - 1)) / FOCAL_PX;
    Point ray = nedFromFrd.times(Point.of(-v, u, 1.0));
    Point way = ray.times(upM / ray.z());
    return MIDDLE.fromNed(Point.of(way.x(), way.y(), 0.0));
  }

  /** Takes an image; tint is added to its colours. */
  private void fly(long micros, Attitude attitude, double upM, int tint) throws IOException {
    Rotation nedFromFrd = attitude.nedFromFrd();
    BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      Point utm = UTM.grid(ground(nedFromFrd, upM, i % WIDTH, i / WIDTH));
      image.setRGB(i % WIDTH, i / WIDTH, chess(utm) + tint);
    }
    List<Point> corners = new ArrayList<>();
    for (int[] each : new int[][] {{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      double column = each[0] * (WIDTH - 1);
      corners.add(ground(nedFromFrd, upM, column, each[1] * (HEIGHT - 1)).point());
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(image, "png", bytes);
    take(micros, corners, bytes.toByteArray());
  }

  private void take(long micros, List<Point> corners, byte[] bytes) {
    ImageFootprint footprint = new ImageFootprint().resolution(0.2).points(corners);
    footprint.sensorName("camera").x(MIDDLE.longitudeDeg()).y(MIDDLE.latitudeDeg());
    footprint.referenceFrame(ReferenceFrame.GLOBAL).timestamp(micros);
    CameraImage image =
        new CameraImage().sensorName("camera").format("png").data(ByteString.copyOf(bytes));
    image.timestamp(micros);
    mosaic.take(image);
    mosaic.take(footprint);
  }

  /** Share of the shown pixels whose colour is the chessboard's. */
  private double right() {
    int seen = 0;
    int right = 0;
    for (int row = 0; row < mosaic.grid().rows(); row++) {
      for (int column = 0; column < mosaic.grid().columns(); column++) {
        int colour = mosaic.picture().getRGB(column, row);
        int expected = chess(Point.of(mosaic.grid().eastM(column), mosaic.grid().northM(row), 0.0));
        seen += colour >>> 24 == 0 ? 0 : 1;
        right += Math.abs((colour & 0xff) - (expected & 0xff)) < 64 ? 1 : 0;
      }
    }
    return (double) right / seen;
  }

  @Test
  void take_tiltedImage_squaresAreWhereTheyAreOnTheGround() throws IOException {
    fly(1_000, new Attitude(0.35, -0.2, 2.1), 40.0, 0);

    assertThat(mosaic.used()).isEqualTo(1);
    assertThat(mosaic.areaM2()).isGreaterThan(250.0);
    assertThat(right()).isGreaterThan(0.93); // the rest is on the edges of squares
  }

  @Test
  void take_coarserImageAfterwards_theFinerOneStays() throws IOException {
    fly(1_000, new Attitude(0.0, 0.0, 0.5), 30.0, 0);
    fly(2_000, new Attitude(0.0, 0.0, 0.5), 60.0, 0x100000);
    int middle = mosaic.picture().getRGB(mosaic.grid().columns() / 2, mosaic.grid().rows() / 2);

    assertThat(mosaic.used()).isEqualTo(2);
    assertThat(middle >> 16 & 0xff).isEqualTo(middle & 0xff);
  }

  @Test
  void take_damagedImageAndImpossibleFootprints_areRefusedAndTheRestIsUsed() throws IOException {
    Point here = MIDDLE.point();
    Point east = here.plus(Point.of(1e-4, 0.0, 0.0));
    Point north = here.plus(Point.of(0.0, 1e-4, 0.0));
    Point both = here.plus(Point.of(1e-4, 1e-4, 0.0));
    take(1_000, List.of(here, east, both, north), new byte[] {(byte) 0xff, (byte) 0xd8, 1, 2});
    take(2_000, List.of(here, both, east, north), new byte[1]); // crossed
    take(3_000, List.of(here, east, both, Point.of(10.0, -38.0, 0.0)), new byte[1]);
    fly(4_000, new Attitude(0.0, 0.0, 0.0), 40.0, 0);

    assertThat(mosaic.refused()).isEqualTo(3);
    assertThat(mosaic.used()).isEqualTo(1);
  }

  private static byte[] progressive(int repetitions) throws IOException {
    BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    return ProgressiveJpeg.of(image, repetitions);
  }

  @Test
  void take_progressiveJpegOfThousandsOfScans_isRefused() throws IOException {
    List<Point> corners = new ArrayList<>();
    for (double[] each : new double[][] {{-20, -20}, {-20, 20}, {20, 20}, {20, -20}}) {
      corners.add(MIDDLE.fromNed(Point.of(each[0], each[1], 0.0)).point());
    }
    take(1_000_000L, corners, progressive(0));
    assertThat(mosaic.used()).isEqualTo(1);
    take(2_000_000L, corners, progressive(10_000));
    assertThat(mosaic.used()).isEqualTo(1);
    assertThat(mosaic.refused()).isEqualTo(1);
  }

  @ParameterizedTest
  @ValueSource(doubles = {180.0, -180.0, 179.9999, -179.9999})
  void take_imageAcross180Degrees_isUsedWhole(double longitude) throws IOException {
    Geodetic middle = new Geodetic(longitude, -17.0, 0.0);
    SurveyMosaic there = new SurveyMosaic(MosaicGrid.around(List.of(middle), 1.0, 20.0));
    List<Point> corners = new ArrayList<>();
    for (int[] each : new int[][] {{-20, 20}, {20, 20}, {20, -20}, {-20, -20}}) {
      corners.add(middle.fromEnu(Point.of(each[0], each[1], 0.0)).point());
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(new BufferedImage(50, 50, BufferedImage.TYPE_INT_RGB), "png", bytes);
    ImageFootprint footprint = new ImageFootprint().resolution(1.0).points(corners);
    footprint.referenceFrame(ReferenceFrame.GLOBAL).sensorName("camera").timestamp(1_000);
    CameraImage image = new CameraImage().data(ByteString.copyOf(bytes.toByteArray()));
    image.sensorName("camera").timestamp(1_000);
    there.take(image);
    there.take(footprint);

    assertThat(there.used()).isEqualTo(1);
    assertThat(there.areaM2()).isCloseTo(1_600.0, Offset.offset(80.0));
  }

  @Test
  void around_tooManyPixels_saysHowMany() {
    Geodetic far = MIDDLE.fromEnu(Point.of(900.0, 900.0, 0.0));
    assertThatThrownBy(() -> MosaicGrid.around(List.of(MIDDLE, far), 0.1, 0.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("at most 40000000 pixels");
  }

  @Test
  void write_png_worldFileAndSystemAreBesideIt() throws IOException {
    fly(1_000, new Attitude(0.0, 0.0, 0.5), 30.0, 0);
    Path file = folder.resolve("area.png");
    MosaicFile.write(mosaic, file);

    assertThat(ImageIO.read(file.toFile()).getWidth()).isEqualTo(mosaic.grid().columns());
    List<String> world = Files.readAllLines(folder.resolve("area.pgw"));
    assertThat(world).hasSize(6);
    assertThat(Double.parseDouble(world.get(4))).isEqualTo(mosaic.grid().westM() + 0.1, within());
    assertThat(Double.parseDouble(world.get(5))).isEqualTo(mosaic.grid().northM() - 0.1, within());
    assertThat(folder.resolve("area.prj")).content().contains("UTM zone 18N", "32618");
  }

  private static Offset<Double> within() {
    return Offset.offset(1e-3);
  }

  @Test
  void write_tiff_hasThePlaceInItsTags() throws IOException {
    Path file = folder.resolve("area.tif");
    MosaicFile.write(mosaic, file);
    ImageReader reader = ImageIO.getImageReadersByFormatName("tiff").next();
    try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
      reader.setInput(in);
      TIFFDirectory tags = TIFFDirectory.createFromMetadata(reader.getImageMetadata(0));

      assertThat(tags.getTIFFField(GeoTIFFTagSet.TAG_MODEL_TIE_POINT).getAsDoubles())
          .containsExactly(0, 0, 0, mosaic.grid().westM(), mosaic.grid().northM(), 0);
      assertThat(tags.getTIFFField(GeoTIFFTagSet.TAG_GEO_KEY_DIRECTORY).getAsInt(15))
          .isEqualTo(32_618);
    } finally {
      reader.dispose();
    }
  }

  @Test
  void requireKind_otherName_isRefused() {
    assertThatThrownBy(() -> MosaicFile.requireKind(Path.of("area.jpg")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("area.jpg: expected a name that ends in .png, .tif or .tiff");
  }
}
