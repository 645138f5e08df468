package org.u2sa.vision.lens;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.interfaces.BadInputException;

class CalibrationFileTest {
  private static final LensCalibration LENS =
      new LensCalibration(
          640,
          480,
          new Intrinsics(533.6, 533.7, 342.2, 234.1),
          -0.291,
          0.105,
          0.0012,
          4.8e-5,
          0.01,
          0.169,
          13);

  @TempDir private Path folder;

  private Path written(String was, String becomes) throws IOException {
    Path file = folder.resolve("camera.xml");
    CalibrationFile.write(LENS, file);
    String text = Files.readString(file);
    assertThat(text).contains(was);
    return Files.writeString(file, text.replace(was, becomes));
  }

  @Test
  void read_whatWasWritten_isTheSameToTheLastBit() throws IOException {
    assertThat(CalibrationFile.read(written("<camera>", "<camera>"))).isEqualTo(LENS);
  }

  @Test
  void read_wrongNumber_namesFileLineAndValue() throws IOException {
    Path file = written("focalX=\"533.6\"", "focalX=\"wide\"");
    assertThatThrownBy(() -> CalibrationFile.read(file))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("camera.xml, line 5")
        .hasMessageContaining("focalX = \"wide\" is not a number");
  }

  @Test
  void read_focalLengthOfZero_isRefused() throws IOException {
    Path file = written("focalX=\"533.6\"", "focalX=\"0\"");
    assertThatThrownBy(() -> CalibrationFile.read(file)).hasMessageContaining("not both positive");
  }

  @Test
  void read_elementMissing_namesIt() throws IOException {
    Path file = written("  <quality errorPx=\"0.169\" pictures=\"13\"/>\n", "");
    assertThatThrownBy(() -> CalibrationFile.read(file))
        .hasMessageContaining("<quality> is missing");
  }

  @Test
  void scaledTo_anotherShape_isRefused() {
    assertThatThrownBy(() -> LENS.scaledTo(640, 360))
        .hasMessageContaining("640 x 480")
        .hasMessageContaining("640 x 360");
  }

  @Test
  void reach_foldingPolynomial_endsWhereItTurnsBack() {
    LensCalibration folding =
        new LensCalibration(640, 480, LENS.pinhole(), -0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0);
    // r (1 - 0.3 r²) is largest at r = 1/√0.9.
    assertThat(folding.reach()).isBetween(1.0, 1.06);
    assertThat(folding.place(342.2 + 533.6 * 0.9, 234.1)).isEmpty();
  }
}
