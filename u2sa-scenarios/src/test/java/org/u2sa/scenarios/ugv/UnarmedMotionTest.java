package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Terrain;

class UnarmedMotionTest {
  private static final DriveCommand DRIVEN = new DriveCommand(0.1, 0.1);

  private DriveCommand motors = DRIVEN;
  private final UnarmedMotion level = on(Terrain.flat());
  private final UnarmedMotion steep = on(Terrain.slope(0.1, 0.0));

  private UnarmedMotion on(Terrain terrain) {
    return new UnarmedMotion(terrain, () -> motors, () -> 2);
  }

  private static VehicleTruth at(double timeS, double northMps) {
    Attitude north = new Attitude(0.0, 0.0, 0.0);
    Point velocity = Point.of(0.0, northMps, 0.0);
    return new VehicleTruth(timeS, Point.ORIGIN, north, velocity, Point.ORIGIN, Point.ORIGIN);
  }

  private static void arm(UnarmedMotion motion, boolean armed, double timeS) {
    motion.armed(new ArmingState().armed(armed), at(timeS, 0.0));
  }

  @Test
  void see_movesThoughNobodyArmed_isAViolation() {
    level.see(at(1.0, 0.1));

    assertThat(level.outcome().violations()).containsExactly("moved unarmed at 1.0 s, at 0.10 m/s");
    assertThat(level.outcome().contacts()).isEqualTo(2);
  }

  @Test
  void see_stopsWithinTwoSecondsOfBeingDisarmed_isNone() {
    arm(level, true, 0.0);
    level.see(at(1.0, 1.0));
    arm(level, false, 2.0);
    level.see(at(3.0, 0.5));
    level.see(at(5.0, 0.0));

    assertThat(level.outcome().violations()).isEmpty();
  }

  @Test
  void see_goesOnAfterBeingDisarmed_isOneViolationEachTime() {
    arm(level, true, 0.0);
    arm(level, false, 2.0);
    level.see(at(4.5, 0.5));
    level.see(at(4.6, 0.5));
    arm(level, true, 5.0);
    arm(level, false, 6.0);
    level.see(at(9.0, 0.3));

    assertThat(level.outcome().violations()).hasSize(2);
  }

  @Test
  void see_rollsDownASlopeWithItsMotorsAtRest_isNone() {
    motors = DriveCommand.none();
    steep.see(at(1.0, 0.1));
    motors = DriveCommand.neutral();
    steep.see(at(1.1, 0.1));

    assertThat(steep.outcome().violations()).isEmpty();
  }

  @Test
  void see_movesOnLevelGroundOrByItsMotors_isAViolation() {
    motors = DriveCommand.none();
    level.see(at(1.0, 0.1));
    motors = new DriveCommand(0.0, 0.1);
    steep.see(at(1.0, 0.1));

    assertThat(level.outcome().violations()).hasSize(1);
    assertThat(steep.outcome().violations()).hasSize(1);
  }
}
