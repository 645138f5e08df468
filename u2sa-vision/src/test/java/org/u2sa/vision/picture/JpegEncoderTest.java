package org.u2sa.vision.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import javax.imageio.ImageIO;
import javax.imageio.plugins.jpeg.JPEGHuffmanTable;
import javax.imageio.plugins.jpeg.JPEGQTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;

/** What is packed, as the JDK's own decoder reads it. */
class JpegEncoderTest {
  private static CameraFrame frame(int width, int height, PixelFormat format, byte[] pixels) {
    return new CameraFrame(1, width, height, format, pixels, Optional.empty());
  }

  /** Red rises to the right, green downwards, blue against both. */
  private static CameraFrame gradient(int width, int height) {
    byte[] pixels = new byte[3 * width * height];
    for (int y = 0, at = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int red = 20 + 200 * x / width;
        int green = 30 + 180 * y / height;
        pixels[at++] = (byte) red;
        pixels[at++] = (byte) green;
        pixels[at++] = (byte) (240 - red / 2 - green / 2);
      }
    }
    return frame(width, height, PixelFormat.RGB24, pixels);
  }

  private static BufferedImage decoded(byte[] jpeg) throws IOException {
    return ImageIO.read(new ByteArrayInputStream(jpeg));
  }

  /** Root mean square of what decoding changed, over all colours [0…255]. */
  private static double error(CameraFrame frame, BufferedImage image) {
    assertThat(image.getWidth()).isEqualTo(frame.width());
    assertThat(image.getHeight()).isEqualTo(frame.height());
    double sum = 0.0;
    byte[] pixels = frame.pixels();
    int each = frame.format().bytesPerPixel();
    int[] colours = new int[3];
    for (int i = 0; i < frame.width() * frame.height(); i++) {
      int x = i % frame.width();
      int y = i / frame.width();
      image.getRaster().getPixel(x, y, colours);
      for (int colour = 0; colour < each; colour++) {
        double difference = colours[colour] - (pixels[each * i + colour] & 0xFF);
        sum += difference * difference;
      }
    }
    return Math.sqrt(sum / pixels.length);
  }

  @ParameterizedTest
  @CsvSource({"64, 48", "16, 16", "17, 9", "1, 1", "8, 33", "250, 130"})
  void encode_colours_areDecodedAlmostAsTheyWere(int width, int height) throws IOException {
    CameraFrame frame = gradient(width, height);

    assertThat(error(frame, decoded(new JpegEncoder(95).encode(frame)))).isLessThan(4.0);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 8, 9, 65})
  void encode_grey_isDecodedAlmostAsItWas(int width) throws IOException {
    byte[] pixels = new byte[width * 40];
    for (int i = 0; i < pixels.length; i++) {
      pixels[i] = (byte) (i / width * 5 + i % width);
    }
    CameraFrame frame = CameraFrame.grey(1, width, 40, pixels);
    BufferedImage image = decoded(new JpegEncoder(95).encode(frame));

    assertThat(image.getRaster().getNumBands()).isEqualTo(1);
    assertThat(error(frame, image)).isLessThan(2.0);
  }

  /** Noise needs all lengths of numbers and runs. At quality 100 only rounding is lost. */
  @ParameterizedTest
  @CsvSource({"100, 1.0", "90, 8.0", "30, 40.0"})
  void encode_greyNoise_losesLessTheBetterTheQuality(int quality, double most) throws IOException {
    byte[] pixels = new byte[96 * 96];
    new Random(7).nextBytes(pixels);
    CameraFrame frame = CameraFrame.grey(1, 96, 96, pixels);

    assertThat(error(frame, decoded(new JpegEncoder(quality).encode(frame)))).isLessThan(most);
  }

  /** One coefficient after more than sixteen zeros. */
  @Test
  void encode_onlyTheHighestFrequency_isDecoded() throws IOException {
    byte[] pixels = new byte[64];
    for (int i = 0; i < pixels.length; i++) {
      double across = Math.cos((2 * (i % 8) + 1) * 7 * Math.PI / 16);
      double down = Math.cos((2 * (i / 8) + 1) * 7 * Math.PI / 16);
      pixels[i] = (byte) Math.round(128 + 100 * across * down);
    }
    CameraFrame frame = CameraFrame.grey(1, 8, 8, pixels);

    assertThat(error(frame, decoded(new JpegEncoder(90).encode(frame)))).isLessThan(3.0);
  }

  @Test
  void encode_blackAndWhite_staysSo() throws IOException {
    byte[] pixels = new byte[3 * 32 * 16];
    Arrays.fill(pixels, 0, pixels.length / 2, (byte) 255);
    BufferedImage image =
        decoded(new JpegEncoder(90).encode(frame(32, 16, PixelFormat.RGB24, pixels)));

    assertThat(image.getRGB(3, 2)).isEqualTo(0xFFFFFFFF);
    assertThat(image.getRGB(3, 13)).isEqualTo(0xFF000000);
  }

  @Test
  void encode_lowerQuality_isSmaller() {
    CameraFrame frame = gradient(160, 120);

    assertThat(new JpegEncoder(30).encode(frame).length)
        .isLessThan(new JpegEncoder(95).encode(frame).length);
  }

  @Test
  void encode_twice_givesTheSameBytes() {
    JpegEncoder encoder = new JpegEncoder(80);
    byte[] first = encoder.encode(gradient(40, 30));
    encoder.encode(gradient(64, 64));

    assertThat(encoder.encode(gradient(40, 30))).isEqualTo(first);
  }

  @Test
  void encode_jpeg_isLeftAsItIs() {
    byte[] file = {(byte) 0xFF, (byte) 0xD8, 1, 2};

    assertThat(new JpegEncoder(80).encode(frame(640, 480, PixelFormat.JPEG, file)))
        .isEqualTo(file)
        .isNotSameAs(file);
  }

  @Test
  void encode_sideTooLongForTheFormat_isRefused() {
    CameraFrame frame = CameraFrame.grey(1, 65_536, 1, new byte[65_536]);

    assertThatThrownBy(() -> new JpegEncoder(80).encode(frame))
        .hasMessageContaining("65536 x 1")
        .hasMessageContaining("at most 65535 pixels");
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 101, -1})
  void construction_qualityOutOfRange_isRefused(int quality) {
    assertThatThrownBy(() -> new JpegEncoder(quality))
        .hasMessage("JPEG quality: expected 1…100, not " + quality);
  }

  @Test
  void codes_areThoseOfTheStandard() {
    same(HuffmanCode.LUMINANCE_DC, JPEGHuffmanTable.StdDCLuminance);
    same(HuffmanCode.CHROMINANCE_DC, JPEGHuffmanTable.StdDCChrominance);
    same(HuffmanCode.LUMINANCE_AC, JPEGHuffmanTable.StdACLuminance);
    same(HuffmanCode.CHROMINANCE_AC, JPEGHuffmanTable.StdACChrominance);
  }

  private static void same(HuffmanCode code, JPEGHuffmanTable standard) {
    short[] counts = Arrays.copyOf(standard.getLengths(), 16);
    for (int i = 0; i < counts.length; i++) {
      assertThat((short) code.counts()[i]).isEqualTo(counts[i]);
    }
    short[] values = standard.getValues();
    assertThat(code.symbols()).hasSize(values.length);
    for (int i = 0; i < values.length; i++) {
      assertThat((short) (code.symbols()[i] & 0xFF)).isEqualTo(values[i]);
    }
  }

  @Test
  void steps_ofQuality50_areThoseOfTheStandard() {
    int[] luminance = JPEGQTable.K1Luminance.getTable();
    int[] chrominance = JPEGQTable.K2Chrominance.getTable();
    QuantizationTable first = QuantizationTable.luminance(50);
    QuantizationTable second = QuantizationTable.chrominance(50);
    double[] frequencies = new double[64];
    int[] kept = new int[64];
    for (int place = 0; place < 64; place++) { // one frequency at a time, so their order counts
      Arrays.fill(frequencies, 0.0);
      frequencies[place] = 7.0 * luminance[place];
      first.quantize(frequencies, kept);
      assertThat(Arrays.stream(kept).sum()).isEqualTo(7);
      frequencies[place] = 7.0 * chrominance[place];
      second.quantize(frequencies, kept);
      assertThat(Arrays.stream(kept).sum()).isEqualTo(7);
    }
  }

  @Test
  void transform_ofAConstantBlock_isItsMeanTimesEight() {
    double[] samples = new double[64];
    double[] frequencies = new double[64];
    Arrays.fill(samples, 10.0);
    new CosineTransform().forward(samples, frequencies);

    assertThat(frequencies[0]).isCloseTo(80.0, within(1e-9));
    frequencies[0] = 0.0;
    for (double each : frequencies) {
      assertThat(each).isCloseTo(0.0, within(1e-9));
    }
  }
}
