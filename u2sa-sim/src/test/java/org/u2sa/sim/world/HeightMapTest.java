package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;
import org.u2sa.testkit.ProgressiveJpeg;

class HeightMapTest {
  @TempDir private Path folder;

  private Path png(int type, int... samples) throws IOException {
    BufferedImage image = new BufferedImage(3, samples.length / 3, type);
    for (int i = 0; i < samples.length; i++) {
      image.getRaster().setSample(i % 3, i / 3, 0, samples[i]);
    }
    Path file = folder.resolve("heights.png");
    ImageIO.write(image, "png", file.toFile());
    return file;
  }

  @Test
  void read_greyPng_northIsUpAndWhiteIsHigh() throws IOException {
    Path file = png(BufferedImage.TYPE_USHORT_GRAY, 0, 0, 65_535, 0, 0, 0);

    HeightMap map = HeightMap.read(file, 20.0, 10.0, -1.0, 3.0);

    assertThat(map.heightM(10.0, 5.0)).isCloseTo(3.0, within(1e-9)); // north-east corner
    assertThat(map.heightM(-10.0, -5.0)).isCloseTo(-1.0, within(1e-9));
    assertThat(map.heightM(5.0, 5.0)).isCloseTo(1.0, within(1e-9)); // half way along the edge
    assertThat(map.heightM(5.0, 0.0)).isCloseTo(0.0, within(1e-9)); // middle of that cell
    assertThat(map.heightM(99.0, 99.0)).isCloseTo(3.0, within(1e-9)); // goes on
    assertThat(map.riseEast(5.0, 5.0)).isCloseTo(0.4, within(1e-9));
    assertThat(map.riseNorth(10.0, 0.0)).isCloseTo(0.4, within(1e-9));
    assertThat(map.riseEast(11.0, 5.0)).isZero();
    assertThat(map.highestM()).isCloseTo(3.0, within(1e-9));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void distanceM_raysOverRandomGround_endAtTheGround(long seed) {
    Random random = new Random(seed);
    double[] heights = random.doubles(20 * 30, 0.0, 4.0).toArray();
    HeightMap map = HeightMap.of(heights, 20, 60.0, 90.0);
    for (int i = 0; i < 100; i++) {
      Point from = Point.of(random.nextDouble(-40, 40), random.nextDouble(-50, 50), 6.0);
      Ray ray = Ray.of(from, random.nextDouble(0.0, 6.28), random.nextDouble(-1.5, -0.05));

      double distance = map.distanceM(ray, 1_000.0);

      Point at = ray.at(distance);
      assertThat(map.heightM(at.x(), at.y())).isCloseTo(at.z(), within(1e-6));
      for (double along = 0.0; along < distance - 0.01; along += 0.25) {
        Point above = ray.at(along);
        assertThat(above.z()).isGreaterThan(map.heightM(above.x(), above.y()));
      }
    }
  }

  @Test
  void read_whatIsNoHeightMap_namesTheFileAndSaysWhy() throws IOException {
    Path colour = png(BufferedImage.TYPE_INT_RGB, 0, 0, 9, 9, 0, 0);
    Path text = Files.writeString(folder.resolve("text.png"), "no image");
    Path flat = folder.resolve("missing.png");
    byte[] damaged = Files.readAllBytes(colour);
    Path cut = Files.write(folder.resolve("cut.png"), Arrays.copyOf(damaged, 40));

    assertRefused(colour, "not grey");
    assertRefused(text, "not a readable image");
    assertRefused(flat, "missing.png");
    assertRefused(cut, "cut.png");
    Path grey = png(BufferedImage.TYPE_BYTE_GRAY, 0, 0, 255, 0, 0, 0);
    assertThatThrownBy(() -> HeightMap.read(grey, 0.01, 10.0, 0.0, 5.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("steepest slope");
  }

  @Test
  void read_progressiveJpegOfThousandsOfScans_isRefused() throws IOException {
    BufferedImage grey = new BufferedImage(1_000, 1_000, BufferedImage.TYPE_BYTE_GRAY);
    Path few = Files.write(folder.resolve("few.jpg"), ProgressiveJpeg.of(grey, 0));
    Path many = Files.write(folder.resolve("many.jpg"), ProgressiveJpeg.of(grey, 1_000));

    assertThat(HeightMap.read(few, 10.0, 10.0, 0.0, 1.0).highestM()).isZero();
    assertRefused(many, "1000 by 1000 pixels in 10");
  }

  /** A TIFF file may contain JPEG images of any size. */
  @Test
  void read_tiffThatIsNamedPng_isRefused() throws IOException {
    Path file = folder.resolve("heights.png");
    BufferedImage grey = new BufferedImage(3, 3, BufferedImage.TYPE_BYTE_GRAY);
    ImageIO.write(grey, "tiff", file.toFile());

    assertRefused(file, "is not a PNG, JPEG, BMP or GIF picture");
  }

  @Test
  void read_pipeThatNobodyWrites_isRefusedInsteadOfWaitedFor() throws Exception {
    Path pipe = folder.resolve("pipe.png");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    assertTimeoutPreemptively(Duration.ofSeconds(30), () -> assertRefused(pipe, "regular file"));
  }

  private static void assertRefused(Path file, String why) {
    assertThatThrownBy(() -> HeightMap.read(file, 10.0, 10.0, 0.0, 1.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(file.toString())
        .hasMessageContaining(why);
  }
}
