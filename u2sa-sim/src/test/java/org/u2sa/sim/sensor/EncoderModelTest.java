package org.u2sa.sim.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class EncoderModelTest {
  private final NoiseStreams streams = new NoiseStreams(1L);

  @Test
  void sample_perfectEncoder_countsWholeSteps() {
    EncoderModel encoder = new EncoderModel(100.0, 0.0, streams, "left encoder");
    assertThat(encoder.sample(2.0 * Math.PI * 0.0099)).isZero();
    assertThat(encoder.sample(2.0 * Math.PI * 0.0101)).isEqualTo(1);
    assertThat(encoder.sample(2.0 * Math.PI * 10.5)).isEqualTo(1050);
    assertThat(encoder.sample(-2.0 * Math.PI * 0.995)).isEqualTo(-100);
  }

  @Test
  void sample_missedCounts_losesTheirShare() {
    EncoderModel encoder = new EncoderModel(1_000.0, 0.01, streams, "left encoder");
    long counts = encoder.sample(2.0 * Math.PI * 1_000.0);
    // binomial: 1 % of a million, five standard deviations
    assertThat((double) counts).isCloseTo(990_000.0, within(5.0 * Math.sqrt(9_900.0)));
  }
}
