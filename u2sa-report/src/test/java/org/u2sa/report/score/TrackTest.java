package org.u2sa.report.score;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class TrackTest {

  private static TrackSample at(double timeS, int leg) {
    return SyntheticFlight.sample(timeS, timeS, 0.0, 100.0, leg);
  }

  @Property(tries = 50)
  void append_anyNumberOfSamples_staysWithinTheBound(
      @ForAll @IntRange(min = 4, max = 100) int capacity, @ForAll @IntRange(max = 3000) int n) {
    Track track = new Track(capacity);
    for (int i = 0; i < n; i++) {
      track.append(at(i, i));
      assertThat(track.samples()).hasSizeLessThanOrEqualTo(capacity);
    }
    assertThat(track.samples()).isSortedAccordingTo((a, b) -> Double.compare(a.timeS(), b.timeS()));
  }

  @Test
  void append_moreThanTheCapacity_thinsEvenlyFromTheStart() {
    Track track = new Track(10);
    for (int i = 0; i < 40; i++) {
      track.append(at(i, 0));
    }
    assertThat(track.samples())
        .extracting(TrackSample::timeS)
        .containsExactly(0.0, 4.0, 8.0, 12.0, 16.0, 20.0, 24.0, 28.0, 32.0, 36.0);
  }

  @Test
  void append_changeOfLegBetweenKeptSamples_isKept() {
    Track track = new Track(10);
    for (int i = 0; i < 40; i++) {
      track.append(at(i, i < 13 ? 0 : 1));
    }
    assertThat(track.samples()).extracting(TrackSample::timeS).contains(13.0);
  }

  @Test
  void append_sameTimeAgain_isRefused() {
    Track track = new Track();
    track.append(at(1.0, 0));
    assertThatThrownBy(() -> track.append(at(1.0, 0)))
        .hasMessageContaining("does not come after 1.0");
  }

  @Test
  void newSample_notANumber_isRefused() {
    assertThatThrownBy(() -> SyntheticFlight.sample(0.0, 0.0, 0.0, Double.NaN, 0))
        .hasMessageContaining("altitudeM: NaN");
  }
}
