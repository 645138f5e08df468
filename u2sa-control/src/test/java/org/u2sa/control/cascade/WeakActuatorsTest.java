package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.control.allocation.DegreeOfFreedom;
import org.u2sa.control.allocation.Effector;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;

class WeakActuatorsTest {
  private final WeakActuators weak = new WeakActuators();
  private final List<Effector> sound = List.of(effector("LEFT"), effector("RIGHT"));

  private static Effector effector(String name) {
    Optional<Effector> effector =
        Effector.of(
            new ActuatorAnnouncement()
                .actuatorName(name)
                .minimum(-100.0)
                .maximum(100.0)
                .force(Point.of(40.0, 0.0, 0.0))
                .moment(Point.ORIGIN)
                .renewal(0.25));
    return effector.orElseThrow();
  }

  private static ResponseWatch.Finding found(String actuator, double left) {
    return new ResponseWatch.Finding(actuator, left);
  }

  private double surge(int index) {
    return weak.of(sound).get(index).effect(DegreeOfFreedom.SURGE);
  }

  @Test
  void of_nothingFound_areTheSame() {
    assertThat(weak.of(sound)).isEqualTo(sound);
    assertThat(weak.words()).isEmpty();
  }

  @Test
  void add_weakTwice_isTheProductOfBoth() {
    weak.add(found("RIGHT", 0.5), 1_000L);
    weak.add(found("RIGHT", 0.6), 2_000L);

    assertThat(surge(1) / surge(0)).isCloseTo(0.3, within(1.0e-9));
    assertThat(weak.words()).isEqualTo("weak: RIGHT (30 %); ");
    assertThat(weak.lost()).isEmpty();
  }

  @Test
  void add_dead_isLeftOutAndLost() {
    weak.add(found("LEFT", 0.0), 1_000L);

    assertThat(weak.of(sound)).extracting(Effector::name).containsExactly("RIGHT");
    assertThat(weak.lost()).containsExactly("LEFT");
    assertThat(weak.words()).isEmpty();
  }

  @Test
  void forget_atItsTimeAndNotBefore_isSoundAgain() {
    weak.add(found("LEFT", 0.0), 1_000L);

    assertThat(weak.forget(999L)).isFalse();
    assertThat(weak.lost()).containsExactly("LEFT");
    assertThat(weak.forget(1_000L)).isTrue();
    assertThat(weak.of(sound)).isEqualTo(sound);
    assertThat(weak.forget(1_000L)).isFalse();
  }
}
