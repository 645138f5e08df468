package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.ArmingState;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.GroundState;

class UnarmedMotionTest {
  private static final DriveCommand DRIVEN = new DriveCommand(0.1, 0.1);
  private static final double STEEP = 0.1;

  private final UnarmedMotion motion = new UnarmedMotion();

  private static GroundState at(double timeS, double forwardMps) {
    return new GroundState(
        timeS, 0.0, 0.0, 0.0, forwardMps, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 12.0, 1.0);
  }

  private void arm(boolean armed, double timeS) {
    motion.see(new ArmingState().armed(armed), at(timeS, 0.0));
  }

  @Test
  void see_movesThoughNobodyArmed_isAViolation() {
    motion.see(at(1.0, 0.1), DRIVEN, 0.0);

    assertThat(motion.violations()).containsExactly("moved unarmed at 1.0 s, at 0.10 m/s");
  }

  @Test
  void see_stopsWithinTwoSecondsOfBeingDisarmed_isNone() {
    arm(true, 0.0);
    motion.see(at(1.0, 1.0), DRIVEN, 0.0);
    arm(false, 2.0);
    motion.see(at(3.0, 0.5), DRIVEN, 0.0);
    motion.see(at(5.0, 0.0), DRIVEN, 0.0);

    assertThat(motion.violations()).isEmpty();
  }

  @Test
  void see_goesOnAfterBeingDisarmed_isOneViolationEachTime() {
    arm(true, 0.0);
    arm(false, 2.0);
    motion.see(at(4.5, 0.5), DRIVEN, 0.0);
    motion.see(at(4.6, 0.5), DRIVEN, 0.0);
    arm(true, 5.0);
    arm(false, 6.0);
    motion.see(at(9.0, 0.3), DRIVEN, 0.0);

    assertThat(motion.violations()).hasSize(2);
  }

  @Test
  void see_rollsDownASlopeWithItsMotorsAtRest_isNone() {
    motion.see(at(1.0, 0.1), DriveCommand.none(), STEEP);
    motion.see(at(1.1, 0.1), DriveCommand.neutral(), STEEP);

    assertThat(motion.violations()).isEmpty();
  }

  @Test
  void see_movesOnLevelGroundOrByItsMotors_isAViolation() {
    motion.see(at(1.0, 0.1), DriveCommand.none(), 0.0);
    assertThat(motion.violations()).hasSize(1);

    arm(true, 2.0);
    arm(false, 3.0);
    motion.see(at(6.0, 0.1), new DriveCommand(0.0, 0.1), STEEP);
    assertThat(motion.violations()).hasSize(2);
  }
}
