package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;

class GeoTiffTest {
  private static final int SIZE = 40;
  private static final Geodetic ORIGIN = new Geodetic(9.0, 54.0, 100.0);

  @TempDir private Path folder;
  private String noData = "-9999";
  private int bands = 1;
  private int compression = 1;

  private record Tag(int id, int type, int count, byte[] data) {}

  private static ByteBuffer little(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static Tag shorts(int id, int... values) {
    ByteBuffer data = little(2 * values.length);
    for (int each : values) {
      data.putShort((short) each);
    }
    return new Tag(id, 3, values.length, data.array());
  }

  private static Tag longs(int id, int value) {
    return new Tag(id, 4, 1, little(4).putInt(value).array());
  }

  private static Tag doubles(int id, double... values) {
    ByteBuffer data = little(8 * values.length);
    for (double each : values) {
      data.putDouble(each);
    }
    return new Tag(id, 12, values.length, data.array());
  }

  /** A little-endian TIFF of one strip of 32-bit floats. */
  private Path write(float[] heights, double scale, Point corner, int model, int crs)
      throws IOException {
    int strip = 4 * heights.length;
    List<Tag> tags = new ArrayList<>();
    tags.add(shorts(256, SIZE));
    tags.add(shorts(257, SIZE));
    tags.add(shorts(258, 32));
    tags.add(shorts(259, compression));
    tags.add(shorts(262, 1));
    tags.add(longs(273, 8));
    tags.add(shorts(277, bands));
    tags.add(shorts(278, SIZE));
    tags.add(longs(279, strip));
    tags.add(shorts(339, 3));
    tags.add(doubles(33_550, scale, scale, 0.0));
    tags.add(doubles(33_922, 0.0, 0.0, 0.0, corner.x(), corner.y(), 0.0));
    tags.add(
        shorts(
            34_735,
            1,
            1,
            0,
            3,
            1024,
            0,
            1,
            model,
            1025,
            0,
            1,
            1,
            model == 1 ? 3072 : 2048,
            0,
            1,
            crs));
    byte[] absent = (noData + "\0").getBytes(StandardCharsets.US_ASCII);
    tags.add(new Tag(42_113, 2, absent.length, absent));
    int directory = 8 + strip;
    int extra = directory + 2 + 12 * tags.size() + 4;
    ByteBuffer file = little(extra + 1_000);
    file.put((byte) 'I').put((byte) 'I').putShort((short) 42).putInt(directory);
    for (float each : heights) {
      file.putFloat(each);
    }
    file.putShort((short) tags.size());
    int next = extra;
    for (Tag tag : tags) {
      file.putShort((short) tag.id).putShort((short) tag.type).putInt(tag.count);
      if (tag.data.length <= 4) {
        file.put(tag.data).put(new byte[4 - tag.data.length]);
      } else {
        file.putInt(next);
        file.duplicate().order(ByteOrder.LITTLE_ENDIAN).position(next).put(tag.data);
        next += tag.data.length;
      }
    }
    file.putInt(0);
    Path path = folder.resolve("dem.tif");
    Files.write(path, file.array());
    return path;
  }

  /** Rises by 1 m a pixel to the east, and by 2 m a pixel to the south, from 100 m. */
  private static float[] slope() {
    float[] heights = new float[SIZE * SIZE];
    for (int i = 0; i < heights.length; i++) {
      heights[i] = 100.0f + i % SIZE + 2 * (i / SIZE);
    }
    return heights;
  }

  @Test
  void read_utm_givesAltitudesAboveTheOrigin() throws IOException {
    Point here = new UtmGrid(ReferenceFrame.parse("UTM 32N")).grid(ORIGIN);
    Point corner = Point.of(here.x() - 200.0, here.y() + 200.0, 0.0);
    Path file = write(slope(), 10.0, corner, 1, 32_632);

    HeightMap map = GeoTiff.read(file, new LocalPlane(ORIGIN), 100.0, 80.0);

    assertThat(map.heightM(0.0, 0.0)).isCloseTo(19.5 + 39.0, within(0.1));
    assertThat(map.riseEast(3.0, 3.0)).isCloseTo(0.1, within(0.01));
    assertThat(map.riseNorth(3.0, 3.0)).isCloseTo(-0.2, within(0.01));
  }

  @Test
  void read_degrees_givesAltitudesAboveTheOrigin() throws IOException {
    double scale = 0.0001;
    Path file = write(slope(), scale, Point.of(9.0 - 20 * scale, 54.0 + 20 * scale, 0.0), 2, 4_326);

    HeightMap map = GeoTiff.read(file, new LocalPlane(ORIGIN), 60.0, 60.0);

    assertThat(map.heightM(0.0, 0.0)).isCloseTo(58.5, within(0.1));
    assertThat(map.riseNorth(3.0, 3.0)).isCloseTo(-2.0 / 11.13, within(0.01));
  }

  @Test
  void requireRoom_moreThanHalfOfTheHeap_isRefusedBeforeMemoryIsTaken() throws IOException {
    GeoTiff.requireRoom(8_192, 8_192, 512L << 20);
    assertThatThrownBy(() -> GeoTiff.requireRoom(8_192, 8_192, 256L << 20))
        .hasMessage(
            "8192 by 8192 pixels take 256 MB, more than half of this program's memory, 256 MB");
  }

  @Test
  void read_outsideOtherCrsAndNoData_areRefusedWithTheReason() throws IOException {
    Path far = write(slope(), 10.0, Point.of(0.0, 0.0, 0.0), 1, 32_632);
    assertThatThrownBy(() -> GeoTiff.read(far, new LocalPlane(ORIGIN), 100.0, 80.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("dem.tif: height map: does not reach");

    Path other = write(slope(), 10.0, Point.of(0.0, 0.0, 0.0), 1, 3_857);
    assertThatThrownBy(() -> GeoTiff.read(other, new LocalPlane(ORIGIN), 100.0, 80.0))
        .hasMessageContaining("EPSG 3857: expected 4326");

    float[] holes = new float[SIZE * SIZE];
    Arrays.fill(holes, -9_999.0f);
    Point here = new UtmGrid(ReferenceFrame.parse("UTM 32N")).grid(ORIGIN);
    Path empty = write(holes, 10.0, Point.of(here.x() - 200.0, here.y() + 200.0, 0.0), 1, 32_632);
    assertThatThrownBy(() -> GeoTiff.read(empty, new LocalPlane(ORIGIN), 100.0, 80.0))
        .hasMessageContaining("has no height in column");
  }

  /** The file has the data of one: it is not decoded. */
  @Test
  void read_manyBands_isRefusedBeforeTheyAreRead() throws IOException {
    bands = 20;
    Path many = write(slope(), 10.0, Point.of(0.0, 0.0, 0.0), 1, 32_632);

    assertThatThrownBy(() -> GeoTiff.read(many, new LocalPlane(ORIGIN), 100.0, 80.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("dem.tif: height map: 20 bands; expected one");
  }

  @Test
  void read_tilesOfJpeg_areRefused() throws IOException {
    compression = 7;
    Path many = write(slope(), 10.0, Point.of(0.0, 0.0, 0.0), 1, 32_632);

    assertThatThrownBy(() -> GeoTiff.read(many, new LocalPlane(ORIGIN), 100.0, 80.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("dem.tif: height map: is compressed as JPEG");
  }

  /** GDAL writes these in lower case. */
  @ParameterizedTest
  @ValueSource(strings = {"nan", "-inf", "inf", "NaN"})
  void read_noDataValueThatIsNotFinite_isReadAndRefusesOnlyHoles(String value) throws IOException {
    noData = value;
    Point here = new UtmGrid(ReferenceFrame.parse("UTM 32N")).grid(ORIGIN);
    Point corner = Point.of(here.x() - 200.0, here.y() + 200.0, 0.0);
    Path file = write(slope(), 10.0, corner, 1, 32_632);
    assertThat(GeoTiff.read(file, new LocalPlane(ORIGIN), 100.0, 80.0).heightM(0.0, 0.0))
        .isCloseTo(58.5, within(0.1));

    float[] holes = slope();
    Arrays.fill(holes, Float.parseFloat(value.replace("nan", "NaN").replace("inf", "Infinity")));
    Path empty = write(holes, 10.0, corner, 1, 32_632);
    assertThatThrownBy(() -> GeoTiff.read(empty, new LocalPlane(ORIGIN), 100.0, 80.0))
        .hasMessageContaining("has no height in column");
  }

  @Test
  void read_cutAnywhere_isRefusedWithAReason() throws IOException {
    Point here = new UtmGrid(ReferenceFrame.parse("UTM 32N")).grid(ORIGIN);
    Path file = write(slope(), 10.0, here, 1, 32_632);
    byte[] whole = Files.readAllBytes(file);
    for (int length = 0; length < whole.length; length += 97) {
      Files.write(file, Arrays.copyOf(whole, length));
      assertThatThrownBy(() -> GeoTiff.read(file, new LocalPlane(ORIGIN), 100.0, 80.0))
          .as("%d bytes", length)
          .isInstanceOf(BadInputException.class)
          .hasMessageContaining("dem.tif: height map: ")
          .hasMessageNotContaining("null");
    }
  }

  @Test
  void read_folder_isRefused() {
    assertThatThrownBy(() -> GeoTiff.read(folder, new LocalPlane(ORIGIN), 100.0, 80.0))
        .hasMessageContaining("no such regular file");
  }
}
