package org.u2sa.vision.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.vision.calibration.ChessboardCalibration.Result;
import org.u2sa.vision.lens.LensCalibration;

/** With OpenCV's own sample pictures, against what OpenCV makes of them. */
class ChessboardCalibrationTest {
  private static final Chessboard BOARD = new Chessboard(9, 6, 0.025);

  private static CameraFrame picture(int number) throws IOException {
    String name = String.format("/chessboard/left%02d.jpg", number);
    try (InputStream in = ChessboardCalibrationTest.class.getResourceAsStream(name)) {
      BufferedImage image = ImageIO.read(in);
      byte[] grey = new byte[image.getWidth() * image.getHeight()];
      for (int i = 0; i < grey.length; i++) {
        int rgb = image.getRGB(i % image.getWidth(), i / image.getWidth());
        grey[i] = (byte) (rgb >> 8);
      }
      return CameraFrame.grey(0, image.getWidth(), image.getHeight(), grey);
    }
  }

  private static CameraFrame empty(int width, int height) {
    return CameraFrame.grey(0, width, height, new byte[width * height]);
  }

  @Test
  void calibrate_openCvsPictures_agreesWithOpenCv() throws IOException {
    ChessboardCalibration calibration = new ChessboardCalibration(BOARD);
    for (int i = 1; i <= 8; i++) {
      assertThat(calibration.add("left" + i, picture(i))).as("left" + i).isTrue();
    }
    assertThat(calibration.add("nothing", empty(640, 480))).isFalse();
    Result result = calibration.calibrate();
    LensCalibration lens = result.lens();
    // cv2.calibrateCamera (5.0.0) of these eight, k3 fixed, gives what is expected here.
    assertThat(lens.pinhole().focalX()).isCloseTo(533.49, within(2.0));
    assertThat(lens.pinhole().focalY()).isCloseTo(533.73, within(2.0));
    assertThat(lens.pinhole().centreX()).isCloseTo(342.37, within(1.5));
    assertThat(lens.pinhole().centreY()).isCloseTo(235.33, within(1.5));
    assertThat(lens.k1()).isCloseTo(-0.2955, within(0.02));
    assertThat(lens.errorPx()).isBetween(0.05, 0.3);
    assertThat(lens.pictures()).isEqualTo(8);
    assertThat(result.pictures()).hasSize(9);
    assertThat(result.pictures().get(8).hasBoard()).isFalse();
    // The first corner of left01 by cv2.cornerSubPix: 0 is the middle of the first pixel.
    assertThat(result.pictures().get(0).corners().get(0).x()).isCloseTo(244.43, within(0.25));
    assertThat(result.pictures().get(0).corners().get(0).y()).isCloseTo(94.16, within(0.25));
  }

  @Test
  void calibrate_noBoardAnywhere_saysHowManyAreNeeded() {
    ChessboardCalibration calibration = new ChessboardCalibration(BOARD);
    calibration.add("a", empty(320, 240));
    calibration.add("b", empty(320, 240));
    assertThatThrownBy(calibration::calibrate)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("0 of 2 pictures show a complete board of 9x6 corners")
        .hasMessageContaining("expected at least 4");
  }

  @Test
  void calibrate_sameViewFourTimes_isRefused() throws IOException {
    ChessboardCalibration calibration = new ChessboardCalibration(BOARD);
    for (int i = 0; i < 4; i++) {
      calibration.add("again " + i, picture(5));
    }
    assertThatThrownBy(calibration::calibrate)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("do not determine the camera");
  }

  @Test
  void add_pictureOfAnotherSize_isRefusedWithBothSizes() {
    ChessboardCalibration calibration = new ChessboardCalibration(BOARD);
    calibration.add("a", empty(320, 240));
    assertThatThrownBy(() -> calibration.add("b", empty(640, 480)))
        .hasMessageContaining("b has 640 x 480 pixels")
        .hasMessageContaining("a 320 x 240");
  }

  @Test
  void parse_textsThatAreNoBoards_areRefused() {
    assertThat(Chessboard.parse("7 X 5", 0.03)).isEqualTo(new Chessboard(7, 5, 0.03));
    assertThatThrownBy(() -> Chessboard.parse("9by6", 0.03)).hasMessageContaining("\"9by6\"");
    assertThatThrownBy(() -> Chessboard.parse("9xsix", 0.03)).hasMessageContaining("such as 9x6");
    assertThatThrownBy(() -> Chessboard.parse("9x2", 0.03)).hasMessageContaining("at least 3x3");
    assertThatThrownBy(() -> Chessboard.parse("9x6", 0.0)).hasMessageContaining("0.0 m");
  }
}
