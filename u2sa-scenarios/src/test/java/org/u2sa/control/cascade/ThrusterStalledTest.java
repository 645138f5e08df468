package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.device.ThrusterActuator;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.sim.marine.BlueRov2;
import org.u2sa.sim.marine.VesselThruster;

/** A thruster that notices itself that it does not turn, under control that allocates. */
class ThrusterStalledTest {
  private static final VesselThruster FIRST = BlueRov2.thrusters().get(0);
  private static final double SETTLING_S = 25.0;

  /** What is left of the first thruster, by its newest announcement [%]. */
  private static double left(SixThrusterDive dive) {
    return dive.kit.published(Channels.ACTUATORS).stream()
        .filter(each -> each.actuatorName().equals(FIRST.name()))
        .reduce((first, second) -> second)
        .orElseThrow()
        .available()
        .orElse(100.0);
  }

  private static long times(SixThrusterDive dive, String what) {
    return dive.kit.log("Control").stream().filter(line -> line.contains(what)).count();
  }

  @Test
  void caughtInWeedsAndFreed_holdingStation_isLeftOutAndOfferedAgainUntilItTurns() {
    try (SixThrusterDive dive = new SixThrusterDive(0.25, -0.2)) {
      dive.control.setVariable("WATCHES RESPONSE", false); // the thruster itself knows
      VesselPropeller propeller = new VesselPropeller(dive.run, FIRST.name());
      dive.startMeasuring(FIRST, propeller);
      dive.dive(SETTLING_S);
      assertThat(dive.worstM(5.0)).isLessThan(0.03);
      assertThat(Math.abs(propeller.percent())).as("it works").isGreaterThan(20.0);

      propeller.caught(true);
      dive.dive(2.0);
      assertThat(left(dive)).isZero();
      assertThat(dive.health()).startsWith("lost: THRUSTER 1; authority left: ");
      dive.dive(22.0); // two pauses of 10 s, with a try after each
      assertThat(times(dive, "lost: THRUSTER 1")).isGreaterThanOrEqualTo(2);
      assertThat(dive.worstM(2.0)).isLessThan(0.1);

      propeller.caught(false);
      dive.dive(25.0);
      assertThat(left(dive)).isEqualTo(100.0);
      assertThat(dive.kit.log(FIRST.name()))
          .anySatisfy(line -> assertThat(line).contains("the thruster turns again"));
      assertThat(dive.worstM(5.0)).isLessThan(0.03);
    }
  }

  @Test
  void wireBreaksAndIsMended_holdingStation_isLostMeanwhile() {
    try (SixThrusterDive dive = new SixThrusterDive(0.15, -0.1)) {
      VesselPropeller propeller = new VesselPropeller(dive.run, FIRST.name());
      dive.startMeasuring(FIRST, propeller);
      dive.dive(SETTLING_S);

      propeller.plugged(false);
      dive.dive(2.0);
      assertThat(left(dive)).isZero();
      assertThat(dive.health()).startsWith("lost: THRUSTER 1; authority left: ");
      propeller.plugged(true);
      dive.dive(5.0);
      assertThat(left(dive)).isEqualTo(100.0);
      assertThat(dive.worstM(5.0)).isLessThan(0.03);
    }
  }

  @Test
  void swap_thrusterUnderWay_goesOnWithItsThrust() {
    try (SixThrusterDive dive = new SixThrusterDive(0.25, -0.2)) {
      VesselPropeller propeller = new VesselPropeller(dive.run, FIRST.name());
      ThrusterActuator before = dive.startMeasuring(FIRST, propeller);
      dive.dive(SETTLING_S);
      double thrust = propeller.percent();
      assertThat(Math.abs(thrust)).isGreaterThan(20.0);

      dive.kit.withoutVariables();
      SixThrusterDive.measuring(FIRST).forEach(dive.kit::with);
      dive.kit.swap(before, context -> new ThrusterActuator(context, propeller));
      dive.kit.advance(0.04);
      assertThat(propeller.percent()).isCloseTo(thrust, within(1.0));
      dive.dive(5.0);
      assertThat(times(dive, "lost: THRUSTER 1")).isZero();
      assertThat(dive.worstM(5.0)).isLessThan(0.03);
    }
  }

  @Test
  void swap_stalledThruster_staysLostUntilItsPauseIsOver() {
    try (SixThrusterDive dive = new SixThrusterDive(0.25, -0.2)) {
      dive.control.setVariable("WATCHES RESPONSE", false);
      VesselPropeller propeller = new VesselPropeller(dive.run, FIRST.name());
      ThrusterActuator before = dive.startMeasuring(FIRST, propeller);
      dive.dive(SETTLING_S);
      propeller.caught(true);
      dive.dive(4.0);
      assertThat(left(dive)).isZero();

      dive.kit.withoutVariables();
      SixThrusterDive.measuring(FIRST).forEach(dive.kit::with);
      dive.kit.swap(before, context -> new ThrusterActuator(context, propeller));
      dive.dive(1.0);
      assertThat(left(dive)).isZero();
      dive.dive(9.0);
      assertThat(times(dive, "full control authority")).as("offered again").isPositive();
    }
  }
}
