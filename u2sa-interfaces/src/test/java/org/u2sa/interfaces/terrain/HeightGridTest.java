package org.u2sa.interfaces.terrain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;

class HeightGridTest {
  private static final String HEAD =
      "ncols 3\nnrows 2\nxllcorner 9.9995\nyllcorner 49.9995\ncellsize 0.001\nNODATA_value -99\n";

  @TempDir private Path folder;

  private HeightGrid grid(String text) throws IOException {
    return HeightGrid.read(Files.writeString(folder.resolve("map.asc"), text));
  }

  @Test
  void altitudeM_betweenHeights_isBilinear() throws IOException {
    HeightGrid grid = grid(HEAD + "10 20 30\n14 24 34\n");

    assertThat(grid.altitudeM(new Geodetic(10.0 + 1e-9, 50.0 + 1e-9, 0.0)).orElseThrow())
        .isEqualTo(14.0, Offset.offset(1e-4));
    assertThat(grid.altitudeM(new Geodetic(10.0005, 50.0005, 0.0)).orElseThrow())
        .isEqualTo(17.0, Offset.offset(1e-6));
    assertThat(grid.altitudeM(new Geodetic(10.002 - 1e-9, 50.001 - 1e-9, 0.0)).orElseThrow())
        .isEqualTo(30.0, Offset.offset(1e-4));
  }

  @ParameterizedTest
  @ValueSource(strings = {"179.9985", "-180.0015"})
  void altitudeM_gridAcross180Degrees_isKnownOnBothSides(String west) throws IOException {
    HeightGrid grid =
        grid(HEAD.replace("xllcorner 9.9995", "xllcorner " + west) + "10 20 30\n14 24 34\n");

    assertThat(grid.altitudeM(new Geodetic(179.9995, 50.0005, 0.0)).orElseThrow())
        .isEqualTo(17.0, Offset.offset(1e-4));
    assertThat(grid.altitudeM(new Geodetic(-179.9995, 50.0005, 0.0)).orElseThrow())
        .isEqualTo(27.0, Offset.offset(1e-4));
    assertThat(grid.altitudeM(new Geodetic(0.0, 50.0, 0.0))).isEmpty();
  }

  /** A thousandth of a degree is 71.7 m from west to east, and 111.2 m from south to north. */
  @ParameterizedTest
  @CsvSource({
    "10.0015, 50.0005, 0.0",
    "10.003, 50.0005, 71.7",
    "9.999, 50.0005, 71.7",
    "10.001, 50.002, 111.2",
    "10.001, 49.998, 222.5",
    "10.003, 50.002, 132.3",
    "-349.997, 50.0005, 71.7",
  })
  void outsideM_anyPlace_isTheDistanceToTheNearestHeight(
      double longitudeDeg, double latitudeDeg, double metres) throws IOException {
    HeightGrid grid = grid(HEAD + "10 20 30\n14 24 -99\n");

    assertThat(grid.outsideM(new Geodetic(longitudeDeg, latitudeDeg, 0.0)))
        .isCloseTo(metres, Offset.offset(0.1));
  }

  @Test
  void altitudeM_outsideOrUnknown_isEmpty() throws IOException {
    HeightGrid grid = grid(HEAD + "10 20 30\n14 24 -99\n");

    assertThat(grid.altitudeM(new Geodetic(10.0015, 50.0005, 0.0))).isEmpty();
    assertThat(grid.altitudeM(new Geodetic(9.9, 50.0, 0.0))).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1 2 3                     | 3 heights; expected as many as ncols by nrows",
        "1 2 3 4 5 6 7             | more heights than 3 by 2",
        "1 2 3 4 x 6               | \"x\"; expected a number",
        "1 2 3 4 NaN 6             | \"NaN\"; expected a number within ±1e9",
      })
  void read_wrongHeights_isRefused(String heights, String reason) {
    assertThatThrownBy(() -> grid(HEAD + heights))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("map.asc")
        .hasMessageContaining(reason);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ncols 3         | ncols 100000000 | ncols 1.0E8; expected a number of cells",
        "ncols 3         | ncols 3000000   | expected at most 4000000",
        "cellsize 0.001  | cellsize 30     | cellsize 30.0; expected degrees",
        "cellsize 0.001  | cells 0.001     | has no cellsize",
        "yllcorner 49    | yllcorner 4241  | expected longitude and latitude",
      })
  void read_wrongHead_isRefused(String part, String other, String reason) {
    String head = HEAD.replace(part, other);
    assertThatThrownBy(() -> grid(head + "1 2 3 4 5 6"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(reason);
  }

  @Test
  void read_oneEndlessLine_isRefusedBeforeItIsRead() throws IOException {
    Path file = folder.resolve("endless.asc");
    try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
      sparse.setLength(1L << 40);
    }
    assertThatThrownBy(() -> HeightGrid.read(file))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("endless.asc: height map: more than 100000000 bytes");
  }

  @Test
  void named_empty_isNone() {
    assertThat(HeightGrid.named("", Path::of)).isEmpty();
    assertThatThrownBy(() -> HeightGrid.named("gone.asc", folder::resolve))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("gone.asc: height map: no such regular file");
  }
}
