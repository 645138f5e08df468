package org.u2sa.device.port;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.DecodingLimit;
import org.u2sa.testkit.ProgressiveJpeg;

/** What is known of an image's decoding before it begins. */
class DecodingLimitTest {
  private static final BufferedImage GREY = new BufferedImage(16, 16, BufferedImage.TYPE_BYTE_GRAY);

  private static long scans(byte[] file) throws IOException {
    return DecodingLimit.scans(new ByteArrayInputStream(file)::read);
  }

  private static byte[] written(String format) throws IOException {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    ImageIO.write(GREY, format, file);
    return file.toByteArray();
  }

  @ParameterizedTest
  @CsvSource({
    "100, 10, 1, true",
    "101, 10, 1, false",
    "100, 10, 5, true",
    "100, 10, 6, false",
    "65536, 65536, 1, false"
  })
  void problem_pixelsOrScansBeyondTheLimit_isNamed(
      int width, int height, long scans, boolean isFine) {
    assertThat(new DecodingLimit(1_000, 5_000).problem(width, height, scans).isEmpty())
        .isEqualTo(isFine);
  }

  @Test
  void scans_progressiveJpeg_areCountedAcrossBlocks() throws IOException {
    long own = scans(ProgressiveJpeg.of(GREY, 0));
    assertThat(own).isGreaterThan(1);
    assertThat(scans(ProgressiveJpeg.of(GREY, 20_000))).isEqualTo(own + 20_000);
  }

  @ParameterizedTest
  @ValueSource(strings = {"png", "bmp", "gif", "jpeg"})
  void scans_plainPicture_isOne(String format) throws IOException {
    assertThat(scans(written(format))).isEqualTo(1);
  }

  @ParameterizedTest
  @ValueSource(ints = {4, 5})
  void scans_bitmapThatContainsAnotherPicture_isRefused(int compression) throws IOException {
    byte[] bitmap = written("bmp");
    bitmap[30] = (byte) compression;
    assertThatThrownBy(() -> scans(bitmap)).hasMessage("is not a PNG, JPEG, BMP or GIF picture");
  }

  @Test
  void scans_anythingElse_isRefused() throws IOException {
    byte[] tiff = written("tiff");
    assertThatThrownBy(() -> scans(tiff)).hasMessage("is not a PNG, JPEG, BMP or GIF picture");
    assertThatThrownBy(() -> scans(new byte[0])).isInstanceOf(IOException.class);
  }
}
