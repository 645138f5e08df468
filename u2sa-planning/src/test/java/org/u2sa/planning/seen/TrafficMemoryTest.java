package org.u2sa.planning.seen;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.Clock;

class TrafficMemoryTest {
  private final TrafficMemory memory = new TrafficMemory();

  private static Mover walker(double seconds, double eastMps) {
    return walker("walker", seconds, eastMps);
  }

  private static Mover walker(String name, double seconds, double eastMps) {
    return new Mover(
        name,
        Clock.micros(seconds),
        0.0,
        new double[] {3.0},
        new double[] {4.0},
        0.0,
        eastMps,
        0.5);
  }

  private List<Double> mightMove(double seconds) {
    return memory.mightMove(walker(seconds, 0.0)).stream().map(Mover::eastMps).toList();
  }

  @Test
  void mightMove_stoppedAWhileAgo_onOrBack() {
    memory.moves(walker(10.0, 0.4));
    assertThat(mightMove(12.0)).containsExactlyInAnyOrder(0.4, -0.4);
  }

  @Test
  void mightMove_estimateFadedAsItStopped_asFastAsBefore() {
    memory.moves(walker(10.0, 0.4));
    memory.moves(walker(10.5, 0.2));
    memory.moves(walker(11.0, 0.06));
    assertThat(mightMove(12.0)).containsExactlyInAnyOrder(0.4, -0.4);
  }

  @Test
  void mightMove_fastLongAgoAndSlowSince_asSlowAsSince() {
    memory.moves(walker(10.0, 0.9));
    memory.moves(walker(15.0, 0.2));
    memory.moves(walker(21.0, 0.2));
    assertThat(mightMove(22.0)).containsExactlyInAnyOrder(0.2, -0.2);
  }

  @Test
  void mightMove_movedUntilAMomentAgo_isNotParkedThoughItWasFastestBefore() {
    memory.moves(walker(10.0, 0.4));
    memory.moves(walker(18.0, 0.3));
    assertThat(mightMove(25.0)).containsExactlyInAnyOrder(0.4, -0.4);
  }

  /** Objects that move are never asked about, so only their number and age can end the memory. */
  @Test
  void moves_inventedNamesByTheThousand_areForgottenWhenTheyAreOld() {
    for (int i = 0; i < 1_000; i++) {
      memory.moves(walker("invented " + i, 10.0, 0.4));
    }
    memory.moves(walker(19.0, 0.4));
    assertThat(mightMove(19.5)).as("as many as any traffic has").isEmpty();

    memory.moves(walker(20.1, 0.4));

    assertThat(mightMove(20.5)).containsExactlyInAnyOrder(0.4, -0.4);
    assertThat(memory.mightMove(walker("invented 0", 12.0, 0.0))).isEmpty();
  }

  @Test
  void moves_inventedNamesDatedInTheFuture_makeRoomAtOnce() {
    for (int i = 0; i < 1_000; i++) {
      memory.moves(walker("invented " + i, 1.0e9, 0.4));
    }
    memory.moves(walker(10.0, 0.4));

    assertThat(mightMove(12.0)).containsExactlyInAnyOrder(0.4, -0.4);
    assertThat(memory.mightMove(walker("invented 0", 1.0e9 + 1.0, 0.0))).isEmpty();
  }

  @Test
  void mightMove_parkedOrNeverMoved_doesNot() {
    assertThat(mightMove(5.0)).isEmpty();
    memory.moves(walker(10.0, 0.4));
    assertThat(mightMove(20.1)).isEmpty();
  }
}
