package org.u2sa.vision.lane;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import org.junit.jupiter.api.Test;

/** Samples of painted lines: how they are seen, linked and doubted. */
class LineChainsTest {
  private final PaintedLines paint = new PaintedLines();

  @Test
  void lines_straightLineSeenThrice_isOneChainOfItsLength() {
    paint.lookThrice(0.0, 1.0, 4.0, 1.0);
    assertThat(paint.chains().lines())
        .singleElement()
        .satisfies(line -> assertThat(PaintedLines.length(line)).isCloseTo(4.0, offset(0.2)))
        .satisfies(
            line ->
                assertThat(line).allSatisfy(p -> assertThat(p.y()).isCloseTo(1.0, offset(1e-9))));
  }

  @Test
  void lines_seenTwice_areNotCertain() {
    paint.look(0.0, 1.0, 4.0, 1.0);
    paint.look(0.0, 1.0, 4.0, 1.0);
    assertThat(paint.chains().lines()).isEmpty();
  }

  @Test
  void lines_seenInTwoPiecesOfOnePicture_areOneSightingEach() {
    paint.look(0.0, 1.0, 4.0, 1.0, 0.0, 1.0, 4.0, 1.0, 0.0, 1.0, 4.0, 1.0);
    assertThat(paint.chains().lines()).isEmpty();
  }

  @Test
  void lines_seenFromOtherDirection_areTheSameLine() {
    paint.look(0.0, 1.0, 4.0, 1.0);
    paint.look(4.0, 1.0, 0.0, 1.0);
    paint.look(0.0, 1.0, 4.0, 1.0);
    assertThat(paint.chains().lines()).hasSize(1);
  }

  @Test
  void enter_displacedSighting_movesTheLineTowardsIt() {
    paint.look(0.0, 1.0, 4.0, 1.0);
    paint.look(0.0, 1.2, 4.0, 1.2);
    paint.look(0.0, 1.2, 4.0, 1.2);
    assertThat(paint.chains().lines())
        .singleElement()
        .satisfies(line -> assertThat(line).allSatisfy(p -> assertThat(p.y()).isBetween(1.1, 1.2)));
  }

  @Test
  void enter_lineBeyondTheGate_isAnotherLine() {
    paint.lookThrice(0.0, 1.0, 4.0, 1.0, 0.0, 1.6, 4.0, 1.6);
    assertThat(paint.chains().lines()).hasSize(2);
  }

  @Test
  void lines_crossing_areTwo() {
    paint.lookThrice(0.0, 0.0, 4.0, 0.0, 2.0, -2.0, 2.0, 2.0);
    assertThat(paint.chains().lines().size()).isGreaterThanOrEqualTo(2);
  }

  @Test
  void doubt_lineBehindWhatStands_stays() {
    paint.lookThrice(1.5, 0.0, 2.4, 0.0);
    int before = paint.samples.count();
    for (int i = 0; i < 8; i++) {
      paint.samples.begin(paint.micros += 100_000, 0.0);
      paint.samples.doubt(0.0, 0.0, 0.0, 2.5, 0.5, (x, y) -> x < 1.0);
      paint.samples.forget(0.0, 0.0, 50.0, paint.micros - 3_000_000, 3);
    }
    assertThat(paint.samples.count()).isEqualTo(before);
  }

  @Test
  void doubt_lineAheadNotSeenAnyMore_goes() {
    paint.lookThrice(1.5, 0.0, 2.4, 0.0);
    for (int i = 0; i < 8; i++) {
      paint.samples.begin(paint.micros += 100_000, 0.0);
      paint.samples.doubt(0.0, 0.0, 0.0, 2.5, 0.5, (x, y) -> true);
      paint.samples.forget(0.0, 0.0, 50.0, paint.micros - 3_000_000, 3);
    }
    assertThat(paint.samples.count()).isZero();
  }

  @Test
  void doubt_lineBesideTheVehicle_stays() {
    paint.lookThrice(0.0, 2.0, 2.0, 2.0);
    int before = paint.samples.count();
    for (int i = 0; i < 8; i++) {
      paint.samples.begin(paint.micros += 100_000, 0.0);
      paint.samples.doubt(0.0, 0.0, 0.0, 2.5, 0.5, (x, y) -> true);
      paint.samples.forget(0.0, 0.0, 50.0, paint.micros - 3_000_000, 3);
    }
    assertThat(paint.samples.count()).isEqualTo(before);
  }

  @Test
  void forget_seenOnceLongAgoOrFarAway_goes() {
    paint.look(0.0, 0.0, 1.0, 0.0);
    paint.lookThrice(20.0, 0.0, 21.0, 0.0);
    paint.samples.forget(0.0, 0.0, 10.0, paint.micros, 3);
    assertThat(paint.samples.count()).isZero();
  }

  @Test
  void enter_notSeenForAMinute_isLookedForFartherAway() {
    paint.lookThrice(0.0, 1.0, 4.0, 1.0);
    paint.micros += 60_000_000;
    paint.look(0.0, 1.5, 4.0, 1.5);
    assertThat(paint.samples.certain(0.0, 0.0, 50.0, 1))
        .allSatisfy(sample -> assertThat(sample.y).isBetween(1.4, 1.5));
  }

  @Test
  void doubt_sameLineSeenBesideItsPlaceAgainAndAgain_goes() {
    paint.lookThrice(0.0, 1.0, 4.0, 1.0);
    paint.micros += 5_000_000;
    for (int i = 0; i < 8; i++) {
      paint.look(0.0, 1.9, 4.0, 1.9);
      paint.samples.doubt(0.0, 0.0, Math.PI, 2.5, 0.1, (x, y) -> true); // looks the other way
      paint.samples.forget(0.0, 0.0, 50.0, paint.micros - 3_000_000, 3);
    }
    assertThat(paint.samples.certain(0.0, 0.0, 50.0, 3))
        .isNotEmpty()
        .allSatisfy(sample -> assertThat(sample.y).isGreaterThan(1.5));
  }

  @Test
  void doubt_twoLinesSeenInOnePicture_bothStay() {
    paint.lookThrice(0.0, 1.0, 4.0, 1.0, 0.0, 1.9, 4.0, 1.9);
    paint.micros += 5_000_000;
    paint.look(0.0, 1.0, 4.0, 1.0, 0.0, 1.9, 4.0, 1.9);
    paint.samples.doubt(0.0, 0.0, Math.PI, 2.5, 0.1, (x, y) -> true);
    assertThat(paint.samples.certain(0.0, 0.0, 50.0, 4))
        .as("four sightings, no doubt")
        .hasSize(paint.samples.count());
    for (int i = 0; i < 8; i++) {
      paint.look(0.0, 1.0, 4.0, 1.0, 0.0, 1.9, 4.0, 1.9);
      paint.samples.doubt(0.0, 0.0, Math.PI, 2.5, 0.1, (x, y) -> true);
      paint.samples.forget(0.0, 0.0, 50.0, paint.micros - 3_000_000, 3);
    }
    assertThat(paint.chains().lines()).hasSize(2);
  }

  @Test
  void isSure_seenFromOnePlaceOnly_isNot() {
    paint.lookThrice(0.0, 1.0, 4.0, 1.0);
    LineChains chains = paint.chains();
    assertThat(chains.isSure(chains.lines().get(0))).isFalse();
  }

  @Test
  void isSure_seenFromThreePlaces_is() {
    for (int i = 0; i < 3; i++) {
      paint.samples.from(0.3 * i, 0.0);
      paint.look(0.0, 1.0, 4.0, 1.0);
    }
    LineChains chains = paint.chains();
    assertThat(chains.isSure(chains.lines().get(0))).isTrue();
  }
}
