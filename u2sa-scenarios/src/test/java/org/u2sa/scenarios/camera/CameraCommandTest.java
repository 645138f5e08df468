package org.u2sa.scenarios.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.testkit.ProgressiveJpeg;

class CameraCommandTest {
  private static final int HORIZON = 100;

  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int u2sa(String... arguments) {
    return Main.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
  }

  /** A lawn with a line straight ahead of the camera. */
  private static BufferedImage lawn() {
    BufferedImage image = new BufferedImage(320, 240, BufferedImage.TYPE_INT_RGB);
    Graphics2D pen = image.createGraphics();
    pen.setColor(new Color(190, 205, 230));
    pen.fillRect(0, 0, 320, HORIZON);
    pen.setColor(new Color(88, 112, 62));
    pen.fillRect(0, HORIZON, 320, 240);
    pen.setColor(new Color(228, 230, 226));
    for (int row = HORIZON + 1; row < 240; row++) {
      int half = (int) Math.round(0.033 * (row - HORIZON)); // 7 cm seen from 1.1 m above
      pen.fillRect(160 - half, row, 2 * half + 1, 1);
    }
    pen.dispose();
    return image;
  }

  private Path saved(BufferedImage image, String name) throws IOException {
    Path file = folder.resolve(name);
    ImageIO.write(image, "png", file.toFile());
    return file;
  }

  @Test
  void look_lineAhead_isInTheTableAndInThePicture() throws IOException {
    Path file = saved(lawn(), "lawn.png");
    // Focal length 277 px (60 deg): the horizon, 20 px above the middle, is 4.1 deg above the axis.
    int code =
        u2sa(
            "camera",
            "look",
            file.toString(),
            "--height",
            "1.1",
            "--down",
            "4.1",
            "--out",
            folder.resolve("seen").toString());
    assertThat(err.toString()).isEmpty();
    assertThat(code).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("white line").contains("not calibrated");
    BufferedImage picture = ImageIO.read(folder.resolve("seen/lawn-seen.png").toFile());
    assertThat(picture.getWidth()).isGreaterThan(320);
    assertThat(picture.getHeight()).isEqualTo(240);
  }

  @Test
  void look_noPicture_isRefused() throws IOException {
    Path text = Files.writeString(folder.resolve("notes.png"), "no picture");
    assertThat(u2sa("camera", "look", text.toString(), "--height", "1"))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("notes.png: is not a PNG, JPEG, BMP or GIF picture");
  }

  @Test
  void look_progressiveJpegOfThousandsOfScans_isRefused() throws IOException {
    byte[] slow =
        ProgressiveJpeg.of(new BufferedImage(1_000, 1_000, BufferedImage.TYPE_BYTE_GRAY), 1_000);
    Path file = Files.write(folder.resolve("slow.jpg"), slow);
    assertThat(u2sa("camera", "look", file.toString(), "--height", "1"))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("slow.jpg: an image of 1000 by 1000 pixels in 10");
  }

  @Test
  void look_moreThan33MillionPixels_isRefused() throws IOException {
    Path file = saved(new BufferedImage(8_193, 4_096, BufferedImage.TYPE_BYTE_BINARY), "big.png");
    assertThat(u2sa("camera", "look", file.toString(), "--height", "1"))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("big.png: an image of 8193 by 4096 pixels");
  }

  @Test
  void look_pictureOfOneColour_saysThatNothingIsSeen() throws IOException {
    Path file = saved(new BufferedImage(320, 240, BufferedImage.TYPE_INT_RGB), "plain.png");
    Path seen = folder.resolve("seen");
    int code = u2sa("camera", "look", file.toString(), "--height", "1.1", "--out", seen.toString());
    assertThat(err.toString()).isEmpty();
    assertThat(code).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("nothing seen");
    assertThat(seen.resolve("plain-seen.png")).exists();
  }

  @Test
  void look_cameraOnTheGround_isRefused() throws IOException {
    Path file = saved(lawn(), "lawn.png");
    assertThat(u2sa("camera", "look", file.toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("the camera is not above the ground");
  }

  @Test
  void calibrate_noBoardInAnyPicture_failsWithWhatIsMissingAndWritesNothing() throws IOException {
    Path one = saved(lawn(), "one.png");
    Path two = saved(lawn(), "two.png");
    Path file = folder.resolve("camera.xml");
    int code =
        u2sa("camera", "calibrate", one.toString(), two.toString(), "--out", file.toString());
    assertThat(code).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString()).contains("one.png: no complete board found");
    assertThat(err.toString()).contains("0 of 2 pictures show a complete board of 9x6 corners");
    assertThat(file).doesNotExist();
  }

  @Test
  void calibrate_withoutPicturesOrWithAWrongBoard_isRefused() {
    assertThat(u2sa("camera", "calibrate")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("no pictures: expected files, or --live");
    assertThat(u2sa("camera", "calibrate", "--board", "big")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("board \"big\"");
  }

  @Test
  void decode_jpeg_isTheSamePictureWithItsTime() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(lawn(), "jpg", bytes);
    CameraFrame jpeg =
        new CameraFrame(42L, 320, 240, PixelFormat.JPEG, bytes.toByteArray(), Optional.empty());
    CameraFrame pixels = new ImageIoJpeg().decode(jpeg);
    assertThat(pixels.format()).isEqualTo(PixelFormat.RGB24);
    assertThat(pixels.measuredAtMicros()).isEqualTo(42L);
    int at = 3 * (220 * 320 + 40);
    assertThat(pixels.pixels()[at] & 0xFF).isBetween(80, 96);
    assertThat(pixels.pixels()[at + 1] & 0xFF).isBetween(104, 120);
    assertThat(pixels.pixels()[at + 2] & 0xFF).isBetween(54, 70);
  }
}
