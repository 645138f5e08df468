package org.u2sa.drivers.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

class JpegFramerProperties {
  @Property(tries = 200)
  void accept_damagedPictures_neverThrowsAndRecovers(
      @ForAll long seed, @ForAll @IntRange(min = 1, max = 50) int damages) {
    JpegFramer parser = new JpegFramer();
    byte[] small = Jpegs.darkThenBright(24, 16);
    Random random = new Random(seed);
    byte[] bad = small.clone();
    for (int i = 0; i < damages; i++) {
      bad[random.nextInt(bad.length)] = (byte) random.nextInt(256);
    }
    parser.accept(bad, bad.length, 1);
    byte[] good = Jpegs.part(small);
    for (int i = 0; i < 300; i++) { // a false segment swallows at most 65 535 bytes
      parser.accept(good, good.length, 2 + i);
    }
    assertThat(parser.latest().orElseThrow().pixels()).isEqualTo(small);
  }
}
