package org.u2sa.scenarios.roboboat.gate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

class GateSequenceTest {
  private static final Gate FIRST = northward(10.0);
  private static final Gate SECOND = northward(15.0);

  private final GateSequence gates = new GateSequence();

  private static Gate northward(double north) {
    return new Gate(Point.of(north, -1.2, 0.0), Point.of(north, 1.2, 0.0));
  }

  private boolean sailTo(double north, Gate... seen) {
    return gates.move(List.of(seen), Point.of(north, 0.0, 0.0));
  }

  @Test
  void move_throughAGate_itIsPassedOnceAndTheNextFollows() {
    sailTo(9.8, FIRST, SECOND);

    assertThat(sailTo(10.1, FIRST, SECOND)).isTrue();
    assertThat(sailTo(10.4, FIRST, SECOND)).isFalse();
    assertThat(gates.passed()).isEqualTo(1);
    assertThat(gates.next(Point.of(10.4, 0.0, 0.0), FIRST)).contains(SECOND);
  }

  @Test
  void move_aBuoyOfTheGateIsLostFromSight_itIsPassedAllTheSame() {
    sailTo(9.0, FIRST, SECOND);
    gates.aimAt(Optional.of(FIRST));
    sailTo(9.8, SECOND);

    assertThat(sailTo(10.1, SECOND)).isTrue();
    assertThat(gates.last()).contains(FIRST);
  }

  @Test
  void begin_afterAGate_nothingIsPassed() {
    sailTo(9.8, FIRST);
    sailTo(10.1, FIRST);
    gates.begin();

    assertThat(gates.passed()).isZero();
    assertThat(gates.last()).isEmpty();
  }
}
